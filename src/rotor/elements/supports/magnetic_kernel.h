// A radial magnetic bearing (Schweitzer, Maslen 2009): on each of two axes, u along it, a pair of opposing magnets,
//
//     F = k cos a [((i_0 + i)/(s_0 - u))^2 - ((i_0 - i)/(s_0 + u))^2],       both currents within 0 and i_max,
//
// or F = k_i i + k_s u; and a loop i = -A(p) C(p) S(p) u of sensor, controller (PID, then a filter) and amplifier. Each
// of these is a transfer function b(p)/a(p) of order m in observable form, a_m = 1,
//
//     y = x_1 + b_m u,    x_j' = x_{j+1} + b_{m-j} u - a_{m-j} y,    x_{m+1} = 0.
//
// The switches of an axis are the currents of both coils, which stay above 0, and i_max minus these currents.
//
// A bearing that fails has one more state, a clock x' = lambda (1 - x), which begins at 0: x = 1 - e^(-lambda tau).
// Currents fall smoothly while x grows from one given value to another. Linear analyses, which do not depend on time,
// leave x at 0. The unit of x is a current of 1 A.

/// Computes one of the loop's transfer functions on `lines` axes side by side. The inputs u [lines] become the outputs.
/// s and slope are those of the first axis; those of the next axis are `apart` further on.
VECTOR_INLINE void KERNEL(of_order)(const kernel_view *view, size_t part, int order, size_t lines, size_t apart, num *u,
                                    const num *s, num *slope) {
    const size_t stride = view->stride;
    const vec *b = view->number + ((size_t)MAGNETIC_BLOCKS + part * BLOCK_NUMBERS) * stride;
    const vec *a = b + (size_t)(BLOCK_ORDER + 1) * stride;
    VECTOR_FOR (line, lines) {
        const num *own = s + line * apart;
        num y = n_scale(b[(size_t)order * stride], u[line]);
        if (order > 0) y = n_add(own[0], y);
        for (int j = 0; j < order; j++) {
            const size_t back = (size_t)(order - 1 - j) * stride;
            num rate = n_sub(n_scale(b[back], u[line]), n_scale(a[back], y));
            if (j + 1 < order) rate = n_add(rate, own[j + 1]);
            slope[line * apart + (size_t)j] = rate;
        }
        u[line] = y;
    }
}

/// Replaces the displacements u of `lines` axes by the currents of their loops.
VECTOR_INLINE void KERNEL(currents)(const element *own, const kernel_view *view, size_t lines, num *u, const num *s,
                                    num *slope) {
    const size_t apart = (size_t)loop_order(own);
    VECTOR_FOR (part, (size_t)LOOP_BLOCKS) {
        const int order = block_order(own, (int)part);
#ifndef NUMBERS_DUAL
        // Orders that are known to the compiler are faster.
        if (order == 0)
            KERNEL(of_order)(view, part, 0, lines, apart, u, s, slope);
        else if (order == 1)
            KERNEL(of_order)(view, part, 1, lines, apart, u, s, slope);
        else if (order == 2)
            KERNEL(of_order)(view, part, 2, lines, apart, u, s, slope);
        else
#endif
            KERNEL(of_order)(view, part, order, lines, apart, u, s, slope);
        s += order;
        slope += order;
    }
    VECTOR_FOR (line, lines) u[line] = n_sub(n_set(0.0), u[line]);
}

/// Limits a coil's current; by `sides` [MAGNETIC_LIMITS] if they are given, otherwise by the current.
static inline num KERNEL(limited)(const kernel_view *view, num current, const vec *sides) {
    const vec zero = v_set(0.0), most = view->number[MAGNETIC_MAX * view->stride];
    const vec above = sides ? sides[MAGNETIC_ABOVE * view->stride] : n_value(current);
    const vec below = sides ? sides[MAGNETIC_BELOW * view->stride] : v_sub(most, n_value(current));
    const num lifted = n_select(v_less(zero, above), current, n_set(0.0));
    return n_select(v_less(zero, below), lifted, n_of(most));
}

/// Returns the force along an axis.
static inline num KERNEL(pull)(const element *own, const kernel_view *view, num u, num current, const vec *sides) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    if (own->law & MAGNETIC_LINEAR)
        return n_add(n_scale(number[MAGNETIC_BY_CURRENT * stride], current),
                     n_scale(number[MAGNETIC_BY_PLACE * stride], u));
    const num bias = n_of(number[MAGNETIC_BIAS * stride]), gap = n_of(number[MAGNETIC_GAP * stride]);
    const vec *others = sides ? sides + MAGNETIC_LIMITS * stride : NULL;
    // Use only one division: of the currents by the gaps; the difference of squares is computed from their sum and
    // difference.
    const num near = n_sub(gap, u), far = n_add(gap, u), over = n_div(n_set(1.0), n_mul(near, far));
    const num one = n_mul(KERNEL(limited)(view, n_add(bias, current), sides), far);
    const num other = n_mul(KERNEL(limited)(view, n_sub(bias, current), others), near);
    const num square = n_mul(n_sub(one, other), n_add(one, other));
    return n_scale(number[MAGNETIC_FORCE * stride], n_mul(square, n_mul(over, over)));
}

/// Computes the displacements along both axes.
static inline void KERNEL(along_axes)(const kernel_view *view, const num *d, num *u) {
    const vec c = view->number[MAGNETIC_COS * view->stride], sine = view->number[MAGNETIC_SIN * view->stride];
    u[0] = n_add(n_scale(c, d[0]), n_scale(sine, d[1]));
    u[1] = n_sub(n_scale(c, d[1]), n_scale(sine, d[0]));
}

static inline void KERNEL(switches)(const element *own, const kernel_view *view, const num *d, const num *w,
                                    const num *s, num *values) {
    const size_t stride = view->stride;
    const num bias = n_of(view->number[MAGNETIC_BIAS * stride]), most = n_of(view->number[MAGNETIC_MAX * stride]);
    num u[2], current[2], slope[KERNEL_STATES];
    (void)w;
    KERNEL(along_axes)(view, d, u);
    for (size_t line = 0; line < 2; line++) current[line] = u[line];
    KERNEL(currents)(own, view, 2, current, s, slope);
    for (size_t line = 0; line < 2; line++) {
        const num coils[2] = {n_add(bias, current[line]), n_sub(bias, current[line])};
        for (size_t coil = 0; coil < 2; coil++) {
            values[line * MAGNETIC_AXIS_SWITCHES + coil * MAGNETIC_LIMITS + MAGNETIC_ABOVE] = coils[coil];
            values[line * MAGNETIC_AXIS_SWITCHES + coil * MAGNETIC_LIMITS + MAGNETIC_BELOW] = n_sub(most, coils[coil]);
        }
    }
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    const vec c = number[MAGNETIC_COS * stride], sine = number[MAGNETIC_SIN * stride], one = v_set(1.0),
              ampere = number[MAGNETIC_AMPERE * stride];
    num u[2], pull[2], current[2], left = n_set(1.0);
    const size_t loop = (size_t)loop_order(own);
    (void)w;
    // Compute the currents of the controller, and the pull of both axes.
    KERNEL(along_axes)(view, d, u);
    for (size_t line = 0; line < 2; line++) current[line] = u[line];
    KERNEL(currents)(own, view, 2, current, s, slope);
    for (size_t line = 0; line < 2; line++) {
        const vec *sides = view->sides ? view->sides + line * MAGNETIC_AXIS_SWITCHES * stride : NULL;
        pull[line] = KERNEL(pull)(own, view, u[line], current[line], sides);
    }
    // After a failure the pull falls to 0.
    if (own->law & MAGNETIC_FAILS) {
        const vec C = view->phase[COS_TAU], S = view->phase[SIN_TAU], running = v_fma(C, C, v_mul(S, S));
        const num clock = s[2 * loop], way = n_sub(clock, n_of(number[MAGNETIC_FAILS_AT * stride]));
        slope[2 * loop] = n_scale(number[MAGNETIC_CLOCK * stride], n_sub(n_of(v_mul(running, ampere)), clock));
        num q = n_scale(number[MAGNETIC_FALLS * stride], way);
        q = n_select(n_less(n_set(0.0), q), q, n_set(0.0));
        q = n_select(n_less(q, n_set(1.0)), q, n_set(1.0));
        const num share = n_sub(n_of(one), n_mul(n_mul(q, q), n_sub(n_set(3.0), n_scale(v_set(2.0), q))));
        left = n_mul(share, share);
    }
    // Turn the force back from the magnets' axes.
    force[0] = n_mul(left, n_sub(n_scale(c, pull[0]), n_scale(sine, pull[1])));
    force[1] = n_mul(left, n_add(n_scale(sine, pull[0]), n_scale(c, pull[1])));
}
