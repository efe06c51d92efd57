// Bearings in motions: pairs of poles of the rational function that replaces a bearing's table over the frequency of
// whirl. Each pair has two states for each axis u of the displacement,
//
//     z_1' = w z_2,    z_2' = w (u - z_1) - g z_2,    f = -sum (E z_1 + F z_2),
//
// so that z_1 = w^2 u/(s^2 + g s + w^2) and z_2 = s z_1/w.

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    const num u[2] = {n_sub(d[0], n_of(view->number[BEARING_SIDEWAYS * stride])),
                      n_sub(d[1], n_of(view->number[BEARING_ELEVATION * stride]))};
    num sum[2] = {n_set(0.0), n_set(0.0)};
    (void)w;
    for (size_t j = 0; j < (size_t)own->law; j++) {
        const vec *pair = view->number + (BEARING_PAIRS + j * PAIR_NUMBERS) * stride;
        const num *z = s + 4 * j;
        for (size_t a = 0; a < 2; a++) {
            const num pull = n_scale(pair[PAIR_W * stride], n_sub(u[a], z[2 * a]));
            slope[4 * j + 2 * a] = n_scale(pair[PAIR_W * stride], z[2 * a + 1]);
            slope[4 * j + 2 * a + 1] = n_sub(pull, n_scale(pair[PAIR_G * stride], z[2 * a + 1]));
            for (size_t row = 0; row < 2; row++) {
                sum[row] = n_add(sum[row], n_scale(pair[(PAIR_PLACE + 2 * row + a) * stride], z[2 * a]));
                sum[row] = n_add(sum[row], n_scale(pair[(PAIR_RATE + 2 * row + a) * stride], z[2 * a + 1]));
            }
        }
    }
    for (size_t row = 0; row < 2; row++) force[row] = n_sub(n_set(0.0), sum[row]);
}
