/// The system of Lorenz (1963) with sigma = 10 and b = 8/3; its model begins with r.
#ifndef TESTS_LORENZ_H
#define TESTS_LORENZ_H

#include <stddef.h>

static inline void lorenz_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)t, (void)forcing;
    dxdt[0] = 10.0 * (x[1] - x[0]);
    dxdt[1] = x[0] * (*(const double *)model - x[2]) - x[1];
    dxdt[2] = x[0] * x[1] - 8.0 / 3.0 * x[2];
}

static inline void lorenz_tangent(const void *model, double t, const double *forcing, const double *x,
                                  const double *sides, size_t count, const double *dx, double *ddxdt) {
    (void)t, (void)forcing, (void)sides;
    for (; count > 0; count--, dx += 3, ddxdt += 3) {
        ddxdt[0] = 10.0 * (dx[1] - dx[0]);
        ddxdt[1] = dx[0] * (*(const double *)model - x[2]) - x[0] * dx[2] - dx[1];
        ddxdt[2] = dx[0] * x[1] + x[0] * dx[1] - 8.0 / 3.0 * dx[2];
    }
}

static inline double lorenz_divergence(const void *model, double t, const double *forcing, const double *x,
                                       const double *sides) {
    (void)model, (void)t, (void)forcing, (void)x, (void)sides;
    return -41.0 / 3.0;
}

#endif
