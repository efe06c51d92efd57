/// A step of RK4 in Nystrom's form: the classical method applied to (x, v). The stages of x follow from those of v in
/// closed form, which saves half of the combinations. States of first order follow the velocities.
#ifndef INTEGRATE_RK4_SCHEME_H
#define INTEGRATE_RK4_SCHEME_H

#include "vector.h"

/// Workspace of a step; k1 to k3 are slopes of v. Before the fourth slope is taken, the sum of the second and third
/// replaces the second. The fourth slope replaces the third.
typedef struct scheme {
    vec *q, *v, *k1, *k2, *k3, *stage_q, *stage_v;
    vec whole, half, sixth, quarter_square, half_square, sixth_square; ///< fractions of the step's length
} scheme;

static inline scheme scheme_of(double h) {
    return (scheme){.whole = v_set(h),
                    .half = v_set(0.5 * h),
                    .sixth = v_set(h / 6.0),
                    .quarter_square = v_set(0.25 * h * h),
                    .half_square = v_set(0.5 * h * h),
                    .sixth_square = v_set(h * h / 6.0)};
}

/// Returns the scheme with the given arrays.
VECTOR_INLINE scheme scheme_at(const scheme *constants, vec *q, vec *v, vec *k1, vec *k2, vec *k3, vec *stage_q,
                               vec *stage_v) {
    scheme s = *constants;
    s.q = q;
    s.v = v;
    s.k1 = k1;
    s.k2 = k2;
    s.k3 = k3;
    s.stage_q = stage_q;
    s.stage_v = stage_v;
    return s;
}

/// Compute the states at which accelerations 2 to 4 are taken, and the state at the step's end.
static inline void enter_second(const scheme *s, size_t i) {
    const vec v = s->v[i];
    s->stage_q[i] = v_fma(s->half, v, s->q[i]);
    s->stage_v[i] = v_fma(s->half, s->k1[i], v);
}
static inline void enter_third(const scheme *s, size_t i) {
    s->stage_q[i] = v_fma(s->quarter_square, s->k1[i], s->stage_q[i]);
    s->stage_v[i] = v_fma(s->half, s->k2[i], s->v[i]);
}
static inline void enter_fourth(const scheme *s, size_t i) {
    const vec v = s->v[i], k2 = s->k2[i], k3 = s->k3[i];
    s->stage_q[i] = v_fma(s->half_square, k2, v_fma(s->whole, v, s->q[i]));
    s->stage_v[i] = v_fma(s->whole, k3, v);
    s->k2[i] = v_add(k2, k3);
}
static inline void enter_end(const scheme *s, size_t i) {
    const vec k1 = s->k1[i], v = s->v[i], inner = s->k2[i];
    s->q[i] = v_fma(s->sixth_square, v_add(k1, inner), v_fma(s->whole, v, s->q[i]));
    s->v[i] = v_fma(s->sixth, v_fma(v_set(2.0), inner, v_add(k1, s->k3[i])), v);
}

/// The same four functions for states of first order.
static inline void enter_second_state(const scheme *s, size_t i) {
    s->stage_v[i] = v_fma(s->half, s->k1[i], s->v[i]);
}
static inline void enter_third_state(const scheme *s, size_t i) {
    s->stage_v[i] = v_fma(s->half, s->k2[i], s->v[i]);
}
static inline void enter_fourth_state(const scheme *s, size_t i) {
    const vec k3 = s->k3[i];
    s->stage_v[i] = v_fma(s->whole, k3, s->v[i]);
    s->k2[i] = v_add(s->k2[i], k3);
}
static inline void enter_end_state(const scheme *s, size_t i) {
    s->v[i] = v_fma(s->sixth, v_fma(v_set(2.0), s->k2[i], v_add(s->k1[i], s->k3[i])), s->v[i]);
}

#endif
