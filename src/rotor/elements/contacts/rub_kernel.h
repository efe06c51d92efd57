/// A stator ring that a station touches when its displacement r exceeds the gap: elastic, with Coulomb friction.
///
/// Normal force N = k (r - gap) + c r', never below zero (no adhesion), and friction f N against the sliding of the
/// rotor's surface. For a surface that moves counter-clockwise past the stator (v_t > 0; else -f)
///
///     (Fx, Fy) = -(N/r) [1 -f; f 1] (x, y),      v_t = R omega + (x y' - y x')/r.
///
/// `law: paper` keeps this for every motion, as the paper of 2015 (eq. 3) does; `law: slip` gives the friction the sign
/// of v_t, so that backward whirl settles to rolling where v_t = 0 (Black 1968); with a slip speed v_0 the sign grows
/// as v_t/sqrt(v_t^2 + v_0^2).
///
/// The law changes where r - gap changes sign; with damping also where N does; with a sharp sign of friction also where
/// v_t does. These functions are the switches, in this order. A rub is in contact where the first two are positive.
#ifndef ROTOR_RUB_KERNEL_H
#define ROTOR_RUB_KERNEL_H

#include "../../element.h"
#include "vector.h"

/// Numbers, in length scales: gap; k/(m omega^2); c/(m omega); f; R (the surface's speed by tau); v_0. Then newtons of
/// a unit of N; the square of the gap; R with the sign of the rotation, 0 if it is unknown; a length scale in metres;
/// the power in W of 1 N that slides at one length scale by tau.
enum {
    RUB_GAP,
    RUB_STIFFNESS,
    RUB_DAMPING,
    RUB_FRICTION,
    RUB_SURFACE,
    RUB_SLIP_SPEED,
    RUB_NEWTONS,
    RUB_GAP_SQUARE,
    RUB_LEVER,
    RUB_METRES,
    RUB_WATTS,
    RUB_NUMBERS
};

/// Bits of the law: which friction, whether the contact is damped, and whether friction jumps where the slip reverses.
enum { RUB_LAW_PAPER, RUB_LAW_SLIP, RUB_DAMPED = 2, RUB_SHARP = 4 };

static inline int rub_slips(const element *rub) {
    return (rub->law & RUB_LAW_SLIP) != 0;
}
static inline int rub_damped(const element *rub) {
    return (rub->law & RUB_DAMPED) != 0;
}
/// Returns true if friction jumps where the slip reverses.
static inline int rub_sharp(const element *rub) {
    return (rub->law & RUB_SHARP) != 0;
}
static inline size_t rub_slip_switch(const element *rub) {
    return rub_damped(rub) ? 2 : 1;
}
static inline size_t rub_switch_count(const element *rub) {
    return rub_slip_switch(rub) + (rub_sharp(rub) ? 1 : 0);
}

/// State of a contact: displacement and normal force.
typedef struct rub_place {
    vec x, y, vx, vy;
    vec_mask touching;
    vec r;    ///< displacement; 1 without contact
    vec push; ///< N/r; 0 without contact
} rub_place;

static inline vec_mask rub_touching(const element *rub, size_t stride, const vec *number, const vec *sides,
                                    vec square) {
    if (!sides) return v_less(number[RUB_GAP_SQUARE * stride], square);
    return v_less(v_set(0.0), rub_damped(rub) ? v_min(sides[0], sides[stride]) : sides[0]);
}

/// Returns true if any lane is in contact, and then fills `place`. If `sides` is given, N follows the law of contact
/// even where it is negative.
VECTOR_INLINE int rub_meet(const element *rub, size_t stride, const vec *number, const vec *sides, const vec *q,
                           const vec *v, rub_place *place) {
    const size_t i = rub->port[0] * stride, j = rub->port[1] * stride;
    const vec x = q[i], y = q[j], zero = v_set(0.0), one = v_set(1.0);
    const vec square = v_fma(x, x, v_mul(y, y));
    const vec_mask touching = rub_touching(rub, stride, number, sides, square);
    if (!v_any(touching)) return 0;
    const vec r = v_sqrt(v_select(touching, square, one));
    vec push = v_mul(number[RUB_STIFFNESS * stride], v_sub(one, v_div(number[RUB_GAP * stride], r)));
    if (rub_damped(rub)) {
        const vec along = v_fma(x, v[i], v_mul(y, v[j]));
        push = v_add(push, v_div(v_mul(number[RUB_DAMPING * stride], along), v_select(touching, square, one)));
        if (!sides) push = v_max(zero, push);
    }
    *place = (rub_place){x, y, v[i], v[j], touching, r, v_select(touching, push, zero)};
    return 1;
}

/// Returns the sign of the slip v_t: -1 to 1.
static inline vec slip_sign(vec slip, vec slip_speed) {
    const vec size = v_sqrt(v_fma(slip, slip, v_mul(slip_speed, slip_speed)));
    return v_select(v_less(v_set(0.0), size), v_div(slip, v_max(size, v_set(0x1p-1022))), v_set(0.0));
}

static inline vec rub_slip(const rub_place *p, size_t stride, const vec *number) {
    const vec transverse = v_div(v_fms(p->x, p->vy, v_mul(p->y, p->vx)), p->r);
    return v_add(number[RUB_SURFACE * stride], transverse);
}

/// Returns the coefficient of friction with the sign that the law gives it.
VECTOR_INLINE vec rub_friction(const element *rub, size_t stride, const vec *number, const vec *sides,
                               const rub_place *p) {
    const vec f = number[RUB_FRICTION * stride];
    if (!rub_slips(rub)) return f;
    if (sides && rub_sharp(rub)) return v_mul(f, sides[rub_slip_switch(rub) * stride]);
    return v_mul(f, slip_sign(rub_slip(p, stride, number), number[RUB_SLIP_SPEED * stride]));
}

/// Adds the force. If the sides of the switches are given, the laws are those of these sides; otherwise the state
/// decides.
VECTOR_INLINE void rub_kernel(const element *rub, size_t stride, const vec *number, const vec *sides, const vec *q,
                              const vec *v, vec *a) {
    const size_t i = rub->port[0] * stride, j = rub->port[1] * stride;
    rub_place p;
    if (!rub_meet(rub, stride, number, sides, q, v, &p)) return;
    const vec f = rub_friction(rub, stride, number, sides, &p);
    a[i] = v_fnma(p.push, v_fnma(f, p.y, p.x), a[i]);
    a[j] = v_fnma(p.push, v_fma(f, p.x, p.y), a[j]);
}

/// Returns the normal force in newtons.
static inline vec rub_normal(const element *rub, size_t stride, const vec *number, const vec *q, const vec *v) {
    rub_place p;
    if (!rub_meet(rub, stride, number, NULL, q, v, &p)) return v_set(0.0);
    return v_mul(number[RUB_NEWTONS * stride], v_mul(p.push, p.r));
}

/// Computes torque and power of the friction, the two rows of `out` (element_kernels.contact). They are NaN if friction
/// acts and the radius is unknown.
static inline void rub_rubbing(const element *rub, size_t stride, const vec *number, const vec *q, const vec *v,
                               vec *out) {
    const vec zero = v_set(0.0), lever = number[RUB_LEVER * stride], none = v_div(zero, zero);
    rub_place p;
    out[0] = out[stride] = zero;
    if (!rub_meet(rub, stride, number, NULL, q, v, &p)) return;
    const vec normal = v_mul(number[RUB_NEWTONS * stride], v_mul(p.push, p.r));
    const vec force = v_mul(normal, rub_friction(rub, stride, number, NULL, &p));
    // Lanes without contact get 0, independently of their neighbours.
    const vec unknown = v_select(v_less(zero, v_abs(force)), none, zero);
    const vec_mask known = v_less(zero, v_abs(lever));
    const vec torque = v_mul(force, v_mul(number[RUB_METRES * stride], lever));
    const vec power = v_mul(force, v_mul(number[RUB_WATTS * stride], rub_slip(&p, stride, number)));
    out[0] = v_select(known, torque, unknown);
    out[stride] = v_select(known, power, unknown);
}

/// Computes the switching functions and, unless `rates` is NULL, their derivatives by time along (v, a). The slip is
/// multiplied by r, which makes it smooth at the centre.
static inline void rub_switches(const element *rub, size_t stride, const vec *number, const vec *q, const vec *v,
                                const vec *a, vec *values, vec *rates) {
    const size_t i = rub->port[0] * stride, j = rub->port[1] * stride, slip = rub_slip_switch(rub) * stride;
    const vec x = q[i], y = q[j], vx = v[i], vy = v[j];
    const vec stiffness = number[RUB_STIFFNESS * stride], damping = number[RUB_DAMPING * stride];
    const vec r = v_max(v_sqrt(v_fma(x, x, v_mul(y, y))), v_set(0x1p-1022));
    const vec growth = v_div(v_fma(x, vx, v_mul(y, vy)), r);
    const vec depth = v_sub(r, number[RUB_GAP * stride]);
    values[0] = depth;
    if (rub_damped(rub)) values[stride] = v_fma(stiffness, depth, v_mul(damping, growth));
    if (rub_sharp(rub)) values[slip] = v_fma(number[RUB_SURFACE * stride], r, v_fms(x, vy, v_mul(y, vx)));
    if (!rates) return;
    rates[0] = growth;
    if (rub_damped(rub)) {
        const vec speeds = v_fnma(growth, growth, v_fma(vx, vx, v_mul(vy, vy)));
        const vec second = v_div(v_add(speeds, v_fma(x, a[i], v_mul(y, a[j]))), r);
        rates[stride] = v_fma(stiffness, growth, v_mul(damping, second));
    }
    if (rub_sharp(rub)) rates[slip] = v_fma(number[RUB_SURFACE * stride], growth, v_fms(x, a[j], v_mul(y, a[i])));
}

#endif
