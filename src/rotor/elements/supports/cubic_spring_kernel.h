// A spring that stiffens (k3 > 0) or softens with the cube of the displacement, alike in all directions of its axes,
//
//     f = -((k1 + k3 |d|^2) d + c d').
static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const vec *number = view->number;
    const vec cubic = number[CUBIC_CUBE * view->stride], damping = number[CUBIC_DAMPING * view->stride];
    num square = n_mul(d[0], d[0]);
    (void)own, (void)s, (void)slope;
    for (int a = 1; a < KERNEL_AXES; a++) square = n_fma(d[a], d[a], square);
    const num stiffness = n_add(n_of(number[CUBIC_STIFFNESS * view->stride]), n_scale(cubic, square));
    for (int a = 0; a < KERNEL_AXES; a++) force[a] = n_sub(n_set(0.0), n_fma(stiffness, d[a], n_scale(damping, w[a])));
}
