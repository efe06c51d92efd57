/// A stator ring that a station touches when its displacement r exceeds the gap: elastic, with Coulomb friction.
///
/// Normal force N = k (r - gap), friction f N against the sliding of the rotor's surface. For a surface that moves
/// counter-clockwise past the stator (v_t > 0)
///
///     (Fx, Fy) = -k (1 - gap/r) [1 -f; f 1] (x, y),      v_t = R omega + (x y' - y x')/r.
///
/// `law: paper` keeps this for every motion, as the paper of 2015 (eq. 3) does; `law: slip` gives the friction the sign
/// of v_t, so that backward whirl settles to rolling where v_t = 0 (Black 1968); with a slip speed v_0 the sign grows as
/// v_t/sqrt(v_t^2 + v_0^2).
#ifndef ROTOR_RUB_KERNEL_H
#define ROTOR_RUB_KERNEL_H

#include "element.h"
#include "vector.h"

/// Gap, k/(m omega^2), f, R (the surface's speed by tau), v_0, all in length scales.
enum { RUB_GAP, RUB_STIFFNESS, RUB_FRICTION, RUB_SURFACE, RUB_SLIP_SPEED, RUB_NEWTONS, RUB_NUMBERS };
enum { RUB_LAW_PAPER, RUB_LAW_SLIP };

/// The sign of the slip v_t = w/r, w = R r + x vy - y vx: -1 to 1.
static inline vec slip_sign(vec slip, vec slip_speed) {
    const vec size = v_sqrt(v_fma(slip, slip, v_mul(slip_speed, slip_speed)));
    return v_select(v_less(v_set(0.0), size), v_div(slip, v_max(size, v_set(0x1p-1022))), v_set(0.0));
}

static inline void rub_kernel(const element *rub, size_t stride, const vec *number, const vec *q, const vec *v,
                              vec *a) {
    const size_t i = 2 * rub->station[0] * stride, j = i + stride;
    const vec x = q[i], y = q[j];
    const vec gap = number[RUB_GAP * stride];
    const vec square = v_fma(x, x, v_mul(y, y));
    const vec_mask touching = v_less(v_mul(gap, gap), square);
    if (!v_any(touching)) return;
    const vec r = v_sqrt(v_select(touching, square, v_set(1.0)));
    const vec depth = v_sub(v_set(1.0), v_div(gap, r));
    const vec push = v_select(touching, v_mul(number[RUB_STIFFNESS * stride], depth), v_set(0.0));
    vec f = number[RUB_FRICTION * stride];
    if (rub->law == RUB_LAW_SLIP) {
        const vec transverse = v_div(v_fms(x, v[j], v_mul(y, v[i])), r);
        f = v_mul(f, slip_sign(v_add(number[RUB_SURFACE * stride], transverse), number[RUB_SLIP_SPEED * stride]));
    }
    a[i] = v_fnma(push, v_fnma(f, y, x), a[i]);
    a[j] = v_fnma(push, v_fma(f, x, y), a[j]);
}

#endif
