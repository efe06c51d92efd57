// A stator that a station touches where its distance r from the stator's centre exceeds the gap, and where it looks
// into the stator's arc: normal force of the depth d = r - gap (Hertz 1882; Hunt, Crossley 1975),
//
//     N = K d^n (1 + chi d')                              and never below zero,
//
// friction f N against the sliding v_t = R omega + (x y' - y x')/r of the rotor's surface, (Fx, Fy) = -(N/r) [1 -f; f
// 1] (x, y) as for a rub, with
//
//     f = sign(v_t) (f_k + (f_s - f_k) e^(-(v_t/v_s)^2)) + s_2 v_t,    sign smooth as v_t/sqrt(v_t^2 + v_0^2), or
//     f = s_0 z + s_1 z' + s_2 v_t,  z' = v_t - s_0 |v_t| z/g(v_t),    g the bracket before: bristles (LuGre), which
//
// spring back by themselves, z' = -(s_0/s_1) z, while nothing touches.
//
// Switches: d, 1 + chi d', the slip times r, and the arc; those that a law has not are 1.

/// The distance from the middle, 1 in the middle itself.
static inline num KERNEL(distance)(const num *d) {
    const num r = n_sqrt(n_fma(d[0], d[0], n_mul(d[1], d[1])));
    return n_select(n_less(n_set(0x1p-500), r), r, n_set(1.0));
}

static inline void KERNEL(switches)(const element *own, const kernel_view *view, const num *d, const num *w,
                                    num *values) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    const num r = n_sqrt(n_fma(d[0], d[0], n_mul(d[1], d[1]))), one = n_set(1.0);
    const num growth = n_div(n_fma(d[0], w[0], n_mul(d[1], w[1])), KERNEL(distance)(d));
    const num slip = n_add(n_scale(number[CONTACT_SURFACE * stride], r), n_sub(n_mul(d[0], w[1]), n_mul(d[1], w[0])));
    const num along =
        n_add(n_scale(number[CONTACT_ARC_X * stride], d[0]), n_scale(number[CONTACT_ARC_Y * stride], d[1]));
    values[CONTACT_DEPTH] = n_sub(r, n_of(number[CONTACT_GAP * stride]));
    values[CONTACT_PUSH] = own->law & CONTACT_LOSSY ? n_add(one, n_scale(number[CONTACT_LOSS * stride], growth)) : one;
    values[CONTACT_SLIP] = own->law & (CONTACT_SHARP | CONTACT_BRISTLES) ? slip : one;
    values[CONTACT_ARC] =
        own->law & CONTACT_PARTIAL ? n_sub(along, n_scale(number[CONTACT_ARC_HALF * stride], r)) : one;
}

/// The normal force, where it touches; and the switching functions.
static inline num KERNEL(normal)(const element *own, const kernel_view *view, const num *d, const num *w, num *value,
                                 vec_mask *touching) {
    const size_t stride = view->stride;
    const vec *number = view->number, *sides = view->sides;
    const num none = n_set(0.0), least = n_set(0x1p-800);
    KERNEL(switches)(own, view, d, w, value);
    vec held = sides ? sides[CONTACT_DEPTH * stride] : n_value(value[CONTACT_DEPTH]);
    held = v_min(held, sides ? sides[CONTACT_PUSH * stride] : n_value(value[CONTACT_PUSH]));
    held = v_min(held, sides ? sides[CONTACT_ARC * stride] : n_value(value[CONTACT_ARC]));
    *touching = v_less(v_set(0.0), held);
    // On a side that is held the depth may be a little below zero: the law goes on as an odd function.
    const num depth = value[CONTACT_DEPTH];
    const num size = n_select(n_less(none, depth), depth, n_sub(none, depth));
    const num power = n_pow(n_select(n_less(least, size), size, least), number[CONTACT_POWER * stride]);
    const num push = n_scale(number[CONTACT_STIFFNESS * stride], n_mul(depth, power));
    return n_select(*touching, n_mul(push, value[CONTACT_PUSH]), none);
}

/// The coefficient of friction with its sign, and the slope of the bristles.
static inline num KERNEL(friction)(const element *own, const kernel_view *view, num slip, num z, vec side, num *rate) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    const num over = n_scale(number[CONTACT_STRIBECK * stride], slip);
    const num excess = n_exp(n_sub(n_set(0.0), n_mul(over, over)));
    const num level = n_add(n_of(number[CONTACT_KINETIC * stride]), n_scale(number[CONTACT_EXCESS * stride], excess));
    const num viscous = n_scale(number[CONTACT_VISCOUS * stride], slip);
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
    return n_fma(level, n_div(slip, n_sqrt(n_fma(slip, slip, n_mul(speed, speed)))), viscous);
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    const num none = n_set(0.0), r = KERNEL(distance)(d), z = own->states ? s[0] : none;
    num value[KERNEL_SWITCHES], f = none, rate = none;
    vec_mask touching;
    const num push = n_div(KERNEL(normal)(own, view, d, w, value, &touching), r);
    if (own->law & CONTACT_SLIPS) {
        const num turn = n_sub(n_mul(d[0], w[1]), n_mul(d[1], w[0]));
        const num slip = n_add(n_of(view->number[CONTACT_SURFACE * stride]), n_div(turn, r));
        const vec side = view->sides ? view->sides[CONTACT_SLIP * stride] : n_value(slip);
        f = KERNEL(friction)(own, view, slip, z, side, &rate);
    }
    slope[0] = n_select(touching, rate, n_scale(v_sub(v_set(0.0), view->number[CONTACT_BACK * stride]), z));
    force[0] = n_mul(push, n_sub(n_mul(f, d[1]), d[0]));
    force[1] = n_sub(none, n_mul(push, n_fma(f, d[0], d[1])));
}
