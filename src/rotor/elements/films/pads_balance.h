/// Tilt rate of a pad without inertia, at which the moments about its pivot balance.
///
/// At a fixed tilt s the film's (A, B) = p (c, d) + r (d, -c), where (c, d) lies along the pad at its pivot. p is
/// determined by the journal, and s' = rate changes only r = r_0 + 2 rate/speed. The moment
///
///     M(rate) = spring s + damper rate + (c, d) f(p, r)
///
/// grows with the rate, since films dissipate. The moment has one zero, which Newton's method finds within a bracket.
/// If p > 0 the method starts at the zero of a pad without spring and damper, r = lean p, where `lean` depends on the
/// journal's position alone; otherwise at rate 0. Lanes that have converged stay there: no lane depends on its
/// neighbours.
#ifndef ROTOR_PADS_BALANCE_H
#define ROTOR_PADS_BALANCE_H

#include "pads_look_up.h"

/// State of the search. All pads of a bearing search at the same time, a step of each in turn, so that no step waits
/// for the previous one.
typedef struct pads_pivot {
    vec along[2]; ///< c, d
    vec p, r;     ///< r at rate 0
    vec twice;    ///< 2/speed
    vec scale;    ///< scale of the film: f = scale V S
    vec held;     ///< spring s
    vec damper;   ///< above 0
    vec lean;     ///< r/p of a pad that tilts freely, approximately
    pads_spot spot;
    // Rate and its bracket; size of the last step; derivative of M by the rate; force, and its derivative by the rate.
    vec rate, low, high, steep, force[2], by_rate[2];
    vec cell, rows[1][8]; ///< cell of alpha, and the sums there
    bool found;
} pads_pivot;

/// Computes M at the present rate.
VECTOR_INLINE vec pads_moment(pads_pivot *at, vec *V) {
    const vec r = v_fma(at->twice, at->rate, at->r);
    const vec a = v_fma(at->along[0], at->p, v_mul(at->along[1], r));
    const vec b = v_fms(at->along[1], at->p, v_mul(at->along[0], r));
    vec half, over, weight[4], turned[4], S[2], by_alpha[2];
    pads_polar(a, b, V, &half, &over);
    const pads_axis alpha = pads_on_alpha(half);
    if (v_any(v_less(v_set(0.0), v_abs(v_sub(alpha.cell, at->cell))))) pads_sum(&at->spot, alpha.cell, false, at->rows);
    at->cell = alpha.cell;
    pads_splines(alpha.u, weight);
    pads_spline_slopes(alpha.u, v_set(1.0 / PAD_STEP_ALPHA), turned);
    pads_weigh(at->rows[0], weight, S);
    pads_weigh(at->rows[0], turned, by_alpha);
    // dV/dr = r/V, d alpha/dr = -p/V^2.
    const vec grow = v_mul(v_mul(at->scale, at->twice), over), size = v_mul(at->scale, *V);
    for (int n = 0; n < 2; n++) {
        at->force[n] = v_mul(size, S[n]);
        at->by_rate[n] = v_mul(grow, v_fms(r, S[n], v_mul(at->p, by_alpha[n])));
    }
    const vec rising = v_fma(at->along[0], at->by_rate[0], v_mul(at->along[1], at->by_rate[1]));
    at->steep = v_max(v_add(at->damper, rising), at->damper);
    const vec held = v_fma(at->damper, at->rate, at->held);
    return v_fma(at->along[0], at->force[0], v_fma(at->along[1], at->force[1], held));
}

/// Takes a step of Newton's method, or bisects if that leaves the bracket. A converged lane repeats the same step; the
/// step is applied when all lanes have converged, or if it is the last one.
VECTOR_INLINE void pads_step(pads_pivot *at, bool last) {
    const vec zero = v_set(0.0), near = v_set(1e-7);
    vec V;
    const vec moment = pads_moment(at, &V);
    const vec newton = v_sub(at->rate, v_div(moment, at->steep));
    at->high = v_select(v_less(zero, moment), at->rate, at->high);
    at->low = v_select(v_less(moment, zero), at->rate, at->low);
    const vec middle = v_mul(v_set(0.5), v_add(at->low, at->high));
    const vec above = v_select(v_less(newton, at->low), middle, newton);
    const vec next = v_select(v_less(at->high, newton), middle, above), move = v_sub(next, at->rate);
    const vec_mask moving = v_less(v_mul(near, V), v_abs(v_mul(at->twice, move)));
    at->found = last || !v_any(moving);
    if (!at->found) {
        at->rate = v_select(moving, next, at->rate);
        return;
    }
    // The other terms are linear in the rate.
    at->rate = next;
    for (int n = 0; n < 2; n++) at->force[n] = v_fma(at->by_rate[n], move, at->force[n]);
}

static inline void pads_balance(pads_pivot *pads, size_t count) {
    enum { PASSES = 60 };
    for (pads_pivot *at = pads; at < pads + count; at++) {
        const vec free = v_div(v_fms(at->lean, at->p, at->r), at->twice);
        at->rate = v_select(v_less(v_set(0.0), at->p), free, v_set(0.0));
        at->low = v_set(-INFINITY);
        at->high = v_set(INFINITY);
        at->cell = v_set(-1.0); // no cell
        at->found = false;
    }
    bool all = false;
    for (int pass = 0; pass < PASSES && !all; pass++) {
        all = true;
        for (pads_pivot *at = pads; at < pads + count; at++) {
            if (!at->found) pads_step(at, pass == PASSES - 1);
            all = all && at->found;
        }
    }
}

#endif
