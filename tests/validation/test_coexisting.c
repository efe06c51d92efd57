// Attractors on which chaos may end, and the confidence of verdicts on transient chaos: Lorenz's system, whose
// equilibria are stable up to r = 470/19 and draw in all motions up to 24.06 (Sparrow 1982); a rub, case C4 at w
// = 3.62, whose motions end on a P-3 in thousands of revolutions; and Ueda's oscillator, whose chaos is its only
// attractor (Ueda 1980, k = 0.05, B = 7.5).
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "lorenz.h"
#include "support_check.h"
#include "support_rotor.h"
#include "whirl/engine/study.h"

static void ueda_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = 7.5 * cos(t) - 0.05 * x[1] - x[0] * x[0] * x[0];
}

static void ueda_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                         size_t count, const double *dx, double *out) {
    (void)model, (void)t, (void)forcing, (void)sides;
    for (; count > 0; count--, dx += 2, out += 2) {
        out[0] = dx[1];
        out[1] = -0.05 * dx[1] - 3.0 * x[0] * x[0] * dx[0];
    }
}

static whirl_integrate_options steps_of(int steps) {
    whirl_integrate_options integrate = whirl_integrate_default();
    strcpy(integrate.method, "rk4");
    integrate.steps_per_revolution = steps;
    return integrate;
}

static whirl_record_options watched(void) {
    whirl_record_options options = whirl_record_default();
    options.transient = 1100;
    options.record = 100;
    options.watch = 650;
    options.waveform = false;
    return options;
}

static int coexisting_of(const whirl_system *system, const double *start, int steps) {
    const whirl_integrate_options integrate = steps_of(steps);
    const whirl_record_options options = watched();
    whirl_record *record;
    int coexisting;
    require_ok(whirl_record_motion(system, &integrate, &options, start, NULL, &record));
    assert_int_equal(whirl_judge(record).regime, WHIRL_CHAOTIC);
    require_ok(whirl_record_coexisting(system, &integrate, record, &coexisting));
    whirl_record_free(record);
    return coexisting;
}

static void coexisting_attractors_of_lorenz(void **state) {
    static const whirl_probe probe = {.name = "x"};
    const struct {
        double r;
        int coexisting;
    } known[] = {{23.9, WHIRL_COEXISTING_AT_REST}, {24.03, WHIRL_COEXISTING_AT_REST}, {28.0, 0}};
    const double start[] = {3.0, 4.0, 6.0};
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const whirl_system system = {.dimension = 3,
                                     .period = 1.0,
                                     .rhs = lorenz_rhs,
                                     .tangent = lorenz_tangent,
                                     .model = &known[i].r,
                                     .probe_count = 1,
                                     .probes = &probe};
        assert_int_equal(coexisting_of(&system, start, 128), known[i].coexisting);
    }
}

static void chaos_that_is_all_there_is(void **state) {
    static const whirl_probe probe = {.name = "x", .vx = 1, .vy = 1};
    const whirl_system system = {.dimension = 2,
                                 .period = 6.283185307179586,
                                 .rhs = ueda_rhs,
                                 .tangent = ueda_tangent,
                                 .probe_count = 1,
                                 .probes = &probe};
    const double start[] = {2.0, 1.0};
    (void)state;
    assert_int_equal(coexisting_of(&system, start, 128), 0);
}

typedef struct rubbing {
    whirl_rotor *rotor;
    double start[4];
} rubbing;

static void release(void *owner) {
    rubbing *r = owner;
    whirl_rotor_free(r->rotor);
    free(r);
}

/// Makes start number `value` of case C4 at w = 3.62, where chaos is transient.
static whirl_status make_rubbing(const void *family, const whirl_batch *batch, double value, whirl_machine *machine) {
    const rub_case c = {
        .speed = 3.62, .zeta = 0.1, .kappa = 10.0, .eccentricity = 0.9, .friction = 0.05, .weight = 0.5};
    rubbing *r = calloc(1, sizeof *r);
    (void)family, (void)batch;
    assert_non_null(r);
    *r = (rubbing){make_rub_rotor(&c), {0.1 + 0.02 * value, -0.2 + 0.013 * value}};
    *machine =
        (whirl_machine){.system = whirl_rotor_system(r->rotor), .start = r->start, .owner = r, .release = release};
    return whirl_ok();
}

static void transient_chaos_high(void **state) {
    double values[12];
    whirl_result *result;
    whirl_study study = {.batch_count = 1, .machine = make_rubbing};
    whirl_batch *batch = &study.batches[0];
    int chaotic = 0, reported = 0;
    (void)state;
    *batch = (whirl_batch){.name = "starts", .parameter = "k", .count = 12, .values = values, .confirm = true};
    for (size_t i = 0; i < 12; i++) values[i] = (double)i;
    batch->integrate = steps_of(192);
    batch->record = watched();
    assert_true(whirl_analysis_add(&batch->analyses, "regime"));
    require_ok(whirl_study_run(&study, &(whirl_run_options){.threads = 2}, &result));
    for (size_t i = 0; i < 12; i++) {
        const whirl_verdict v = whirl_table_verdict(result->tables, i);
        char reason[512];
        if (v.regime != WHIRL_CHAOTIC) continue;
        whirl_verdict_reason(&v, reason, sizeof reason);
        chaotic++;
        assert_true(v.confidence < WHIRL_HIGH);
        reported += v.coexisting == 3 && strstr(reason, "a stable P-3 is near the motion") != NULL;
        assert_non_null(strstr(reason, "chaotic for at least"));
    }
    assert_true(chaotic >= 3 && reported >= 2);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coexisting_attractors_of_lorenz),
        cmocka_unit_test(chaos_that_is_all_there_is),
        cmocka_unit_test(transient_chaos_high),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
