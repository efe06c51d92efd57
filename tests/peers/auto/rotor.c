// AUTO-07p's side of the rotor: its functions, an orbit to begin with, and a line of numbers for every point that it
// writes, with digits that its own files do not have.
#include <auto_f2c.h>

#include "rotor_equations.h"

static const double pi = 3.14159265358979323846;

/// Carries u from tau to tau + length by RK4.
static void carry(double r_k, double length, int steps, double u[ROTOR_ALL]) {
    const double h = length / steps;
    double k[4][ROTOR_ALL], v[ROTOR_ALL];
    for (int n = 0; n < steps; n++) {
        rotor_slope(r_k, u, k[0]);
        for (int stage = 1; stage < 4; stage++) {
            const double part = stage == 3 ? h : 0.5 * h;
            for (int i = 0; i < ROTOR_ALL; i++) v[i] = u[i] + part * k[stage - 1][i];
            rotor_slope(r_k, v, k[stage]);
        }
        for (int i = 0; i < ROTOR_ALL; i++) u[i] += h / 6.0 * (k[0][i] + 2.0 * (k[1][i] + k[2][i]) + k[3][i]);
    }
}

static int func(integer ndim, const doublereal *u, const integer *icp, const doublereal *par, integer ijac,
                doublereal *f, doublereal *dfdu, doublereal *dfdp) {
    double by_state[ROTOR_ALL][ROTOR_ALL];
    (void)icp;
    rotor_slope(par[0], u, f);
    if (ijac == 0) return 0;
    // Column-major, as Fortran has it; the first parameter is the first column of dfdp.
    rotor_slope_by_state(par[0], u, by_state);
    for (int i = 0; i < ndim; i++)
        for (int j = 0; j < ndim; j++) dfdu[i + j * ndim] = by_state[i][j];
    if (ijac > 1) rotor_slope_by_ratio(u, dfdp);
    return 0;
}

/// Sets the orbit at the first value of r_k, for t from 0 to 1 (AUTO requires rising t): nine digits of the settled
/// motion, which AUTO corrects.
static int stpnt(integer ndim, doublereal t, doublereal *u, doublereal *par) {
    static const double begin[ROTOR_ALL] = {0.172805946,  -0.904191162, 0.172249261,  -0.857663012, -0.010018961,
                                            -0.257350322, 0.084299494,  -0.136670746, 1.0,          0.0};
    static double there[ROTOR_ALL], instant = 2.0;
    par[0] = 0.6;
    par[10] = 2.0 * pi;
    if (t < instant) {
        for (int i = 0; i < ndim; i++) there[i] = begin[i];
        instant = 0.0;
    }
    if (t > instant) carry(par[0], 2.0 * pi * (t - instant), 1 + (int)(1024.0 * (t - instant)), there);
    for (int i = 0; i < ndim; i++) u[i] = there[i];
    instant = t;
    return 0;
}

static int bcnd(integer ndim, const doublereal *par, const integer *icp, integer nbc, const doublereal *u0,
                const doublereal *u1, integer ijac, doublereal *fb, doublereal *dbc) {
    (void)ndim, (void)par, (void)icp, (void)nbc, (void)u0, (void)u1, (void)ijac, (void)fb, (void)dbc;
    return 0;
}

static int icnd(integer ndim, const doublereal *par, const integer *icp, integer nint, const doublereal *u,
                const doublereal *uold, const doublereal *udot, const doublereal *upold, integer ijac, doublereal *fi,
                doublereal *dint) {
    (void)ndim, (void)par, (void)icp, (void)nint, (void)u, (void)uold, (void)udot, (void)upold, (void)ijac, (void)fi;
    (void)dint;
    return 0;
}

static int fopt(integer ndim, const doublereal *u, const integer *icp, const doublereal *par, integer ijac,
                doublereal *fs, doublereal *dfdu, doublereal *dfdp) {
    (void)ndim, (void)u, (void)icp, (void)par, (void)ijac, (void)fs, (void)dfdu, (void)dfdp;
    return 0;
}

/// Prints a line of points.txt: r_k, period, the state at tau = 0, the multipliers as pairs of real and imaginary part.
static int pvls(integer ndim, const doublereal *u, doublereal *par) {
    static FILE *points;
    double start[ROTOR_ALL];
    if (!points) points = fopen("points.txt", "w");
    if (!points) exit(1);
    for (int i = 0; i < ndim; i++) start[i] = getp("BV0", i + 1, u);
    // An orbit of AUTO may begin at any phase: move it to the instant at which the cosine is one.
    const double phase = atan2(start[9], start[8]);
    if (phase != 0.0) carry(par[0], -phase, 64, start);
    fprintf(points, "%.16g %.16g", par[0], par[10]);
    for (int i = 0; i < ROTOR_STATES; i++) fprintf(points, " %.16g", start[i]);
    for (int i = 1; i <= 2 * ROTOR_ALL; i++) fprintf(points, " %.16g", getp("EIG", i, u));
    fprintf(points, "\n");
    fflush(points);
    return 0;
}
