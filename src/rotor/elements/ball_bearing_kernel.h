// A ball bearing whose balls pass under the load (Sunnersjo 1978; Fukata et al. 1985). Ball j stands at
// theta_j = theta + 2 pi j/N, theta = theta_0 + ratio tau; it is pressed in by delta_j = x cos theta_j + y sin theta_j
// - g_0 and pushes back by Hertz's law where that is above zero,
//
//     f = -C sum_j delta_j^(3/2) (cos theta_j, sin theta_j).
//
// The force has a continuous derivative, so that contacts need not be located. With a state of its own, theta - theta_0
// is integrated, for cages that do not fit the revolution.
static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    const vec ratio = number[BALL_RATIO * stride], start = number[BALL_START * stride];
    const vec c = number[BALL_APART_COS * stride], sine = number[BALL_APART_SIN * stride];
    const num gap = n_of(number[BALL_GAP * stride]), zero = n_set(0.0);
    const num angle = n_add(s[0], n_of(start));
    num x, y, sum_x = zero, sum_y = zero;
    (void)w;
    slope[0] = n_of(ratio);
    n_sincos(angle, &y, &x);
    for (int j = 0; j < own->law; j++) {
        const num pressed = n_sub(n_fma(d[0], x, n_mul(d[1], y)), gap);
        const num depth = n_select(n_less(zero, pressed), pressed, zero), push = n_mul(depth, n_sqrt(depth));
        sum_x = n_fma(push, x, sum_x);
        sum_y = n_fma(push, y, sum_y);
        const num next = n_sub(n_scale(c, x), n_scale(sine, y));
        y = n_add(n_scale(sine, x), n_scale(c, y));
        x = next;
    }
    const vec stiffness = v_sub(v_set(0.0), number[BALL_STIFFNESS * stride]);
    force[0] = n_scale(stiffness, sum_x);
    force[1] = n_scale(stiffness, sum_y);
}
