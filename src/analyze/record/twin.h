/// A perturbation followed by a second trajectory.
#ifndef ANALYZE_TWIN_H
#define ANALYZE_TWIN_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/integrate.h"

/// A second trajectory close to the first, drawn back to its distance after every revolution (Benettin et al. 1980).
typedef struct trajectory_twin {
    size_t dimension;
    const double *turns, *angles; ///< as whirl_system has them: what turns is not perturbed
    double share;                 ///< of the state's size (twin_share)
    double least;                 ///< distance, in the state's units
    double distance;
    double *x; ///< NULL: no twin
} trajectory_twin;

/// A twin at x, yet to be placed, of motions that are carried in that way. Steps of one-step methods are a smooth
/// function of the state: twin and motion err alike. CVODE's orders and steps have a history, each motion errs on its
/// own, and the twin stands 10^4 tolerances off, so that what they err by is a small part of the distance. (All others
/// would lose by it: a distance d adds errors of the order of d.)
trajectory_twin twin_of(const whirl_integrate_options *integrate, const whirl_system *system, double *x);

/// Places the twin beside the state x.
void twin_begin(trajectory_twin *twin, const double *x);

/// Natural logarithm of the growth since the last call; the twin is drawn back to its distance from x.
/// Where the distance is lost in rounding or out of all bounds, the growth is the limit of what can be told.
double twin_growth(trajectory_twin *twin, const double *x, bool bounded);

#endif
