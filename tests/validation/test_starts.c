// Coexisting motions: the attractors at every point of a study with several starts, and the number of starts that lead
// to each, against independent brute force: its own equations, RK4 and quasi-random starts; kinds of motions follow
// from their returns.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_brute.h"
#include "support_check.h"
#include "whirl/engine/case.h"
#include "whirl/engine/study.h"

// ---------------------------------------------------------------- two wells

// D2 of the validation problems: x'' + .3 x' - x + x^3 = F cos(1.2 t); here in tau = 1.2 t.
static const double speed = 1.2, damping = 0.3;

static void duffing(double force, double cosine, double sine, const double *x, double *dx) {
    (void)sine;
    dx[0] = x[1];
    dx[1] = (force * cosine + x[0] - x[0] * x[0] * x[0] - damping * speed * x[1]) / (speed * speed);
}

static void duffing_rate(const void *model, double t, const double *forcing, const double *x, double *dx) {
    (void)forcing;
    duffing(*(const double *)model, cos(t), sin(t), x, dx);
}

static const whirl_probe probe = {.name = "mass", .x = 0, .y = 0, .vx = 1, .vy = 1};

typedef struct oscillator {
    double force, start[2];
    whirl_system system;
} oscillator;

static void place_start(size_t start, double *x) {
    x[0] = -1.6 + 3.2 * brute_mirrored((int)start + 1, 2);
    x[1] = (-1.0 + 2.0 * brute_mirrored((int)start + 1, 3)) / speed;
}

static whirl_status machine_at(const void *family, const whirl_batch *batch, double value, whirl_machine *machine) {
    oscillator *own = malloc(sizeof *own);
    (void)family;
    assert_non_null(own);
    own->force = value;
    place_start(batch->start, own->start);
    own->system = (whirl_system){.model = &own->force,
                                 .dimension = 2,
                                 .period = 2.0 * pi,
                                 .rhs = duffing_rate,
                                 .probe_count = 1,
                                 .probes = &probe};
    *machine = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

enum { STARTS = 64 };

/// A motion in each well, whose period doubles once and twice; and chaos about both.
static const double two_wells[] = {0.18, 0.2, 0.22, 0.24, 0.26, 0.28, 0.29}, both_wells[] = {0.5, 0.52};

static whirl_result *run_wells(const double *forces, size_t count) {
    static const char *const analyses[] = {"poincare", "orbit", "regime"};
    whirl_study study = {.batch_count = 1, .machine = machine_at};
    whirl_batch *batch = &study.batches[0];
    whirl_result *result;
    const whirl_run_options options = {.threads = 2};
    *batch = (whirl_batch){.name = "sweep", .parameter = "F", .count = count, .values = forces, .starts = STARTS};
    batch->integrate = whirl_integrate_default();
    strcpy(batch->integrate.method, "dop853");
    batch->integrate.rtol = 1e-9;
    batch->record = whirl_record_default();
    batch->record.transient = 500;
    batch->record.record = 100;
    batch->record.settle = true;
    for (size_t i = 0; i < 3; i++) assert_true(whirl_analysis_add(&batch->analyses, analyses[i]));
    whirl_analysis_needs(batch->analyses, &batch->record);
    require_ok(whirl_study_run(&study, &options, &result));
    return result;
}

/// Kinds of motions: 3 times the period (0: none), and which well: 0 both, 1 the right one, 2 the left one.
enum { KINDS = 3 * (LONGEST + 1) };

static int kind_of(const outcome *o) {
    return 3 * o->period + (o->mean > 0.3 ? 1 : o->mean < -0.3 ? 2 : 0);
}

static int kind_of_point(const whirl_table *table, size_t point) {
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    const double mean = *whirl_table_field(table, point, "orbit/mean", 0);
    return 3 * (verdict.regime == WHIRL_PERIODIC ? verdict.period : 0) + (mean > 0.3 ? 1 : mean < -0.3 ? 2 : 0);
}

/// Returns the kind of motion that brute force reaches with `steps` steps.
static int brute_kind(double force, size_t start, int steps) {
    const brute b = {duffing, force, 2, steps, 500};
    double x[MAX_STATE];
    place_start(start, x);
    const outcome o = brute_follow(&b, x, 1e-5);
    return kind_of(&o);
}

/// Compares the attractors of a place with the kinds of motions that brute force comes to. Starts that it takes
/// elsewhere with twice the steps it is not sure of.
static void compare_wells(const whirl_table *table, const whirl_coexistence *found, size_t place) {
    const double force = table->values[place];
    int counts[KINDS] = {0}, kinds = 0, different = 0, sure = 0;
    double largest = 0.0;
    for (size_t start = 0; start < STARTS; start++) {
        const int kind = brute_kind(force, start, 400), again = brute_kind(force, start, 800);
        kinds += counts[kind]++ == 0;
        sure += kind == again;
        different += kind == again && kind != kind_of_point(table, start * (table->count / STARTS) + place);
    }
    size_t attractors = 0;
    for (size_t k = 0; k < found->count; k++) {
        const whirl_coexisting *one = &found->items[k];
        if (one->place != place) continue;
        const double share = (double)counts[kind_of_point(table, one->first)] / STARTS;
        largest = fmax(largest, fabs(one->share - share) - one->error);
        attractors++;
    }
    check_within("starts", words("D2, F = %g: attractors", force), (double)kinds, (double)attractors, 0.0);
    check_within("starts",
                 words("D2, F = %g: of %d starts that brute force is sure of come to another kind", force, sure), 0.0,
                 (double)different, 1.0);
    check_holds("starts", words("D2, F = %g: shares are within their standard errors", force), largest <= 0.0);
}

/// Attractors, their kinds and their shares are right at every point, and each well keeps one number.
static void wells_are_distinguished(void **state) {
    whirl_coexistence found;
    (void)state;
    enum { WELLS = sizeof two_wells / sizeof *two_wells };
    whirl_result *result = run_wells(two_wells, WELLS);
    const whirl_table *table = &result->tables[0];
    require_ok(whirl_table_coexistence(table, &found));
    for (size_t place = 0; place < WELLS; place++) compare_wells(table, &found, place);
    bool kept = true;
    for (size_t i = 0; i < table->count; i++) {
        const size_t label = found.labels[i];
        if (label == 0) continue;
        const whirl_coexisting *one = whirl_coexistence_at(&found, table, i);
        const double mean = *whirl_table_field(table, i, "orbit/mean", 0);
        for (size_t k = 0; k < table->count; k++) {
            const double other = *whirl_table_field(table, k, "orbit/mean", 0);
            if (found.labels[k] == label) kept = kept && mean * other > 0.0;
        }
        kept = kept && one->coexisting == 2;
    }
    check_holds("starts", "D2, F = .18 to .29: each well has a number of its own, through the doublings", kept);
    whirl_coexistence_free(&found);
    whirl_result_free(result);
}

/// Chaos about both wells is one attractor, next to the others.
static void chaos_is_about_both_wells(void **state) {
    enum { FORCES = sizeof both_wells / sizeof *both_wells };
    whirl_coexistence found;
    (void)state;
    whirl_result *result = run_wells(both_wells, FORCES);
    const whirl_table *table = &result->tables[0];
    require_ok(whirl_table_coexistence(table, &found));
    for (size_t place = 0; place < FORCES; place++) compare_wells(table, &found, place);
    whirl_coexistence_free(&found);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- the paper's rotor

/// One of the motions at a ratio of stiffness: after how many revolutions it returns, and between which bounds the
/// largest x of its section lies; and a transient after which it can be distinguished from the others.
typedef struct ratio {
    double r_k;
    int period, transient;
    double low, high;
    const char *what;
} ratio;

static const ratio ratios[] = {{0.300123, 4, 1000, -2.0, 0.2534, "other P-4"},
                               {0.498, 5, 1000, 0.3, 2.0, "P-5"},
                               {0.58, 1, 300, -2.0, 2.0, "P-1"}};
enum { RATIOS = sizeof ratios / sizeof *ratios, PAPER_STARTS = 64 };

static const char *const paper_study = "study:\n"
                                       "  sweep: {parameter: r_k, values: [0.300123, 0.498, 0.58]}\n"
                                       "  starts: {count: 64, within: {disc: {x: [-1.1, 1.1], y: [-1.1, 1.1]}}}\n"
                                       "  integrate: {method: dop853, rtol: 1e-6, transient: 8000, record: 100}\n"
                                       "  analyze: [poincare, regime, lyapunov, orbit, rub, floquet]\n";

/// Returns true if a motion is of the searched kind.
static bool is_sought(const ratio *at, int period, double largest) {
    return period == at->period && largest > at->low && largest < at->high;
}

static bool brute_is_sought(const ratio *at, size_t start) {
    const brute b = {brute_paper_rotor, at->r_k, 8, 256, at->transient};
    double x[MAX_STATE] = {0.0}, largest = -9.0;
    if (start > 0) {
        x[0] = -1.1 + 2.2 * brute_mirrored((int)start, 2);
        x[1] = -1.1 + 2.2 * brute_mirrored((int)start, 3);
    }
    const outcome o = brute_follow(&b, x, 1e-4);
    for (int n = 0; n < SEEN; n++) largest = fmax(largest, o.section[n][0]);
    return is_sought(at, o.period, largest);
}

static bool point_is_sought(const ratio *at, const whirl_table *table, size_t point) {
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    const whirl_field *field = whirl_layout_field(&table->layout, "poincare/section");
    const double *section = whirl_table_field(table, point, "poincare/section", 0);
    double largest = -9.0;
    for (size_t row = 0; row < field->rows; row++) largest = fmax(largest, section[row * field->columns]);
    return is_sought(at, verdict.regime == WHIRL_PERIODIC ? verdict.period : 0, largest);
}

/// Checks that the equations of this file are those of the case: slopes at a few states.
static void equations_agree(const whirl_study *study) {
    double largest = 0.0;
    for (size_t place = 0; place < RATIOS; place++) {
        whirl_machine machine;
        require_ok(whirl_study_machine(study, &study->batches[0], place, &machine));
        for (int n = 0; n < 16; n++) {
            double x[8], dx[8], own[8], forcing[WHIRL_MAX_FORCING];
            const double t = 2.0 * pi * brute_mirrored(n + 1, 2);
            for (int i = 0; i < 8; i++) x[i] = (i < 2 ? 1.6 : 0.9) * (brute_mirrored(7 * n + i + 1, 3) - 0.5);
            machine.system->forcing(machine.system->model, t, forcing);
            machine.system->rhs(machine.system->model, t, forcing, x, dx);
            brute_paper_rotor(ratios[place].r_k, cos(t), sin(t), x, own);
            for (int i = 0; i < 8; i++) largest = fmax(largest, fabs(dx[i] - own[i]) / fmax(1.0, fabs(own[i])));
        }
        machine.release(machine.owner);
    }
    check_within("starts", "the paper's rotor: slopes by equations of the test's own", 0.0, largest, 1e-12);
}

/// Compares the numbers of starts that lead to each motion of a place, by whirl and by brute force. Errors of a method
/// decide where a start near the boundary of two basins goes, since the basins are folded into each other: only shares
/// can be compared, by their standard errors.
static void compare_shares(const whirl_table *table, size_t place) {
    const ratio *at = &ratios[place];
    double shares[2] = {0.0, 0.0}, variance = 0.0;
    for (size_t start = 0; start < PAPER_STARTS; start++) {
        shares[0] += (double)brute_is_sought(at, start) / PAPER_STARTS;
        shares[1] += (double)point_is_sought(at, table, start * RATIOS + place) / PAPER_STARTS;
    }
    for (int i = 0; i < 2; i++) variance += shares[i] * (1.0 - shares[i]) / PAPER_STARTS;
    check_within("starts", words("paper, r_k = %g: share of the %s (two standard errors)", at->r_k, at->what),
                 shares[0], shares[1], 2.0 * sqrt(variance));
}

/// Two coexisting motions, known from continuation (the manual's changes of the paper's rotor), and the shares of
/// starts that lead to them.
static void the_paper_has_its_motions(void **state) {
    whirl_case *object = brute_paper_case(paper_study);
    whirl_study study;
    whirl_result *result;
    whirl_coexistence found;
    const whirl_run_options options = {.threads = 2};
    size_t attractors[RATIOS] = {0};
    (void)state;
    require_ok(whirl_case_study(object, &study));
    equations_agree(&study);
    require_ok(whirl_study_run(&study, &options, &result));
    require_ok(whirl_table_coexistence(&result->tables[0], &found));
    for (size_t k = 0; k < found.count; k++) attractors[found.items[k].place]++;
    for (size_t place = 0; place < RATIOS; place++) {
        check_within("starts", words("paper, r_k = %g: attractors", ratios[place].r_k), 2.0, (double)attractors[place],
                     0.0);
        compare_shares(&result->tables[0], place);
    }
    whirl_coexistence_free(&found);
    whirl_result_free(result);
    whirl_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(wells_are_distinguished),
                                       cmocka_unit_test(chaos_is_about_both_wells),
                                       cmocka_unit_test(the_paper_has_its_motions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
