/// A disturbance followed by a second trajectory.
#ifndef ANALYZE_TWIN_H
#define ANALYZE_TWIN_H

#include <stdbool.h>
#include <stddef.h>

/// A second trajectory close to the first, drawn back to its distance after every revolution (Benettin et al. 1980).
typedef struct trajectory_twin {
    size_t dimension;
    double distance;
    double *x; ///< NULL: no twin
} trajectory_twin;

/// Places the twin beside the state x.
void twin_begin(trajectory_twin *twin, const double *x);

/// Natural logarithm of the growth since the last call; the twin is drawn back to its distance from x.
/// Where the distance is lost in rounding or out of all bounds, the growth is the limit of what can be told.
double twin_growth(trajectory_twin *twin, const double *x, bool bounded);

#endif
