// Forces that turn at ratios of the speed, at frequencies of their own and while the speed runs up, against closed
// forms: a disc on a spring and a damper to the ground is linear.
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
#include "support_flow.h"
#include "support_lanes.h"
#include "support_record.h"
#include "whirl/engine.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

static const double two_pi = 6.283185307179586476925;
static const double speed = 300.0, scale = 1e-4, mass = 2.0, damping = 120.0, stiffness = 2.2e5;

/// Begins the design of a disc whose time counts turns at `clock`, rad/s.
static whirl_design *begin_disc_by(double clock) {
    const whirl_setting disc[] = {{"mass", mass, NULL}};
    const whirl_setting spring[] = {
        {"between", 0, "disc, ground"}, {"stiffness", stiffness, NULL}, {"damping", damping, NULL}};
    whirl_design *design;
    require_ok(whirl_design_new(clock, scale, &design));
    require_ok(whirl_design_station(design, "disc", disc, 1));
    require_ok(whirl_design_element(design, "spring", spring, 3));
    return design;
}

static whirl_design *begin_disc(void) {
    return begin_disc_by(speed);
}

static whirl_rotor *finish(whirl_design *design) {
    whirl_rotor *rotor;
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Adds a force of 20 N with one key for its rate.
static void add_force(whirl_design *design, const char *law, const char *key, double value) {
    const whirl_setting force[] = {{"at", 0, "disc"},    {"amplitude", 20.0, NULL}, {"law", 0, law},
                                   {"angle", 0.7, NULL}, {"phase", 0.4, NULL},      {key, value, NULL}};
    require_ok(whirl_design_element(design, "force", force, key ? 6 : 5));
}

static void add_unbalance(whirl_design *design, const char *key, double value) {
    const whirl_setting unbalance[] = {
        {"at", 0, "disc"}, {"moment", 1e-4, NULL}, {"angle", 0.3, NULL}, {key, value, NULL}};
    require_ok(whirl_design_element(design, "unbalance", unbalance, key ? 4 : 3));
}

// ---------------------------------------------------------------- linear response

/// Returns z = x + i y at t under a force F e^(i nu t), in length scales.
static double complex response(double complex force, double nu, double t) {
    return force * cexp(I * nu * t) / (stiffness - mass * nu * nu + I * damping * nu) / scale;
}

/// Returns the sum of the responses to all forces of the test below.
static double complex all_responses(double t) {
    static const double ratio = 1.5, turning = 0.6180339887498949, hertz = 31.0, second = -1.25;
    const double nu[] = {ratio * speed, turning * speed, two_pi * hertz, second * speed};
    const double complex axis = 10.0 * cexp(0.7 * I); // half of 20 N either way
    return response(axis * cexp(0.4 * I), nu[0], t) + response(axis * cexp(-0.4 * I), -nu[0], t) +
           response(20.0 * cexp(1.1 * I), nu[1], t) + response(20.0 * cexp(0.3 * I), -nu[2], t) +
           response(1e-4 * nu[3] * nu[3] * cexp(0.3 * I), nu[3], t) + response(20.0 * cexp(1.1 * I), speed, t) +
           response(1e-4 * speed * speed * cexp(0.3 * I), speed, t);
}

static void linear_response(void **unused) {
    (void)unused;
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    enum { SETTLED = 120, SEEN = 20 };
    whirl_design *design = begin_disc();
    add_force(design, "axis", "ratio", 1.5);
    add_force(design, "forward", "ratio", 0.6180339887498949);
    add_force(design, "backward", "frequency", 31.0);
    add_force(design, "forward", NULL, 0.0);
    add_unbalance(design, "speed", -1.25 * speed);
    add_unbalance(design, NULL, 0.0);
    whirl_rotor *rotor = finish(design);
    const whirl_system *system = whirl_rotor_system(rotor);
    assert_int_equal(system->dimension, 8);
    for (size_t m = 0; m < COUNT_OF(methods); m++) {
        whirl_integrator *integrator = make_integrator(system, methods[m], 2048);
        double x[8] = {0}, worst = 0.0, size = 0.0;
        revolve(integrator, x, SETTLED);
        for (int i = 1; i <= SEEN; i++) {
            revolve(integrator, x, 1);
            const double complex expected = all_responses((SETTLED + i) * two_pi / speed);
            worst = fmax(worst, cabs(x[0] + I * x[1] - expected));
            size = fmax(size, cabs(expected));
        }
        check_within("Phases", words("six forces and unbalances by %s, part of the response", methods[m]), 0.0,
                     worst / size, 1e-9);
        whirl_integrator_free(integrator);
    }
    whirl_rotor_free(rotor);
}

/// Frees the rotor after it has revolved from rest: *x is where it is then.
static void settle(whirl_rotor *rotor, int revolutions, double *x) {
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
    revolve(integrator, x, revolutions);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

/// A moment that turns backward on a disc that tilts: I_d phi'' + (c - i I_p omega) phi' + k phi = M e^(-i nu t).
static void tilting_response(void **unused) {
    (void)unused;
    const double diametral = 0.02, polar = 0.03, turn = 2000.0, damper = 3.0, ratio = 0.7;
    const whirl_setting disc[] = {{"mass", mass, NULL}, {"diametral", diametral, NULL}, {"polar", polar, NULL}};
    const whirl_setting spring[] = {
        {"between", 0, "disc, ground"}, {"along", 0, "tilts"}, {"stiffness", turn, NULL}, {"damping", damper, NULL}};
    const whirl_setting moment[] = {
        {"at", 0, "disc"}, {"moment", 4.0, NULL}, {"law", 0, "backward"}, {"angle", 0.2, NULL}, {"ratio", ratio, NULL}};
    whirl_design *design = begin_disc();
    whirl_design_free(design);
    require_ok(whirl_design_new(speed, scale, &design));
    require_ok(whirl_design_station(design, "disc", disc, 3));
    require_ok(whirl_design_element(design, "spring", spring, 4));
    require_ok(whirl_design_element(design, "force", moment, 5));
    whirl_rotor *rotor = finish(design);
    const double nu = -ratio * speed, unit = scale / sqrt(diametral / mass);
    const double complex amplitude =
        4.0 * cexp(0.2 * I) / (turn - diametral * nu * nu + I * nu * (damper - I * polar * speed)) / unit;
    double x[9] = {0};
    settle(rotor, 200, x);
    const double complex expected = amplitude * cexp(I * nu * 200.0 * two_pi / speed);
    check_within("Phases", "a moment that turns backward, part of the response", 0.0,
                 cabs(x[2] + I * x[3] - expected) / cabs(expected), 1e-9);
}

/// A pedestal that moves along y is moved by the component of a force along y.
static void along_one_axis(void **unused) {
    (void)unused;
    const whirl_setting pedestal[] = {{"mass", mass, NULL}, {"moves", 0, "y"}};
    const whirl_setting spring[] = {{"between", 0, "pedestal, ground"},
                                    {"along", 0, "y"},
                                    {"stiffness", stiffness, NULL},
                                    {"damping", damping, NULL}};
    const whirl_setting force[] = {
        {"at", 0, "pedestal"}, {"amplitude", 20.0, NULL}, {"angle", 0.7, NULL}, {"frequency", 40.0, NULL}};
    whirl_design *design;
    require_ok(whirl_design_new(speed, scale, &design));
    require_ok(whirl_design_station(design, "pedestal", pedestal, 2));
    require_ok(whirl_design_element(design, "spring", spring, 4));
    require_ok(whirl_design_element(design, "force", force, 4));
    whirl_rotor *rotor = finish(design);
    double x[3] = {0};
    settle(rotor, 140, x);
    const double complex expected = response(20.0 * sin(0.7), two_pi * 40.0, 140.0 * two_pi / speed);
    check_within("Phases", "a force on a station that moves along y, part of the response", 0.0,
                 fabs(x[0] - creal(expected)) / cabs(expected), 1e-9);
}

/// The Jacobian's column of the phase: the derivative of F (cos(theta + delta)) by theta.
static void the_derivative(void **unused) {
    (void)unused;
    const double state[5] = {0.3, -0.2, 0.1, 0.5, 2.1};
    whirl_design *design = begin_disc();
    add_force(design, "axis", "ratio", 2.3);
    whirl_rotor *rotor = finish(design);
    double matrix[25], worst = 0.0;
    const double size = 20.0 / (mass * speed * speed * scale), slope = -size * sin(2.1 + 0.4);
    exact_jacobian(whirl_rotor_system(rotor), 0.4, state, matrix);
    for (int a = 0; a < 2; a++)
        worst = fmax(worst, fabs(matrix[5 * (2 + a) + 4] - slope * (a == 0 ? cos(0.7) : sin(0.7))));
    for (int i = 0; i < 5; i++) worst = fmax(worst, fabs(matrix[20 + i])); // the phase turns whatever happens
    check_within("Phases", "derivative by the phase, part of the force", 0.0, worst / size, 1e-14);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- what repeats, and what verdicts say

typedef struct repeating {
    double ratios[2]; ///< 0: none
    size_t repeats;
    const char *regime;
} repeating;

/// Regimes of a stable linear rotor under its unbalance and forces at ratios of the speed. The last ratio is the
/// golden one, the nearest to fit no revolution.
static const repeating rows[] = {{{2.0, 0.0}, 1, "P-1"},
                                 {{1.5, 0.0}, 2, "P-2"},
                                 {{5.0 / 3.0, 0.0}, 3, "P-3"},
                                 {{0.5, 4.0 / 3.0}, 6, "P-6"},
                                 {{11.0 / 17.0, 0.0}, 17, "P-17"},
                                 {{29.0 / 61.0, 0.0}, 61, "P-61"},
                                 {{0.6180339887498949, 0.0}, 0, "quasi-periodic (forced)"},
                                 {{1.5, 0.6180339887498949}, 0, "quasi-periodic (forced)"}};

static void regimes(void **unused) {
    (void)unused;
    for (size_t i = 0; i < COUNT_OF(rows); i++) {
        whirl_design *design = begin_disc();
        add_unbalance(design, NULL, 0.0);
        for (int k = 0; k < 2 && rows[i].ratios[k] > 0.0; k++) add_force(design, "axis", "ratio", rows[i].ratios[k]);
        whirl_rotor *rotor = finish(design);
        const whirl_system *system = whirl_rotor_system(rotor);
        const double start[6] = {0};
        assert_int_equal(system->repeats, rows[i].repeats);
        whirl_record *record = record_motion(system, start, 256, 150, 300);
        check_regime("Phases", words("forces at %g and %g of the speed", rows[i].ratios[0], rows[i].ratios[1]),
                     rows[i].regime, record);
        // Perturbations die out with the damping, c/(2 m), whatever forces there are.
        const whirl_estimate exponent = whirl_lyapunov_largest(record);
        check_within("Phases", words("largest exponent, row %zu", i + 1), -damping / (2.0 * mass) * two_pi / speed,
                     exponent.value, 1e-3);
        whirl_record_free(record);
        whirl_rotor_free(rotor);
    }
}

/// Returns the regime of a disc under a force of 31 Hz, by sections once a turn at `clock` (rad/s), with an unbalance
/// at the speed of the shaft or without.
static const char *regime_by(double clock, bool unbalanced) {
    static char name[64];
    whirl_design *design = begin_disc_by(clock);
    const double start[6] = {0};
    add_force(design, "axis", "frequency", 31.0);
    if (unbalanced) add_unbalance(design, "speed", speed);
    whirl_rotor *rotor = finish(design);
    whirl_record *record = record_motion(whirl_rotor_system(rotor), start, 256, 150, 300);
    const whirl_verdict verdict = whirl_judge(record);
    whirl_verdict_name(&verdict, name, sizeof name);
    whirl_record_free(record);
    whirl_rotor_free(rotor);
    return name;
}

/// Sections by another phase: its rate replaces the rotor's speed, and elements that turn with the shaft have a speed
/// of their own.
static void sections_by_another_phase(void **unused) {
    (void)unused;
    const double shaker = two_pi * 31.0;
    check_text("Phases", "31 Hz by sections of the shaft", "quasi-periodic (forced)", regime_by(speed, false));
    check_text("Phases", "31 Hz by sections of its own", "P-1", regime_by(shaker, false));
    check_text("Phases", "31 Hz and an unbalance by sections of the shaft", "quasi-periodic (forced)",
               regime_by(speed, true));
    check_text("Phases", "31 Hz and an unbalance by sections of the 31 Hz", "quasi-periodic (forced)",
               regime_by(shaker, true));
    whirl_design *design = begin_disc_by(shaker);
    add_force(design, "forward", "frequency", 31.0);
    add_unbalance(design, "speed", speed);
    whirl_rotor *rotor = finish(design);
    double x[6] = {0};
    settle(rotor, 120, x);
    const double t = 120.0 / 31.0;
    const double complex expected =
        response(20.0 * cexp(1.1 * I), shaker, t) + response(1e-4 * speed * speed * cexp(0.3 * I), speed, t);
    check_within("Phases", "both by sections of the 31 Hz, part of the response", 0.0,
                 cabs(x[0] + I * x[1] - expected) / cabs(expected), 1e-9);
}

/// A force and an unbalance of 31 Hz on a shaft whose speed approaches 0: machines at rest are the same as without
/// them; motions are refused, except with sections by the force.
static void slow_shafts(void **unused) {
    static const double speeds[] = {0.0, 1e-9, 1e-3, 0.1, 1.0, 100.0};
    const double hertz = 31.0, nu = two_pi * hertz, half = 0.5 * damping / mass;
    (void)unused;
    for (size_t i = 0; i < COUNT_OF(speeds); i++) {
        whirl_design *design = begin_disc_by(speeds[i]);
        add_force(design, "axis", "frequency", hertz);
        add_unbalance(design, "speed", -nu);
        whirl_rotor *rotor = finish(design);
        const double start[8] = {0}, clock = whirl_rotor_clock(rotor);
        whirl_modes *modes;
        require_ok(whirl_modes_new(whirl_rotor_system(rotor), start, &modes));
        assert_int_equal(modes->count, 2);
        for (size_t k = 0; k < 2; k++) {
            check_within("Phases", words("31 Hz, shaft of %g rad/s: decay of mode %zu, part", speeds[i], k), 1.0,
                         -modes->modes[k].real * clock / half, 1e-9);
            check_within("Phases", words("31 Hz, shaft of %g rad/s: frequency of mode %zu, part", speeds[i], k), 1.0,
                         modes->modes[k].imaginary * clock / sqrt(stiffness / mass - half * half), 1e-9);
        }
        whirl_modes_free(modes);
        whirl_rotor_free(rotor);
    }
    for (size_t i = 1; i < COUNT_OF(speeds); i++) {
        whirl_design *design = begin_disc_by(speeds[i]);
        whirl_rotor *rotor;
        whirl_design_in_time(design);
        add_force(design, "axis", "frequency", hertz);
        const whirl_status status = whirl_rotor_new(design, &rotor);
        whirl_design_free(design);
        assert_int_equal(status.code, nu / speeds[i] > 1000.0 ? WHIRL_BAD_INPUT : WHIRL_OK);
        if (status.code == WHIRL_OK) whirl_rotor_free(rotor);
        if (speeds[i] < 0.1) continue;
        const whirl_setting force[] = {{"at", 0, "disc"},    {"amplitude", 20.0, NULL},  {"angle", 0.7, NULL},
                                       {"phase", 0.4, NULL}, {"frequency", hertz, NULL}, {"keyphasor", 0, "yes"}};
        double x[16] = {0};
        design = begin_disc_by(speeds[i]);
        whirl_design_in_time(design);
        require_ok(whirl_design_element(design, "force", force, COUNT_OF(force)));
        settle(finish(design), 120, x);
        const double complex axis = 10.0 * cexp(0.7 * I); // half of 20 N either way
        const double complex expected =
            response(axis * cexp(0.4 * I), nu, 120.0 / hertz) + response(axis * cexp(-0.4 * I), -nu, 120.0 / hertz);
        check_within("Phases", words("31 Hz by its own sections, shaft of %g rad/s, part of the response", speeds[i]),
                     0.0, cabs(x[0] + I * x[1] - expected) / cabs(expected), 1e-9);
    }
}

/// A chaotic rotor that rubs stays chaotic under a small force that fits no revolution; where it runs in permanent
/// contact that force makes a torus. Without the force: chaos and P-1 (cases/jeffcott-rub.yaml).
static void chaos_with_a_phase(void **unused) {
    (void)unused;
    static const double speeds[] = {3.3, 1.5};
    static const char *const expected[] = {"chaotic", "quasi-periodic (forced)"};
    for (int i = 0; i < 2; i++) {
        const whirl_setting disc[] = {{"mass", 1.0, NULL}, {"damping", 0.2, NULL}, {"eccentricity", 0.9, NULL}};
        const whirl_setting shaft[] = {{"between", 0, "disc, ground"}, {"k1", 1.0, NULL}};
        const whirl_setting rub[] = {
            {"at", 0, "disc"}, {"gap", 1.0, NULL}, {"stiffness", 10.0, NULL}, {"friction", 0.05, NULL}};
        const whirl_setting gravity[] = {{"acceleration", 0.5, NULL}};
        const whirl_setting force[] = {
            {"at", 0, "disc"}, {"amplitude", 0.02, NULL}, {"ratio", 0.6180339887498949, NULL}};
        whirl_design *design;
        require_ok(whirl_design_new(speeds[i], 1.0, &design));
        require_ok(whirl_design_station(design, "disc", disc, 3));
        require_ok(whirl_design_element(design, "shaft", shaft, 2));
        require_ok(whirl_design_element(design, "rub", rub, 4));
        require_ok(whirl_design_element(design, "gravity", gravity, 1));
        require_ok(whirl_design_element(design, "force", force, 3));
        whirl_rotor *rotor = finish(design);
        const double start[5] = {0.1, -0.2};
        whirl_record *record = record_motion(whirl_rotor_system(rotor), start, 1024, 500, 2000);
        check_regime("Phases", words("a rotor that rubs at %g, and a force", speeds[i]), expected[i], record);
        whirl_record_free(record);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- a speed that changes

/// Makes a disc of unit mass, stiffness and unbalance whose speed begins at `start` and grows by `acceleration`.
static whirl_rotor *make_run_up(double zeta, double start, double acceleration) {
    const whirl_setting disc[] = {{"mass", 1.0, NULL}, {"damping", 2.0 * zeta, NULL}};
    const whirl_setting spring[] = {{"between", 0, "disc, ground"}, {"stiffness", 1.0, NULL}};
    const whirl_setting unbalance[] = {
        {"at", 0, "disc"}, {"moment", 1.0, NULL}, {"speed", start, NULL}, {"acceleration", acceleration, NULL}};
    whirl_design *design;
    require_ok(whirl_design_new(1.0, 1.0, &design));
    require_ok(whirl_design_add_type(design, whirl_run_up_type()));
    require_ok(whirl_design_station(design, "disc", disc, 2));
    require_ok(whirl_design_element(design, "spring", spring, 2));
    require_ok(whirl_design_element(design, "run_up", unbalance, 4));
    return finish(design);
}

/// The largest radius so far, and the last two instants' ones.
typedef struct peak {
    double before, last, radius, time;
} peak;

/// Takes the radius at t, a step after the last, and reads a peak off the parabola through three.
static void take(peak *p, double t, double step, double radius) {
    const double rise = p->last - p->before, fall = p->last - radius;
    if (rise > 0.0 && fall >= 0.0) {
        const double aside = 0.5 * (rise - fall) / (rise + fall), top = p->last + 0.25 * (rise - fall) * aside;
        if (top > p->radius) {
            p->radius = top;
            p->time = t + (aside - 1.0) * step;
        }
    }
    p->before = p->last;
    p->last = radius;
}

enum { STEPS = 4096 };
static const double fastest = 1.3; ///< the speed up to which it runs, over omega_n

typedef struct running {
    peak peak;
    double turns;
} running;

static void watch_peak(void *observer, double t, const double *x) {
    running *r = observer;
    take(&r->peak, r->turns * two_pi + t, two_pi / STEPS, hypot(x[0], x[1]));
}

typedef long double complex extended;

/// Computes z'' = (phi'^2 - i phi'') e^(i phi) - 2 zeta z' - z, phi = a t^2/2.
static void lewis(double a, double zeta, long double t, const extended z[2], extended slope[2]) {
    const long double phase = 0.5L * a * t * t, rate = a * t;
    slope[0] = z[1];
    slope[1] = (rate * rate - I * a) * (cosl(phase) + I * sinl(phase)) - 2.0L * zeta * z[1] - z[0];
}

/// Returns the same peak by the classical method on the equation in complex numbers of extended precision.
static peak run_up_apart(double a, double zeta) {
    const long double h = 4e-3L;
    extended z[2] = {0.0L, 0.0L}, k[4][2], at[2];
    peak p = {0};
    for (int n = 0; a * n * h < fastest; n++) {
        const long double t = n * h;
        lewis(a, zeta, t, z, k[0]);
        for (int stage = 1; stage < 4; stage++) {
            const long double part = stage < 3 ? 0.5L * h : h;
            for (int i = 0; i < 2; i++) at[i] = z[i] + part * k[stage - 1][i];
            lewis(a, zeta, t + part, at, k[stage]);
        }
        for (int i = 0; i < 2; i++) z[i] += h / 6.0L * (k[0][i] + 2.0L * (k[1][i] + k[2][i]) + k[3][i]);
        take(&p, (double)(t + h), (double)h, (double)cabsl(z[0]));
    }
    return p;
}

/// Lewis 1932: from rest through the resonance. The eighth decimals that were printed are one below what the rotor by
/// three methods, its equation in extended precision and its convolution integral in 25 digits agree on.
static void run_up(void **unused) {
    (void)unused;
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    static const struct {
        double acceleration, printed, integral;
        const char *radius, *speed;
    } known[] = {{0.001, 20.28372963, 20.283729640233, "20.2837296", "1.0492"},
                 {0.005, 13.99974170, 13.999741706287, "13.9997417", "1.1314"}};
    for (size_t i = 0; i < COUNT_OF(known); i++) {
        const double a = known[i].acceleration;
        const peak apart = run_up_apart(a, 0.02);
        note_within("Run-up", words("largest radius over e at %g, printed", a), known[i].printed, apart.radius, 5e-9);
        for (size_t m = 0; m < COUNT_OF(methods); m++) {
            whirl_rotor *rotor = make_run_up(0.02, 0.0, a);
            whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), methods[m], STEPS);
            running r = {.turns = 0.0};
            double x[6] = {0};
            for (; a * r.turns * two_pi < fastest; r.turns++)
                assert_int_equal(whirl_integrator_revolve(integrator, x, watch_peak, &r), WHIRL_BOUNDED);
            const char *at = words("at acceleration %g by %s", a, methods[m]);
            check_digits("Run-up", words("largest radius over e %s", at), known[i].radius, r.peak.radius);
            check_digits("Run-up", words("speed there over omega_n %s", at), known[i].speed, a * r.peak.time);
            check_within("Run-up", words("radius %s against extended precision", at), apart.radius, r.peak.radius,
                         1e-9);
            check_within("Run-up", words("radius %s against the integral", at), known[i].integral, r.peak.radius, 1e-9);
            check_within("Run-up", words("speed reached %s", at), a * r.turns * two_pi, x[5],
                         1e-10); // a million roundings
            whirl_integrator_free(integrator);
            whirl_rotor_free(rotor);
        }
    }
}

/// Without acceleration it is an unbalance: e w^2/|1 - w^2 + 2 i zeta w|.
static void steady_speed(void **unused) {
    (void)unused;
    const double zeta = 0.1, w = 1.3;
    whirl_rotor *rotor = make_run_up(zeta, w, 0.0);
    double x[6] = {0};
    settle(rotor, 60, x);
    const double complex expected = w * w * cexp(I * w * 60.0 * two_pi) / (1.0 - w * w + 2.0 * I * zeta * w);
    check_within("Run-up", "at a steady speed, part of the response", 0.0,
                 cabs(x[0] + I * x[1] - expected) / cabs(expected), 1e-9);
}

// ---------------------------------------------------------------- lanes

/// Carries machines whose forces have frequencies of their own side by side: by every method all widths give the same
/// bits, and the numbers of each machine alone. Returns the largest difference.
static double compare_lanes(const char *method, bool fused) {
    enum { LANES = 9, REVOLUTIONS = 7 };
    static const char *const sets[2][4] = {{"scalar", "simd128", NULL}, {"fma", "avx2", "avx512", NULL}};
    whirl_rotor *rotors[LANES];
    for (size_t l = 0; l < LANES; l++) {
        whirl_design *design = begin_disc();
        add_force(design, "forward", "frequency", 20.0 + 5.0 * (double)l);
        rotors[l] = finish(design);
    }
    const double worst = compare_lanes_with_alone(method, sets[fused], rotors, LANES, REVOLUTIONS);
    for (size_t l = 0; l < LANES; l++) whirl_rotor_free(rotors[l]);
    return worst;
}

static void in_lanes(void **unused) {
    (void)unused;
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    // The same steps, but for rounding. A phase near 2 pi is rounded by up to 4.4e-16 in each of 7168 steps, otherwise
    // where multiply-adds are fused than alone, and the motion follows it with up to 5 length scales a radian: 3e-11.
    static const double tolerances[2][3] = {{1e-13, 1e-11, 1e-11}, {3e-11, 1e-11, 1e-11}};
    for (int fused = 0; fused < 2; fused++)
        for (size_t m = 0; m < COUNT_OF(methods); m++)
            check_within("Phases",
                         words("in %slanes and alone by %s after seven revolutions, in length scales",
                               fused ? "fused " : "", methods[m]),
                         0.0, compare_lanes(methods[m], fused), tolerances[fused][m]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(linear_response),
                                       cmocka_unit_test(tilting_response),
                                       cmocka_unit_test(along_one_axis),
                                       cmocka_unit_test(the_derivative),
                                       cmocka_unit_test(regimes),
                                       cmocka_unit_test(chaos_with_a_phase),
                                       cmocka_unit_test(sections_by_another_phase),
                                       cmocka_unit_test(slow_shafts),
                                       cmocka_unit_test(run_up),
                                       cmocka_unit_test(steady_speed),
                                       cmocka_unit_test(in_lanes)};
    return cmocka_run_group_tests_name("phases", tests, NULL, NULL);
}
