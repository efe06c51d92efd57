// A rolling bearing whose balls or rollers pass under the load (Sunnersjo 1978; Fukata et al. 1985). Ball j stands at
// theta_j = theta + 2 pi j/N, theta = theta_0 + ratio tau. With the shaft at r_j = x cos theta_j + y sin theta_j in the
// direction of the ball, the ball is compressed by delta_j = r_j - g_0. Where that is above zero it pushes back by
// Hertz's law:
//
//     f = -C sum_j delta_j^n lever_j (cos theta_j, sin theta_j),    n = 3/2, of rollers 10/9; lever_j = 1.
//
// In an oblique contact the centres of both grooves, whose distance without load is A, are at a distance of
// A_j = sqrt((R + r_j)^2 + Z^2) with R = A cos alpha_0 - g_0 and Z = A sin alpha_0 + the axial displacement. Then
// delta_j = A_j - A and lever_j = (R + r_j)/A_j. A_j - A is computed as (r_j (2 R + r_j) + R^2 + Z^2 - A^2)/(A_j + A),
// which has no cancellation.
//
// A dent of depth h and width w reduces delta_j by h (1 + cos(2 pi phi/w))/2 for |phi| < w/2, where phi is the angle
// from its middle: for a dent in a race, the ball's angle; for a dent in a ball, the angle of the contact with the
// inner race, or with the outer one.
//
// The force has a continuous derivative, so that contacts need not be located. The angles, minus their initial values,
// are states, since they need not return after a revolution.

#ifdef ROLLING_DENTED
/// Returns the depth of dent `which` at the angle from its middle, whose cosine and sine are x and y.
static inline num KERNEL(dent)(const kernel_view *view, int which, num x, num y) {
    const vec *number = view->number;
    const size_t stride = view->stride;
    const vec half = v_mul(v_set(0.5), number[(ROLLING_DEPTH + (size_t)which) * stride]);
    const num edge = n_of(number[(ROLLING_EDGE + (size_t)which) * stride]);
    num sine, cosine;
    n_sincos(n_scale(number[(ROLLING_OVER_WIDTH + (size_t)which) * stride], n_angle(x, y)), &sine, &cosine);
    return n_select(n_less(edge, x), n_scale(half, n_add(n_set(1.0), cosine)), n_set(0.0));
}

/// Returns the depth of both races' dents under a ball at the angle of x and y. `at` has the cosines and sines of the
/// dents.
static inline num KERNEL(race_dents)(const kernel_view *view, const num *at, num x, num y) {
    num taken = n_set(0.0);
    for (int race = DENT_INNER; race <= DENT_OUTER; race++) {
        const num c = at[2 * (size_t)race], s = at[2 * (size_t)race + 1];
        taken = n_add(taken, KERNEL(dent)(view, race, n_fma(x, c, n_mul(y, s)), n_sub(n_mul(y, c), n_mul(x, s))));
    }
    return taken;
}

static inline void KERNEL(find_dents)(const kernel_view *view, const num *s, num *at) {
    for (size_t race = DENT_INNER; race <= DENT_OUTER; race++) {
        const vec start = view->number[(ROLLING_DENT_START + race) * view->stride];
        n_sincos(n_add(s[1 + race], n_of(start)), &at[2 * race + 1], &at[2 * race]);
    }
}

/// Returns the depth of the ball's own dent, at the ball's angle, on both races.
static inline num KERNEL(ball_dent)(const kernel_view *view, num angle) {
    const num zero = n_set(0.0);
    num x, y;
    n_sincos(angle, &y, &x);
    const num back_x = n_sub(zero, x), back_y = n_sub(zero, y);
    return n_add(KERNEL(dent)(view, DENT_BALL, x, y), KERNEL(dent)(view, DENT_BALL, back_x, back_y));
}
#endif

/// Returns the compression of a ball with the shaft at r along it. *lever becomes the part of the ball's push that acts
/// along the radius.
static inline num KERNEL(oblique)(const kernel_view *view, num r, num *lever) {
    const vec *number = view->number;
    const size_t stride = view->stride;
    const vec radial = number[ROLLING_RADIAL * stride];
    const num reach = n_add(r, n_of(radial)), axial = n_of(number[ROLLING_AXIAL_SQUARE * stride]);
    const num square = n_fma(reach, reach, axial), over = n_over_root(square), apart = n_mul(square, over);
    const num further = n_add(reach, n_of(radial)), longer = n_fma(r, further, n_of(number[ROLLING_SPARE * stride]));
    *lever = n_mul(reach, over);
    return n_div(longer, n_add(apart, n_of(number[ROLLING_CENTRES * stride])));
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    const vec start = number[ROLLING_START * stride];
    const vec c = number[ROLLING_APART_COS * stride], sine = number[ROLLING_APART_SIN * stride];
    const num gap = n_of(number[ROLLING_GAP * stride]), zero = n_set(0.0), least = n_set(0x1p-800);
    const num angle = n_add(s[0], n_of(start));
    num x, y, lever = n_set(1.0), sum_x = zero, sum_y = zero;
    (void)w;
    for (size_t i = 0; i < KERNEL_STATES; i++) slope[i] = n_of(number[(ROLLING_RATES + i) * stride]);
    n_sincos(angle, &y, &x);
#ifdef ROLLING_DENTED
    num at[2 * DENT_BALL];
    KERNEL(find_dents)(view, s, at);
#endif
    // For each rolling element compute its compression along its direction (x, y), and its push.
    for (int j = 0; j < (own->law & ROLLING_COUNT); j++) {
        const num r = n_fma(d[0], x, n_mul(d[1], y));
        num pressed = own->law & ROLLING_OBLIQUE ? KERNEL(oblique)(view, r, &lever) : n_sub(r, gap);
#ifdef ROLLING_DENTED
        pressed = n_sub(pressed, KERNEL(race_dents)(view, at, x, y));
        if (j == 0 && own->law & ROLLING_BALL_DENT) pressed = n_sub(pressed, KERNEL(ball_dent)(view, s[3]));
#endif
        const num depth = n_select(n_less(zero, pressed), pressed, zero);
        num push = n_mul(depth, own->law & ROLLING_LINE ? n_ninth_root(n_select(n_less(least, depth), depth, least))
                                                        : n_sqrt(depth));
        if (own->law & ROLLING_OBLIQUE) push = n_mul(push, lever);
        sum_x = n_fma(push, x, sum_x);
        sum_y = n_fma(push, y, sum_y);
        // Turn to the direction of the next element.
        const num next = n_sub(n_scale(c, x), n_scale(sine, y));
        y = n_add(n_scale(sine, x), n_scale(c, y));
        x = next;
    }
    const vec stiffness = v_sub(v_set(0.0), number[ROLLING_STIFFNESS * stride]);
    force[0] = n_scale(stiffness, sum_x);
    force[1] = n_scale(stiffness, sum_y);
}
