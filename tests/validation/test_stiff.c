// A vertical pump: the films of its two unloaded bearings grow stiff as its journals whirl near the wall. What RK4
// makes of it is no motion of the machine, however many points of a sweep agree on it. And a disc that strikes a stator
// a hundred thousand times as stiff as its shaft.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine/case.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/study.h"

static const char pump[] =
    "whirl: 1\n"
    "parameters: {n: 3000 rpm, c: 0.15 mm, k: 12 MN/m, oil: 30 mPa.s}\n"
    "rotor:\n"
    "  speed: = n\n"
    "  length_scale: = c\n"
    "  stations:\n"
    "    upper:  {mass: 6 kg}\n"
    "    imp1:   {mass: 25 kg, damping: 300 N.s/m, eccentricity: 10 um}\n"
    "    imp2:   {mass: 30 kg, damping: 300 N.s/m, eccentricity: 20 um, eccentricity_angle: 120 deg}\n"
    "    imp3:   {mass: 25 kg, damping: 300 N.s/m, eccentricity: 10 um, eccentricity_angle: 240 deg}\n"
    "    lower:  {mass: 6 kg}\n"
    "  elements:\n"
    "    - shaft: {between: [upper, imp1], k1: = k}\n"
    "    - shaft: {between: [imp1, imp2], k1: = k}\n"
    "    - shaft: {between: [imp2, imp3], k1: = k}\n"
    "    - shaft: {between: [imp3, lower], k1: = k}\n"
    "    - film:  {at: upper, clearance: = c, viscosity: = oil, radius: 30 mm, length: 25 mm}\n"
    "    - film:  {at: lower, clearance: = c, viscosity: = oil, radius: 30 mm, length: 25 mm}\n"
    "    - rub:   {at: imp2, gap: 0.25 mm, stiffness: 40 MN/m, friction: 0.15, law: slip, radius: 90 mm}\n"
    "study:\n"
    "  sweep: {parameter: n, from: 2900 rpm, to: 3100 rpm, points: 3, start: state}\n"
    "  initial: {upper: {y: -0.1}, lower: {y: -0.1}}\n"
    "  integrate: {transient: 400, record: 200}\n";

enum { MIDDLE = 1, POINTS = 3 };

static const char striker[] =
    "whirl: 1\n"
    "rotor:\n"
    "  speed: 1 rad/s\n"
    "  length_scale: 1 m\n"
    "  stations: {disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: 0.9 m}}\n"
    "  elements:\n"
    "    - shaft: {between: [disc, ground], k1: 1 N/m}\n"
    "    - rub: {at: disc, gap: 1 m, stiffness: 1e5 N/m, damping: 600 N.s/m, friction: 0.05}\n"
    "    - gravity: {acceleration: 0.5 m/s^2}\n"
    "study:\n"
    "  response: {}\n"
    "  initial: {disc: {x: 0.1 m, y: -0.2 m}}\n";

static whirl_case *load(const char *text, size_t length, whirl_study *study) {
    whirl_problems problems = {0};
    whirl_case *object;
    require_ok(whirl_case_parse(text, length, "case", &problems, &object));
    require_ok(whirl_case_study(object, study));
    return object;
}

static whirl_case *load_pump(whirl_study *study) {
    return load(pump, sizeof pump - 1, study);
}

static whirl_result *run_pump(const char *method, int steps, int transient, int record, size_t points) {
    whirl_study study;
    whirl_result *result;
    whirl_case *object = load_pump(&study);
    whirl_batch *batch = &study.batches[0];
    const double *values = batch->values;
    snprintf(batch->integrate.method, sizeof batch->integrate.method, "%s", method);
    batch->integrate.steps_per_revolution = steps;
    batch->record.transient = transient;
    batch->record.record = record;
    batch->record.samples_per_revolution = 64;
    if (points == 1) batch->values = values + MIDDLE;
    batch->count = points;
    require_ok(whirl_study_run(&study, &(whirl_run_options){.threads = 2}, &result));
    whirl_case_free(object);
    return result;
}

/// With 64 to 4096 steps there is no verdict, and the reason is given.
static void steps_that_are_unstable_give_no_verdict(void **unused) {
    static const int steps[] = {64, 256, 1024, 4096};
    (void)unused;
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        whirl_result *result = run_pump("rk4", steps[i], 100, 100, steps[i] > 1024 ? 1 : POINTS);
        for (size_t point = 0; point < result->tables[0].count; point++) {
            const whirl_verdict verdict = whirl_table_verdict(&result->tables[0], point);
            char reason[WHIRL_MESSAGE_SIZE], advice[WHIRL_MESSAGE_SIZE];
            whirl_verdict_reason(&verdict, reason, sizeof reason);
            whirl_verdict_advice(&verdict, advice, sizeof advice);
            assert_int_equal(verdict.regime, WHIRL_UNDETERMINED);
            assert_int_equal(verdict.confidence, WHIRL_LOW);
            assert_int_equal(verdict.advice.remedy, WHIRL_MORE_STEPS);
            assert_true(verdict.step_growth > 1.001);
            assert_non_null(strstr(reason, "the fixed step is unstable"));
            assert_non_null(strstr(advice, "times as many steps"));
        }
        whirl_result_free(result);
    }
}

/// Method auto chooses rodas5p. Its motion is that of dop853, which needs ten times the work later on.
static void auto_follows_the_machine(void **unused) {
    enum { REVOLUTIONS = 10 };
    whirl_study study;
    whirl_case *object = load_pump(&study);
    double ends[2][20];
    (void)unused;
    assert_string_equal(study.batches[0].integrate.method, "auto");
    require_ok(whirl_study_choose_methods(&study));
    assert_string_equal(study.batches[0].integrate.method, "rodas5p");
    assert_true(study.batches[0].integrate.chosen);
    for (int m = 0; m < 2; m++) {
        whirl_integrate_options options = study.batches[0].integrate;
        whirl_integrator *integrator;
        whirl_machine machine;
        if (m == 1) snprintf(options.method, sizeof options.method, "dop853");
        require_ok(study.machine(study.family, &study.batches[0], study.batches[0].values[MIDDLE], &machine));
        assert_int_equal(machine.system->dimension, 20);
        memcpy(ends[m], machine.start, sizeof ends[m]);
        require_ok(whirl_integrator_new(machine.system, &options, &integrator));
        for (int i = 0; i < REVOLUTIONS; i++)
            assert_int_equal(whirl_integrator_revolve(integrator, ends[m], NULL, NULL), WHIRL_BOUNDED);
        whirl_integrator_free(integrator);
        if (machine.release) machine.release(machine.owner);
    }
    double worst = 0.0;
    for (int i = 0; i < 20; i++) worst = fmax(worst, fabs(ends[0][i] - ends[1][i]));
    check_within("stiff", "vertical pump: largest difference of auto from dop853 after 10 revolutions", 0.0, worst,
                 1e-8);
    whirl_case_free(object);
}

/// Its journals whirl by themselves and its unbalance turns: two frequencies, perturbations that neither grow nor die
/// out. By dop853 the exponent of the case's length is .0005; a second trajectory by cvode-bdf would have shown .395.
static void vertical_pump(void **unused) {
    (void)unused;
    whirl_result *result = run_pump("auto", 1024, 400, 200, 1);
    const whirl_verdict verdict = whirl_table_verdict(&result->tables[0], 0);
    assert_string_equal(result->tables[0].integrate.method, "rodas5p");
    assert_int_not_equal(verdict.regime, WHIRL_CHAOTIC);
    assert_true(isnan(verdict.step_growth));
    check_within("stiff", "vertical pump: largest exponent by auto", 0.0005, verdict.exponent.value, 3e-3);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- the same motion by other methods

/// Carries x over revolutions by a method alone.
static void carry_alone(const whirl_system *system, const char *method, double rtol, int revolutions, double *x) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    snprintf(options.method, sizeof options.method, "%s", method);
    options.rtol = rtol;
    options.atol = 1e-3 * rtol;
    require_ok(whirl_integrator_new(system, &options, &integrator));
    for (int i = 0; i < revolutions; i++)
        assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
    whirl_integrator_free(integrator);
}

static void carry_in_lanes(const whirl_system *system, double rtol, int revolutions, double *x) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_ensemble *lanes;
    snprintf(options.method, sizeof options.method, "rodas5p");
    options.rtol = rtol;
    options.atol = 1e-3 * rtol;
    require_ok(whirl_ensemble_new(system, &options, 3, &lanes));
    require_ok(whirl_ensemble_load(lanes, 1, system, x));
    for (int i = 0; i < revolutions; i++) whirl_ensemble_revolve(lanes, 3, NULL);
    assert_int_equal(whirl_ensemble_motion(lanes, 1), WHIRL_BOUNDED);
    whirl_ensemble_state(lanes, 1, x);
    whirl_ensemble_free(lanes);
}

static double apart(size_t n, const double *a, const double *b) {
    double worst = 0.0;
    for (size_t i = 0; i < n; i++) worst = fmax(worst, fabs(a[i] - b[i]));
    return worst;
}

enum { MAX_DIMENSION = 20 };

/// Compares the states after a few revolutions from `start`: rodas5p in lanes and alone, with the other methods.
static void compare_methods(const char *name, const whirl_system *system, const double *start, int revolutions) {
    double lanes[MAX_DIMENSION], alone[MAX_DIMENSION], bdf[MAX_DIMENSION], dop853[MAX_DIMENSION];
    const size_t n = system->dimension, bytes = n * sizeof *start;
    memcpy(lanes, start, bytes);
    memcpy(alone, start, bytes);
    memcpy(bdf, start, bytes);
    memcpy(dop853, start, bytes);
    carry_in_lanes(system, 1e-11, revolutions, lanes);
    carry_alone(system, "rodas5p", 1e-11, revolutions, alone);
    carry_alone(system, "cvode-bdf", 1e-13, revolutions, bdf);
    carry_alone(system, "dop853", 1e-12, revolutions, dop853);
    check_within("stiff", words("%s: largest difference of rodas5p in lanes from cvode-bdf", name), 0.0,
                 apart(n, lanes, bdf), 1e-8);
    check_within("stiff", words("%s: of rodas5p in lanes from dop853", name), 0.0, apart(n, lanes, dop853), 1e-9);
    check_within("stiff", words("%s: of rodas5p in lanes from rodas5p alone", name), 0.0, apart(n, alone, lanes), 1e-9);
}

static void stiff_films_by_other_methods(void **unused) {
    enum { SETTLING = 150 };
    whirl_study study;
    whirl_case *object = load_pump(&study);
    whirl_machine machine;
    double x[MAX_DIMENSION];
    (void)unused;
    require_ok(study.machine(study.family, &study.batches[0], study.batches[0].values[MIDDLE], &machine));
    memcpy(x, machine.start, sizeof x);
    carry_alone(machine.system, "rodas5p", 1e-6, SETTLING, x); // until its journals whirl near the wall
    compare_methods("vertical pump", machine.system, x, 4);
    if (machine.release) machine.release(machine.owner);
    whirl_case_free(object);
}

static void a_stiff_stator_by_other_methods(void **unused) {
    whirl_study study;
    whirl_case *object = load(striker, sizeof striker - 1, &study);
    whirl_machine machine;
    (void)unused;
    require_ok(study.machine(study.family, &study.batches[0], (double)NAN, &machine));
    compare_methods("stiff stator", machine.system, machine.start, 3);
    if (machine.release) machine.release(machine.owner);
    whirl_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_that_are_unstable_give_no_verdict),
        cmocka_unit_test(auto_follows_the_machine),
        cmocka_unit_test(vertical_pump),
        cmocka_unit_test(stiff_films_by_other_methods),
        cmocka_unit_test(a_stiff_stator_by_other_methods),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
