/// The numbers of kernels that are written once and compiled twice: for vectors, and for duals over vectors, which
/// carry along the derivatives by DUAL_INPUTS inputs. Included with NUMBERS_DUAL defined or not. A kernel names its
/// functions KERNEL(name) and its numbers num.
///
/// Comparisons look at values. A dual chosen by a mask has the derivative of the chosen one.
#ifndef ROTOR_NUMBERS_H
#define ROTOR_NUMBERS_H

#include "elementary.h"
#include "vector.h"

typedef struct dual {
    vec value, by[DUAL_INPUTS];
} dual;

#define FOR_INPUTS for (int i = 0; i < DUAL_INPUTS; i++)

VECTOR_INLINE dual dual_of(vec value) {
    dual out = {.value = value};
    FOR_INPUTS out.by[i] = v_set(0.0);
    return out;
}
VECTOR_INLINE dual dual_set(double value) {
    return dual_of(v_set(value));
}
/// Returns the input with index `input`, whose derivative by itself is 1.
VECTOR_INLINE dual dual_input(vec value, int input) {
    dual out = dual_of(value);
    out.by[input] = v_set(1.0);
    return out;
}
VECTOR_INLINE dual dual_add(dual a, dual b) {
    a.value = v_add(a.value, b.value);
    FOR_INPUTS a.by[i] = v_add(a.by[i], b.by[i]);
    return a;
}
VECTOR_INLINE dual dual_sub(dual a, dual b) {
    a.value = v_sub(a.value, b.value);
    FOR_INPUTS a.by[i] = v_sub(a.by[i], b.by[i]);
    return a;
}
VECTOR_INLINE dual dual_mul(dual a, dual b) {
    dual out = {.value = v_mul(a.value, b.value)};
    FOR_INPUTS out.by[i] = v_fma(a.by[i], b.value, v_mul(a.value, b.by[i]));
    return out;
}
/// Scales a dual by a number that depends on no input.
VECTOR_INLINE dual dual_scale(vec factor, dual a) {
    a.value = v_mul(factor, a.value);
    FOR_INPUTS a.by[i] = v_mul(factor, a.by[i]);
    return a;
}
VECTOR_INLINE dual dual_fma(dual a, dual b, dual c) {
    dual out = {.value = v_fma(a.value, b.value, c.value)};
    FOR_INPUTS out.by[i] = v_fma(a.by[i], b.value, v_fma(a.value, b.by[i], c.by[i]));
    return out;
}
VECTOR_INLINE dual dual_div(dual a, dual b) {
    const vec over = v_div(v_set(1.0), b.value);
    dual out = {.value = v_div(a.value, b.value)};
    FOR_INPUTS out.by[i] = v_mul(over, v_fnma(out.value, b.by[i], a.by[i]));
    return out;
}
/// Returns the square root of a number above 0. The root of 0 has the derivative 0.
VECTOR_INLINE dual dual_sqrt(dual a) {
    dual out = {.value = v_sqrt(a.value)};
    const vec half = v_div(v_set(0.5), v_max(out.value, v_set(0x1p-1000)));
    const vec over = v_select(v_less(v_set(0.0), out.value), half, v_set(0.0));
    FOR_INPUTS out.by[i] = v_mul(over, a.by[i]);
    return out;
}
/// Returns a power of a number above 0, with an exponent that depends on no input.
VECTOR_INLINE dual dual_pow(dual a, vec power) {
    dual out = {.value = v_pow(a.value, power)};
    const vec slope = v_mul(power, v_div(out.value, a.value));
    FOR_INPUTS out.by[i] = v_mul(slope, a.by[i]);
    return out;
}
/// Returns 1/sqrt(a) for a normal number above 0.
VECTOR_INLINE dual dual_over_root(dual a) {
    dual out = {.value = v_over_root(a.value)};
    const vec slope = v_mul(v_mul(v_set(-0.5), out.value), v_mul(out.value, out.value));
    FOR_INPUTS out.by[i] = v_mul(slope, a.by[i]);
    return out;
}
/// Returns the ninth root of a normal number above 0.
VECTOR_INLINE dual dual_ninth_root(dual a) {
    dual out = {.value = v_ninth_root(a.value)};
    const vec slope = v_div(out.value, v_mul(v_set(9.0), a.value));
    FOR_INPUTS out.by[i] = v_mul(slope, a.by[i]);
    return out;
}
VECTOR_INLINE dual dual_exp(dual a) {
    dual out = {.value = v_exp(a.value)};
    FOR_INPUTS out.by[i] = v_mul(out.value, a.by[i]);
    return out;
}
VECTOR_INLINE dual dual_select(vec_mask mask, dual yes, dual no) {
    dual out = {.value = v_select(mask, yes.value, no.value)};
    FOR_INPUTS out.by[i] = v_select(mask, yes.by[i], no.by[i]);
    return out;
}
VECTOR_INLINE vec_mask dual_less(dual a, dual b) {
    return v_less(a.value, b.value);
}
VECTOR_INLINE void dual_sincos(dual a, dual *sine, dual *cosine) {
    vec s, c;
    v_sincos(a.value, &s, &c);
    *sine = (dual){.value = s};
    *cosine = (dual){.value = c};
    FOR_INPUTS {
        sine->by[i] = v_mul(c, a.by[i]);
        cosine->by[i] = v_mul(v_sub(v_set(0.0), s), a.by[i]);
    }
}
/// Returns the angle of (x, y) for x > 0, atan(y/x).
VECTOR_INLINE vec plain_angle(vec x, vec y) {
    const vec over = v_div(v_set(1.0), v_fma(x, x, v_mul(y, y)));
    return v_half_angle(v_fms(x, v_mul(x, over), v_set(0.5)), v_mul(x, v_mul(y, over)));
}
VECTOR_INLINE dual dual_angle(dual x, dual y) {
    const vec over = v_div(v_set(1.0), v_fma(x.value, x.value, v_mul(y.value, y.value)));
    dual out = {.value = plain_angle(x.value, y.value)};
    FOR_INPUTS out.by[i] = v_mul(over, v_fms(x.value, y.by[i], v_mul(y.value, x.by[i])));
    return out;
}
VECTOR_INLINE vec dual_value(dual a) {
    return a.value;
}

#undef FOR_INPUTS

VECTOR_INLINE vec plain_of(vec value) {
    return value;
}
VECTOR_INLINE vec plain_value(vec value) {
    return value;
}
VECTOR_INLINE vec plain_scale(vec factor, vec a) {
    return v_mul(factor, a);
}
#endif

#undef num
#undef KERNEL
#undef n_of
#undef n_set
#undef n_add
#undef n_sub
#undef n_mul
#undef n_scale
#undef n_fma
#undef n_div
#undef n_sqrt
#undef n_pow
#undef n_over_root
#undef n_ninth_root
#undef n_exp
#undef n_select
#undef n_less
#undef n_sincos
#undef n_angle
#undef n_value
#ifdef NUMBERS_DUAL
#define num dual
#define KERNEL(name) name##_dual
#define n_of dual_of
#define n_set dual_set
#define n_add dual_add
#define n_sub dual_sub
#define n_mul dual_mul
#define n_scale dual_scale
#define n_fma dual_fma
#define n_div dual_div
#define n_sqrt dual_sqrt
#define n_pow dual_pow
#define n_over_root dual_over_root
#define n_ninth_root dual_ninth_root
#define n_exp dual_exp
#define n_select dual_select
#define n_less dual_less
#define n_sincos dual_sincos
#define n_angle dual_angle
#define n_value dual_value
#else
#define num vec
#define KERNEL(name) name##_plain
#define n_of plain_of
#define n_set v_set
#define n_add v_add
#define n_sub v_sub
#define n_mul v_mul
#define n_scale plain_scale
#define n_fma v_fma
#define n_div v_div
#define n_sqrt v_sqrt
#define n_pow v_pow
#define n_over_root v_over_root
#define n_ninth_root v_ninth_root
#define n_exp v_exp
#define n_select v_select
#define n_less v_less
#define n_sincos v_sincos
#define n_angle plain_angle
#define n_value plain_value
#endif
