/// Periodic motions of systems whose coefficients turn with the shaft, and their monodromy matrix.
#ifndef LINEAR_PERIODIC_H
#define LINEAR_PERIODIC_H

#include "mean.h"

/// Finds the periodic motion near x [dimension], which becomes where it is at t = 0; monodromy [count][count] of the
/// coordinates that do not turn on and on, over *period. Unless it shall be `closed`, it is enough that the matrix no
/// longer changes: that of a linear machine is the same of all motions, and its periodic one may be beyond all bounds.
/// WHIRL_BAD_INPUT where none is found, or the coefficients fit no number of revolutions.
whirl_status periodic_find(const mean_system *m, double *x, bool closed, double *monodromy, double *period);

/// Its mean [dimension], and its first harmonic [dimension][2], from where periodic_find left x.
whirl_status periodic_harmonic(const mean_system *m, const double *x, double *mean, double *harmonic);

#endif
