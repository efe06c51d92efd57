// An annular seal whose fluid turns at lambda times the shaft's speed (Muszynska 1988). On a place at d with the
// velocity w, both as complex numbers, the force is
//
//     -(K d + D (w - i lambda d) - m_f (2 i lambda w + lambda^2 d)),
//
// K = K_0 (1 - e^2)^-n, D = D_0 (1 - e^2)^-n, lambda = lambda_0 (1 - e)^b, e = |d|/c. The term m_f w' is not in
// this force: it is part of the station's inertia, or in a housing that moves, an inerter between both. At the wall and
// beyond, the force is not a number, and the motion counts as diverged. Powers that are not given by keys are 1, and
// are not computed.

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const vec *number = view->number;
    const size_t stride = view->stride;
    const vec one = v_set(1.0), over_square = number[SEAL_OVER_CLEARANCE_SQUARE * stride];
    const num square = n_scale(over_square, n_fma(d[0], d[0], n_mul(d[1], d[1])));
    const num room = n_sub(n_of(one), square), inside = n_select(n_less(n_set(0.0), room), n_of(one), n_set(NAN));
    num turn = n_of(number[SEAL_RATIO * stride]), growth = inside;
    if (own->law & SEAL_SLOWS)
        turn = n_mul(turn, n_pow(n_sub(n_of(one), n_sqrt(square)), number[SEAL_SLOWING * stride]));
    if (own->law & SEAL_GROWS) growth = n_pow(room, v_sub(v_set(0.0), number[SEAL_GROWTH * stride]));
    const num stiffness = n_scale(number[SEAL_STIFFNESS * stride], growth);
    const num damping = n_scale(number[SEAL_DAMPING * stride], growth);
    const num spin = n_scale(number[SEAL_MASS * stride], turn);
    const num along = n_sub(stiffness, n_mul(spin, turn)), across = n_mul(damping, turn), coriolis = n_add(spin, spin);
    (void)s, (void)slope;
    force[0] = n_add(n_fma(along, d[0], n_mul(across, d[1])), n_fma(damping, w[0], n_mul(coriolis, w[1])));
    force[1] =
        n_add(n_sub(n_mul(along, d[1]), n_mul(across, d[0])), n_sub(n_mul(damping, w[1]), n_mul(coriolis, w[0])));
    for (int a = 0; a < KERNEL_AXES; a++) force[a] = n_sub(n_set(0.0), force[a]);
}
