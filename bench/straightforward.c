// The peer "straightforward C": the paper's equations (printed signs) typed in as they stand, RK4 on an array of eight.
#include "straightforward.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

static void film(double x, double y, double vx, double vy, double *px, double *py) {
    const double a = x - 2.0 * vy, b = y + 2.0 * vx;
    const double q = 1.0 - x * x - y * y;
    const double alpha = atan2(-b, -a);
    const double ca = cos(alpha), sa = sin(alpha);
    const double across = y * ca - x * sa, along = x * ca + y * sa;
    const double G = 2.0 / sqrt(q) * (pi / 2.0 + atan(across / sqrt(q)));
    const double V = (2.0 + across * G) / q;
    const double S = along / (1.0 - along * along);
    const double K = -sqrt(a * a + b * b) / q;
    *px = K * (3.0 * x * V - sa * G - 2.0 * ca * S);
    *py = K * (3.0 * y * V + ca * G - 2.0 * sa * S);
}

static void slope(const straightforward_rotor *r, double t, const double *z, double *dz) {
    const double K1 = 1.0 / (2.0 * r->r_m * r->w * r->w), K2 = 1.0 / (4.0 * r->w * r->w);
    const double a = r->r_k + 1.0, b = r->r_k - 1.0;
    const double c2 = cos(2.0 * t), s2 = sin(2.0 * t);
    const double dx = z[0] - z[2], dy = z[1] - z[3];
    const double sx = (a + b * c2) * dx + b * s2 * dy, sy = (a + b * c2) * dy + b * s2 * dx;
    double fx = 0.0, fy = 0.0, px, py;
    const double radius = sqrt(z[0] * z[0] + z[1] * z[1]);
    if (radius >= r->r_delta) {
        const double push = (1.0 - r->r_delta / radius) * r->r_ck / (r->r_m * r->w * r->w);
        fx = -push * (z[0] - r->f * z[1]);
        fy = -push * (r->f * z[0] + z[1]);
    }
    film(z[2], z[3], z[6], z[7], &px, &py);
    for (int i = 0; i < 4; i++) dz[i] = z[4 + i];
    dz[4] = -r->xi1 * z[4] - K1 * sx + r->rho * cos(t) + fx;
    dz[5] = -r->xi1 * z[5] - K1 * sy + r->rho * sin(t) + fy - r->G;
    dz[6] = -0.5 * r->xi2 * z[6] + K2 * sx + r->S_f * px;
    dz[7] = -0.5 * r->xi2 * z[7] + K2 * sy + r->S_f * py - r->G;
}

void straightforward_revolve(const straightforward_rotor *r, int steps, double *z) {
    const double h = 2.0 * pi / steps;
    double k1[8], k2[8], k3[8], k4[8], y[8];
    for (int n = 0; n < steps; n++) {
        const double t = n * h;
        slope(r, t, z, k1);
        for (int i = 0; i < 8; i++) y[i] = z[i] + 0.5 * h * k1[i];
        slope(r, t + 0.5 * h, y, k2);
        for (int i = 0; i < 8; i++) y[i] = z[i] + 0.5 * h * k2[i];
        slope(r, t + 0.5 * h, y, k3);
        for (int i = 0; i < 8; i++) y[i] = z[i] + h * k3[i];
        slope(r, t + h, y, k4);
        for (int i = 0; i < 8; i++) z[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    }
}
