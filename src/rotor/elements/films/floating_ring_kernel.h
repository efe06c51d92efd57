// A ring that floats between a journal and its housing, with a short film on either side of it.
//
// A film between surfaces that turn at a and b times the shaft's speed is that of film_kernel.h with A = s x - 2y' and
// B = s y + 2x' in place of its A and B, where s = a + b. s may be negative, since the mirror image of a film that
// turns backwards has the same A and B; and 0, for a film that is only squeezed. If the ring turns at r times the
// shaft's speed, s is 1 + r in the inner film and r in the outer one. The oil of each film drags the ring along or
// holds it back with the torque
//
//     2 pi mu R^3 L (a - b)/(c sqrt(1 - e^2))
//
// (Petroff's law, over the mean of 1/h). The state is r minus its value with journal and ring centred, in units of
// RING_STATE_UNIT. Beyond a wall the force is not a number, and the motion counts as diverged.

/// Computes the force on the inner one of two places with the relative displacement d and velocity w, and sqrt(1 -
/// e^2).
static inline void KERNEL(ring_film)(vec over_clearance, vec strength, const num *d, const num *w, num s, num *force,
                                     num *root) {
    const num x = n_scale(over_clearance, d[0]), y = n_scale(over_clearance, d[1]);
    const vec twice = v_add(over_clearance, over_clearance);
    const num A = n_sub(n_mul(s, x), n_scale(twice, w[1])), B = n_fma(s, y, n_scale(twice, w[0]));
    const num q = n_sub(n_set(1.0), n_fma(x, x, n_mul(y, y))), over_q = n_div(n_set(1.0), q);
    const num W = n_sqrt(n_mul(q, n_fma(A, A, n_fma(B, B, n_set(0x1p-600)))));
    const num P = n_sub(n_mul(x, B), n_mul(y, A)), U = n_fma(x, A, n_mul(y, B));
    const num angle = n_add(n_set(1.57079632679489661923), n_angle(W, P));
    const num E = n_div(n_mul(U, W), n_fma(W, W, n_mul(P, P)));
    const num M = n_mul(n_set(3.0), n_mul(over_q, n_fma(P, angle, W)));
    const num factor = n_mul(n_scale(v_mul(v_set(-2.0), strength), n_sqrt(over_q)), over_q);
    force[0] = n_mul(factor, n_fma(x, M, n_sub(n_mul(B, angle), n_mul(A, E))));
    force[1] = n_mul(factor, n_sub(n_mul(y, M), n_fma(A, angle, n_mul(B, E))));
    *root = n_sqrt(q);
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const vec *number = view->number;
    const size_t stride = view->stride;
    const num turn = n_of(number[RING_TURN * stride]);
    const num speed = n_scale(number[RING_INNER_OVER_CLEARANCE * stride], s[0]);
    const num ring = n_add(speed, n_of(number[RING_SPEED * stride]));
    num inner, outer;
    (void)own;
    KERNEL(ring_film)
    (number[RING_INNER_OVER_CLEARANCE * stride], number[RING_INNER_STRENGTH * stride], d, w, n_add(turn, ring), force,
     &inner);
    KERNEL(ring_film)
    (number[RING_OUTER_OVER_CLEARANCE * stride], number[RING_OUTER_STRENGTH * stride], d + 2, w + 2, ring, force + 2,
     &outer);
    const num rate = n_sub(n_div(n_scale(number[RING_INNER_DRAG * stride], n_sub(turn, ring)), inner),
                           n_div(n_scale(number[RING_OUTER_DRAG * stride], ring), outer));
    slope[0] = n_scale(number[RING_STATE_UNIT * stride], rate);
}
