// Basins: which of two wells the starts of a Duffing oscillator lead to, against brute force without any
// verdicts: a plain RK4 of its own, and the sign of the mean displacement at the end.
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
#include "whirl/engine/study.h"

static const double pi = 3.14159265358979323846;

// D2 of the validation problems: x'' + .3 x' - x + x^3 = F cos(1.2 t); here in tau = 1.2 t.
static const double speed = 1.2, damping = 0.3;

static double acceleration(double force, double t, double x, double v) {
    return (force * cos(t) + x - x * x * x - damping * speed * v) / (speed * speed);
}

static void rhs(const void *model, double t, const double *forcing, const double *x, double *dx) {
    const double *force = model;
    (void)forcing;
    dx[0] = x[1];
    dx[1] = acceleration(*force, t, x[0], x[1]);
}

static const whirl_probe probe = {.name = "mass", .x = 0, .y = 0, .vx = 1, .vy = 1};

/// A machine with its start, and the system that it lends.
typedef struct oscillator {
    double start[2];
    whirl_system system;
} oscillator;

/// Makes the machine with a start in the plane.
static whirl_status machine_at(const void *family, const whirl_batch *batch, double value, whirl_machine *machine) {
    oscillator *own = malloc(sizeof *own);
    assert_non_null(own);
    *own = (oscillator){.start = {value, batch->second_value}};
    own->system = (whirl_system){
        .model = family, .dimension = 2, .period = 2.0 * pi, .rhs = rhs, .probe_count = 1, .probes = &probe};
    *machine = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

enum { COLUMNS = 30, ROWS = 20, STARTS = COLUMNS * ROWS };

static void place_starts(double *x, double *v) {
    for (size_t i = 0; i < STARTS; i++) {
        x[i] = -1.6 + 3.2 * (double)(i % COLUMNS) / (COLUMNS - 1);
        v[i] = (-1.0 + 2.0 * (double)(i / COLUMNS) / (ROWS - 1)) / speed;
    }
}

/// Computes the basins of `count` starts, in one row; the force is the family.
static whirl_result *run(const double *force, const double *x, const double *v, size_t count, int transient) {
    static const char *const analyses[] = {"poincare", "orbit", "regime"};
    whirl_study study = {.batch_count = 1, .machine = machine_at, .family = force};
    whirl_batch *batch = &study.batches[0];
    whirl_result *result;
    const whirl_run_options options = {.threads = 2};
    *batch = (whirl_batch){
        .name = "basin", .role = WHIRL_ROLE_BASIN, .parameter = "x", .second = "v", .count = count, .row = count};
    batch->values = x;
    batch->second_values = v;
    batch->integrate = whirl_integrate_default();
    strcpy(batch->integrate.method, "dop853");
    batch->integrate.rtol = 1e-9;
    batch->record = whirl_record_default();
    batch->record.transient = transient;
    batch->record.record = 100;
    batch->record.settle = true;
    for (size_t i = 0; i < 3; i++) assert_true(whirl_analysis_add(&batch->analyses, analyses[i]));
    whirl_analysis_needs(batch->analyses, &batch->record);
    require_ok(whirl_study_run(&study, &options, &result));
    return result;
}

/// Returns true if the motion is in the right well after 200 periods by RK4 with 400 steps each: the sign of the mean
/// displacement in the last.
static bool ends_right(double force, double x, double v) {
    const int steps = 400, periods = 200;
    const double h = 2.0 * pi / steps;
    double mean = 0.0;
    for (int i = 0; i < steps * periods; i++) {
        const double t = h * (double)(i % steps);
        const double a1 = acceleration(force, t, x, v), v2 = v + 0.5 * h * a1;
        const double a2 = acceleration(force, t + 0.5 * h, x + 0.5 * h * v, v2), v3 = v + 0.5 * h * a2;
        const double a3 = acceleration(force, t + 0.5 * h, x + 0.5 * h * v2, v3), v4 = v + h * a3;
        const double a4 = acceleration(force, t + h, x + h * v3, v4);
        x += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
        v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
        if (i >= steps * (periods - 1)) mean += x / steps;
    }
    return mean > 0.0;
}

/// Two motions are found, one in each well, and every start leads to that of brute force. Starts next to a boundary,
/// whose motions stay near the saddle for long, may differ by the errors of the methods.
static void starts_lead_to_their_wells(void **state) {
    const double force = 0.2;
    double x[STARTS], v[STARTS];
    size_t labels[STARTS], count, right = 0, differ = 0;
    whirl_attractor found[4];
    (void)state;
    place_starts(x, v);
    whirl_result *result = run(&force, x, v, STARTS, 300);
    const whirl_table *table = &result->tables[0];
    require_ok(whirl_table_attractors(table, labels, found, 4, &count));
    check_within("basins", "D2, F = .20: attractors", 2.0, (double)count, 0.0);
    const size_t right_label = *whirl_table_field(table, found[0].first, "orbit/mean", 0) > 0.0 ? 1 : 2;
    for (size_t i = 0; i < STARTS; i++) {
        const bool is_right = ends_right(force, x[i], v[i]);
        right += is_right;
        differ += labels[i] == 0 || (labels[i] == right_label) != is_right;
        assert_true(whirl_table_second(table, i) == v[i]);
    }
    const double share = (double)right / STARTS;
    check_within("basins", "D2, F = .20: starts that differ from brute force, of 600", 0.0, (double)differ, 3.0);
    check_within("basins", "D2, F = .20: share of the right well", share, found[right_label - 1].share,
                 found[right_label - 1].error);
    check_within("basins", "... its standard error", sqrt(share * (1.0 - share) / STARTS), found[0].error, 1e-3);
    check_holds("basins", "D2, F = .20: both motions are P-1",
                whirl_table_verdict(table, found[0].first).period == 1 &&
                    whirl_table_verdict(table, found[1].first).period == 1);
    whirl_result_free(result);
}

/// An orbit of two revolutions is one attractor, in either phase: one in each well. Chaos that visits both wells is one
/// attractor for all starts.
static void attractors_are_distinguished(void **state) {
    enum { FEW = 20 };
    static const struct {
        const char *what;
        double force, attractors;
        whirl_regime regime;
        int period;
    } cases[] = {{"F = .28: a P-2 in each well", 0.28, 2, WHIRL_PERIODIC, 2},
                 {"F = .50: chaos about both wells", 0.50, 1, WHIRL_CHAOTIC, 0}};
    double x[STARTS], v[STARTS];
    (void)state;
    place_starts(x, v);
    for (size_t i = 0; i < FEW; i++) {
        x[i] = x[i * (STARTS / FEW)];
        v[i] = v[i * (STARTS / FEW)];
    }
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        whirl_attractor found[4];
        size_t labels[FEW], count;
        whirl_result *result = run(&cases[c].force, x, v, FEW, 500);
        const whirl_table *table = &result->tables[0];
        require_ok(whirl_table_attractors(table, labels, found, 4, &count));
        check_within("basins", words("D2, %s", cases[c].what), cases[c].attractors, (double)count, 0.0);
        for (size_t k = 0; k < count && k < 4; k++) {
            const whirl_verdict verdict = whirl_table_verdict(table, found[k].first);
            assert_int_equal(cases[c].regime, verdict.regime);
            assert_int_equal(cases[c].period, verdict.period);
        }
        for (size_t i = 0; i < FEW; i++) assert_int_not_equal(0, labels[i]);
        whirl_result_free(result);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(starts_lead_to_their_wells),
                                       cmocka_unit_test(attractors_are_distinguished)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
