// Dry friction between two places: a force of constant size against their relative velocity w,
//
//     f = -F w/|w|                   sharp,
//     f = -F w/sqrt(|w|^2 + v0^2)    smoothed.
//
// Sharp friction acts along one axis. w is its switch, and motions stick where less than F holds them.

static inline void KERNEL(switches)(const element *own, const kernel_view *view, const num *d, const num *w,
                                    num *values) {
    (void)view, (void)d;
    values[0] = own->law == FRICTION_SHARP ? w[0] : n_set(1.0);
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const vec size = view->number[FRICTION_FORCE * view->stride];
    const num smooth = n_of(view->number[FRICTION_SLIP_SQUARE * view->stride]);
    (void)d, (void)s, (void)slope;
    if (own->law == FRICTION_SHARP) {
        const vec side = view->sides ? view->sides[0] : n_value(w[0]), none = v_set(0.0);
        const vec opposite = v_select(v_less(side, none), size, v_sub(none, size));
        force[0] = n_of(v_select(v_less(side, none), opposite, v_select(v_less(none, side), opposite, none)));
        force[1] = n_set(0.0);
        return;
    }
    const num speed = n_sqrt(n_fma(w[0], w[0], n_fma(w[1], w[1], smooth)));
    for (int a = 0; a < KERNEL_AXES; a++) force[a] = n_sub(n_set(0.0), n_scale(size, n_div(w[a], speed)));
}
