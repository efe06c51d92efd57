/// The task of the peers at each point of a map: the paper's rotor (rotor.h) with its unbalance as a second
/// parameter, adaptively at rtol 1e-6 and atol 1e-9, from rest; sections and the bounds of the disc over the last
/// revolutions, and the growth of a perturbation of 1e-8 by a second motion over the second half.
#ifndef BENCH_MAP_EQUATIONS_H
#define BENCH_MAP_EQUATIONS_H

#include "equations.h"

#define MAP_RTOL 1e-6
#define MAP_ATOL 1e-9
#define MAP_PERTURBATION 1e-8

enum { MAP_SIDE = 16 };

/// Computes the equations with another unbalance than rotor.h's.
static inline void map_equations(double r_k, double rho, double t, const double *z, double *dz) {
    const double c = cos(t), s = sin(t);
    equations(r_k, c, s, z, dz);
    dz[4] += (rho - rotor_rho) * c;
    dz[5] += (rho - rotor_rho) * s;
}

/// Returns the stiffness ratio of point i along its axis.
static inline double map_r_k(int i) {
    return 1.0 - 0.9 * i / (MAP_SIDE - 1);
}
static inline double map_rho(int i) {
    return 0.04 + 0.08 * i / (MAP_SIDE - 1);
}

#endif
