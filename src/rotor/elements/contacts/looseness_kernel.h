// A seat that can lift: along one axis a force whose slope changes with the displacement d,
//
//     f = -(k1 d + c1 d')                     where d < 0,        seated
//     f = -(k2 d + c2 d')                     where 0 < d < g,    loose
//     f = -(k2 g + k3 (d - g) + c3 d')        where d > g,        held from above;
//
// d and d - g are the switches. The force of the springs is continuous, that of the dampers jumps where they differ.

static inline void KERNEL(switches)(const element *own, const kernel_view *view, const num *d, const num *w,
                                    num *values) {
    (void)own, (void)w;
    values[0] = d[0];
    values[1] = n_sub(d[0], n_of(view->number[LOOSENESS_GAP * view->stride]));
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    const vec *k = view->number + LOOSENESS_STIFFNESS * stride, *c = view->number + LOOSENESS_DAMPING * stride;
    num beyond[KERNEL_SWITCHES], pull[PIECES];
    vec_mask is_beyond[KERNEL_SWITCHES];
    (void)s, (void)slope;
    KERNEL(switches)(own, view, d, w, beyond);
    for (int i = 0; i < KERNEL_SWITCHES; i++)
        is_beyond[i] = v_less(v_set(0.0), view->sides ? view->sides[(size_t)i * stride] : n_value(beyond[i]));
    pull[SEATED] = n_scale(k[SEATED * stride], d[0]);
    pull[LOOSE] = n_scale(k[LOOSE * stride], d[0]);
    pull[HELD] = n_add(n_of(v_mul(k[LOOSE * stride], view->number[LOOSENESS_GAP * stride])),
                       n_scale(k[HELD * stride], beyond[1]));
    for (size_t piece = 0; piece < PIECES; piece++) pull[piece] = n_add(pull[piece], n_scale(c[piece * stride], w[0]));
    const num lifted = n_select(is_beyond[1], pull[HELD], pull[LOOSE]);
    force[0] = n_sub(n_set(0.0), n_select(is_beyond[0], lifted, pull[SEATED]));
}
