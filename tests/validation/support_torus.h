/// Long motions by an integrator of the tests' own, and the distances of their sections from a torus of the library.
#ifndef SUPPORT_TORUS_H
#define SUPPORT_TORUS_H

#include <stddef.h>

#include "whirl/engine/torus_branch.h"

/// dx/dt of a model.
typedef void (*slope_fn)(const void *model, double t, const double *x, double *slope);

enum { MAX_COORDINATES = 8 };

/// Returns sections [count][n] of a motion, one a period, after a transient, by the classical method of Runge and
/// Kutta. Freed by free.
double *long_motion(slope_fn slope, const void *model, size_t n, double period, int steps, const double *start,
                    int settling, size_t count);

/// Turns folded into 0 to 1/2.
double folded_turns(double turns);

/// Mean turn of two coordinates about their mean from one section to the next, folded, with the weights of Das et al.
double mean_turn(const double *points, size_t n, size_t count);

/// The largest distance of points [count][dimension] from the curve.
double distance_from(const whirl_torus *torus, const double *points, size_t count);

#endif
