/// A first curve for the search of a torus, from the sections of a motion.
#ifndef ORBIT_TORUS_START_H
#define ORBIT_TORUS_START_H

#include "torus_equations.h"
#include "whirl/status.h"

#include <stddef.h>

/// Fits a curve to `count` consecutive states [count][dimension]. Uses the rotation number, or finds one if it is NaN.
/// Gives the equations as many nodes as needed, and allocates *u [unknowns] with malloc. Errors as whirl_torus_find.
whirl_status torus_fit(torus_equations *e, const double *states, size_t count, double rotation, double **u);

#endif
