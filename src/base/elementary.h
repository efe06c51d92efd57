/// The elementary functions of the kernels, inlined, the same bits everywhere. Their errors are measured by
/// tests/unit/base/test_elementary.c.
#ifndef BASE_ELEMENTARY_H
#define BASE_ELEMENTARY_H

#include "vector.h"

/// Computes sqrt(3/a) for normal a > 0 by multiply-adds, for code in which the divider is the bottleneck. Three steps:
/// a seed r from the bits of a, with y = a r^2 from 0.7901 to 0.8898; a factor for r, the cubic of y with the least
/// relative error (4.3e-7), after which a r^2 = 3 - e; the series of 1/sqrt(1 - e/3) up to e^2. With z = y minus the
/// place where its square term vanishes, the cubic is -(z^3 + d z) + g: the seed is chosen so that the factor of z^3 is
/// -1.
static inline vec v_root_of_3_over(vec a) {
    vec r = v_seed_half(0x5fe4a4740bc00000, a);
    const vec z = v_fma(v_mul(a, r), r, v_set(-0x1.2cf762c990cfdp+0));
    const vec square = v_fma(z, z, v_set(0x1.92e5d0ddc640cp-1));
    r = v_mul(r, v_fnma(square, z, v_set(0x1.967f5d60dab10p+0)));
    const vec e = v_fnma(v_mul(a, r), r, v_set(3.0));
    return v_fma(v_mul(r, e), v_fma(v_set(0x1.5555555555555p-5), e, v_set(0x1.5555555555555p-3)), r);
}

/// Computes 1/sqrt(a) for normal a > 0, by multiply-adds.
static inline vec v_over_root(vec a) {
    return v_mul(v_set(0.57735026918962576451), v_root_of_3_over(a));
}

/// Computes the angle a, from -pi/2 to pi/2, from half the cosine and half the sine of 2a. It serves as atan(y/x) for x
/// > 0: x^2/(x^2 + y^2) - 1/2 and x y/(x^2 + y^2) are half the cosine and half the sine, and need one division but no
/// root. Symmetries move a to within pi/8 of pi/8, where
///
///     a - pi/8 = w F(v),   w = (sin 2a - cos 2a)/2 = sin(2a - pi/4)/sqrt 2,   v = 1/sqrt 2 - (sin 2a + cos 2a)/2.
///
/// The minimax polynomial F leaves an error of 3.9e-17 in the angle. The error of the result is below 2^-51, two units
/// in the last place of an angle above 1.
static inline vec v_half_angle(vec half_cosine, vec half_sine) {
    const vec c = v_abs(half_cosine), s = v_abs(half_sine);
    const vec v = v_sub(v_set(0x1.6a09e667f3bcdp-1), v_add(s, c));
    const vec v2 = v_mul(v, v), v4 = v_mul(v2, v2);
    const vec F01 = v_fma(v, v_set(0x1.5555555552537p-2), v_set(0x1.6a09e667f3bdbp-1));
    const vec F23 = v_fma(v, v_set(0x1.d41d40846cbf2p-4), v_set(0x1.822cb182e004dp-3));
    const vec F45 = v_fma(v, v_set(0x1.7a3fe37d33d91p-5), v_set(0x1.263a988873f90p-4));
    const vec F67 = v_fma(v, v_set(0x1.41036293aab9fp-6), v_set(0x1.ee6af396cd487p-6));
    const vec F89 = v_fma(v, v_set(0x1.07cb69bc3cb8ap-8), v_set(0x1.e431ede60c503p-7));
    const vec F03 = v_fma(v2, F23, F01), F47 = v_fma(v2, F67, F45);
    const vec F810 = v_fma(v2, v_set(0x1.cbd66ecd8109dp-7), F89);
    const vec F = v_fma(v4, v_fma(v4, F810, F47), F03);
    const vec below = v_fnma(v_sub(s, c), F, v_set(0x1.921fb54442d18p-2)); // pi/4 less the angle
    return v_flip(v_sub(v_set(0x1.921fb54442d18p-1), v_flip(below, half_cosine)), half_sine);
}

/// Rounds a to the nearest whole number, for |a| < 2^51.
static inline vec v_round(vec a) {
    const vec magic = v_set(0x1.8p52);
    return v_sub(v_add(a, magic), magic);
}

/// Remainders of the series after their first terms, for z = r^2 and |r| up to pi/4: sin r = r + r z s, cos r = 1 - z/2
/// + z^2 c. Minimax polynomials, six terms of each function, with relative errors of 2^-57.9 and 2^-63.9.
static inline void v_sincos_tails(vec z, vec *s, vec *c) {
    const vec z2 = v_mul(z, z), z4 = v_mul(z2, z2);
    const vec s12 = v_fma(z, v_set(-0x1.a01a019bfbcc5p-13), v_set(0x1.111111110f7c0p-7));
    const vec s34 = v_fma(z, v_set(-0x1.ae5e59063c7b2p-26), v_set(0x1.71de3565e964dp-19));
    const vec s14 = v_fma(z4, v_set(0x1.5d8f5bd903f93p-33), v_fma(z2, s34, s12));
    const vec c01 = v_fma(z, v_set(-0x1.6c16c16c14f7fp-10), v_set(0x1.555555555554bp-5));
    const vec c23 = v_fma(z, v_set(-0x1.27e4f7e9640b1p-22), v_set(0x1.a01a019c8273bp-16));
    const vec c45 = v_fma(z, v_set(-0x1.8fa417db28766p-37), v_set(0x1.1ee9d6bf3773ep-29));
    *s = v_fma(z, s14, v_set(-0x1.5555555555548p-3));
    *c = v_fma(z4, c45, v_fma(z2, c23, c01));
}

/// sin and cos of an angle r + low with |r| up to pi/4 and low below a unit in the last place of r.
static inline void v_sincos_near(vec r, vec low, vec *sine, vec *cosine) {
    const vec one = v_set(1.0), half = v_set(0.5), z = v_mul(r, r);
    vec s, c;
    v_sincos_tails(z, &s, &c);
    *sine = v_add(r, v_fma(v_mul(r, z), s, v_fnma(v_mul(half, z), low, low)));
    // Adds the rounding error of 1 - z/2 to the remainder.
    const vec drop = v_mul(half, z), first = v_sub(one, drop);
    *cosine = v_add(first, v_add(v_sub(v_sub(one, first), drop), v_fnma(r, low, v_mul(v_mul(z, z), c))));
}

/// sin and cos of an angle r with |r| up to pi/4, to a unit in the last place of 1 (measured:
/// tests/unit/base/test_elementary.c).
static inline void v_sincos_small(vec r, vec *sine, vec *cosine) {
    const vec z = v_mul(r, r);
    vec s, c;
    v_sincos_tails(z, &s, &c);
    *sine = v_fma(v_mul(r, z), s, r);
    *cosine = v_fma(v_mul(z, z), c, v_fnma(v_set(0.5), z, v_set(1.0)));
}

/// sin and cos of |t| up to 10000. Quarter turns are subtracted in three parts, of which the first two have exact
/// products with their number. The error is below 1 unit in the last place for 0 <= t <= 8 pi, and below 2^-52 beyond
/// (measured: tests/unit/base/test_elementary.c).
static inline void v_sincos(vec t, vec *sine, vec *cosine) {
    const vec zero = v_set(0.0), quarters = v_round(v_mul(t, v_set(0x1.45f306dc9c883p-1)));
    const vec near = v_fnma(quarters, v_set(0x1.921fb54400000p+0), t);
    const vec middle = v_mul(quarters, v_set(0x1.0b4611a600000p-34)), r = v_sub(near, middle);
    const vec low = v_fnma(quarters, v_set(0x1.3198a2e037073p-69), v_sub(v_sub(near, r), middle));
    vec s, c;
    v_sincos_near(r, low, &s, &c);
    // turn: quarter turns modulo 4, from -2 to 2. After an odd number of them sin and cos have changed places.
    const vec turn = v_fnma(v_set(4.0), v_round(v_mul(v_set(0.25), quarters)), quarters);
    const vec_mask second = v_less(v_set(1.5), v_abs(turn)),
                   odd = v_less(v_abs(v_sub(v_abs(turn), v_set(1.0))), v_set(0.5));
    const vec rising = v_select(odd, c, s), falling = v_select(odd, s, c);
    const vec_mask back = v_less(turn, v_set(-0.5)), ahead = v_less(v_set(0.5), turn);
    *sine = v_select(second, v_sub(zero, rising), v_select(back, v_sub(zero, rising), rising));
    *cosine = v_select(second, v_sub(zero, falling), v_select(ahead, v_sub(zero, falling), falling));
}

/// ln a for normal a > 0 up to 2^1023; not a number for others. With a = m 2^k, m from 1/sqrt 2 to sqrt 2, f = m - 1
/// and s = f/(2 + f), ln m = 2 artanh s = f - s (f - s^2 P(s^2)), where P is the minimax polynomial of the terms after
/// 2s. Its relative error is 2^-59.4; ln 2 is split so that k times its first part is exact.
static inline vec v_log(vec a) {
    const vec k = v_exponent(v_mul(a, v_set(0x1.6a09e667f3bcdp+0)));
    const vec f = v_sub(v_mul(a, v_power_of_2(v_sub(v_set(0.0), k))), v_set(1.0)), s = v_div(f, v_add(v_set(2.0), f));
    const vec z = v_mul(s, s), z2 = v_mul(z, z), z4 = v_mul(z2, z2);
    const vec P01 = v_fma(z, v_set(0x1.999999997fdc8p-2), v_set(0x1.5555555555592p-1));
    const vec P23 = v_fma(z, v_set(0x1.c71c5208b23f2p-3), v_set(0x1.24924941f13a4p-2));
    const vec P45 = v_fma(z, v_set(0x1.39a1b28db63d7p-3), v_set(0x1.74663f2479389p-3));
    const vec P46 = v_fma(z2, v_set(0x1.2f05c8419c795p-3), P45), P = v_fma(z4, P46, v_fma(z2, P23, P01));
    const vec rest = v_fnma(k, v_set(0x1.ef35793c76730p-45), v_mul(s, v_fnma(z, P, f)));
    const vec log = v_add(v_mul(k, v_set(0x1.62e42fefa3800p-1)), v_sub(f, rest));
    return v_select(v_less(v_set(0.0), a), log, v_set(NAN));
}

/// e^a: 0 below -708, infinite above 709. With a = k ln 2 + r, |r| up to (ln 2)/2, e^r = 1 + r + r^2 Q(r), where Q is a
/// minimax polynomial with a relative error of 2^-57.9 of the whole.
static inline vec v_exp(vec a) {
    const vec k = v_round(v_mul(a, v_set(0x1.71547652b82fep+0)));
    const vec near = v_fnma(k, v_set(0x1.62e42fefa3800p-1), a), drop = v_mul(k, v_set(0x1.ef35793c76730p-45));
    const vec r = v_sub(near, drop), low = v_sub(v_sub(near, r), drop); // rounding error of r
    const vec r2 = v_mul(r, r), r4 = v_mul(r2, r2);
    const vec Q01 = v_fma(r, v_set(0x1.55555555554fap-3), v_set(0x1.000000000000ap-1));
    const vec Q23 = v_fma(r, v_set(0x1.1111111127bddp-7), v_set(0x1.5555555550884p-5));
    const vec Q45 = v_fma(r, v_set(0x1.a01a012a57aa9p-13), v_set(0x1.6c16c18428ac9p-10));
    const vec Q67 = v_fma(r, v_set(0x1.71df25571222ep-19), v_set(0x1.a0199a0fa45cap-16));
    const vec Q89 = v_fma(r, v_set(0x1.ad7f61af5197bp-26), v_set(0x1.28ad7029b0c8dp-22));
    const vec Q49 = v_fma(r4, Q89, v_fma(r2, Q67, Q45)), Q = v_fma(r4, Q49, v_fma(r2, Q23, Q01));
    const vec power = v_mul(v_add(v_set(1.0), v_add(r, v_fma(r2, Q, low))), v_power_of_2(k));
    const vec some = v_select(v_less(a, v_set(-708.0)), v_set(0.0), power);
    return v_select(v_less(v_set(709.0), a), v_set(INFINITY), some);
}

/// The ninth root of normal a > 0 up to 2^1023. With a = m 2^k a quadratic of m and the cubic of the fraction of
/// q = -(log2 a)/9 make z, which is a^(-1/9) within 5.3e-4; then a^(1/9) = a z^8 (1 - e)^(-8/9), e = 1 - a z^9, whose
/// series up to e^6 has an error of 4.1e-17. Most of the error comes from the rounding of z^8.
static inline vec v_ninth_root(vec a) {
    const vec k = v_exponent(a), m = v_mul(a, v_power_of_2(v_sub(v_set(0.0), k)));
    const vec curve = v_fma(m, v_set(0x1.30b22cc8e5453p-5), v_set(-0x1.c5c979892d38cp-3));
    const vec q = v_fma(k, v_set(-0x1.c71c71c71c71cp-4), v_fma(m, curve, v_set(0x1.782d7405aa1f9p-3)));
    const vec whole = v_round(q), f = v_sub(q, whole), f2 = v_mul(f, f);
    const vec rise = v_fma(f, v_set(0x1.62e2d1675f711p-1), v_set(0x1.fff61c8d247ecp-1));
    const vec z =
        v_mul(v_fma(f2, v_fma(f, v_set(0x1.c96d5de3cd482p-5), v_set(0x1.f0ecf78898eebp-3)), rise), v_power_of_2(whole));
    const vec z2 = v_mul(z, z), z4 = v_mul(z2, z2), root = v_mul(a, v_mul(z4, z4)), e = v_fnma(root, z, v_set(1.0));
    const vec e2 = v_mul(e, e), s12 = v_fma(e, v_set(0x1.add3c0ca4587ep-1), v_set(0x1.c71c71c71c71cp-1));
    const vec s34 = v_fma(e, v_set(0x1.926902fa78ee6p-1), v_set(0x1.9de85ad5be370p-1));
    const vec s56 = v_fma(e, v_set(0x1.822e6a85c1cd6p-1), v_set(0x1.8977bea5430b3p-1));
    const vec series = v_fma(e2, v_fma(e2, s56, s34), s12);
    return v_fma(v_mul(root, e), series, root);
}

/// a^b for normal a > 0 up to 2^1023; not a number for others. Its error of up to 2 (1 + |b ln a|) units in the last
/// place comes from the rounding of b ln a. For b = 1/2 it is a square root, rounded once, which is fast if b is 1/2 in
/// all lanes.
static inline vec v_pow(vec a, vec b) {
    const vec_mask other = v_less(v_set(0.0), v_abs(v_sub(b, v_set(0.5)))), above = v_less(v_set(0.0), a);
    const vec root = v_select(above, v_sqrt(a), v_set(NAN));
    return v_any(other) ? v_select(other, v_exp(v_mul(b, v_log(a))), root) : root;
}

#endif
