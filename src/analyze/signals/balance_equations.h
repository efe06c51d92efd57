/// Helpers that the files of balancing share: complex numbers, least squares, unknowns.
#ifndef ANALYZE_BALANCE_EQUATIONS_H
#define ANALYZE_BALANCE_EQUATIONS_H

#include <complex.h>
#include <stddef.h>

#include "whirl/internal/balance.h"

static inline double complex balance_number(const double of[2]) {
    return of[0] + of[1] * I;
}

static inline void balance_set(double out[2], double complex value) {
    out[0] = creal(value);
    out[1] = cimag(value);
}

/// Maximum number of unknowns: a vibration without weights, and one for every plane or set.
enum { BALANCE_UNKNOWNS = WHIRL_MAX_PLANES + 1 };

/// Complex least squares: unknowns x [n] of weighted rows a x = b, by their normal equations; b in side.
typedef struct balance_normal {
    size_t n;
    double complex matrix[BALANCE_UNKNOWNS][BALANCE_UNKNOWNS], side[BALANCE_UNKNOWNS];
} balance_normal;

/// Adds a row a [n] with its right-hand side b to the normal equations.
void balance_add(balance_normal *of, const double complex *a, double complex b, double weight);

/// Solves for the unknowns, into `side`; false if the rows do not determine them.
bool balance_unknowns(balance_normal *of);

/// Moves amounts [n], the solution, to the least squares with |amount| within limits [n]. As a function of one amount
/// the goal is a circular bowl, so the nearest amount within its limit is the best one while the others stay: amounts
/// are moved in turn until none changes (Tseng 2001).
void balance_within(const balance_normal *of, const double *limits, double complex *amounts);

/// Returns the ratio of the largest singular value of the rows to the smallest; significance [n] as in
/// whirl_correction. NaN without memory.
double balance_condition(const balance_normal *of, double *significance);

/// Returns the number of a correction's unknowns: planes, or sets if there are modes.
size_t balance_unknown_count(const whirl_balance *of);

/// Returns the index of the mode to which readings at a speed belong: the mode of the nearest speed.
size_t balance_mode_of(const whirl_balance *of, double speed);

/// Returns the effect of a kg m of an unknown on a row, by the influence coefficients of planes.
double complex balance_effect(const whirl_correction *of, const double (*influence)[2], size_t planes, size_t unknown);

#endif
