// A force on a place that is harmonic in its own phase, a state theta that turns at a constant rate:
//
//     f = (X_c cos theta + X_s sin theta, Y_c cos theta + Y_s sin theta),   theta' = rate.
static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    num sine, cosine;
    (void)own, (void)d, (void)w;
    n_sincos(s[0], &sine, &cosine);
    force[0] = n_add(n_scale(number[HARMONIC_XC * stride], cosine), n_scale(number[HARMONIC_XS * stride], sine));
    force[1] = n_add(n_scale(number[HARMONIC_YC * stride], cosine), n_scale(number[HARMONIC_YS * stride], sine));
    slope[0] = n_of(number[HARMONIC_RATE * stride]);
}
