/// Tori in memory, and how many nodes they need.
#ifndef ORBIT_TORUS_DESCRIBE_H
#define ORBIT_TORUS_DESCRIBE_H

#include "torus_equations.h"

/// The torus of the unknowns u that have just been evaluated with a derivative. WHIRL_NO_MEMORY.
whirl_status torus_describe(torus_equations *e, const double *u, double residual, whirl_torus **out);

/// Whether the torus of u is as accurate as the options ask, or as their tolerance allows where it is small.
bool torus_is_accurate(const torus_equations *e, const double *u, const whirl_torus *torus);

/// Nodes with which the curve of u, whose error is that between its nodes, is about as accurate as the options ask:
/// odd, at most as many as they allow.
size_t torus_nodes_wanted(torus_equations *e, const double *u, double error);

/// Writes unknowns `from` with `count` nodes as those `to` with `many` nodes. False where memory is lacking.
bool torus_resample(const torus_equations *e, size_t count, const double *from, size_t many, double *to);

/// Says that the torus is rough, and near which resonance it is, in `size` bytes of text.
void torus_say_rough(const torus_equations *e, const whirl_torus *torus, char *text, size_t size);

/// Normal exponents of a curve whose derivatives are the last that were evaluated: the torus' exponents [n - 1] and
/// their error. False where memory is lacking or the curve has no direction.
bool torus_find_exponents(const torus_equations *e, const double *u, whirl_torus *torus);

#endif
