// The peer "compiler-vectorised loop": plain C written for the vectoriser. Many machines side by side, one array for
// each quantity; no branch for the contact; no angle except one arctangent; cosines tabulated, since all machines share
// tau. Compiled for this machine's processor with -ffast-math; PEER_ARCTAN chooses the arctangent of the C library (its
// vector version) or the one below.
#include <math.h>

#include "peer.h"
#include "rotor.h"

#ifndef PEER_MACHINES
#define PEER_MACHINES 64
#endif

typedef struct machines {
    double r_k[PEER_MACHINES], z[ROTOR_DIMENSION][PEER_MACHINES];
    double table[2 * ROTOR_STEPS + 1][4]; ///< cos and sin of tau and of 2 tau at every half step
} machines;

#ifdef PEER_OWN_ARCTAN
/// Returns atan(y/x) for x > 0: folded at pi/4, measured from the nearer of 0 and pi/4; a polynomial of ten terms for
/// the rest.
static inline double arctan_quotient(double y, double x) {
    const double size = fabs(y), small = size < x ? size : x, large = size < x ? x : size;
    const int turned = small > 0.41421356237309503 * large;
    const double u = (turned ? small - large : small) / (turned ? small + large : large), s = u * u;
    double p = 0x1.5c499b265fce1p-6;
    p = p * s - 0x1.651538dff7b49p-5;
    p = p * s + 0x1.d253e722db8aap-5;
    p = p * s - 0x1.1005137c53d01p-4;
    p = p * s + 0x1.3afc32143df6bp-4;
    p = p * s - 0x1.745bc2f2036d0p-4;
    p = p * s + 0x1.c71c65ccd3f69p-4;
    p = p * s - 0x1.24924905743e5p-3;
    p = p * s + 0x1.9999999949591p-3;
    p = p * s - 0x1.5555555555317p-2;
    double angle = u + u * s * p + (turned ? ROTOR_PI / 4 : 0.0);
    angle = size < x ? angle : ROTOR_PI / 2 - angle;
    return y < 0.0 ? -angle : angle;
}
#else
#define arctan_quotient(y, x) atan((y) / (x))
#endif

/// Computes the accelerations of one machine; `wave` is a row of the table.
#define SLOPE(ax1, ay1, ax2, ay2, x1, y1, x2, y2, vx1, vy1, vx2, vy2, wave)                                            \
    double ax1, ay1, ax2, ay2;                                                                                         \
    slope(a, b, wave, x1, y1, x2, y2, vx1, vy1, vx2, vy2, &ax1, &ay1, &ax2, &ay2)

static inline void slope(double a, double b, const double *wave, double x1, double y1, double x2, double y2, double vx1,
                         double vy1, double vx2, double vy2, double *ax1, double *ay1, double *ax2, double *ay2) {
    const double dx = x1 - x2, dy = y1 - y2;
    const double direct = a + b * wave[2], cross = b * wave[3];
    const double sx = direct * dx + cross * dy, sy = direct * dy + cross * dx;
    const double push = ROTOR_PUSH * fmin(rotor_r_delta / sqrt(x1 * x1 + y1 * y1) - 1.0, 0.0);
    const double A = x2 - 2.0 * vy2, B = y2 + 2.0 * vx2;
    const double q = 1.0 - x2 * x2 - y2 * y2, CC = A * A + B * B;
    const double C = sqrt(CC), P = x2 * B - y2 * A, U = x2 * A + y2 * B, D = q * CC + P * P;
    const double both = 1.0 / (q * D), over_q = D * both, over_D = q * both, root = sqrt(q);
    const double G = root * over_q * (ROTOR_PI + 2.0 * arctan_quotient(P, C * root));
    const double S2 = -2.0 * U * C * over_D, CV3 = 3.0 * (2.0 * C + P * G) * over_q;
    const double scale = -rotor_S_f * over_q;
    *ax1 = rotor_rho * wave[0] - rotor_xi1 * vx1 - ROTOR_K1 * sx + push * (x1 - rotor_f * y1);
    *ay1 = rotor_rho * wave[1] - rotor_G - rotor_xi1 * vy1 - ROTOR_K1 * sy + push * (y1 + rotor_f * x1);
    *ax2 = ROTOR_K2 * sx - 0.5 * rotor_xi2 * vx2 + scale * (x2 * CV3 + B * G + A * S2);
    *ay2 = ROTOR_K2 * sy - rotor_G - 0.5 * rotor_xi2 * vy2 + scale * (y2 * CV3 - A * G + B * S2);
}

/// Carries all machines over one step, in Nystrom's form of RK4: one loop body takes a machine over the whole step.
static void step(machines *restrict m, const double *start, const double *middle, const double *end) {
    const double h = 2.0 * ROTOR_PI / ROTOR_STEPS, g = 0.5 * h;
    double *restrict px1 = m->z[0], *restrict py1 = m->z[1], *restrict px2 = m->z[2], *restrict py2 = m->z[3];
    double *restrict pu1 = m->z[4], *restrict pv1 = m->z[5], *restrict pu2 = m->z[6], *restrict pv2 = m->z[7];
#pragma omp simd
    for (int i = 0; i < PEER_MACHINES; i++) {
        const double a = m->r_k[i] + 1.0, b = m->r_k[i] - 1.0;
        const double x1 = px1[i], y1 = py1[i], x2 = px2[i], y2 = py2[i];
        const double u1 = pu1[i], v1 = pv1[i], u2 = pu2[i], v2 = pv2[i];
        SLOPE(ka, kb, kc, kd, x1, y1, x2, y2, u1, v1, u2, v2, start);
        const double mx1 = x1 + g * u1, my1 = y1 + g * v1, mx2 = x2 + g * u2, my2 = y2 + g * v2;
        SLOPE(la, lb, lc, ld, mx1, my1, mx2, my2, u1 + g * ka, v1 + g * kb, u2 + g * kc, v2 + g * kd, middle);
        SLOPE(ma, mb, mc, md, mx1 + g * g * ka, my1 + g * g * kb, mx2 + g * g * kc, my2 + g * g * kd, u1 + g * la,
              v1 + g * lb, u2 + g * lc, v2 + g * ld, middle);
        const double ex1 = x1 + h * u1, ey1 = y1 + h * v1, ex2 = x2 + h * u2, ey2 = y2 + h * v2;
        SLOPE(na, nb, nc, nd, ex1 + h * g * la, ey1 + h * g * lb, ex2 + h * g * lc, ey2 + h * g * ld, u1 + h * ma,
              v1 + h * mb, u2 + h * mc, v2 + h * md, end);
        px1[i] = ex1 + h * h / 6.0 * (ka + la + ma);
        py1[i] = ey1 + h * h / 6.0 * (kb + lb + mb);
        px2[i] = ex2 + h * h / 6.0 * (kc + lc + mc);
        py2[i] = ey2 + h * h / 6.0 * (kd + ld + md);
        pu1[i] = u1 + h / 6.0 * (ka + 2.0 * (la + ma) + na);
        pv1[i] = v1 + h / 6.0 * (kb + 2.0 * (lb + mb) + nb);
        pu2[i] = u2 + h / 6.0 * (kc + 2.0 * (lc + mc) + nc);
        pv2[i] = v2 + h / 6.0 * (kd + 2.0 * (ld + md) + nd);
    }
}

static void revolve(void *context) {
    machines *m = context;
    for (int n = 0; n < ROTOR_STEPS; n++) step(m, m->table[2 * n], m->table[2 * n + 1], m->table[2 * n + 2]);
}

static double x1(void *context) {
    return ((machines *)context)->z[0][0];
}

int main(int argc, char **argv) {
    static machines m;
    const double start[ROTOR_DIMENSION] = ROTOR_START;
    for (int i = 0; i < PEER_MACHINES; i++) {
        m.r_k[i] = rotor_r_k(i, PEER_MACHINES);
        for (int k = 0; k < ROTOR_DIMENSION; k++) m.z[k][i] = start[k];
    }
    for (int n = 0; n <= 2 * ROTOR_STEPS; n++) {
        const double tau = ROTOR_PI * n / ROTOR_STEPS;
        m.table[n][0] = cos(tau), m.table[n][1] = sin(tau);
        m.table[n][2] = cos(2.0 * tau), m.table[n][3] = sin(2.0 * tau);
    }
    peer_measure(&(peer){PEER_NAME, PEER_MACHINES, revolve, x1, &m}, peer_seconds(argc, argv));
    return 0;
}
