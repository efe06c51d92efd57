// A squeeze film damper: a cylinder that does not turn, in an oil film of clearance c.
//
// The centre of the cylinder is at r = (x, y) from that of its housing and moves at v, both in clearances. The film's
// thickness is h = 1 - r.n in the direction n = (cos phi, sin phi). By Reynolds' equation without the wedge term the
// pressure (in the short damper its integral over the length, in the long one its value at every axial position) is
// proportional to
//
//     short: v.n/h^3,      long: w.n (1/h + 1/h^2),   w = (2v + r (r.v))/(2 + r^2),
//
// The pressure is positive over the half of the circumference around the direction of v or w. With v standing for w in
// the long damper and
//
//     q = 1 - r^2,  p = r.v,  u = y v_x - x v_y,  W = sqrt(q v^2),  D = W^2 + p^2,  M = (W + p angle)/q,  E = u W/D
//
// the force, the integral over the positive half, is with angle = pi/2 + atan(p/W)
//
//     short: f = -q^(-3/2) (angle v + 3 M r + E (v_y, -v_x)),      long: f = -q^(-1/2) (angle v + M r)
//
// times mu omega R L^3/c^2 or 12 mu omega L R^3/c^2. For the whole film, which has negative pressures too, angle = pi
// and W = 0.
//
// A cylinder at rest feels no force; the 2^-600 in v^2 keeps its quotients finite. The derivative of the half film
// jumps there with the direction. The derivative is taken as half that of the whole film, the mean of those for motions
// in opposite directions. Beyond the wall (q < 0) the force is not a number, and the motion counts as diverged.

/// Computes r and v in clearances; for a long damper, w in place of v.
static inline void KERNEL(squeeze_motion)(const element *own, vec over_clearance, const num *d, const num *w, num *r,
                                          num *v) {
    for (int a = 0; a < KERNEL_AXES; a++) {
        r[a] = n_scale(over_clearance, d[a]);
        v[a] = n_scale(over_clearance, w[a]);
    }
    if (!(own->law & SQUEEZE_LONG)) return;
    const num two = n_set(2.0), p = n_fma(r[0], v[0], n_mul(r[1], v[1]));
    const num over = n_div(n_set(1.0), n_fma(r[0], r[0], n_fma(r[1], r[1], two)));
    for (int a = 0; a < KERNEL_AXES; a++) v[a] = n_mul(over, n_fma(r[a], p, n_mul(two, v[a])));
}

static inline void KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s,
                                 num *force, num *slope) {
    const vec strength = view->number[SQUEEZE_STRENGTH * view->stride];
    num r[KERNEL_AXES], v[KERNEL_AXES];
    (void)s, (void)slope;
    KERNEL(squeeze_motion)(own, view->number[SQUEEZE_OVER_CLEARANCE * view->stride], d, w, r, v);
    // q is 1 minus the square of the eccentricity, p half the rate of that square.
    const num q = n_sub(n_set(1.0), n_fma(r[0], r[0], n_mul(r[1], r[1])));
    const num p = n_fma(r[0], v[0], n_mul(r[1], v[1])), over_q = n_div(n_set(1.0), q);
    // With cavitation only half of the circumference carries; without, all of it.
    num W = n_set(0.0), angle = n_set(3.14159265358979323846), E = n_set(0.0);
    if (!(own->law & SQUEEZE_FULL)) {
        W = n_sqrt(n_mul(q, n_fma(v[0], v[0], n_fma(v[1], v[1], n_set(0x1p-600)))));
        angle = n_add(n_set(1.57079632679489661923), n_angle(W, p));
        const num u = n_sub(n_mul(r[1], v[0]), n_mul(r[0], v[1]));
        E = n_div(n_mul(u, W), n_fma(W, W, n_mul(p, p)));
    }
    // Choose between a short and a long film.
    num M = n_mul(n_fma(p, angle, W), over_q), factor = n_scale(strength, n_sqrt(over_q));
    num across[2] = {n_set(0.0), n_set(0.0)};
    if (!(own->law & SQUEEZE_LONG)) {
        M = n_mul(n_set(3.0), M);
        factor = n_mul(factor, over_q);
        across[0] = n_mul(E, v[1]);
        across[1] = n_sub(n_set(0.0), n_mul(E, v[0]));
    }
    // Compute the force along both axes.
    for (int a = 0; a < KERNEL_AXES; a++) {
        const num push = n_fma(angle, v[a], n_fma(M, r[a], across[a]));
        force[a] = n_sub(n_set(0.0), n_mul(factor, push));
    }
}
