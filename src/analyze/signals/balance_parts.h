/// What files on balancing share: complex numbers, least squares, what is unknown.
#ifndef ANALYZE_BALANCE_PARTS_H
#define ANALYZE_BALANCE_PARTS_H

#include <complex.h>

#include "whirl/engine/balance.h"

static inline double complex balance_number(const double of[2]) {
    return of[0] + of[1] * I;
}

static inline void balance_set(double out[2], double complex value) {
    out[0] = creal(value);
    out[1] = cimag(value);
}

/// The most unknowns: a vibration without weights, and one for every plane or set.
enum { BALANCE_UNKNOWNS = WHIRL_MAX_PLANES + 1 };

/// Complex least squares: unknowns x [n] of rows a x = b, each of its weight, by their normal equations; b in side.
typedef struct balance_normal {
    size_t n;
    double complex matrix[BALANCE_UNKNOWNS][BALANCE_UNKNOWNS], side[BALANCE_UNKNOWNS];
} balance_normal;

void balance_add(balance_normal *of, const double complex *a, double complex b, double weight);

/// The unknowns in `side`; false where the rows do not tell all of them.
bool balance_unknowns(balance_normal *of);

/// How many unknowns a correction has: planes, or sets where there are modes.
size_t balance_unknown_count(const whirl_balance *of);

/// Which mode readings at a speed are of: the one of the nearest speed.
size_t balance_mode_of(const whirl_balance *of, double speed);

/// What a kg m of an unknown does at a row, by influence coefficients of planes.
double complex balance_effect(const whirl_correction *of, const double (*influence)[2], size_t planes, size_t unknown);

#endif
