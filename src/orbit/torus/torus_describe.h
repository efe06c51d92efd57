/// Tori in memory, and the number of nodes they need.
#ifndef ORBIT_TORUS_DESCRIBE_H
#define ORBIT_TORUS_DESCRIBE_H

#include "torus_equations.h"
#include "whirl/engine/torus.h"
#include "whirl/status.h"

#include <stddef.h>

/// Makes the torus of the unknowns u that have just been evaluated with a derivative. WHIRL_NO_MEMORY.
whirl_status torus_describe(torus_equations *e, const double *u, double residual, whirl_torus **out);

/// Returns true if the torus of u is as accurate as the options require, or as their tolerance allows if it is small.
bool torus_is_accurate(const torus_equations *e, const double *u, const whirl_torus *torus);

/// Returns the number of nodes with which the curve of u, whose error between its nodes is `error`, is about as
/// accurate as the options require: odd, at most as many as they allow.
size_t torus_nodes_wanted(torus_equations *e, const double *u, double error);

/// Converts unknowns `from` with `count` nodes to `to` with `many` nodes. Returns false without memory.
bool torus_resample(const torus_equations *e, size_t count, const double *from, size_t many, double *to);

/// Writes to text [size] that the torus is inaccurate, and near which resonance it is.
void torus_say_rough(const torus_equations *e, const whirl_torus *torus, char *text, size_t size);

/// Computes the normal exponents of a curve whose derivatives were evaluated last: the torus' exponents [n - 1] and
/// their errors. Returns false without memory, or if the curve has no direction.
bool torus_find_exponents(const torus_equations *e, const double *u, whirl_torus *torus);

#endif
