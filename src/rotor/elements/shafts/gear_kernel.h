// The mesh of two gears: a spring and damper along the line of action, with play. Its stiffness and its error may
// change with the phase psi of the mesh, a state that turns by 2 pi from tooth to tooth.
//
//     delta = n_x (x1 - x2) + n_y (y1 - y2) + r1 theta1 + r2 theta2 + n_z (z1 - z2) - e cos(psi + phi)
//     F = k(psi) (delta - b) + c delta'    where delta > b,
//     F = k(psi) (delta + b) + c delta'    where delta < -b,    else 0
//     k(psi) = k (1 + eps) where |psi - pi d| < pi d, else k (1 - eps), or a sum of cosines and sines of n psi;
//
// The switches are delta - b and delta + b if there is play; then, if the stiffness changes, cos(psi - pi d) - cos(pi
// d). The last one is computed as a product, so that rounding does not move its zeros, one of which is at the beginning
// of a revolution. d[GEAR_TWIST] is the sum of both twists times their radii, of which the second is negative. z1 and
// z2 are the shifts of both pitch points along the shafts, by the gears' tilts and by their axial displacements;
// d[GEAR_TILT_X] + d[GEAR_TILT_Y] + d[GEAR_AXIAL] is n_z (z1 - z2).

/// Returns delta by the displacements, without the error.
static inline num KERNEL(along_action)(const kernel_view *view, const num *d) {
    const vec *number = view->number;
#ifdef GEAR_IN_SPACE
    const num turned = n_add(d[GEAR_TWIST], n_add(d[GEAR_AXIAL], n_add(d[GEAR_TILT_X], d[GEAR_TILT_Y])));
#else
    const num turned = d[GEAR_TWIST];
#endif
    return n_add(turned, n_add(n_scale(number[GEAR_ALONG_X * view->stride], d[0]),
                               n_scale(number[GEAR_ALONG_Y * view->stride], d[1])));
}

/// Computes the closing of the mesh and its rate, with the error.
static inline void KERNEL(closing)(const element *own, const kernel_view *view, const num *d, const num *w,
                                   const num *s, num *closing, num *rate) {
    const size_t stride = view->stride;
    *closing = KERNEL(along_action)(view, d);
    *rate = KERNEL(along_action)(view, w);
    if (!(own->law & GEAR_ERROR)) return;
    num sine, cosine;
    n_sincos(s[0], &sine, &cosine);
    const vec c = view->number[GEAR_ERROR_COS * stride], e = view->number[GEAR_ERROR_SIN * stride];
    const vec turn = view->number[GEAR_RATE * stride];
    *closing = n_sub(*closing, n_sub(n_scale(c, cosine), n_scale(e, sine)));
    *rate = n_add(*rate, n_scale(turn, n_add(n_scale(c, sine), n_scale(e, cosine))));
}

/// Writes the switches of a mesh with a closing.
static inline void KERNEL(mesh_switches)(const element *own, const kernel_view *view, num closing, const num *s,
                                         num *values) {
    const size_t stride = view->stride;
    int next = 0;
    if (own->law & GEAR_PLAY) {
        values[next++] = n_sub(closing, n_of(view->number[GEAR_GAP * stride]));
        values[next++] = n_add(closing, n_of(view->number[GEAR_GAP * stride]));
    }
    if (own->law & GEAR_PAIRS) {
        const num half = n_scale(v_set(0.5), s[0]);
        num begun, ends, cosine;
        n_sincos(half, &begun, &cosine);
        n_sincos(n_sub(n_of(view->number[GEAR_SHARE * stride]), half), &ends, &cosine);
        values[next] = n_scale(v_set(2.0), n_mul(begun, ends));
    }
}

static inline void KERNEL(switches)(const element *own, const kernel_view *view, const num *d, const num *w,
                                    const num *s, num *values) {
    num closing = n_set(0.0), rate;
    if (own->law & GEAR_PLAY) KERNEL(closing)(own, view, d, w, s, &closing, &rate);
    KERNEL(mesh_switches)(own, view, closing, s, values);
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const size_t stride = view->stride;
    const vec *number = view->number;
    num closing, rate, at[KERNEL_SWITCHES];
    vec_mask above[KERNEL_SWITCHES];
    KERNEL(closing)(own, view, d, w, s, &closing, &rate);
    KERNEL(mesh_switches)(own, view, closing, s, at);
    for (int i = 0; i < (int)GEAR_SWITCHES(own); i++)
        above[i] = v_less(v_set(0.0), view->sides ? view->sides[(size_t)i * stride] : n_value(at[i]));
    num stiffness = n_of(number[GEAR_STIFFNESS * stride]);
    if (own->law & GEAR_PAIRS)
        stiffness = n_select(above[GEAR_SWITCHES(own) - 1], n_of(number[GEAR_STIFFNESS * stride]),
                             n_of(number[GEAR_STIFFNESS_LESS * stride]));
    if (own->law & GEAR_PROFILE) {
        // Compute cos and sin of n psi from those of (n - 1) psi.
        num c, s1, cosine, sine;
        n_sincos(s[0], &s1, &c);
        cosine = c;
        sine = s1;
        for (int n = 0; n < own->law / GEAR_LAWS; n++) {
            const num by_cos = n_scale(number[(size_t)(GEAR_PARTS + n) * stride], cosine);
            const num by_sin = n_scale(number[(size_t)(GEAR_PARTS + GEAR_HARMONICS + n) * stride], sine);
            stiffness = n_add(stiffness, n_add(by_cos, by_sin));
            const num next = n_sub(n_mul(cosine, c), n_mul(sine, s1));
            sine = n_add(n_mul(sine, c), n_mul(cosine, s1));
            cosine = next;
        }
    }
    const num damper = n_scale(number[GEAR_DAMPING * stride], rate);
    num pressed = n_add(n_mul(stiffness, closing), damper);
    if (own->law & GEAR_PLAY) {
        const num ahead = n_add(n_mul(stiffness, at[0]), damper), behind = n_add(n_mul(stiffness, at[1]), damper);
        pressed = n_select(above[0], ahead, n_select(above[1], n_set(0.0), behind));
    }
    pressed = n_sub(n_set(0.0), pressed);
    force[0] = n_scale(number[GEAR_ALONG_X * stride], pressed);
    force[1] = n_scale(number[GEAR_ALONG_Y * stride], pressed);
    for (size_t a = GEAR_TWIST; a < KERNEL_AXES; a++) force[a] = pressed;
    slope[0] = n_of(number[GEAR_RATE * stride]); // used only if the phase of the mesh is a state
}
