/// The elementary functions of the kernels, inlined, the same bits everywhere. Their errors are measured by
/// tests/unit/base/test_elementary.c.
#ifndef BASE_ELEMENTARY_H
#define BASE_ELEMENTARY_H

#include "vector.h"

/// 1/a for normal a with a normal reciprocal, by multiply-adds where the divider is the bottleneck: a seed from the bits of a
/// (relative error e below 0.06), then twice r (1 + e)(1 + e^2), which leaves e^4.
static inline vec v_reciprocal(vec a) {
    vec r = v_seed(0x7fde623822fc16e6, a);
    for (int i = 0; i < 2; i++) {
        const vec e = v_fnma(a, r, v_set(1.0)), near = v_fma(r, e, r);
        r = v_fma(near, v_mul(e, e), near);
    }
    return r;
}

/// 1/sqrt(a) for normal a > 0, not a number for a <= 0: a seed from the bits of a (error e of a r^2 below 0.07), then
/// twice the series of 1/sqrt(1 - e) up to e^3.
static inline vec v_inverse_root(vec a) {
    vec r = v_seed_half(0x5fe6eb50c7b537a9, a);
    for (int i = 0; i < 2; i++) {
        const vec e = v_fnma(v_mul(a, r), r, v_set(1.0));
        const vec series = v_fma(v_fma(v_set(0.3125), e, v_set(0.375)), e, v_set(0.5));
        r = v_fma(v_mul(r, e), series, r);
    }
    return v_select(v_less(v_set(0.0), a), r, v_set(NAN));
}

/// atan(y/x) for x > 0 and any y, without a division before the angle is reduced.
///
/// The angle is measured from the nearest of 0, pi/4 and pi/2, found by comparison with tan(pi/8) and tan(3 pi/8); what is left
/// lies within pi/8, where a minimax polynomial of ten terms has a relative error of 3.6e-17. The error of the whole is
/// below 2.5 units in the last place: half a unit each for the difference, the sum, the quotient, the polynomial and the last
/// addition (2.1 measured).
static inline vec v_arctan_quotient(vec y, vec x) {
    const vec size = v_abs(y);
    const vec_mask middle = v_less(v_mul(v_set(0x1.a827999fcef32p-2), x), size);
    const vec_mask high = v_less(v_mul(v_set(0x1.3504f333f9de6p+1), x), size);
    vec numerator = v_select(middle, v_sub(size, x), size);
    vec denominator = v_select(middle, v_add(size, x), x);
    numerator = v_select(high, v_sub(v_set(0.0), x), numerator);
    denominator = v_select(high, size, denominator);
    // The centre in two parts, so that pi/4 and pi/2 are exact enough.
    vec centre = v_select(middle, v_set(0x1.921fb54442d18p-1), v_set(0.0));
    vec centre_low = v_select(middle, v_set(0x1.1a62633145c07p-55), v_set(0.0));
    centre = v_select(high, v_set(0x1.921fb54442d18p+0), centre);
    centre_low = v_select(high, v_set(0x1.1a62633145c07p-54), centre_low);
    const vec z = v_div(numerator, denominator);
    const vec u = v_mul(z, z), u2 = v_mul(u, u), u4 = v_mul(u2, u2);
    const vec p01 = v_fma(u, v_set(0x1.9999999949591p-3), v_set(-0x1.5555555555317p-2));
    const vec p23 = v_fma(u, v_set(0x1.c71c65ccd3f69p-4), v_set(-0x1.24924905743e5p-3));
    const vec p45 = v_fma(u, v_set(0x1.3afc32143df6bp-4), v_set(-0x1.745bc2f2036d0p-4));
    const vec p67 = v_fma(u, v_set(0x1.d253e722db8aap-5), v_set(-0x1.1005137c53d01p-4));
    const vec p89 = v_fma(u, v_set(0x1.5c499b265fce1p-6), v_set(-0x1.651538dff7b49p-5));
    const vec p03 = v_fma(u2, p23, p01), p47 = v_fma(u2, p67, p45);
    const vec p = v_fma(u4, v_fma(u4, p89, p47), p03);
    const vec angle = v_add(centre, v_add(z, v_fma(v_mul(z, u), p, centre_low)));
    return v_copysign(angle, y);
}

#endif
