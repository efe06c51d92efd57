/// Periodic motions of systems whose coefficients turn with the shaft, and the monodromy matrix of these motions.
#ifndef LINEAR_PERIODIC_H
#define LINEAR_PERIODIC_H

#include "mean.h"

/// Finds the periodic motion near x [dimension]. x becomes its state at t = 0. Writes its monodromy matrix
/// [count][count] over *period, for the coordinates other than angles of turning parts (mean_system.kept).
///
/// Without `closed` it is enough that the matrix no longer changes: the matrix of a linear machine is the same for all
/// motions, and its periodic motion may be unbounded. WHIRL_BAD_INPUT if no motion is found, or if the coefficients do
/// not repeat after a number of revolutions.
whirl_status periodic_find(const mean_system *m, double *x, bool closed, double *monodromy, double *period);

/// Writes the mean [dimension] and the first harmonic [dimension][2] of the periodic motion that begins at x, as found
/// by periodic_find.
whirl_status periodic_harmonic(const mean_system *m, const double *x, double *mean, double *harmonic);

#endif
