/// The derivative of a rub's force on its station (rub_kernel.h).
///
/// With N/r = K(1 - gap/r) + D (x x' + y y')/r^2 and the friction s f, s the sign of the slip v_t,
///
///     a = -(N/r) (x - s f y, s f x + y),    ds/dv_t = v_0^2/(v_t^2 + v_0^2)^(3/2), 0 for a sharp sign.
#ifndef ROTOR_RUB_TANGENT_H
#define ROTOR_RUB_TANGENT_H

#include "elements/tangent.h"
#include "rub_kernel.h"

/// Computes the derivatives of N/r in contact.
static inline void rub_push_tangent(const element *rub, size_t stride, const vec *number, const rub_place *p,
                                    vec by[4]) {
    const vec over = v_div(v_set(1.0), p->r), over_square = v_mul(over, over);
    vec radial = v_mul(v_mul(number[RUB_STIFFNESS * stride], number[RUB_GAP * stride]), v_mul(over_square, over));
    by[2] = by[3] = v_set(0.0);
    if (rub_damped(rub)) {
        const vec damping = v_mul(number[RUB_DAMPING * stride], over_square);
        const vec along = v_fma(p->x, p->vx, v_mul(p->y, p->vy));
        radial = v_fnma(v_mul(v_set(2.0), damping), v_mul(along, over_square), radial);
        by[0] = v_fma(radial, p->x, v_mul(damping, p->vx));
        by[1] = v_fma(radial, p->y, v_mul(damping, p->vy));
        by[2] = v_mul(damping, p->x);
        by[3] = v_mul(damping, p->y);
    } else {
        by[0] = v_mul(radial, p->x);
        by[1] = v_mul(radial, p->y);
    }
}

/// Computes the derivatives of the friction s f with a gradual sign.
static inline void rub_friction_tangent(size_t stride, const vec *number, const rub_place *p, vec by[4]) {
    const vec slip = rub_slip(p, stride, number), speed = number[RUB_SLIP_SPEED * stride];
    const vec square = v_fma(slip, slip, v_mul(speed, speed));
    const vec size = v_mul(square, v_sqrt(square)), over = v_div(v_set(1.0), p->r);
    const vec steep =
        v_select(v_less(v_set(0.0), size), v_div(v_mul(speed, speed), v_max(size, v_set(0x1p-1022))), v_set(0.0));
    const vec slope = v_mul(v_mul(number[RUB_FRICTION * stride], steep), over);
    const vec turn = v_mul(v_mul(v_fms(p->x, p->vy, v_mul(p->y, p->vx)), over), over);
    by[0] = v_mul(slope, v_fnma(turn, p->x, p->vy));
    by[1] = v_mul(v_sub(v_set(0.0), slope), v_fma(turn, p->y, p->vx));
    by[2] = v_mul(v_sub(v_set(0.0), slope), p->y);
    by[3] = v_mul(slope, p->x);
}

/// Returns true if any lane is in contact, and then fills `tangent` with the derivatives, zero in the other lanes.
static inline int rub_tangent(const element *rub, size_t stride, const vec *number, const vec *sides, const vec *q,
                              const vec *v, tangent_block *tangent) {
    rub_place p;
    if (!rub_meet(rub, stride, number, sides, q, v, &p)) return 0;
    // Lanes in which damping would pull the stator are not in contact either.
    const vec_mask touching = sides ? p.touching : v_less(v_set(0.0), p.push);
    const vec zero = v_set(0.0), f = rub_friction(rub, stride, number, sides, &p);
    const vec along_x = v_fnma(f, p.y, p.x), along_y = v_fma(f, p.x, p.y);
    vec push[4], friction[4] = {zero, zero, zero, zero};
    rub_push_tangent(rub, stride, number, &p, push);
    if (rub_slips(rub) && !(sides && rub_sharp(rub))) rub_friction_tangent(stride, number, &p, friction);
    for (int i = 0; i < 4; i++) {
        const vec own_x = i == 0 ? v_set(1.0) : i == 1 ? v_sub(zero, f) : zero;
        const vec own_y = i == 0 ? f : i == 1 ? v_set(1.0) : zero;
        const vec by_x = v_fma(push[i], along_x, v_mul(p.push, v_fnma(friction[i], p.y, own_x)));
        const vec by_y = v_fma(push[i], along_y, v_mul(p.push, v_fma(friction[i], p.x, own_y)));
        tangent->x[i] = v_select(touching, v_sub(zero, by_x), zero);
        tangent->y[i] = v_select(touching, v_sub(zero, by_y), zero);
    }
    return 1;
}

#endif
