// A ball bearing of type 6306 whose balls pass under a weight, against forces and a periodic motion computed by other
// programs, and cages that fit no revolution.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "support_lanes.h"
#include "whirl/engine.h"

/// Makes a bearing: Nb 8, C_b 1.334e10 N/m^1.5, m 20 kg, c 200 N s/m, W 196 N along x, g_0 3 um; lengths in um, `cage`
/// over `speed`.
static whirl_rotor *make_bearing(double speed, double cage, double angle) {
    const whirl_setting rotor[] = {{"mass", 20.0, NULL}};
    const whirl_setting bearing[] = {{"at", 0, "rotor"},        {"balls", 8, NULL},   {"stiffness", 1.334e10, NULL},
                                     {"clearance", 3e-6, NULL}, {"cage", cage, NULL}, {"angle", angle, NULL},
                                     {"damping", 200.0, NULL}};
    const whirl_setting weight[] = {{"acceleration", 9.8, NULL}, {"direction", 0.0, NULL}};
    whirl_design *design;
    whirl_rotor *built;
    require_ok(whirl_design_new(speed, 1e-6, &design));
    require_ok(whirl_design_station(design, "rotor", rotor, 1));
    require_ok(whirl_design_element(design, "ball_bearing", bearing, 7));
    require_ok(whirl_design_element(design, "gravity", weight, 2));
    require_ok(whirl_rotor_new(design, &built));
    whirl_design_free(design);
    return built;
}

/// Returns the position of rest under the weight while the balls stand still.
static double rest_of(const whirl_system *system) {
    double low = 3.0, high = 20.0;
    for (int i = 0; i < 200; i++) {
        const double middle = 0.5 * (low + high), x[5] = {middle, 0.0, 0.0, 0.0, 0.0};
        double slope[5];
        evaluate_rhs(system, 0.0, x, slope);
        *(slope[2] > 0.0 ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

static void at_rest(void **unused) {
    (void)unused;
    const double pi = 3.14159265358979323846;
    whirl_rotor *under = make_bearing(600.0, 0.125, 0.0), *between = make_bearing(600.0, 0.125, pi / 8.0);
    check_digits("Ball bearing", "sag with a ball under the load, um", "7.5371266416811",
                 rest_of(whirl_rotor_system(under)));
    check_digits("Ball bearing", "sag with the load between balls, um", "7.5592676354843",
                 rest_of(whirl_rotor_system(between)));
    whirl_rotor_free(under);
    whirl_rotor_free(between);
}

typedef struct extent {
    double low[2], high[2];
} extent;

static void widen(void *observer, double t, const double *x) {
    extent *e = observer;
    (void)t;
    for (int i = 0; i < 2; i++) {
        e->low[i] = fmin(e->low[i], x[i]);
        e->high[i] = fmax(e->high[i], x[i]);
    }
}

/// Balls pass once a revolution: 600 rad/s is the frequency at which they do. The state that it is compared with had
/// returned to within 6e-9 um after 400 revolutions, so its last digit is open.
static void varying_compliance(void **unused) {
    (void)unused;
    static const char *const methods[] = {"dop853", "rk4"};
    whirl_rotor *rotor = make_bearing(600.0, 0.125, 0.0);
    const whirl_system *system = whirl_rotor_system(rotor);
    for (int m = 0; m < 2; m++) {
        whirl_integrator *integrator = make_integrator(system, methods[m], 4000);
        double x[5] = {7.54, 0.0, 0.0, 0.0, 0.0};
        extent e = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
        revolve(integrator, x, 700);
        assert_int_equal(whirl_integrator_revolve(integrator, x, widen, &e), WHIRL_BOUNDED);
        const char *by = methods[m];
        check_within("Ball bearing", words("x at the section by %s, um", by), 7.612449224, x[0], 2e-8);
        check_within("Ball bearing", words("y at the section by %s, um", by), 1.82232938e-2, x[1], 1e-7);
        check_within("Ball bearing", words("x' at the section by %s, um/s", by), 13.2815, x[2] * 600.0, 1e-3);
        check_within("Ball bearing", words("y' at the section by %s, um/s", by), 914.4185, x[3] * 600.0, 1e-3);
        check_digits("Ball bearing", words("x peak to peak by %s, um", by), ".2275075", e.high[0] - e.low[0]);
        check_digits("Ball bearing", words("y peak to peak by %s, um", by), "1.560230", e.high[1] - e.low[1]);
        whirl_integrator_free(integrator);
    }
    whirl_rotor_free(rotor);
}

/// Computes the equations as they are written, with the angle of the cage by time: ratio .125, from .2 rad.
static void by_time(const void *model, double t, const double *forcing, const double *x, double *slope) {
    const double pi = 3.14159265358979323846, omega = 600.0, mass = 20.0;
    double force[2] = {mass * 9.8 * 1e6, 0.0}; // in kg um/s^2
    (void)model, (void)forcing;
    for (int j = 0; j < 8; j++) {
        const double angle = 0.2 + 0.125 * t + 2.0 * pi * j / 8.0;
        const double depth = x[0] * cos(angle) + x[1] * sin(angle) - 3.0;
        const double push = depth > 0.0 ? 1.334e10 * pow(1e-6, 1.5) * depth * sqrt(depth) * 1e6 : 0.0;
        force[0] -= push * cos(angle);
        force[1] -= push * sin(angle);
    }
    for (int a = 0; a < 2; a++) {
        slope[a] = x[2 + a];
        slope[2 + a] = force[a] / (mass * omega * omega) - 200.0 / (mass * omega) * x[2 + a];
    }
}

/// The cage's angle is a state. If the balls pass a whole number of times in a revolution, the motion is that of the
/// equations with the angle as a function of time.
static void cage_as_a_state(void **unused) {
    (void)unused;
    const whirl_system timed = {.dimension = 4, .period = 6.283185307179586476925, .rhs = by_time, .kinked = true};
    whirl_rotor *rotor = make_bearing(600.0, 0.125, 0.2);
    const whirl_system *turning = whirl_rotor_system(rotor);
    whirl_integrator *a = make_integrator(&timed, "dop853", 64), *b = make_integrator(turning, "dop853", 64);
    double x[4] = {7.5, 0.0, 0.0, 0.0}, z[5] = {7.5, 0.0, 0.0, 0.0, 0.0}, worst = 0.0;
    assert_int_equal(turning->dimension, 5);
    for (int i = 0; i < 20; i++) {
        revolve(a, x, 1);
        revolve(b, z, 1);
        for (int k = 0; k < 4; k++) worst = fmax(worst, fabs(x[k] - z[k]));
        assert_true(z[4] >= 0.0 && z[4] < turning->turns[4]);
    }
    check_within("Ball bearing", "cage as a state against its angle by time over 20 revolutions, um", 0.0, worst, 1e-9);
    whirl_integrator_free(a);
    whirl_integrator_free(b);
    whirl_rotor_free(rotor);
}

/// 8 balls pass 8 times the cage's ratio in a revolution: once, 16 times in five, and never a whole number of times.
static void common_periods(void **unused) {
    (void)unused;
    static const double ratios[] = {0.125, 0.4, 40.1 / (40.1 + 63.9)};
    static const size_t expected[] = {1, 5, 0};
    for (int i = 0; i < 3; i++) {
        whirl_rotor *rotor = make_bearing(600.0, ratios[i], 0.0);
        assert_int_equal(whirl_rotor_system(rotor)->repeats, expected[i]);
        whirl_rotor_free(rotor);
    }
}

/// Returns the speed of the cage over the rotor's, for a bearing between a low shaft and a high one of that ratio, from
/// the keys of the bearing and of the stations that it joins; NAN if the machine is refused, with *why.
static double cage_of(double ratio, const char *at, const char *from, const char *keys, whirl_status *why) {
    char text[2048];
    whirl_case *object;
    whirl_rotor *rotor = NULL;
    snprintf(text, sizeof text,
             "whirl: 1\nrotor:\n  speed: 3000 rpm\n  length_scale: 1 um\n  shafts: {low: {}, high: {ratio: %.17g}}\n"
             "  stations:\n    l0: {shaft: low, position: 0 m}\n    l1: {shaft: low, position: 0.5 m}\n"
             "    h0: {shaft: high, position: 0 m}\n    h1: {shaft: high, position: 0.2 m}\n    block: {mass: 5}\n"
             "  elements:\n    - segment: {shaft: low, length: 0.5 m, outer: 36 mm, elements: 2}\n"
             "    - segment: {shaft: high, length: 0.2 m, outer: 80 mm, inner: 56 mm}\n    - %s: {at: %s%s%s, %s}\n"
             "study: {response: {}}\n",
             ratio,
             strstr(keys, "balls")       ? "ball_bearing"
             : strstr(keys, "clearance") ? "seal"
                                         : "bearing",
             at, from ? ", from: " : "", from ? from : "", keys);
    *why = whirl_case_parse(text, strlen(text), "text", NULL, &object);
    if (why->code != WHIRL_OK) return NAN;
    *why = whirl_case_rotor(object, NULL, 0.0, &rotor);
    whirl_case_free(object);
    if (why->code != WHIRL_OK) return NAN;
    const whirl_system *system = whirl_rotor_system(rotor);
    double *x = calloc(2 * system->dimension, sizeof *x), *slope = x + system->dimension;
    evaluate_rhs(system, 0.0, x, slope);
    const double cage = slope[system->dimension - 1];
    free(x);
    whirl_rotor_free(rotor);
    return cage;
}

/// public/intershaft-cage (spools, cage, at-fast), and its brothers: (nu_i r_i + nu_o r_o)/(r_i + r_o), by which 8
/// balls pass the load at order 10.4348 between the spools; the cages of the low shaft alone stay as they were.
static void intershaft_cage(void **unused) {
    (void)unused;
    static const char *const radii = "balls: 8, stiffness: 1.3e10, clearance: 5 um, inner: 18 mm, outer: 28 mm";
    static const char *const said = "balls: 8, stiffness: 1.3e10, clearance: 5 um, cage: 1.3043478";
    static const struct {
        double ratio;
        const char *at, *from, *keys;
        double cage;
    } rows[] = {{1.5, "l1", "h1", radii, (18.0 + 1.5 * 28.0) / 46.0},
                {1.5, "h1", "l1", radii, (1.5 * 18.0 + 28.0) / 46.0},
                {1.5, "l1", "h1", said, 1.3043478},
                {1.6, "h1", NULL, radii, 1.6 * 18.0 / 46.0},
                {1.5, "l1", NULL, radii, 18.0 / 46.0},
                {1.5, "l1", "block", radii, 18.0 / 46.0},
                {1.5, "h1", "block", radii, 1.5 * 18.0 / 46.0},
                {-1.5, "l1", "h1", radii, (18.0 - 1.5 * 28.0) / 46.0}};
    whirl_status why;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double found = cage_of(rows[i].ratio, rows[i].at, rows[i].from, rows[i].keys, &why);
        require_ok(why);
        if (!(fabs(found - rows[i].cage) <= 1e-14)) fail_msg("row %zu: %.17g, not %.17g", i, found, rows[i].cage);
    }
    assert_true(fabs(8.0 * rows[0].cage - 10.4348) < 5e-5);
}

/// A cage that is faster than both races, a seal whose housing is on a shaft of another speed, and coefficients over
/// speeds that are not those of their shaft.
static void other_ends_are_checked(void **unused) {
    (void)unused;
    static const struct {
        const char *at, *from, *keys, *words;
    } rows[] = {
        {"l1", NULL, "balls: 8, stiffness: 1.3e10, cage: 1.3", "between its races, above 0 and below 1"},
        {"l1", "h1", "balls: 8, stiffness: 1.3e10, cage: 0.4", "above 1 and below 1.5"},
        {"l1", "h1", "clearance: 0.1 mm, stiffness: 1e6, damping: 100, ratio: 0.4", "acts at station 'h1' on a"},
        {"l1", "h1", "kxx: [1e6, 2e6], speeds: [1, 1000]", "acts at station 'h1' on a shaft of another speed"},
        {"h1", NULL, "kxx: [1e6, 2e6], speeds: [1, 1000]", "acts at station 'h1' on a shaft of another speed"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        whirl_status why;
        assert_true(isnan(cage_of(1.5, rows[i].at, rows[i].from, rows[i].keys, &why)));
        if (!strstr(why.message, rows[i].words)) fail_msg("row %zu: %s", i, why.message);
    }
}

/// The derivative by dual numbers agrees with that of the force in closed form: dF/dd = -3/2 C sqrt(delta) n n^T
/// summed.
static void the_derivative(void **unused) {
    (void)unused;
    const double pi = 3.14159265358979323846, cage = 0.37, state[5] = {6.1, -2.3, 0.4, 0.7, 1.234};
    whirl_rotor *rotor = make_bearing(600.0, cage, 0.3);
    double matrix[25], worst = 0.0, sum[2][3] = {{0}}, size = 0.0;
    exact_jacobian(whirl_rotor_system(rotor), 0.4, state, matrix);
    for (int j = 0; j < 8; j++) {
        const double angle = 0.3 + state[4] + 2.0 * pi * j / 8.0, c = cos(angle), s = sin(angle);
        const double depth = state[0] * c + state[1] * s - 3.0, across = -state[0] * s + state[1] * c;
        if (depth <= 0.0) continue;
        const double root = sqrt(depth), n[2] = {c, s}, turned[2] = {-s, c};
        for (int a = 0; a < 2; a++) {
            sum[a][0] += 1.5 * root * n[a] * c;
            sum[a][1] += 1.5 * root * n[a] * s;
            sum[a][2] += 1.5 * root * n[a] * across + depth * root * turned[a];
        }
    }
    const double scale = 1.334e10 * pow(1e-6, 1.5) / (20.0 * 600.0 * 600.0 * 1e-6);
    for (int a = 0; a < 2; a++)
        for (int k = 0; k < 3; k++) {
            const double found = matrix[5 * (2 + a) + (k < 2 ? k : 4)], expected = -scale * sum[a][k];
            size = fmax(size, fabs(expected));
            worst = fmax(worst, fabs(found - expected));
        }
    check_within("Ball bearing", "derivative by duals against its closed form, part of its size", 0.0, worst / size,
                 1e-14);
    whirl_rotor_free(rotor);
}

/// Three revolutions in lanes, each with its own cage speed, agree with the integrator.
static void cages_in_lanes(void **unused) {
    (void)unused;
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    enum { LANES = 5 };
    for (size_t m = 0; m < sizeof methods / sizeof *methods; m++) {
        whirl_rotor *rotors[LANES];
        double x[LANES][5], y[LANES][5], worst = 0.0;
        for (int l = 0; l < LANES; l++) rotors[l] = make_bearing(600.0, 0.38 + 0.01 * l, 0.2);
        carry_both(methods[m], 2048, rotors, LANES, (double[5]){7.0, 0.5}, 3, y[0], x[0]);
        for (size_t l = 0; l < LANES; l++) {
            assert_true(y[l][4] >= 0.0 && y[l][4] < whirl_rotor_system(rotors[l])->turns[4]);
            for (int k = 0; k < 5; k++) worst = fmax(worst, fabs(x[l][k] - y[l][k]));
        }
        check_within("Ball bearing", words("cages in lanes by %s and by the integrator, um", methods[m]), 0.0, worst,
                     1e-9);
        for (int l = 0; l < LANES; l++) whirl_rotor_free(rotors[l]);
    }
}

/// All perturbations of a machine whose cage turns without end: in lanes, and by the integrator that locates contacts,
/// of which there are none here. The phase comes last and is not scaled.
static void perturbations_with_a_cage(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_bearing(600.0, 0.38, 0.2);
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    whirl_record *record[2];
    double worst = 0.0;
    options.transient = 2;
    options.record = options.watch = 8;
    options.growth = WHIRL_GROWTH_ALL;
    for (int i = 0; i < 2; i++) {
        integrate.located = i == 1;
        assert_int_equal(whirl_ensemble_follows(system, &integrate), i == 0);
        require_ok(whirl_record_motion(system, &integrate, &options, (double[5]){7.0, 0.5}, NULL, &record[i]));
    }
    for (size_t n = 0; n < 5 * record[0]->growth_count; n++) {
        worst = fmax(worst, fabs(record[0]->growths[n] - record[1]->growths[n]));
        if (n % 5 == 4) assert_true(fabs(record[0]->growths[n]) < 1e-12);
    }
    for (size_t n = 0; n < record[0]->growth_count; n++)
        worst = fmax(worst, fabs(record[0]->volume[n] - record[1]->volume[n]));
    check_within("Ball bearing", "growth of all perturbations in lanes and by the integrator", 0.0, worst, 1e-9);
    whirl_record_free(record[0]);
    whirl_record_free(record[1]);
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(at_rest),
                                       cmocka_unit_test(varying_compliance),
                                       cmocka_unit_test(cage_as_a_state),
                                       cmocka_unit_test(common_periods),
                                       cmocka_unit_test(intershaft_cage),
                                       cmocka_unit_test(other_ends_are_checked),
                                       cmocka_unit_test(the_derivative),
                                       cmocka_unit_test(cages_in_lanes),
                                       cmocka_unit_test(perturbations_with_a_cage)};
    return cmocka_run_group_tests_name("ball bearing", tests, NULL, NULL);
}
