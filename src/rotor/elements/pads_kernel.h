// The films of pads, fixed or tilting (pads/reynolds.h has the equation, pads/table.h the tables). Included twice, so
// without a guard; KERNEL_STATES is 0 of fixed pads.
//
// For every pad the journal is turned into its frame, x along its middle, moved by the preload and, of one that tilts
// by s, by -s along the pad at its pivot; all of a machine that turns clockwise is that of its mirror image. The film's
// force on the journal acts along the pad on its tilt with the opposite sign: s'' = -force, with a spring and a damper
// at the pivot. With PADS_YIELD the pivot moves outwards by u, the journal before the pad by -u along its radius.

#ifndef PADS_YIELD
#define PADS_YIELD 0
#endif

#ifndef NUMBERS_DUAL
static inline void pads_look_up_plain(const kernel_view *view, const vec *pad, vec t, vec w, vec half, vec sum[2]) {
    pads_look_up(view->stride, pad, t, w, half, sum, NULL);
}
#else
static inline void pads_look_up_dual(const kernel_view *view, const vec *pad, dual t, dual w, dual half, dual sum[2]) {
    vec value[2], slope[2][3];
    pads_look_up(view->stride, pad, t.value, w.value, half.value, value, slope);
    for (int n = 0; n < 2; n++) {
        sum[n].value = value[n];
        for (int i = 0; i < DUAL_INPUTS; i++)
            sum[n].by[i] = v_fma(slope[n][0], t.by[i], v_fma(slope[n][1], w.by[i], v_mul(slope[n][2], half.by[i])));
    }
}
#endif

/// Half the angle of (a, b), from -pi/2 to pi/2.
static inline num KERNEL(pads_half_angle)(num a, num b, num over) {
#ifdef NUMBERS_DUAL
    const vec half = v_set(0.5);
    dual out = {.value =
                    v_half_angle(v_mul(half, v_mul(a.value, over.value)), v_mul(half, v_mul(b.value, over.value)))};
    const vec square = v_mul(half, v_mul(over.value, over.value));
    for (int i = 0; i < DUAL_INPUTS; i++) out.by[i] = v_mul(square, v_fms(a.value, b.by[i], v_mul(b.value, a.by[i])));
    return out;
#else
    const vec half = v_mul(v_set(0.5), over);
    return v_half_angle(v_mul(a, half), v_mul(b, half));
#endif
}

/// The force of one pad in its frame.
static inline void KERNEL(pads_film)(const kernel_view *view, const vec *pad, num x, num y, num a, num b, num f[2]) {
    const vec cosine = pad[PAD_HALF_COSINE * view->stride], sine = pad[PAD_HALF_SINE * view->stride];
    const num one = n_set(1.0), thickness = n_sub(one, x), t = n_sqrt(thickness);
    const num straight = n_div(n_sub(one, n_scale(cosine, x)), n_of(sine)), round = n_sqrt(n_sub(one, n_mul(x, x)));
    const num v = n_div(y, n_select(n_less(x, n_of(cosine)), straight, round)), root = n_sqrt(n_sub(one, n_mul(v, v)));
    const num w = n_div(v, n_add(one, root));
    // Beyond the wall the root is not a number, and the motion counts as diverged. The 2^-600 keeps a journal that
    // neither turns nor moves before the pad from dividing by zero.
    const num V = n_sqrt(n_fma(a, a, n_fma(b, b, n_set(0x1p-600))));
    const num half = KERNEL(pads_half_angle)(a, b, n_div(one, V));
    const num scale = n_div(V, n_mul(n_mul(root, root), n_mul(thickness, thickness)));
    num sum[2];
    KERNEL(pads_look_up)(view, pad, t, w, half, sum);
    for (int n = 0; n < 2; n++) f[n] = n_mul(scale, sum[n]);
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    const vec over = view->number[PADS_OVER_CLEARANCE * stride], twice = view->number[PADS_TWICE * stride];
    const vec sign = view->number[PADS_SIGN * stride];
    const num X = n_scale(over, d[0]), Y = n_scale(v_mul(sign, over), d[1]);
    const num VX = n_scale(over, w[0]), VY = n_scale(v_mul(sign, over), w[1]);
    num FX = n_set(0.0), FY = n_set(0.0);
    for (size_t p = 0; p < (size_t)own->law; p++) {
        const vec *pad = view->number + (PADS_FIRST + p * PAD_NUMBERS) * stride;
        const vec c = pad[PAD_COSINE * stride], sn = pad[PAD_SINE * stride];
        num x = n_add(n_add(n_scale(c, X), n_scale(sn, Y)), n_of(pad[PAD_SHIFT_X * stride]));
        num y = n_add(n_sub(n_scale(c, Y), n_scale(sn, X)), n_of(pad[PAD_SHIFT_Y * stride]));
        num vx = n_add(n_scale(c, VX), n_scale(sn, VY)), vy = n_sub(n_scale(c, VY), n_scale(sn, VX)), f[2];
        const vec along[] = {pad[PAD_ALONG_X * stride], pad[PAD_ALONG_Y * stride]};
        if (KERNEL_STATES > 0) {
            x = n_sub(x, n_scale(along[0], s[2 * p]));
            y = n_sub(y, n_scale(along[1], s[2 * p]));
            vx = n_sub(vx, n_scale(along[0], s[2 * p + 1]));
            vy = n_sub(vy, n_scale(along[1], s[2 * p + 1]));
        }
        const size_t yield = 2 * ((size_t)own->law + p);
        if (PADS_YIELD) {
            x = n_sub(x, n_scale(along[1], s[yield]));
            y = n_add(y, n_scale(along[0], s[yield]));
            vx = n_sub(vx, n_scale(along[1], s[yield + 1]));
            vy = n_add(vy, n_scale(along[0], s[yield + 1]));
        }
        KERNEL(pads_film)(view, pad, x, y, n_sub(x, n_scale(twice, vy)), n_add(y, n_scale(twice, vx)), f);
        FX = n_add(FX, n_sub(n_scale(c, f[0]), n_scale(sn, f[1])));
        FY = n_add(FY, n_add(n_scale(sn, f[0]), n_scale(c, f[1])));
        if (KERNEL_STATES > 0) {
            const num moment = n_add(n_scale(along[0], f[0]), n_scale(along[1], f[1]));
            const num held = n_add(n_scale(view->number[PADS_TILT_SPRING * stride], s[2 * p]),
                                   n_scale(view->number[PADS_TILT_DAMPER * stride], s[2 * p + 1]));
            slope[2 * p] = s[2 * p + 1];
            slope[2 * p + 1] = n_sub(n_set(0.0), n_add(held, n_scale(view->number[PADS_TILT_FORCE * stride], moment)));
        }
        if (PADS_YIELD) {
            const num outwards = n_sub(n_scale(along[1], f[0]), n_scale(along[0], f[1]));
            const num held = n_add(n_scale(view->number[PADS_YIELD_SPRING * stride], s[yield]),
                                   n_scale(view->number[PADS_YIELD_DAMPER * stride], s[yield + 1]));
            slope[yield] = s[yield + 1];
            slope[yield + 1] =
                n_sub(n_set(0.0), n_add(held, n_scale(view->number[PADS_YIELD_FORCE * stride], outwards)));
        }
    }
    force[0] = FX;
    force[1] = n_scale(sign, FY);
    (void)s, (void)slope;
}
