// A machine of eighty uncoupled discs, each within a ring that it touches: 80 contacts, 120 switches. Every disc must
// move as it does alone: to the bit with fixed steps that do not locate contacts, and to the error of the method where
// the contacts of other discs shorten its steps.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "whirl/engine/ensemble.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/rotor.h"

/// ROWS: x, y, x', y' of a disc. TOLD: these and their perturbations.
enum { DISCS = 80, ROWS = 4, TOLD = 2 * ROWS, REVOLUTIONS = 5 };

static void must(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

/// Adds disc number `disc` with its shaft and its ring; every second ring has damping.
static void add_disc(whirl_design *design, size_t disc) {
    char name[16], ends[32];
    const double part = (double)disc / DISCS;
    snprintf(name, sizeof name, "d%zu", disc);
    snprintf(ends, sizeof ends, "%s, ground", name);
    const whirl_setting station[] = {
        {"mass", 1.0, NULL}, {"damping", 0.2, NULL}, {"eccentricity", 0.4 + 0.3 * part, NULL}};
    const whirl_setting shaft[] = {{"between", 0.0, ends}, {"k1", 1.2, NULL}, {"k2", 0.9, NULL}};
    const whirl_setting rub[] = {{"at", 0.0, name},
                                 {"gap", 1.0 - 0.2 * part, NULL},
                                 {"stiffness", 10.0, NULL},
                                 {"friction", 0.05, NULL},
                                 {"damping", 0.3, NULL}};
    must(whirl_design_station(design, name, station, 3));
    must(whirl_design_element(design, "shaft", shaft, 3));
    must(whirl_design_element(design, "rub", rub, disc % 2 ? 5 : 4));
}

/// Makes a machine of `count` discs from number `first` on.
static whirl_rotor *discs(size_t first, size_t count) {
    const whirl_setting gravity[] = {{"acceleration", 0.3, NULL}};
    whirl_design *design;
    whirl_rotor *rotor;
    must(whirl_design_new(1.0, 1.0, &design));
    for (size_t d = first; d < first + count; d++) add_disc(design, d);
    must(whirl_design_element(design, "gravity", gravity, 1));
    must(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Discs that have touched their rings.
typedef struct touches {
    const whirl_system *system;
    bool seen[DISCS];
} touches;

static void look(void *context, double t, const double *x) {
    touches *own = context;
    double force[DISCS];
    (void)t;
    own->system->contacts(own->system->model, x, force);
    for (size_t c = 0; c < own->system->contact_count; c++) own->seen[c] = own->seen[c] || force[c] > 0.0;
}

/// Carries `count` discs from rest, with one perturbation that displaces each along x. Writes out [count][TOLD]: state
/// and perturbation of each disc.
static void carry(const whirl_rotor *rotor, size_t count, const char *method, bool located, double *out) {
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_integrate_options options = whirl_integrate_default();
    touches touched = {.system = system};
    whirl_integrator *integrator;
    snprintf(options.method, sizeof options.method, "%s", method);
    options.located = located;
    double *x = calloc(system->dimension, sizeof *x), *u = calloc(system->dimension, sizeof *u);
    assert_true(x && u);
    for (size_t d = 0; d < count; d++) u[2 * d] = 1.0;
    must(whirl_integrator_new(system, &options, &integrator));
    must(whirl_integrator_follow(integrator, 1));
    for (int r = 0; r < REVOLUTIONS; r++) {
        whirl_perturbations set = {.count = 1, .vectors = u};
        assert_int_equal(whirl_integrator_carry(integrator, x, &set, look, &touched), WHIRL_BOUNDED);
    }
    for (size_t d = 0; d < count; d++) {
        assert_true(touched.seen[d]);
        for (size_t row = 0; row < ROWS; row++) {
            const size_t at = (row < 2 ? 0 : 2 * count) + 2 * d + row % 2;
            out[TOLD * d + row] = x[at];
            out[TOLD * d + ROWS + row] = u[at];
        }
    }
    whirl_integrator_free(integrator);
    free(x);
    free(u);
}

/// Returns the largest difference between discs in one machine and the same discs in machines of their own.
static double apart(const char *method, bool located) {
    static double all[TOLD * DISCS];
    double alone[TOLD], most = 0.0;
    whirl_rotor *rotor = discs(0, DISCS);
    carry(rotor, DISCS, method, located, all);
    whirl_rotor_free(rotor);
    for (size_t d = 0; d < DISCS; d++) {
        rotor = discs(d, 1);
        carry(rotor, 1, method, located, alone);
        whirl_rotor_free(rotor);
        for (size_t i = 0; i < TOLD; i++) most = fmax(most, fabs(alone[i] - all[TOLD * d + i]));
    }
    return most;
}

static void fixed_steps_are_equal_to_the_bit(void **state) {
    (void)state;
    assert_true(apart("rk4", false) == 0.0);
}

static void located_steps_agree(void **state) {
    (void)state;
    const double far_rk4 = apart("rk4", true), far_dop853 = apart("dop853", true);
    print_message("80 discs together and alone: rk4 located %.1e, dop853 %.1e apart\n", far_rk4, far_dop853);
    assert_true(far_rk4 < 1e-6);
    assert_true(far_dop853 < 1e-6);
}

/// Discs in one machine and discs alone, both in lanes, have the same bits.
static void lanes_are_equal_to_the_bit(void **state) {
    (void)state;
    whirl_integrate_options options = whirl_integrate_default();
    whirl_rotor *rotor = discs(0, DISCS);
    const whirl_system *system = whirl_rotor_system(rotor);
    double *x = calloc(system->dimension, sizeof *x);
    whirl_ensemble *together;
    assert_non_null(x);
    assert_int_equal(system->contact_count, DISCS);
    assert_true(system->switch_count > DISCS);
    must(whirl_ensemble_new(system, &options, 1, &together));
    must(whirl_ensemble_load(together, 0, system, x));
    for (int r = 0; r < REVOLUTIONS; r++) whirl_ensemble_revolve(together, 1, NULL);
    whirl_ensemble_state(together, 0, x);
    for (size_t d = 0; d < DISCS; d++) {
        whirl_rotor *one = discs(d, 1);
        const double rest[ROWS] = {0.0};
        double own[ROWS];
        whirl_ensemble *alone;
        must(whirl_ensemble_new(whirl_rotor_system(one), &options, 1, &alone));
        must(whirl_ensemble_load(alone, 0, whirl_rotor_system(one), rest));
        for (int r = 0; r < REVOLUTIONS; r++) whirl_ensemble_revolve(alone, 1, NULL);
        whirl_ensemble_state(alone, 0, own);
        for (size_t row = 0; row < ROWS; row++) assert_true(own[row] == x[(row < 2 ? 0 : 2 * DISCS) + 2 * d + row % 2]);
        whirl_ensemble_free(alone);
        whirl_rotor_free(one);
    }
    whirl_ensemble_free(together);
    whirl_rotor_free(rotor);
    free(x);
}

static void too_many_are_refused(void **state) {
    (void)state;
    whirl_rotor *rotor = discs(0, 1);
    whirl_system system = *whirl_rotor_system(rotor);
    const whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    system.switch_count = WHIRL_MAX_SWITCHES + 1;
    const whirl_status status = whirl_integrator_new(&system, &options, &integrator);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, "the system has 4097 switching functions, expected at most 4096");
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fixed_steps_are_equal_to_the_bit),
        cmocka_unit_test(located_steps_agree),
        cmocka_unit_test(lanes_are_equal_to_the_bit),
        cmocka_unit_test(too_many_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
