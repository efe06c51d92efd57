/// The course of a switching function over a step, by the Bernstein coefficients of the cubic through its values and
/// derivatives at both ends.
#ifndef INTEGRATE_BERNSTEIN_H
#define INTEGRATE_BERNSTEIN_H

#include "vector.h"

/// Returns 1 if the function clearly stays positive, otherwise 0. All coefficients must exceed a bound for the
/// difference of function and polynomial, which is taken from the bend of their polygon.
static inline vec bernstein_clear(vec b0, vec b1, vec b2, vec b3) {
    const vec bend0 = v_add(v_sub(b0, v_add(b1, b1)), b2), bend1 = v_add(v_sub(b1, v_add(b2, b2)), b3);
    const vec margin = v_fma(v_set(0.5), v_max(v_abs(bend0), v_abs(bend1)), v_abs(v_sub(bend1, bend0)));
    return v_select(v_less(margin, v_min(v_min(b0, b1), v_min(b2, b3))), v_set(1.0), v_set(0.0));
}

#endif
