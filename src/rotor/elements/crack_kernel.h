// A shaft with a breathing crack: its stiffness k along axes that turn with it, the first towards the crack, is k (1 -
// d1 f) and k (1 - d2 f). With theta the angle of the first axis and phi that from the load to the crack
//
//     f = (1 + cos phi)/2     (Mayes & Davies 1984),
//     f = 1/2 + (2/pi) sum_{i < n} (-1)^i cos((2i + 1) phi)/(2i + 1)     (Gasch's switching crack in n terms),
//
// and the force on a place at d from the other is, with M = k (1 - f (d1 + d2)/2) and H = -k f (d1 - d2)/2,
//
//     -(M + H [cos 2theta   sin 2theta; sin 2theta   -cos 2theta]) d.

/// How far the crack is open; own->law: terms of the square wave, or 0.
static inline vec KERNEL(crack_opening)(const element *own, const kernel_view *view) {
    const vec half = v_set(0.5);
    const vec cosine = view->number[CRACK_LOAD_COS * view->stride], sine = view->number[CRACK_LOAD_SIN * view->stride];
    const vec first = v_fnma(sine, view->phase[SIN_TAU], v_mul(cosine, view->phase[COS_TAU]));
    if (own->law == 0) return v_fma(half, first, half);
    // cos((n + 2) phi) = 2 cos 2phi cos(n phi) - cos((n - 2) phi)
    const vec twice = v_fms(v_mul(v_set(4.0), first), first, v_set(2.0));
    vec open = half, wave = first, before = first;
    for (int i = 0; i < own->law; i++) {
        const vec next = v_fms(twice, wave, before);
        open = v_fma(v_set((i % 2 ? -2.0 : 2.0) / (3.14159265358979323846 * (2 * i + 1))), wave, open);
        before = wave;
        wave = next;
    }
    return open;
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const vec cosine = view->number[CRACK_AXIS_COS * view->stride], sine = view->number[CRACK_AXIS_SIN * view->stride];
    const vec c = v_fnma(sine, view->phase[SIN_2TAU], v_mul(cosine, view->phase[COS_2TAU]));
    const vec across = v_fma(sine, view->phase[COS_2TAU], v_mul(cosine, view->phase[SIN_2TAU]));
    const vec open = KERNEL(crack_opening)(own, view);
    const vec mean =
        v_fms(open, view->number[CRACK_MEAN_LOSS * view->stride], view->number[CRACK_STIFFNESS * view->stride]);
    const vec half = v_mul(open, view->number[CRACK_HALF_LOSS * view->stride]), turn = v_mul(half, across);
    (void)w, (void)s, (void)slope;
    force[0] = n_add(n_scale(v_fma(half, c, mean), d[0]), n_scale(turn, d[1]));
    force[1] = n_add(n_scale(v_fnma(half, c, mean), d[1]), n_scale(turn, d[0]));
}
