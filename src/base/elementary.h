/// The elementary functions of the kernels, inlined, the same bits everywhere. Their errors are measured by
/// tests/unit/base/test_elementary.c.
#ifndef BASE_ELEMENTARY_H
#define BASE_ELEMENTARY_H

#include "vector.h"

/// 1/sqrt(a) for normal a > 0, by multiply-adds where the divider is the bottleneck: a seed from the bits of a (error e of
/// a r^2 below 0.07), then twice the series of 1/sqrt(1 - e) up to e^3.
static inline vec v_inverse_root(vec a) {
    vec r = v_seed_half(0x5fe6eb50c7b537a9, a);
    for (int i = 0; i < 2; i++) {
        const vec e = v_fnma(v_mul(a, r), r, v_set(1.0));
        const vec series = v_fma(v_fma(v_set(0.3125), e, v_set(0.375)), e, v_set(0.5));
        r = v_fma(v_mul(r, e), series, r);
    }
    return r;
}

/// atan(y/x) for x > 0 as the angle `centre` and what is left: atan of a quotient within tan(pi/8). The angle is measured from
/// the nearest of 0, pi/4 and pi/2, found by comparison with tan(pi/8) and tan(3 pi/8). The division is the caller's, who may
/// have others to share it with.
typedef struct arctan_fold {
    vec numerator, denominator, centre;
} arctan_fold;

static inline arctan_fold v_arctan_fold(vec y, vec x) {
    const vec size = v_abs(y), zero = v_set(0.0);
    const vec_mask middle = v_less(v_mul(v_set(0x1.a827999fcef32p-2), x), size);
    const vec_mask high = v_less(v_mul(v_set(0x1.3504f333f9de6p+1), x), size);
    return (arctan_fold){
        v_select(high, v_sub(zero, x), v_select(middle, v_sub(size, x), size)),
        v_select(high, size, v_select(middle, v_add(size, x), x)),
        v_select(high, v_set(0x1.921fb54442d18p+0), v_select(middle, v_set(0x1.921fb54442d18p-1), zero))};
}

/// From the quotient z of the fold back to the angle, with the sign of y. The minimax polynomial of ten terms has a relative
/// error of 3.6e-17; that of the whole is below 3 units in the last place: half a unit each for the difference, the sum, the
/// quotient, the polynomial, the centre and the last addition.
static inline vec v_arctan_unfold(vec z, vec centre, vec y) {
    const vec u = v_mul(z, z), u2 = v_mul(u, u), u4 = v_mul(u2, u2);
    const vec p01 = v_fma(u, v_set(0x1.9999999949591p-3), v_set(-0x1.5555555555317p-2));
    const vec p23 = v_fma(u, v_set(0x1.c71c65ccd3f69p-4), v_set(-0x1.24924905743e5p-3));
    const vec p45 = v_fma(u, v_set(0x1.3afc32143df6bp-4), v_set(-0x1.745bc2f2036d0p-4));
    const vec p67 = v_fma(u, v_set(0x1.d253e722db8aap-5), v_set(-0x1.1005137c53d01p-4));
    const vec p89 = v_fma(u, v_set(0x1.5c499b265fce1p-6), v_set(-0x1.651538dff7b49p-5));
    const vec p03 = v_fma(u2, p23, p01), p47 = v_fma(u2, p67, p45);
    const vec p = v_fma(u4, v_fma(u4, p89, p47), p03);
    return v_copysign(v_add(centre, v_fma(v_mul(z, u), p, z)), y);
}

/// a rounded to the nearest whole number, for |a| < 2^51.
static inline vec v_round(vec a) {
    const vec magic = v_set(0x1.8p52);
    return v_sub(v_add(a, magic), magic);
}

/// sin and cos of an angle r + low with |r| up to pi/4 and low below a unit in the last place of r: minimax polynomials of six
/// terms with relative errors of 2^-57.9 and 2^-63.9.
static inline void v_sincos_near(vec r, vec low, vec *sine, vec *cosine) {
    const vec one = v_set(1.0), half = v_set(0.5), z = v_mul(r, r), z2 = v_mul(z, z), z4 = v_mul(z2, z2);
    const vec s12 = v_fma(z, v_set(-0x1.a01a019bfbcc5p-13), v_set(0x1.111111110f7c0p-7));
    const vec s34 = v_fma(z, v_set(-0x1.ae5e59063c7b2p-26), v_set(0x1.71de3565e964dp-19));
    const vec s14 = v_fma(z4, v_set(0x1.5d8f5bd903f93p-33), v_fma(z2, s34, s12));
    const vec s = v_fma(z, s14, v_set(-0x1.5555555555548p-3));
    const vec c01 = v_fma(z, v_set(-0x1.6c16c16c14f7fp-10), v_set(0x1.555555555554bp-5));
    const vec c23 = v_fma(z, v_set(-0x1.27e4f7e9640b1p-22), v_set(0x1.a01a019c8273bp-16));
    const vec c45 = v_fma(z, v_set(-0x1.8fa417db28766p-37), v_set(0x1.1ee9d6bf3773ep-29));
    const vec c = v_fma(z4, c45, v_fma(z2, c23, c01));
    *sine = v_add(r, v_fma(v_mul(r, z), s, v_fnma(v_mul(half, z), low, low)));
    // What 1 - z/2 loses by rounding is added to the rest.
    const vec drop = v_mul(half, z), first = v_sub(one, drop);
    *cosine = v_add(first, v_add(v_sub(v_sub(one, first), drop), v_fnma(r, low, v_mul(z2, c))));
}

/// sin and cos of 0 <= t <= 8 pi. The quarter turns are taken off in three parts, whose products with up to 16 are exact for
/// the first two. The error is below 1 unit in the last place (measured: tests/unit/base/test_elementary.c).
static inline void v_sincos(vec t, vec *sine, vec *cosine) {
    const vec zero = v_set(0.0), quarters = v_round(v_mul(t, v_set(0x1.45f306dc9c883p-1)));
    const vec near = v_fnma(quarters, v_set(0x1.921fb54400000p+0), t);
    const vec middle = v_mul(quarters, v_set(0x1.0b4611a600000p-34)), r = v_sub(near, middle);
    const vec low = v_fnma(quarters, v_set(0x1.3198a2e037073p-69), v_sub(v_sub(near, r), middle));
    vec s, c;
    v_sincos_near(r, low, &s, &c);
    // -2, -1, 0, 1 or 2 of four quarters; after an odd number sin and cos have changed places.
    const vec turn = v_fnma(v_set(4.0), v_round(v_mul(v_set(0.25), quarters)), quarters);
    const vec_mask second = v_less(v_set(1.5), v_abs(turn)),
                   odd = v_less(v_abs(v_sub(v_abs(turn), v_set(1.0))), v_set(0.5));
    const vec rising = v_select(odd, c, s), falling = v_select(odd, s, c);
    const vec_mask back = v_less(turn, v_set(-0.5)), ahead = v_less(v_set(0.5), turn);
    *sine = v_select(second, v_sub(zero, rising), v_select(back, v_sub(zero, rising), rising));
    *cosine = v_select(second, v_sub(zero, falling), v_select(ahead, v_sub(zero, falling), falling));
}

#endif
