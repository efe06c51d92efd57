/// The rotor's equations for solvers that take dz/dt = f(t, z): with no angle except one arctangent, cosines and sines
/// by the C library, as a careful user of such a solver would write them. C and C++; in C++ for any number type.
#ifndef BENCH_EQUATIONS_H
#define BENCH_EQUATIONS_H

#include "rotor.h"

#ifdef __cplusplus
#include <cmath>
using std::atan;
using std::sqrt;
#define EQUATIONS_FOR template <class number>
#else
#include <math.h>
#define EQUATIONS_FOR
typedef double number;
#endif

/// min(r_delta/r - 1, 0) without a branch, for numbers that have none.
#ifndef EQUATIONS_OWN_MINIMUM
static inline double below_zero(double a) {
    return a < 0.0 ? a : 0.0;
}
#endif

EQUATIONS_FOR static inline void equations_film(number x, number y, number vx, number vy, number *fx, number *fy) {
    const number A = x - 2.0 * vy, B = y + 2.0 * vx;
    const number q = 1.0 - x * x - y * y, CC = A * A + B * B;
    const number C = sqrt(CC), root = sqrt(q);
    const number P = x * B - y * A, U = x * A + y * B;
    const number G = (ROTOR_PI + 2.0 * atan(P / (C * root))) / root;
    const number S2 = -2.0 * U * C / (q * CC + P * P), CV3 = 3.0 * (2.0 * C + P * G) / q;
    *fx = -(x * CV3 + B * G + A * S2) / q;
    *fy = -(y * CV3 - A * G + B * S2) / q;
}

/// Computes dz. c, s: cosine and sine of tau. z holds x1, y1, x2, y2 and their derivatives.
EQUATIONS_FOR static inline void equations(number r_k, double c, double s, const number *z, number *dz) {
    const double c2 = 1.0 - 2.0 * s * s, s2 = 2.0 * s * c;
    const number a = r_k + 1.0, b = r_k - 1.0;
    const number dx = z[0] - z[2], dy = z[1] - z[3];
    const number sx = (a + b * c2) * dx + b * s2 * dy, sy = (a + b * c2) * dy + b * s2 * dx;
    const number push = ROTOR_PUSH * below_zero(rotor_r_delta / sqrt(z[0] * z[0] + z[1] * z[1]) - 1.0);
    number px, py;
    equations_film(z[2], z[3], z[6], z[7], &px, &py);
    for (int i = 0; i < 4; i++) dz[i] = z[4 + i];
    dz[4] = -rotor_xi1 * z[4] - ROTOR_K1 * sx + rotor_rho * c + push * (z[0] - rotor_f * z[1]);
    dz[5] = -rotor_xi1 * z[5] - ROTOR_K1 * sy + rotor_rho * s + push * (z[1] + rotor_f * z[0]) - rotor_G;
    dz[6] = -0.5 * rotor_xi2 * z[6] + ROTOR_K2 * sx + rotor_S_f * px;
    dz[7] = -0.5 * rotor_xi2 * z[7] + ROTOR_K2 * sy + rotor_S_f * py - rotor_G;
}

#endif
