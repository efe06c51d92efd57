/// Effect on perturbations of a switch at which the right-hand side jumps (Aizerman, Gantmakher 1958; Leine, Nijmeijer
/// 2004).
#ifndef INTEGRATE_SALTATION_H
#define INTEGRATE_SALTATION_H

#include <stddef.h>

/// Applies S = I + (f+ - f-) n^T/(n^T f- + dh/dt) to `count` perturbations [count][dimension]. A motion meets the
/// switch h(t, x) = 0 with the slope f- `before`, and leaves it with f+ `after`; n = dh/dx is `gradient`, dh/dt is
/// `by_time`. Returns ln|det S| = ln|(n^T f+ + dh/dt)/(n^T f- + dh/dt)|, which is minus infinity if the motion slides
/// along the switch from now on. If the motion only touches the switch (n^T f- + dh/dt = 0), perturbations stay as they
/// are.
double saltate(size_t dimension, const double *before, const double *after, const double *gradient, double by_time,
               size_t count, double *perturbations);

#endif
