/// Best weights within limits, for goals that coordinate-wise moves do not minimize.
#ifndef ANALYZE_BALANCE_LIMITS_H
#define ANALYZE_BALANCE_LIMITS_H

#include <complex.h>
#include <stddef.h>

#include "whirl/signals.h"

/// Goal of a correction: rows before + effect x, with moments share x of at most limits in the planes.
typedef struct balance_goal {
    size_t n, rows, planes;       ///< unknowns; readings; planes with a limit
    const double complex *effect; ///< [rows][n] times the root of a row's weight
    const double complex *before; ///< [rows] times the same
    const double complex *share;  ///< [planes][n]
    const double *limits;         ///< [planes] kg m, above 0
    bool least_max;               ///< minimize the largest |row|; false: the sum of squares
} balance_goal;

/// Finds the best unknowns x [n]: to 1e-11 of the largest |row|, or of the largest |before|^2 for squares. The rows
/// must determine all unknowns. False without memory.
bool balance_best_within(const balance_goal *goal, double complex *amounts);

#endif
