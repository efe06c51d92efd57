// An unbalance while the speed runs up. The states are theta' = nu and nu' = alpha, so that nothing divides by the
// speed. The force is
//
//     f = U (nu^2 cos theta + alpha sin theta, nu^2 sin theta - alpha cos theta).
static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    const vec size = number[RUN_UP_SIZE * stride];
    const num alpha = n_of(number[RUN_UP_ACCELERATION * stride]);
    const num rate = n_add(s[1], n_of(number[RUN_UP_SPEED * stride])), square = n_mul(rate, rate);
    num sine, cosine;
    (void)own, (void)d, (void)w;
    n_sincos(n_add(s[0], n_of(number[RUN_UP_ANGLE * stride])), &sine, &cosine);
    force[0] = n_scale(size, n_fma(square, cosine, n_mul(alpha, sine)));
    force[1] = n_scale(size, n_sub(n_mul(square, sine), n_mul(alpha, cosine)));
    slope[0] = rate;
    slope[1] = alpha;
}
