// A stator that a station touches where its distance r from the stator's centre exceeds the gap, and where the station
// is within the stator's arc. The normal force by the depth d = r - gap is (Hertz 1882; Hunt, Crossley 1975)
//
//     N = K d^n (1 + chi d')                              and never below zero,
//
// The friction f N acts against the sliding v_t = R omega + (x y' - y x')/r of the rotor's surface. The force is
// (Fx, Fy) = -(N/r) [1 -f; f 1] (x, y) as for a rub, with
//
//     f = sign(v_t) (f_k + (f_s - f_k) e^(-(v_t/v_s)^2)) + s_2 v_t,    sign smooth as v_t/sqrt(v_t^2 + v_0^2), or
//     f = s_0 z + s_1 z' + s_2 v_t,  z' = v_t - s_0 |v_t| z/g(v_t)
//
// for bristles (LuGre) with the deflection z, where g is the first line's bracket. The bristles spring back while
// nothing touches, z' = -(s_0/s_1) z.
//
// The switches are d, 1 + chi d', the slip times r, and the arc. A switch that a law does not use is 1.

/// Returns the distance from the centre. *over becomes its inverse, 1 at the centre.
static inline num KERNEL(distance)(const num *d, num *over) {
    const num r = n_sqrt(n_fma(d[0], d[0], n_mul(d[1], d[1]))), one = n_set(1.0);
    *over = n_div(one, n_select(n_less(n_set(0x1p-500), r), r, one));
    return r;
}

/// Returns the factor by which the normal force changes with the rate of the depth.
static inline num KERNEL(push)(const element *own, const kernel_view *view, const num *d, const num *w, num over) {
    if (!(own->law & CONTACT_LOSSY)) return n_set(1.0);
    const num growth = n_mul(n_fma(d[0], w[0], n_mul(d[1], w[1])), over);
    return n_fma(n_of(view->number[CONTACT_LOSS * view->stride]), growth, n_set(1.0));
}

static inline num KERNEL(in_arc)(const element *own, const kernel_view *view, const num *d, num r) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    if (!(own->law & CONTACT_PARTIAL)) return n_set(1.0);
    const num along =
        n_add(n_scale(number[CONTACT_ARC_X * stride], d[0]), n_scale(number[CONTACT_ARC_Y * stride], d[1]));
    return n_sub(along, n_scale(number[CONTACT_ARC_HALF * stride], r));
}

static inline void KERNEL(switches)(const element *own, const kernel_view *view, const num *d, const num *w,
                                    num *values) {
    num over;
    const num r = KERNEL(distance)(d, &over), turn = n_sub(n_mul(d[0], w[1]), n_mul(d[1], w[0]));
    values[CONTACT_DEPTH] = n_sub(r, n_of(view->number[CONTACT_GAP * view->stride]));
    values[CONTACT_PUSH] = KERNEL(push)(own, view, d, w, over);
    values[CONTACT_SLIP] = own->law & (CONTACT_SHARP | CONTACT_BRISTLES)
                               ? n_fma(n_of(view->number[CONTACT_SURFACE * view->stride]), r, turn)
                               : n_set(1.0);
    values[CONTACT_ARC] = KERNEL(in_arc)(own, view, d, r);
}

/// Returns the normal force at the distance r; *touching becomes true where the station touches the stator.
static inline num KERNEL(normal)(const element *own, const kernel_view *view, const num *d, const num *w, num r,
                                 num over, vec_mask *touching) {
    const size_t stride = view->stride;
    const vec *number = view->number, *sides = view->sides;
    const num none = n_set(0.0), depth = n_sub(r, n_of(number[CONTACT_GAP * stride]));
    const num push = KERNEL(push)(own, view, d, w, over);
    vec held = sides ? sides[CONTACT_DEPTH * stride] : n_value(depth);
    held = v_min(held, sides ? sides[CONTACT_PUSH * stride] : n_value(push));
    held = v_min(held, sides ? sides[CONTACT_ARC * stride] : n_value(KERNEL(in_arc)(own, view, d, r)));
    *touching = v_less(v_set(0.0), held);
    if (!v_any(*touching)) return none;
    // On a fixed side of a switch the depth may be slightly negative. The law continues as an odd function.
    const num size = n_select(n_less(none, depth), depth, n_sub(none, depth)), least = n_set(0x1p-800);
    const num power = own->law & CONTACT_POWERED
                          ? n_pow(n_select(n_less(least, size), size, least), number[CONTACT_POWER * stride])
                          : n_sqrt(size);
    const num force = n_scale(number[CONTACT_STIFFNESS * stride], n_mul(depth, power));
    return n_select(*touching, n_mul(force, push), none);
}

/// Returns the coefficient of friction at a slip, without its sign.
static inline num KERNEL(level)(const element *own, const kernel_view *view, num slip) {
    const size_t stride = view->stride;
    const num kinetic = n_of(view->number[CONTACT_KINETIC * stride]);
    if (!(own->law & CONTACT_FALLS)) return kinetic;
    const num over = n_scale(view->number[CONTACT_STRIBECK * stride], slip);
    const num excess = n_exp(n_sub(n_set(0.0), n_mul(over, over)));
    return n_fma(n_of(view->number[CONTACT_EXCESS * stride]), excess, kinetic);
}

/// Returns the coefficient of friction with its sign. *rate becomes the slope of the bristles' deflection.
static inline num KERNEL(friction)(const element *own, const kernel_view *view, num slip, num z, vec side, num *rate) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    const num level = KERNEL(level)(own, view, slip), viscous = n_scale(number[CONTACT_VISCOUS * stride], slip);
    const vec zero = v_set(0.0);
    const vec sign = v_select(v_less(zero, side), v_set(1.0), v_select(v_less(side, zero), v_set(-1.0), zero));
    if (own->law & CONTACT_BRISTLES) {
        const vec stiffness = number[CONTACT_BRISTLE * stride];
        *rate = n_sub(slip, n_div(n_mul(n_scale(v_mul(stiffness, sign), slip), z), level));
        const num damped = n_scale(number[CONTACT_BRISTLE_DAMPING * stride], *rate);
        return n_add(viscous, n_add(n_scale(stiffness, z), damped));
    }
    if (own->law & CONTACT_SHARP) return n_add(viscous, n_scale(sign, level));
    const num speed = n_of(number[CONTACT_SLIP_SPEED * stride]);
    const num over = n_over_root(n_fma(slip, slip, n_mul(speed, speed)));
    return n_fma(level, n_mul(slip, over), viscous);
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    num over, f = n_set(0.0), rate = f;
    const num none = f, r = KERNEL(distance)(d, &over), z = own->states ? s[0] : none;
    vec_mask touching;
    const num push = n_mul(KERNEL(normal)(own, view, d, w, r, over, &touching), over);
    if (own->law & CONTACT_SLIPS && v_any(touching)) {
        const num turn = n_sub(n_mul(d[0], w[1]), n_mul(d[1], w[0]));
        const num slip = n_fma(turn, over, n_of(view->number[CONTACT_SURFACE * stride]));
        const vec side = view->sides ? view->sides[CONTACT_SLIP * stride] : n_value(slip);
        f = KERNEL(friction)(own, view, slip, z, side, &rate);
    }
    slope[0] = n_select(touching, rate, n_scale(v_sub(v_set(0.0), view->number[CONTACT_BACK * stride]), z));
    const num share = n_select(touching, f, none);
    force[0] = n_mul(push, n_sub(n_mul(share, d[1]), d[0]));
    force[1] = n_sub(none, n_mul(push, n_fma(share, d[0], d[1])));
}

#ifndef NUMBERS_DUAL
/// Computes torque and power of the friction under a normal force, the two rows of `out` (element_kernels.contact).
static inline void KERNEL(rubbing)(const element *own, const kernel_view *view, vec normal, const vec *d, const vec *w,
                                   const vec *s, vec *out) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    vec over;
    (void)KERNEL(distance)(d, &over);
    const vec slip = v_fma(v_fms(d[0], w[1], v_mul(d[1], w[0])), over, number[CONTACT_SURFACE * stride]);
    vec rate = v_set(0.0), f = rate;
    if (own->law & CONTACT_SLIPS) f = KERNEL(friction)(own, view, slip, own->states ? s[0] : rate, slip, &rate);
    const vec force = v_mul(f, normal);
    out[0] = v_mul(force, v_mul(number[CONTACT_METRES * stride], number[CONTACT_LEVER * stride]));
    out[stride] = v_mul(force, v_mul(number[CONTACT_WATTS * stride], slip));
}
#endif
