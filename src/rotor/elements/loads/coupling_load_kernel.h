// Reactions with a common time function: the sum over the orders n of c_n cos n tau + s_n sin n tau. The powers of
// exp(i tau) are computed as products.
static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const num cosine = n_phase(view, COS_TAU), sine = n_phase(view, SIN_TAU);
    num sum = n_of(view->number[0]), c = cosine, t = sine;
    (void)d, (void)w, (void)s, (void)slope;
    for (int n = 1; n <= own->law; n++) {
        const vec *part = view->number + (2 * (size_t)n - 1) * view->stride;
        sum = n_add(sum, n_add(n_scale(part[0], c), n_scale(part[view->stride], t)));
        const num next = n_sub(n_mul(c, cosine), n_mul(t, sine));
        t = n_add(n_mul(c, sine), n_mul(t, cosine));
        c = next;
    }
    for (int i = 0; i < KERNEL_AXES; i++) force[i] = sum;
}
