// A spring and damper between two places with play: along every axis a force where the distance d is beyond the gap,
//
//     f = -(k (d - g) + c d')   where d > g,      f = -(k (d + g) + c d')   where d < -g.
//
// The force of the damper jumps where the play ends; d - g and -d - g are the switches, axis after axis.

static inline void KERNEL(switches)(const element *own, const kernel_view *view, const num *d, const num *w,
                                    num *values) {
    const num gap = n_of(view->number[SPRING_GAP * view->stride]);
    (void)own, (void)w;
    for (size_t a = 0; a < KERNEL_AXES; a++) {
        values[2 * a] = n_sub(d[a], gap);
        values[2 * a + 1] = n_sub(n_sub(n_set(0.0), d[a]), gap);
    }
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const vec stiffness = view->number[SPRING_STIFFNESS * view->stride];
    const vec damping = view->number[SPRING_DAMPING * view->stride];
    num beyond[KERNEL_SWITCHES];
    (void)s, (void)slope;
    KERNEL(switches)(own, view, d, w, beyond);
    for (int i = 0; i < KERNEL_SWITCHES; i++) {
        const int a = i / 2;
        const vec side = view->sides ? view->sides[(size_t)i * view->stride] : n_value(beyond[i]);
        const num resistance = n_scale(damping, w[a]), push = n_scale(stiffness, beyond[i]);
        const num whole = i % 2 == 0 ? n_sub(n_sub(n_set(0.0), push), resistance) : n_sub(push, resistance);
        const num own_force = n_select(v_less(v_set(0.0), side), whole, n_set(0.0));
        force[a] = i % 2 == 0 ? own_force : n_add(force[a], own_force);
    }
}
