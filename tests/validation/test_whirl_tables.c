// Bearings with coefficients over the frequency of whirl, against closed forms: modes whose damped frequency is the one
// that coefficients are looked up at, the synchronous response, and the poles of a bearing that has a state of its own.
#include <complex.h>
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
#include "whirl/engine/analyze.h"
#include "whirl/engine/case.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/rotor.h"

enum { MAX_STATIONS = 3, TEXT = 32 * 32 * 26 };

/// Discs that nothing joins, each on a bearing of its own, with the same axes of their tables.
typedef struct discs {
    double speed, eccentricity, cross; ///< rad/s; m; N/m of a constant cross coupling that drives them forward
    const char *speeds, *frequencies;  ///< NULL: no such axis
    size_t count;
    double mass[MAX_STATIONS];
    const char *kxx[MAX_STATIONS], *cxx[MAX_STATIONS];
} discs;

static whirl_status build(const discs *d, bool asynchronous, double frequency, whirl_rotor **rotor) {
    static const char *const names[] = {"a", "b", "c"};
    whirl_design *design;
    whirl_status status = whirl_design_new(d->speed, 1e-3, &design);
    for (size_t i = 0; i < d->count && status.code == WHIRL_OK; i++) {
        const whirl_setting disc[] = {{"mass", d->mass[i], NULL}, {"eccentricity", d->eccentricity, NULL}};
        status = whirl_design_station(design, names[i], disc, 2);
    }
    for (size_t i = 0; i < d->count && status.code == WHIRL_OK; i++) {
        const whirl_setting bearing[] = {
            {"at", 0, names[i]},
            {"kxx", 0, d->kxx[i]},
            {"cxx", 0, d->cxx[i]},
            {d->speeds ? "speeds" : "frequencies", 0, d->speeds ? d->speeds : d->frequencies},
            {"frequencies", 0, d->frequencies}};
        const whirl_setting cross[] = {{"at", 0, names[i]}, {"kxy", d->cross, NULL}, {"kyx", -d->cross, NULL}};
        status = whirl_design_element(design, "bearing", bearing, d->speeds && d->frequencies ? 5 : 4);
        if (status.code == WHIRL_OK) status = whirl_design_element(design, "bearing", cross, 3);
    }
    if (asynchronous) whirl_design_frequency(design, frequency);
    if (status.code == WHIRL_OK) status = whirl_rotor_new(design, rotor);
    whirl_design_free(design);
    return status;
}

typedef struct member {
    whirl_rotor *rotor;
    double start[4 * MAX_STATIONS];
} member;

static void release(void *owner) {
    member *m = owner;
    whirl_rotor_free(m->rotor);
    free(m);
}

static whirl_status at(const void *context, double frequency, whirl_machine *machine) {
    member *m = calloc(1, sizeof *m);
    assert_non_null(m);
    const whirl_status status = build(context, true, frequency, &m->rotor);
    require_ok(status);
    *machine = (whirl_machine){.system = whirl_rotor_system(m->rotor),
                               .start = m->start,
                               .owner = m,
                               .release = release,
                               .clock = whirl_rotor_clock(m->rotor),
                               .speed = whirl_rotor_speed(m->rotor)};
    return status;
}

/// Writes real parts and frequencies of the modes [most] in SI, and the largest real part of all; returns their number.
static size_t modes_of(const discs *d, size_t most, double (*found)[2], double *growth) {
    whirl_machine machine;
    whirl_modes *modes;
    at(d, 0.0, &machine);
    require_ok(whirl_modes_of(&machine, &(whirl_whirling){at, d}, &modes));
    const size_t count = modes->count;
    assert_true(count <= most);
    for (size_t i = 0; i < count; i++) {
        found[i][0] = machine.clock * modes->modes[i].real;
        found[i][1] = machine.clock * modes->modes[i].imaginary;
    }
    *growth = machine.clock * modes->growth;
    whirl_modes_free(modes);
    machine.release(machine.owner);
    return count;
}

static void relative(const char *what, double expected, double obtained, double share) {
    check_within("Whirl tables", what, expected, obtained, share * fabs(expected));
}

// ---------------------------------------------------------------- straight tables

/// K = a + b w and C = c between two frequencies are straight: w^2 = (a + b w)/m - (c/2m)^2.
static void straight(void **state) {
    const double m = 12.0, a = 4e6, b = 3e3, c = 900.0, sigma = -c / (2.0 * m);
    const double w = b / (2.0 * m) + sqrt(b * b / (4.0 * m * m) + a / m - sigma * sigma);
    const discs d = {300.0, 0.0, 0.0, NULL, "0, 2000", 1, {m}, {"4e6, 1e7"}, {"900, 900"}};
    double found[8][2], growth;
    (void)state;
    const size_t count = modes_of(&d, 8, found, &growth);
    check_holds("Whirl tables", "straight stiffness: two modes, along x and along y", count == 2);
    for (size_t i = 0; i < 2; i++) {
        relative("straight stiffness: damped frequency, rad/s", w, found[i][1], 1e-12);
        relative("straight stiffness: decay, 1/s", sigma, found[i][0], 1e-12);
    }
    relative("straight stiffness: stability, 1/s", sigma, growth, 1e-12);
}

/// Returns a number of bilinear tables of speed and frequency: K = a + b W + c w + d W w.
static double bilinear(double speed, double w) {
    return 4e6 + 2e3 * speed + 3e3 * w + 1.5 * speed * w;
}

static void over_both(void **state) {
    const double m = 12.0, e = 2e-5, c = 900.0, speed = 400.0, sigma = -c / (2.0 * m);
    char kxx[256];
    snprintf(kxx, sizeof kxx, "%.17g, %.17g; %.17g, %.17g", bilinear(200.0, 100.0), bilinear(200.0, 1500.0),
             bilinear(700.0, 100.0), bilinear(700.0, 1500.0));
    const discs d = {speed, e, 0.0, "200, 700", "100, 1500", 1, {m}, {kxx}, {"900, 900; 900, 900"}};
    const double b = 3e3 + 1.5 * speed, a = bilinear(speed, 0.0);
    const double w = b / (2.0 * m) + sqrt(b * b / (4.0 * m * m) + a / m - sigma * sigma);
    double found[8][2], growth, rest[4], response[8], start[4] = {0};
    whirl_rotor *rotor;
    (void)state;
    check_holds("Whirl tables", "over speed and frequency: two modes", modes_of(&d, 8, found, &growth) == 2);
    relative("over speed and frequency: damped frequency, rad/s", w, found[0][1], 1e-12);
    require_ok(build(&d, false, 0.0, &rotor));
    require_ok(whirl_forced_response(whirl_rotor_system(rotor), start, rest, response));
    const double expected = m * e * speed * speed / hypot(bilinear(speed, speed) - m * speed * speed, c * speed);
    relative("over speed and frequency: response at the frequency of the speed, m", expected,
             1e-3 * hypot(response[0], response[1]), 1e-12);
    whirl_rotor_free(rotor);
}

/// Three discs that nothing joins; the stiffness of one rises so steeply that it has three frequencies along each axis.
static void all_of_them(void **state) {
    // w^2 of the mass 1: below K at 0 and 150, above at 250 and 350, below at 450, above from 900 on.
    const discs d = {300.0,
                     0.0,
                     0.0,
                     NULL,
                     "0, 150, 250, 350, 450, 900",
                     3,
                     {1.0, 2.0, 1.0},
                     {"4e4, 4e4, 4e4, 4e4, 3e5, 3e5", "1e5, 1e5, 1e5, 1e5, 1e5, 1e5", "1e6, 1e6, 1e6, 1e6, 1e6, 1e6"},
                     {"2, 2, 2, 2, 2, 2", "0, 0, 0, 0, 0, 0", "3e3, 3e3, 3e3, 3e3, 3e3, 3e3"}};
    double found[24][2], growth, worst = 0.0;
    (void)state;
    const size_t count = modes_of(&d, 24, found, &growth);
    // The third disc is damped beyond a frequency; of the second one the frequency is that of any table.
    check_holds("Whirl tables", "three discs: (3 + 1) modes along each axis, and no others", count == 8);
    for (size_t i = 0; i < count; i++) {
        whirl_machine machine;
        whirl_modes *own;
        double nearest = INFINITY;
        at(&d, found[i][1], &machine);
        require_ok(whirl_modes_new(machine.system, machine.start, &own));
        for (size_t k = 0; k < own->count; k++)
            nearest = fmin(nearest, fabs(machine.clock * own->modes[k].imaginary - found[i][1]) / found[i][1]);
        worst = fmax(worst, nearest);
        whirl_modes_free(own);
        machine.release(machine.owner);
    }
    check_within("Whirl tables",
                 "three discs: frequency of the coefficients over that of the mode, largest difference from 1", 0.0,
                 worst, 1e-12);
}

// ---------------------------------------------------------------- a bearing with a state of its own

/// A spring, in parallel with a spring and a damper in series: Z(s) = k0 + k1 T s/(1 + T s), T = c1/k1.
typedef struct solid {
    double mass, k0, k1, relaxation;
} solid;

static double stiffness(const solid *s, double w) {
    const double t = w * s->relaxation;
    return s->k0 + s->k1 * t * t / (1.0 + t * t);
}

static double damping(const solid *s, double w) {
    const double t = w * s->relaxation;
    return s->k1 * s->relaxation / (1.0 + t * t);
}

/// Makes a table of `count` frequencies up to `high`.
static discs tabulate(const solid *s, size_t count, double high, double cross, char text[3][TEXT]) {
    size_t used[3] = {0};
    for (size_t i = 0; i < count; i++) {
        const double w = high * (double)i / (double)(count - 1);
        const double row[] = {w, stiffness(s, w), damping(s, w)};
        for (size_t k = 0; k < 3; k++)
            used[k] += (size_t)snprintf(text[k] + used[k], TEXT - used[k], "%s%.17g", i > 0 ? ", " : "", row[k]);
    }
    return (discs){300.0, 0.0, cross, NULL, text[0], 1, {s->mass}, {text[1]}, {text[2]}};
}

/// Returns the root of m s^2 + Z(s) - i q = 0 by Newton's method from the mode of the table.
static double complex exact_pole(const solid *s, double q, double complex from) {
    double complex p = from;
    for (int step = 0; step < 50; step++) {
        const double complex d = 1.0 + s->relaxation * p,
                             value = s->mass * p * p + s->k0 + s->k1 * s->relaxation * p / d;
        p -= (value - I * q) / (2.0 * s->mass * p + s->k1 * s->relaxation / (d * d));
    }
    return p;
}

/// Returns the root of m s^2 + C(w) s + K(w) = 0 with w = Im s, by the formulas themselves: w by halving.
static double complex consistent_pole(const solid *s, double high) {
    double low = 0.0, middle = 0.0;
    for (int step = 0; step < 200; step++) {
        middle = 0.5 * (low + high);
        const double sigma = -damping(s, middle) / (2.0 * s->mass);
        if (stiffness(s, middle) / s->mass - sigma * sigma > middle * middle)
            low = middle;
        else
            high = middle;
    }
    return -damping(s, middle) / (2.0 * s->mass) + I * middle;
}

/// Returns the largest eigenvalue of the table's machine.
static double complex pole_of(const discs *d) {
    double found[8][2], growth;
    const size_t count = modes_of(d, 8, found, &growth);
    assert_true(count > 0);
    size_t best = 0;
    for (size_t i = 0; i < count; i++)
        if (found[i][0] > found[best][0]) best = i;
    return found[best][0] + I * found[best][1];
}

static void own_state(void **state) {
    static char text[3][TEXT];
    static const double branches[] = {2e4, 2e5, 1e6};
    (void)state;
    for (size_t i = 0; i < sizeof branches / sizeof *branches; i++) {
        const solid s = {10.0, 1e6, branches[i], 2e-3};
        const discs d = tabulate(&s, 32, 600.0, 0.0, text);
        const double complex own = pole_of(&d), formula = consistent_pole(&s, 600.0), exact = exact_pole(&s, 0.0, own);
        const double ratio = -creal(exact) / cabs(exact);
        check_within(
            "Whirl tables",
            words("solid, damping ratio %.4f: part by which 32 points of a table differ from its formula", ratio), 0.0,
            cabs(own - formula) / cabs(formula), 3e-5);
        check_within("Whirl tables",
                     words("solid, damping ratio %.4f: relative difference from the pole of the state space, over the "
                           "ratio's square",
                           ratio),
                     0.0, cabs(own - exact) / cabs(exact) / (ratio * ratio), 1.5);
    }
}

/// At a decay of 0, K and C at the damped frequency are Z itself: m w^2 = K(w), q = w C(w).
static void onset(void **state) {
    static char text[3][TEXT];
    const solid s = {10.0, 1e6, 2e5, 2e-3};
    double low = 0.0, high = 600.0, growth[2];
    (void)state;
    for (int step = 0; step < 200; step++) {
        const double middle = 0.5 * (low + high);
        *(stiffness(&s, middle) > s.mass * middle * middle ? &low : &high) = middle;
    }
    const double w = low, limit = w * damping(&s, w);
    double below = 0.5 * limit, above = 1.5 * limit;
    for (int step = 0; step < 45; step++) {
        const double middle = 0.5 * (below + above);
        const discs d = tabulate(&s, 32, 600.0, middle, text);
        growth[0] = creal(pole_of(&d));
        *(growth[0] < 0.0 ? &below : &above) = middle;
    }
    relative("solid: cross coupling at which it loses its stability, N/m", limit, below, 1e-5);
    const discs d = tabulate(&s, 32, 600.0, below, text);
    relative("solid: frequency there, rad/s", w, cimag(pole_of(&d)), 1e-6);
}

/// The same by the study `stability`, whose stages bring the cross coupling: each of its modes has its own
/// coefficients.
static void onset_by_stages(void **state) {
    static char text[3][TEXT], whole[4 * TEXT], problems[TEXT];
    const solid s = {10.0, 1e6, 2e5, 2e-3};
    double low = 0.0, high = 600.0;
    whirl_case *object = NULL;
    whirl_result *result;
    (void)state;
    for (int step = 0; step < 200; step++) {
        const double middle = 0.5 * (low + high);
        *(stiffness(&s, middle) > s.mass * middle * middle ? &low : &high) = middle;
    }
    tabulate(&s, 32, 600.0, 0.0, text);
    snprintf(whole, sizeof whole,
             "whirl: 1\nrotor:\n  speed: 900 rad/s\n  length_scale: 1 mm\n  stations:\n    disc: {mass: 10 kg}\n"
             "  elements:\n    - bearing:\n        at: disc\n        frequencies: [%s]\n        kxx: [%s]\n"
             "        cxx: [%s]\n    - stage: {at: disc, power: 100 kW, diameter: 0.4 m, width: 20 mm}\n"
             "study:\n  stability: {}\n",
             text[0], text[1], text[2]);
    if (whirl_case_check(whole, strlen(whole), "case.yaml", problems, sizeof problems, &object).code != WHIRL_OK)
        fail_msg("%s", problems);
    require_ok(whirl_case_run(object, &(whirl_run_options){.threads = 1}, &result));
    const whirl_table *table = &result->tables[0];
    relative("solid: limit of the cross coupling of stages, N/m", low * damping(&s, low),
             whirl_table_number(table, 0, WHIRL_FIELD_STABILITY_LIMIT, 0), 1e-5);
    whirl_result_free(result);
    whirl_case_free(object);
}

// ---------------------------------------------------------------- what is refused

static void refused(void **state) {
    const discs apart = {300.0, 0.0, 0.0, NULL, "100, 200", 1, {1.0}, {"1e4, 1e4"}, {"1, 1"}};
    whirl_rotor *rotor;
    (void)state;
    require_ok(build(&apart, false, 0.0, &rotor));
    const whirl_system *system = whirl_rotor_system(rotor);
    check_text("Whirl tables", "synchronous motions beyond the frequencies",
               "bearings are known at frequencies of whirl from 100 to 200 rad/s, and the rotor turns at 300 rad/s, "
               "which is the frequency of synchronous motions",
               whirl_synchronous_check(system, 300.0).message);
    check_holds("Whirl tables", "within them", whirl_synchronous_check(system, -150.0).code == WHIRL_OK);
    check_holds("Whirl tables", "motions in time are refused", whirl_integrate_check(system).code == WHIRL_BAD_INPUT);
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(straight),    cmocka_unit_test(over_both),
                                       cmocka_unit_test(all_of_them), cmocka_unit_test(own_state),
                                       cmocka_unit_test(onset),       cmocka_unit_test(onset_by_stages),
                                       cmocka_unit_test(refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
