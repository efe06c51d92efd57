// The films of pads, fixed or tilting (pads/reynolds.h has the equation, pads/pad_tables.h the tables). Included twice,
// so without a guard; KERNEL_STATES is 0 for fixed pads.
//
// For every pad the journal is transformed to the pad's frame: turned, so that x is along the pad's middle; moved by
// the preload; and, if the pad tilts by s, moved by -s along the pad at its pivot. A machine that turns clockwise is
// computed as its mirror image. The film's force on the journal along the pad acts on the tilt with the opposite sign:
// s'' = -force, with a spring and a damper at the pivot. For a pad without inertia it is 0 = -force, an equation for s'
// (pads_balance.h). With PADS_YIELD the pivot moves outwards by u, so that the journal is moved by -u along the pad's
// radius.

#ifndef PADS_YIELD
#define PADS_YIELD 0
#endif

/// Computes V and half of alpha for (a, b).
static inline void KERNEL(pads_direction)(num a, num b, num *V, num *half) {
#ifdef NUMBERS_DUAL
    vec over;
    pads_polar(a.value, b.value, &V->value, &half->value, &over);
    const vec square = v_mul(v_set(0.5), v_mul(over, over));
    for (int i = 0; i < DUAL_INPUTS; i++) {
        V->by[i] = v_mul(over, v_fma(a.value, a.by[i], v_mul(b.value, b.by[i])));
        half->by[i] = v_mul(square, v_fms(a.value, b.by[i], v_mul(b.value, a.by[i])));
    }
#else
    vec over;
    pads_polar(a, b, V, half, &over);
#endif
}

/// Computes t, w and 1/((1 - v^2) Hm^2) of the table for the journal at (x, y) in the frame of a pad. Beyond the wall a
/// root is not a number, and the motion counts as diverged.
static inline void KERNEL(pads_place)(const kernel_view *view, const vec *pad, num x, num y, num *t, num *w,
                                      num *scale) {
    const vec cosine = pad[PAD_HALF_COSINE * view->stride], over_sine = pad[PAD_OVER_HALF_SINE * view->stride];
    const num one = n_set(1.0), thickness = n_sub(one, x);
    const num straight = n_scale(over_sine, n_sub(one, n_scale(cosine, x)));
    const num round = n_sqrt(n_mul(thickness, n_add(one, x)));
    const num most = n_select(n_less(x, n_of(cosine)), straight, round);
    const num square = n_mul(n_sub(most, y), n_add(most, y)), root = n_sqrt(square), both = n_add(most, root);
    const num closing = n_mul(square, n_mul(thickness, thickness)), over = n_div(one, n_mul(both, closing));
    *t = n_sqrt(thickness);
    *w = n_mul(n_mul(y, closing), over);
    *scale = n_mul(n_mul(n_mul(most, most), both), over);
}

/// The journal as a pad sees it, in the pad's frame: its position, and (A, B) at the present tilt; the table
/// coordinates of the position (pads_place); half of alpha; V times the scale, which converts S to a force; and the
/// place in the table.
typedef struct KERNEL(pads_view) {
    num x, y, a, b, t, w, scale;
    num half, size;
    pads_entry entry;
} KERNEL(pads_view);

/// Finds the place in the pad's table.
static inline void KERNEL(pads_film_begin)(vec table, KERNEL(pads_view) * seen) {
    num V;
    KERNEL(pads_direction)(seen->a, seen->b, &V, &seen->half);
    seen->size = n_mul(V, seen->scale);
#ifdef NUMBERS_DUAL
    pads_enter(table, seen->t.value, seen->w.value, seen->half.value, true, &seen->entry);
#else
    pads_enter(table, seen->t, seen->w, seen->half, false, &seen->entry);
#endif
}

/// Computes the film's force.
static inline void KERNEL(pads_film_end)(const KERNEL(pads_view) * seen, num f[2]) {
#ifdef NUMBERS_DUAL
    vec value[2], slope[2][3];
    pads_read_sloped(&seen->entry, value, slope);
    for (int n = 0; n < 2; n++) {
        f[n].value = value[n];
        for (int i = 0; i < DUAL_INPUTS; i++)
            f[n].by[i] = v_fma(slope[n][0], seen->t.by[i],
                               v_fma(slope[n][1], seen->w.by[i], v_mul(slope[n][2], seen->half.by[i])));
    }
#else
    pads_read(&seen->entry, f);
#endif
    for (int n = 0; n < 2; n++) f[n] = n_mul(seen->size, f[n]);
}

static inline void KERNEL(pads_see)(const kernel_view *view, const vec *pad, const num journal[4], num tilt,
                                    const num *yield, KERNEL(pads_view) * seen) {
    const size_t stride = view->stride;
    const vec c = pad[PAD_COSINE * stride], sn = pad[PAD_SINE * stride], twice = view->number[PADS_TWICE * stride];
    num vx = n_add(n_scale(c, journal[2]), n_scale(sn, journal[3]));
    num vy = n_sub(n_scale(c, journal[3]), n_scale(sn, journal[2]));
    seen->x = n_add(n_add(n_scale(c, journal[0]), n_scale(sn, journal[1])), n_of(pad[PAD_SHIFT_X * stride]));
    seen->y = n_add(n_sub(n_scale(c, journal[1]), n_scale(sn, journal[0])), n_of(pad[PAD_SHIFT_Y * stride]));
    if (KERNEL_STATES > 0) {
        seen->x = n_sub(seen->x, n_scale(pad[PAD_ALONG_X * stride], tilt));
        seen->y = n_sub(seen->y, n_scale(pad[PAD_ALONG_Y * stride], tilt));
    }
    if (PADS_YIELD) {
        seen->x = n_sub(seen->x, n_scale(pad[PAD_ALONG_Y * stride], yield[0]));
        seen->y = n_add(seen->y, n_scale(pad[PAD_ALONG_X * stride], yield[0]));
        vx = n_sub(vx, n_scale(pad[PAD_ALONG_Y * stride], yield[1]));
        vy = n_add(vy, n_scale(pad[PAD_ALONG_X * stride], yield[1]));
    }
    seen->a = n_sub(seen->x, n_scale(twice, vy));
    seen->b = n_add(seen->y, n_scale(twice, vx));
    KERNEL(pads_place)(view, pad, seen->x, seen->y, &seen->t, &seen->w, &seen->scale);
}

#ifdef KERNEL_FEWER_STATES
/// Changes the view for a pad that tilts at a rate.
static inline void KERNEL(pads_turn)(const kernel_view *view, const vec *pad, num rate, KERNEL(pads_view) * seen) {
    const vec twice = view->number[PADS_TWICE * view->stride];
    seen->a = n_add(seen->a, n_scale(v_mul(twice, pad[PAD_ALONG_Y * view->stride]), rate));
    seen->b = n_sub(seen->b, n_scale(v_mul(twice, pad[PAD_ALONG_X * view->stride]), rate));
}

/// Returns the sum of all moments about the pivot except that of inertia.
static inline num KERNEL(pads_moments)(const kernel_view *view, const vec *pad, num tilt, num rate, const num f[2]) {
    const size_t stride = view->stride;
    const num held = n_add(n_scale(view->number[PADS_TILT_SPRING * stride], tilt),
                           n_scale(view->number[PADS_TILT_DAMPER * stride], rate));
    const num film = n_add(n_scale(pad[PAD_ALONG_X * stride], f[0]), n_scale(pad[PAD_ALONG_Y * stride], f[1]));
    return n_add(held, n_scale(view->number[PADS_TILT_FORCE * stride], film));
}

/// Prepares the balance (pads_balance.h) of a pad without inertia.
static inline void KERNEL(pads_prepare)(const kernel_view *view, const vec *pad, const KERNEL(pads_view) * seen,
                                        num tilt, pads_pivot *out) {
    const size_t stride = view->stride;
    const vec c = pad[PAD_ALONG_X * stride], d = pad[PAD_ALONG_Y * stride];
    const vec a = n_value(seen->a), b = n_value(seen->b);
    out->along[0] = c;
    out->along[1] = d;
    out->p = v_fma(c, a, v_mul(d, b));
    out->r = v_fms(d, a, v_mul(c, b));
    out->twice = view->number[PADS_TWICE * stride];
    out->scale = n_value(seen->scale);
    out->held = v_mul(view->number[PADS_TILT_SPRING * stride], n_value(tilt));
    out->damper = view->number[PADS_TILT_DAMPER * stride];
    out->lean = pads_lean(pad[PAD_TABLE * stride], n_value(seen->t), n_value(seen->w));
    pads_find(pad[PAD_TABLE * stride], n_value(seen->t), n_value(seen->w), false, &out->spot);
}

/// Computes the force of a pad without inertia, and the slope of its tilt, with the derivatives of an implicit
/// function.
static inline num KERNEL(pads_found)(const kernel_view *view, const vec *pad, const pads_pivot *found,
                                     KERNEL(pads_view) * seen, num tilt, num f[2]) {
    num rate = n_of(found->rate);
#ifdef NUMBERS_DUAL
    KERNEL(pads_turn)(view, pad, rate, seen);
    KERNEL(pads_film_begin)(pad[PAD_TABLE * view->stride], seen);
    KERNEL(pads_film_end)(seen, f);
    const dual moments = KERNEL(pads_moments)(view, pad, tilt, rate, f);
    const vec over = v_div(v_set(-1.0), found->steep);
    for (int i = 0; i < DUAL_INPUTS; i++) {
        rate.by[i] = v_mul(over, moments.by[i]);
        for (int n = 0; n < 2; n++) f[n].by[i] = v_fma(found->by_rate[n], rate.by[i], f[n].by[i]);
    }
    for (int n = 0; n < 2; n++) f[n].value = found->force[n];
#else
    (void)view, (void)pad, (void)seen, (void)tilt;
    for (int n = 0; n < 2; n++) f[n] = found->force[n];
#endif
    return rate;
}

#if PADS_YIELD
/// Computes the slopes of a pad's outward displacement, and of its rate.
static inline void KERNEL(pads_yielding)(const kernel_view *view, const vec *pad, const num *yield, const num f[2],
                                         num *slope) {
    const size_t stride = view->stride;
    const num outwards = n_sub(n_scale(pad[PAD_ALONG_Y * stride], f[0]), n_scale(pad[PAD_ALONG_X * stride], f[1]));
    const num held = n_add(n_scale(view->number[PADS_YIELD_SPRING * stride], yield[0]),
                           n_scale(view->number[PADS_YIELD_DAMPER * stride], yield[1]));
    slope[0] = yield[1];
    slope[1] = n_sub(n_set(0.0), n_add(held, n_scale(view->number[PADS_YIELD_FORCE * stride], outwards)));
}
#endif
#endif

/// Computes the forces of all pads, f [count], in the pads' frames, and the slopes of the states.
static inline void KERNEL(pads_forces)(const element *own, const kernel_view *view, const num *d, const num *w,
                                       const num *s, KERNEL(pads_view) * seen, num f[][2], num *slope) {
    const size_t stride = view->stride, count = (size_t)own->law;
    const vec over = view->number[PADS_OVER_CLEARANCE * stride], sign = view->number[PADS_SIGN * stride];
    const num journal[] = {n_scale(over, d[0]), n_scale(v_mul(sign, over), d[1]), n_scale(over, w[0]),
                           n_scale(v_mul(sign, over), w[1])};
    const vec *pads[MAX_PADS];
    for (size_t p = 0; p < count; p++) pads[p] = view->number + (PADS_FIRST + p * PAD_NUMBERS) * stride;
#ifdef KERNEL_FEWER_STATES
    // States of pads are in length scales, like displacements; convert them to the clearance.
    num place[KERNEL_STATES], rate[KERNEL_STATES];
    for (int i = 0; i < STATES_OF(own); i++) {
        place[i] = n_scale(over, s[i]);
        rate[i] = n_set(0.0); // for compilers, which do not see that the pads set all of them
    }
    const num *yields = place + (pads_are_light(own) ? count : 2 * count);
    if (pads_are_light(own)) {
        pads_pivot pivots[MAX_PADS];
        for (size_t p = 0; p < count; p++) {
            KERNEL(pads_see)(view, pads[p], journal, place[p], yields + 2 * p, &seen[p]);
            KERNEL(pads_prepare)(view, pads[p], &seen[p], place[p], &pivots[p]);
        }
        pads_balance(pivots, count);
        for (size_t p = 0; p < count; p++)
            rate[p] = KERNEL(pads_found)(view, pads[p], &pivots[p], &seen[p], place[p], f[p]);
    } else {
        for (size_t p = 0; p < count; p++) {
            KERNEL(pads_see)(view, pads[p], journal, place[2 * p], yields + 2 * p, &seen[p]);
            KERNEL(pads_turn)(view, pads[p], place[2 * p + 1], &seen[p]);
            KERNEL(pads_film_begin)(pads[p][PAD_TABLE * stride], &seen[p]);
        }
        for (size_t p = 0; p < count; p++) {
            KERNEL(pads_film_end)(&seen[p], f[p]);
            rate[2 * p] = place[2 * p + 1];
            rate[2 * p + 1] =
                n_sub(n_set(0.0), KERNEL(pads_moments)(view, pads[p], place[2 * p], place[2 * p + 1], f[p]));
        }
    }
#if PADS_YIELD
    for (size_t p = 0; p < count; p++)
        KERNEL(pads_yielding)(view, pads[p], yields + 2 * p, f[p], rate + (yields - place) + 2 * p);
#endif
    for (int i = 0; i < STATES_OF(own); i++) slope[i] = n_scale(view->number[PADS_CLEARANCE_UNIT * stride], rate[i]);
#else
    for (size_t p = 0; p < count; p++) {
        KERNEL(pads_see)(view, pads[p], journal, n_set(0.0), NULL, &seen[p]);
        KERNEL(pads_film_begin)(pads[p][PAD_TABLE * stride], &seen[p]);
    }
    for (size_t p = 0; p < count; p++) KERNEL(pads_film_end)(&seen[p], f[p]);
#endif
    (void)s, (void)slope;
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    num FX = n_set(0.0), FY = n_set(0.0), f[MAX_PADS][2];
    KERNEL(pads_view) seen[MAX_PADS];
    KERNEL(pads_forces)(own, view, d, w, s, seen, f, slope);
    for (size_t p = 0; p < (size_t)own->law; p++) {
        const vec *pad = view->number + (PADS_FIRST + p * PAD_NUMBERS) * stride;
        const vec c = pad[PAD_COSINE * stride], sn = pad[PAD_SINE * stride];
        FX = n_add(FX, n_sub(n_scale(c, f[p][0]), n_scale(sn, f[p][1])));
        FY = n_add(FY, n_add(n_scale(sn, f[p][0]), n_scale(c, f[p][1])));
    }
    force[0] = FX;
    force[1] = n_scale(view->number[PADS_SIGN * stride], FY);
}
