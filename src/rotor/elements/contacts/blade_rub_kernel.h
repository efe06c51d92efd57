// Blades whose tips pass a casing. Blade j, of length l_j from the shaft's axis, points along e_j at the angle
// theta_j = theta + 2 pi j/n, theta = theta_0 + tau. The casing of radius R presses on a tip t_j = d + l_j e_j that is
// farther from its centre than R. The force on the disc is
//
//     f = -sum_j k_j depth_j^p (1 + mu J) t_j/|t_j|,    depth_j = |t_j| - R,
//
// summed over depths above 0, with the exponent p of the law, the coefficient of friction mu, and J a quarter turn.
// Friction acts against the rotation, since the tips' speed is nearly that of the rotation. theta - theta_0 is a state.
// The depths are the switches.

/// Computes the depths of all blades.
static inline void KERNEL(switches)(const element *own, const kernel_view *view, const num *d, const num *w,
                                    const num *s, num *values) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    const vec c = number[BLADE_APART_COS * stride], sine = number[BLADE_APART_SIN * stride];
    num x, y;
    (void)w;
    n_sincos(n_add(s[0], n_of(number[BLADE_START * stride])), &y, &x);
    for (int j = 0; j < blades_of(own); j++) {
        const vec length = number[(size_t)(BLADE_LENGTHS + j) * stride];
        const num tip[2] = {n_add(d[0], n_scale(length, x)), n_add(d[1], n_scale(length, y))};
        const num far = n_sqrt(n_fma(tip[0], tip[0], n_mul(tip[1], tip[1])));
        values[j] = n_sub(far, n_of(number[BLADE_CASING * stride]));
        // Turn to the next blade. The multiply-add is written out, because gcc 12 may fuse one of these sums unasked
        // (whirlKernels.cmake), and all fused builds must give the same bits.
        const num next = n_sub(n_scale(c, x), n_scale(sine, y));
        y = n_fma(n_of(sine), x, n_scale(c, y));
        x = next;
    }
}

/// Computes the sum of the normal forces of all touching blades as vectors, and the sum of their magnitudes.
VECTOR_INLINE void KERNEL(blades_by)(const element *own, const kernel_view *view, bool powered, const num *d,
                                     const num *s, num *sum, num *all) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    const vec c = number[BLADE_APART_COS * stride], sine = number[BLADE_APART_SIN * stride];
    const num none = n_set(0.0), least = n_set(0x1p-800), casing = n_of(number[BLADE_CASING * stride]);
    num x, y, sum_x = none, sum_y = none, sizes = none; // local sums, which the compiler keeps in registers
    n_sincos(n_add(s[0], n_of(number[BLADE_START * stride])), &y, &x);
    for (int j = 0; j < blades_of(own); j++) {
        const vec length = number[(size_t)(BLADE_LENGTHS + j) * stride];
        const num tip[2] = {n_add(d[0], n_scale(length, x)), n_add(d[1], n_scale(length, y))};
        const num far = n_sqrt(n_fma(tip[0], tip[0], n_mul(tip[1], tip[1])));
        const num depth = n_sub(far, casing);
        const vec held = view->sides ? view->sides[(size_t)j * stride] : n_value(depth);
        const vec_mask touching = v_less(v_set(0.0), held);
        num push = n_scale(number[(size_t)(BLADE_STIFFNESSES + j) * stride], depth);
        if (powered && v_any(touching)) {
            // On a fixed side of a switch the depth may be slightly negative. The law continues as an odd function.
            const num size = n_select(n_less(none, depth), depth, n_sub(none, depth));
            push = n_mul(push, n_pow(n_select(n_less(least, size), size, least), number[BLADE_POWER * stride]));
        }
        const num force = n_select(touching, push, none), part = n_div(force, far);
        sum_x = n_fma(part, tip[0], sum_x);
        sum_y = n_fma(part, tip[1], sum_y);
        sizes = n_add(sizes, force);
        const num next = n_sub(n_scale(c, x), n_scale(sine, y));
        y = n_fma(n_of(sine), x, n_scale(c, y)); // as in KERNEL(switches)
        x = next;
    }
    sum[0] = sum_x;
    sum[1] = sum_y;
    *all = sizes;
}

/// Chooses between two loops, so that the one without a power has registers for its constants.
static inline void KERNEL(blades)(const element *own, const kernel_view *view, const num *d, const num *s, num *sum,
                                  num *all) {
    if (own->law & BLADE_POWERED)
        KERNEL(blades_by)(own, view, true, d, s, sum, all);
    else
        KERNEL(blades_by)(own, view, false, d, s, sum, all);
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const vec friction = view->number[BLADE_FRICTION * view->stride];
    num sum[2], all;
    (void)w;
    KERNEL(blades)(own, view, d, s, sum, &all);
    slope[0] = n_of(view->number[BLADE_RATE * view->stride]);
    force[0] = n_sub(n_scale(friction, sum[1]), sum[0]);
    force[1] = n_sub(n_set(0.0), n_add(n_scale(friction, sum[0]), sum[1]));
}

#ifndef NUMBERS_DUAL
/// Computes the torque of friction on the shaft (out[0]) and its power (out[stride]). Tips move with the disc and turn
/// about it.
static inline void KERNEL(rubbing)(const element *own, const kernel_view *view, const vec *d, const vec *w,
                                   const vec *s, vec *out) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    const vec c = number[BLADE_APART_COS * stride], sine = number[BLADE_APART_SIN * stride], zero = v_set(0.0);
    vec x, y, torque = zero, power = zero;
    n_sincos(v_add(s[0], number[BLADE_START * stride]), &y, &x);
    // Sum the torque and power of all tips.
    for (int j = 0; j < blades_of(own); j++) {
        const vec length = number[(size_t)(BLADE_LENGTHS + j) * stride];
        const vec tip[2] = {v_fma(length, x, d[0]), v_fma(length, y, d[1])};
        const vec far = v_sqrt(v_fma(tip[0], tip[0], v_mul(tip[1], tip[1])));
        const vec depth = v_max(v_sub(far, number[BLADE_CASING * stride]), zero), least = v_set(0x1p-800);
        const vec power_of = v_pow(v_max(depth, least), number[BLADE_POWER * stride]);
        const vec push = v_div(v_mul(number[(size_t)(BLADE_STIFFNESSES + j) * stride], v_mul(depth, power_of)), far);
        // Arm of the friction about the shaft, and velocity of the tip along the casing, both times `far`.
        const vec lever = v_mul(length, v_fma(x, tip[0], v_mul(y, tip[1])));
        const vec moving = v_fma(number[BLADE_RATE * stride], lever, v_fms(tip[0], w[1], v_mul(tip[1], w[0])));
        torque = v_fma(push, lever, torque);
        power = v_fma(push, moving, power);
        // Turn to the next blade.
        const vec next = v_fms(c, x, v_mul(sine, y));
        y = v_fma(sine, x, v_mul(c, y));
        x = next;
    }
    const vec friction = number[BLADE_FRICTION * stride];
    out[0] = v_mul(v_mul(friction, number[BLADE_METRES * stride]), torque);
    out[stride] = v_mul(v_mul(friction, number[BLADE_WATTS * stride]), power);
}
#endif
