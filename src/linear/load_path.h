/// Equilibria over the share of the load, through folds.
#ifndef LINEAR_LOAD_PATH_H
#define LINEAR_LOAD_PATH_H

#include "mean.h"

/// Follows f(x) = (1 - share) f(x at the start) in all coordinates from share 0 to 1 by arc length. x [dimension]
/// becomes an equilibrium; returns false if the path does not lead to one, or without memory. `unit`: a length in which
/// displacements are of size 1.
bool load_path_follow(mean_system *m, double unit, double *x);

#endif
