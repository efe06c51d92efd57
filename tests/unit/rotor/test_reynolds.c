// The film of a pad where it has closed forms: turbulent ones, whose factors are those of a gap of one height; oil
// that grooves press into a gap without a wedge.
#include <math.h>

#include "reynolds.h"
#include "settings.h"
#include "turbulence.h"

static const double pi = 3.14159265358979323846;

static pad_answer solve(const pad_film *film, const pad_place *at) {
    pad_workspace *work;
    pad_answer out;
    check(pad_workspace_new(film->around, film->along, &work));
    check(pad_solve(work, film, at, &out));
    pad_workspace_free(work);
    return out;
}

/// A squeezed gap of constant height has the flow factors of its Reynolds number, to all digits of a very long and a
/// very short pad, and the shear of Couette's flow.
static void one_height(void **unused) {
    static const double reynolds = 3000.0;
    const pad_place squeezed = {.b = 1.0}, still = {.x = 0.0};
    (void)unused;
    for (int law = WHIRL_NG_PAN; law <= WHIRL_CONSTANTINESCU; law++) {
        const turbulent_factors by = turbulent_resistance((whirl_turbulence)law, reynolds);
        for (int is_long = 0; is_long < 2; is_long++) {
            pad_film film = {
                .arc = 1.2, .ratio = is_long ? 1e4 : 1e-3, .law = CAVITATION_GUMBEL, .around = 96, .along = 8};
            const double laminar = solve(&film, &squeezed).highest, dry = solve(&film, &still).drag;
            film.turbulence = (whirl_turbulence)law;
            film.reynolds = reynolds;
            assert_true(fabs(solve(&film, &squeezed).highest / laminar - (is_long ? by.around : by.along)) < 2e-6);
            assert_true(fabs(dry - film.arc) < 1e-12);
            assert_true(fabs(solve(&film, &still).drag - film.arc * (1.0 + 0.0012 * pow(reynolds, 0.94))) < 1e-9);
        }
    }
}

/// Without inertia there is no turbulence.
static void laminar_limit(void **unused) {
    pad_film film = {.arc = 2.0, .ratio = 0.5, .law = CAVITATION_REYNOLDS, .around = 96, .along = 8};
    const pad_place at = {.x = 0.3, .y = -0.4, .a = 0.3, .b = -0.4};
    const pad_answer laminar = solve(&film, &at);
    (void)unused;
    for (int law = WHIRL_NG_PAN; law <= WHIRL_CONSTANTINESCU; law++) {
        film.turbulence = (whirl_turbulence)law;
        film.reynolds = 0.0;
        const pad_answer none = solve(&film, &at);
        film.reynolds = law == WHIRL_NG_PAN ? 1e-9 : 1e-11;
        const pad_answer little = solve(&film, &at);
        for (int i = 0; i < 2; i++) {
            assert_true(none.force[i] == laminar.force[i]);
            assert_true(fabs(little.force[i] - laminar.force[i]) < 1e-10);
        }
        assert_true(fabs(little.drag - laminar.drag) < 1e-10 && fabs(little.leaving - laminar.leaving) < 1e-10);
    }
}

/// Returns Reichardt's eddy viscosity over the molecular one, y+ from the nearer wall, and its derivative.
static double eddy(double y, double *slope) {
    const double of = tanh(y / 10.7);
    *slope = 0.4 * of * of;
    return 1.0 + 0.4 * (y - 10.7 * of);
}

/// Computes Ng and Pan's factors from the law of the wall to which they were fitted (J. Basic Engineering 87, 1965):
/// Couette flow with h+ = h sqrt(shear/rho)/nu, perturbed by a slope of pressure along and across it. The integrals use
/// midpoints over half the gap.
static double law_of_the_wall(double h, double *around, double *along, double *shear) {
    enum { POINTS = 20000 };
    double turn = 0.0, x = 0.0, z = 0.0;
    for (int i = 0; i < POINTS; i++) {
        const double s = (i + 0.5) / POINTS, e = 0.5 * s * s, de = s / POINTS; // finer at the wall
        double slope;
        const double f = eddy(e * h, &slope), arm = (0.5 - e) * (0.5 - e);
        turn += 2.0 * de / f;
        z += 2.0 * de * arm / f;
        x += 2.0 * de * arm / f * (1.0 - 0.5 * e * h * slope / f);
    }
    *around = 1.0 / x / 12.0;
    *along = 1.0 / z / 12.0;
    *shear = 1.0 / turn;
    return h * h * turn; // the Reynolds number
}

static void against_the_law_of_the_wall(void **unused) {
    static const struct {
        double reynolds, flow, shear; // what the fits err by
    } rows[] = {{1000, 0.08, 0.02}, {2000, 0.02, 0.04}, {5000, 0.05, 0.05}, {10000, 0.05, 0.01}, {20000, 0.02, 0.07}};
    (void)unused;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double low = 1.0, high = 1e5, around, along, shear;
        for (int k = 0; k < 60; k++) {
            const double middle = sqrt(low * high);
            *(law_of_the_wall(middle, &around, &along, &shear) < rows[i].reynolds ? &low : &high) = middle;
        }
        const turbulent_factors by = turbulent_resistance(WHIRL_NG_PAN, rows[i].reynolds);
        assert_true(fabs(by.around / around - 1.0) < rows[i].flow && fabs(by.along / along - 1.0) < rows[i].flow);
        assert_true(fabs(turbulent_shear(WHIRL_NG_PAN, rows[i].reynolds) / shear - 1.0) < rows[i].shear);
    }
}

/// Without a wedge Laplace's equation is left: P = sum a cos(l zeta) cosh(l D/L p)/cosh(l D/L arc/2), l = (n - 1/2) pi,
/// a = 2 cos(l groove)/((1 - groove) l^2) of the trapezoid at the edges. Its force and what leaves at both ends.
static void pressed_by_grooves(void **unused) {
    const pad_film film = {.arc = 1.4, .ratio = 0.6, .around = 384, .along = 48, .supply = 2.0, .groove = 0.75};
    const pad_place at = {.a = 0.0};
    const double half = 0.5 * film.arc;
    double force = 0.0, leaving = 0.0;
    (void)unused;
    for (int n = 1; n < 400; n++) {
        const double l = (n - 0.5) * pi, m = l / film.ratio, sign = n % 2 ? 1.0 : -1.0;
        const double a = film.supply * 2.0 * cos(l * film.groove) / ((1.0 - film.groove) * l * l);
        // int cosh(m p) cos p dp over the pad, over cosh(m half); int cos(l zeta) from 0 to 1 is sign/l.
        const double cosine = 2.0 * (m * tanh(m * half) * cos(half) + sin(half)) / (m * m + 1.0);
        force -= 6.0 * a * sign / l * cosine;
        // 1/2 (D/L)^2 int -dP/dzeta dp at zeta = 1.
        leaving += 0.5 / (film.ratio * film.ratio) * a * l * sign * 2.0 * tanh(m * half) / m;
    }
    const pad_answer out = solve(&film, &at);
    assert_true(fabs(out.force[0] / force - 1.0) < 1e-5 && fabs(out.force[1]) < 1e-12);
    assert_true(fabs(out.leaving / leaving - 1.0) < 2e-3);
    assert_true(fabs(out.drag - film.arc) < 1e-9 && fabs(out.highest - film.supply) < 1e-12);
}

/// Without cavitation the equation is linear: the forces of the wedge and of the grooves add up.
static void added(void **unused) {
    pad_film film = {.arc = 1.4, .ratio = 0.6, .around = 96, .along = 12, .supply = 3.0, .groove = 0.8};
    const pad_place there = {.x = 0.1, .y = 0.2, .a = 0.1, .b = 0.2}, back = {.x = 0.1, .y = 0.2, .a = -0.1, .b = -0.2};
    const pad_place still = {.x = 0.1, .y = 0.2};
    const pad_answer one = solve(&film, &there), other = solve(&film, &back), none = solve(&film, &still);
    (void)unused;
    for (int i = 0; i < 2; i++) assert_true(fabs(one.force[i] + other.force[i] - 2.0 * none.force[i]) < 1e-9);
    assert_true(fabs(one.leaving + other.leaving - 2.0 * none.leaving) < 1e-9);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_height),
        cmocka_unit_test(laminar_limit),
        cmocka_unit_test(against_the_law_of_the_wall),
        cmocka_unit_test(pressed_by_grooves),
        cmocka_unit_test(added),
    };
    return cmocka_run_group_tests_name("reynolds", tests, NULL, NULL);
}
