// An elastomer between two places, the standard linear solid (Zener 1948): along every axis a spring k, in parallel
// with a spring k_m and a damper c in series. The extension s of the damper is a state:
//
//     f = -(k d + k_m (d - s)),   c s' = k_m (d - s).

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const vec stiffness = view->number[MOUNT_STIFFNESS * view->stride];
    const vec branch = view->number[MOUNT_BRANCH * view->stride], rate = view->number[MOUNT_RATE * view->stride];
    (void)own, (void)w;
    for (int a = 0; a < KERNEL_AXES; a++) {
        const num stretch = n_sub(d[a], s[a]);
        force[a] = n_sub(n_set(0.0), n_add(n_scale(stiffness, d[a]), n_scale(branch, stretch)));
        slope[a] = n_scale(rate, stretch);
    }
}
