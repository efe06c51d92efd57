// The peer "straightforward C": the equations typed in as the paper has them, RK4 on an array of eight. Compiled twice,
// with different flags; PEER_NAME says with which.
#include <math.h>

#include "peer.h"
#include "rotor.h"

typedef struct machine {
    double r_k, z[ROTOR_DIMENSION];
} machine;

static void film(double x, double y, double vx, double vy, double *px, double *py) {
    const double a = x - 2.0 * vy, b = y + 2.0 * vx;
    const double q = 1.0 - x * x - y * y;
    const double alpha = atan2(-b, -a);
    const double ca = cos(alpha), sa = sin(alpha);
    const double across = y * ca - x * sa, along = x * ca + y * sa;
    const double G = 2.0 / sqrt(q) * (ROTOR_PI / 2.0 + atan(across / sqrt(q)));
    const double V = (2.0 + across * G) / q;
    const double S = along / (1.0 - along * along);
    const double K = -sqrt(a * a + b * b) / q;
    *px = K * (3.0 * x * V - sa * G - 2.0 * ca * S);
    *py = K * (3.0 * y * V + ca * G - 2.0 * sa * S);
}

static void slope(const machine *m, double t, const double *z, double *dz) {
    const double a = m->r_k + 1.0, b = m->r_k - 1.0;
    const double c2 = cos(2.0 * t), s2 = sin(2.0 * t);
    const double dx = z[0] - z[2], dy = z[1] - z[3];
    const double sx = (a + b * c2) * dx + b * s2 * dy, sy = (a + b * c2) * dy + b * s2 * dx;
    double fx = 0.0, fy = 0.0, px, py;
    const double radius = sqrt(z[0] * z[0] + z[1] * z[1]);
    if (radius >= rotor_r_delta) {
        const double push = (1.0 - rotor_r_delta / radius) * ROTOR_PUSH;
        fx = -push * (z[0] - rotor_f * z[1]);
        fy = -push * (rotor_f * z[0] + z[1]);
    }
    film(z[2], z[3], z[6], z[7], &px, &py);
    for (int i = 0; i < 4; i++) dz[i] = z[4 + i];
    dz[4] = -rotor_xi1 * z[4] - ROTOR_K1 * sx + rotor_rho * cos(t) + fx;
    dz[5] = -rotor_xi1 * z[5] - ROTOR_K1 * sy + rotor_rho * sin(t) + fy - rotor_G;
    dz[6] = -0.5 * rotor_xi2 * z[6] + ROTOR_K2 * sx + rotor_S_f * px;
    dz[7] = -0.5 * rotor_xi2 * z[7] + ROTOR_K2 * sy + rotor_S_f * py - rotor_G;
}

static void revolve(void *context) {
    machine *m = context;
    const double h = 2.0 * ROTOR_PI / ROTOR_STEPS;
    double *z = m->z, k1[8], k2[8], k3[8], k4[8], y[8];
    for (int n = 0; n < ROTOR_STEPS; n++) {
        const double t = n * h;
        slope(m, t, z, k1);
        for (int i = 0; i < 8; i++) y[i] = z[i] + 0.5 * h * k1[i];
        slope(m, t + 0.5 * h, y, k2);
        for (int i = 0; i < 8; i++) y[i] = z[i] + 0.5 * h * k2[i];
        slope(m, t + 0.5 * h, y, k3);
        for (int i = 0; i < 8; i++) y[i] = z[i] + h * k3[i];
        slope(m, t + h, y, k4);
        for (int i = 0; i < 8; i++) z[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    }
}

static double x1(void *context) {
    return ((machine *)context)->z[0];
}

int main(int argc, char **argv) {
    machine m = {ROTOR_R_K, ROTOR_START};
    peer_measure(&(peer){PEER_NAME, 1, revolve, x1, &m}, peer_seconds(argc, argv));
    return 0;
}
