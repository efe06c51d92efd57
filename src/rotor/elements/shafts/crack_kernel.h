// A shaft with a breathing crack: its stiffness k along axes that turn with it, the first towards the crack, is k (1 -
// d1 f) and k (1 - d2 f). With theta, the angle of the first axis, and phi, the angle from the load to the crack,
//
//     f = (1 + cos phi)/2     (Mayes & Davies 1984),
//     f = 1/2 + (2/pi) sum_{i < n} (-1)^i cos((2i + 1) phi)/(2i + 1)     (Gasch's switching crack in n terms),
//
// and the force on a place at d from the other place is, with M = k (1 - f (d1 + d2)/2) and H = -k f (d1 - d2)/2,
//
//     -(M + H [cos 2theta   sin 2theta; sin 2theta   -cos 2theta]) d.

/// Computes cosine and sine of the shaft's angle and of twice that: the forcing, or of the phase that is a state.
static inline void KERNEL(crack_phases)(const kernel_view *view, const num *s, num phase[FORCING_COUNT]) {
#ifdef CRACK_TURNS
    (void)view;
    n_sincos(s[0], &phase[SIN_TAU], &phase[COS_TAU]);
    phase[SIN_2TAU] = n_scale(v_set(2.0), n_mul(phase[SIN_TAU], phase[COS_TAU]));
    phase[COS_2TAU] = n_fma(n_mul(n_set(-2.0), phase[SIN_TAU]), phase[SIN_TAU], n_set(1.0));
#else
    (void)s;
    for (int i = 0; i < FORCING_COUNT; i++) phase[i] = n_phase(view, i);
#endif
}

/// Returns the opening of the crack. own->law: number of terms of the square wave, or 0.
static inline num KERNEL(crack_opening)(const element *own, const kernel_view *view, const num *phase) {
    const num half = n_set(0.5), cosine = n_of(view->number[CRACK_LOAD_COS * view->stride]);
    const num minus_sine = n_of(v_sub(v_set(0.0), view->number[CRACK_LOAD_SIN * view->stride]));
    const num first = n_fma(minus_sine, phase[SIN_TAU], n_mul(cosine, phase[COS_TAU]));
    if (own->law == 0) return n_fma(half, first, half);
    // cos((n + 2) phi) = 2 cos 2phi cos(n phi) - cos((n - 2) phi)
    const num twice = n_fma(n_mul(n_set(4.0), first), first, n_set(-2.0));
    num open = half, wave = first, before = first;
    for (int i = 0; i < own->law; i++) {
        const num next = n_fma(twice, wave, n_sub(n_set(0.0), before));
        open = n_fma(n_set((i % 2 ? -2.0 : 2.0) / (3.14159265358979323846 * (2 * i + 1))), wave, open);
        before = wave;
        wave = next;
    }
    return open;
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const vec *number = view->number;
    const size_t stride = view->stride;
    const num cosine = n_of(number[CRACK_AXIS_COS * stride]), sine = n_of(number[CRACK_AXIS_SIN * stride]);
    num phase[FORCING_COUNT];
    KERNEL(crack_phases)(view, s, phase);
    const num c2 = phase[COS_2TAU], s2 = phase[SIN_2TAU], open = KERNEL(crack_opening)(own, view, phase);
    const num c = n_fma(n_sub(n_set(0.0), sine), s2, n_mul(cosine, c2)), across = n_fma(sine, c2, n_mul(cosine, s2));
    const num minus_stiffness = n_of(v_sub(v_set(0.0), number[CRACK_STIFFNESS * stride]));
    const num mean = n_fma(open, n_of(number[CRACK_MEAN_LOSS * stride]), minus_stiffness);
    const num half = n_scale(number[CRACK_HALF_LOSS * stride], open), turn = n_mul(half, across);
    (void)w;
#ifdef CRACK_TURNS
    slope[0] = n_of(number[CRACK_RATE * stride]);
#else
    (void)slope;
#endif
    force[0] = n_add(n_mul(n_fma(half, c, mean), d[0]), n_mul(turn, d[1]));
    force[1] = n_add(n_mul(n_fma(n_sub(n_set(0.0), half), c, mean), d[1]), n_mul(turn, d[0]));
}
