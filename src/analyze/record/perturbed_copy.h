/// A perturbation followed by a second trajectory.
#ifndef ANALYZE_PERTURBED_COPY_H
#define ANALYZE_PERTURBED_COPY_H

#include <stdbool.h>
#include <stddef.h>

#include "section.h"

/// A perturbed copy of a motion: a second trajectory close to the first, rescaled to its distance after every
/// revolution (Benettin et al. 1980).
typedef struct perturbed_copy {
    size_t dimension;
    const double *turns, *angles; ///< as in whirl_system: coordinates that turn are not perturbed
    double share;                 ///< relative to the state's size
    double least;                 ///< distance, in the state's units
    double distance;
    double range; ///< half the range of the motion over the first revolution that was followed; 0: not known yet
    double *x;    ///< NULL: no copy
} perturbed_copy;

/// Makes a perturbed copy at x, yet to be placed, for motions of these options. Steps of one-step methods are a smooth
/// function of the state: motion and copy have the same errors. CVODE's orders and steps have a history, so each motion
/// has errors of its own, and the copy is 10^4 tolerances away, which makes these errors a small part of the distance.
/// With other methods such a distance would only harm: a distance d adds errors of the order of d.
perturbed_copy perturbed_copy_of(const whirl_integrate_options *integrate, const whirl_system *system, double *x);

/// Places the copy next to the state x.
void perturbed_copy_begin(perturbed_copy *copy, const double *x);

/// Passes on the extremes low, high [dimension] of the motion over a revolution. They are its size in every coordinate,
/// since a coordinate may be tiny at the section alone.
void perturbed_copy_size(perturbed_copy *copy, const double *low, const double *high);

/// Returns the natural logarithm of the growth since the last call, and rescales the copy's distance from x. `first`:
/// the call follows perturbed_copy_size, and the distance was chosen without the motion's range. If the distance is
/// lost in rounding or overflows, the growth is the limit of what can be resolved.
double perturbed_copy_growth(perturbed_copy *copy, const double *x, bool first, bool bounded);

#endif
