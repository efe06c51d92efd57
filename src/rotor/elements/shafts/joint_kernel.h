// Moments on the tilts of two shafts, constant and twice a turn: on tilt i, number[3 i] + number[3 i + 1] cos 2 tau +
// number[3 i + 2] sin 2 tau.
static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const num cosine = n_phase(view, COS_2TAU), sine = n_phase(view, SIN_2TAU);
    (void)own, (void)d, (void)w, (void)s, (void)slope;
    for (size_t i = 0; i < KERNEL_AXES; i++) {
        const vec *part = view->number + 3 * i * view->stride;
        force[i] =
            n_add(n_of(part[0]), n_add(n_scale(part[view->stride], cosine), n_scale(part[2 * view->stride], sine)));
    }
}
