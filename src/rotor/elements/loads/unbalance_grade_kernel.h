// Forces that turn with the shaft: on axis i, number[2 i] cos tau + number[2 i + 1] sin tau.
static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const num cosine = n_phase(view, COS_TAU), sine = n_phase(view, SIN_TAU);
    (void)own, (void)d, (void)w, (void)s, (void)slope;
    for (size_t i = 0; i < KERNEL_AXES; i++) {
        const vec *part = view->number + 2 * i * view->stride;
        force[i] = n_add(n_scale(part[0], cosine), n_scale(part[view->stride], sine));
    }
}
