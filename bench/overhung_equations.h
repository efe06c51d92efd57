/// The overhung rotor as its peers in C have it. Films and rub need no angle except one arctangent, and no branch, so
/// that the compiler can vectorise them. Forces are over speed^2 times the clearance.
#ifndef BENCH_OVERHUNG_EQUATIONS_H
#define BENCH_OVERHUNG_EQUATIONS_H

#include <math.h>

#include "overhung.h"

static inline void overhung_film(double scale, double x, double y, double vx, double vy, double *fx, double *fy) {
    const double A = x - 2.0 * vy, B = y + 2.0 * vx;
    const double q = 1.0 - x * x - y * y, CC = A * A + B * B, C = sqrt(CC), root = sqrt(q);
    const double P = x * B - y * A, U = x * A + y * B, over_q = 1.0 / q;
    const double G = (M_PI + 2.0 * atan(P / (C * root))) / root;
    const double S2 = -2.0 * U * C / (q * CC + P * P), CV3 = 3.0 * (2.0 * C + P * G) * over_q;
    *fx = -scale * over_q * (x * CV3 + B * G + A * S2);
    *fy = -scale * over_q * (y * CV3 - A * G + B * S2);
}

static inline void overhung_rub(double stiffness, double damping, double x, double y, double vx, double vy, double *fx,
                                double *fy) {
    const double r = sqrt(x * x + y * y), depth = r - OVERHUNG_GAP / OVERHUNG_CLEARANCE;
    const double press = stiffness * depth + damping * (x * vx + y * vy) / r;
    const double push = depth > 0.0 && press > 0.0 ? press / r : 0.0;
    *fx = -push * (x - OVERHUNG_FRICTION * y);
    *fy = -push * (y + OVERHUNG_FRICTION * x);
}

/// Computes the slopes of one machine. z: displacements, then velocities.
static inline void overhung_slope(const overhung_matrices *of, const overhung_scales *scales, double t,
                                  const double *restrict z, double *restrict dz) {
    enum { N = OVERHUNG_DEGREES };
    const double c = cos(t), s = sin(t), *v = z + N;
    double F[OVERHUNG_PORTS];
    overhung_film(scales->film[0], z[0], z[1], v[0], v[1], &F[0], &F[1]);
    overhung_film(scales->film[1], z[2], z[3], v[2], v[3], &F[2], &F[3]);
    overhung_rub(scales->push, scales->damping, z[4], z[5], v[4], v[5], &F[4], &F[5]);
    for (int i = 0; i < N; i++) {
        double place = of->g[i], a = of->u[i] * c + of->w[i] * s;
        for (int j = 0; j < N; j++) place += of->K[i][j] * z[j];
        for (int j = 0; j < N; j++) a -= of->G[i][j] * v[j];
        for (int j = 0; j < OVERHUNG_PORTS; j++) a += of->P[j][i] * F[j];
        dz[i] = v[i];
        dz[N + i] = a - scales->stiffness * place;
    }
}

#endif
