// Starts from neighbours: attractors that few starts meet are followed to where they end, against brute force that
// follows each by itself, carried in small steps of the parameter.
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

static const whirl_probe probe = {.name = "mass", .x = 0, .y = 0, .vx = 1, .vy = 1};

// ---------------------------------------------------------------- a hardening spring

// A hardening spring, x'' + .1 x' + x + x^3 = F cos(w t), here in tau = w t. Between two folds an upper orbit coexists
// with the lower one; its basin shrinks to nothing where w nears its fold.
static void hardening(double w, double force, double cosine, const double *x, double *dx) {
    dx[0] = x[1];
    dx[1] = (force * cosine - x[0] - x[0] * x[0] * x[0] - 0.1 * w * x[1]) / (w * w);
}

enum { SPEEDS = 17, LEVELS = 4, PLACES = SPEEDS * LEVELS, FEW = 3 };

/// The force of brute force, whose rates have one parameter.
static double level;

static void hardening_brute(double w, double cosine, double sine, const double *x, double *dx) {
    (void)sine;
    hardening(w, level, cosine, x, dx);
}

typedef struct hard_spring {
    double speed, force, start[2];
    whirl_system system;
} hard_spring;

static void hardening_rate(const void *model, double t, const double *forcing, const double *x, double *dx) {
    const hard_spring *own = model;
    (void)forcing;
    hardening(own->speed, own->force, cos(t), x, dx);
}

static whirl_status spring_at(const void *family, const whirl_batch *batch, double value, whirl_machine *machine) {
    hard_spring *own = malloc(sizeof *own);
    (void)family;
    assert_non_null(own);
    *own = (hard_spring){.speed = value, .force = batch->third_values ? batch->third_value : batch->second_value};
    for (int i = 0; i < 2 && batch->start > 0; i++) own->start[i] = brute_mirrored((int)batch->start, i ? 3 : 2) - 0.5;
    own->system = (whirl_system){
        .model = own, .dimension = 2, .period = 2.0 * pi, .rhs = hardening_rate, .probe_count = 1, .probes = &probe};
    *machine = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

/// Sets speeds along the rows, and forces from row to row.
static void plane_of_springs(double *values, double *seconds) {
    for (int i = 0; i < PLACES; i++) {
        values[i] = 1.2 + 0.04 * (i % SPEEDS);
        seconds[i] = 0.15 + 0.05 * (double)(i / SPEEDS);
    }
}

/// Runs the study of springs. In a stacked map every plane has one row, and the forces change from plane to plane.
static whirl_result *run_springs(size_t rounds, bool stacked) {
    static const char *const analyses[] = {"poincare", "orbit", "regime"};
    static double values[PLACES], seconds[PLACES], nothing[PLACES];
    whirl_study study = {.batch_count = 1, .machine = spring_at};
    whirl_batch *batch = &study.batches[0];
    whirl_result *result;
    const whirl_run_options options = {.threads = 2};
    plane_of_springs(values, seconds);
    *batch = (whirl_batch){.name = "map", .parameter = "w", .count = PLACES, .values = values};
    strcpy(batch->second, stacked ? "none" : "F");
    batch->second_values = stacked ? nothing : seconds;
    batch->row = SPEEDS;
    if (stacked) strcpy(batch->third, "F");
    batch->third_values = stacked ? seconds : NULL;
    batch->plane = stacked ? SPEEDS : 0;
    batch->starts = FEW;
    batch->neighbours = rounds;
    batch->integrate = whirl_integrate_default();
    strcpy(batch->integrate.method, "dop853");
    batch->integrate.rtol = 1e-9;
    batch->record = whirl_record_default();
    batch->record.transient = 300;
    batch->record.settle = true;
    batch->record.record = 64;
    for (size_t i = 0; i < 3; i++) assert_true(whirl_analysis_add(&batch->analyses, analyses[i]));
    whirl_analysis_needs(batch->analyses, &batch->record);
    require_ok(whirl_study_run(&study, &options, &result));
    return result;
}

/// Computes the first section points of the motions that brute force follows up, [0], and down, [1], along each row:
/// carried in steps of a tenth of the distance of places.
static void follow_springs(double (*seen)[2][2]) {
    for (int row = 0; row < LEVELS; row++)
        for (int down = 0; down < 2; down++) {
            double x[MAX_STATE] = {0.0};
            level = 0.15 + 0.05 * row;
            for (int step = 0; step <= 10 * (SPEEDS - 1); step++) {
                const int at = down ? 10 * (SPEEDS - 1) - step : step;
                const brute b = {hardening_brute, 1.2 + 0.004 * at, 2, 200, at % 10 == 0 ? 200 : 40};
                const outcome o = brute_follow(&b, x, 1e-5);
                if (at % 10 != 0) continue;
                assert_int_equal(1, o.period);
                memcpy(seen[row * SPEEDS + at / 10][down], o.section[0], sizeof o.section[0]);
            }
        }
}

static double section_distance(const whirl_table *table, size_t point, const double *seen) {
    const double *section = whirl_table_field(table, point, "poincare/section", 0);
    return fabs(section[0] - seen[0]);
}

/// Results of a map of springs, compared with brute force.
typedef struct tally {
    int several;    ///< places at which brute force knows two motions
    int differing;  ///< places with another number of attractors
    int alone;      ///< attractors that no start of their own place leads to
    int shares;     ///< places whose shares do not make 1
    double largest; ///< distance of a motion of brute force from the nearest attractor
} tally;

static tally compare_springs(const whirl_table *table, const whirl_coexistence *found, double (*seen)[2][2]) {
    tally t = {0};
    for (size_t place = 0; place < PLACES; place++) {
        const int known = fabs(seen[place][0][0] - seen[place][1][0]) > 1e-2 ? 2 : 1;
        double nearest[2] = {INFINITY, INFINITY}, share = 0.0;
        int count = 0;
        for (size_t k = 0; k < found->count; k++) {
            const whirl_coexisting *one = &found->items[k];
            if (one->place != place) continue;
            for (int i = 0; i < 2; i++)
                nearest[i] = fmin(nearest[i], section_distance(table, one->first, seen[place][i]));
            share += one->share;
            t.alone += one->starts == 0;
            assert_int_equal(FEW, one->of);
            count++;
        }
        t.several += known > 1;
        t.differing += count != known;
        t.shares += fabs(share - 1.0) > 1e-12;
        t.largest = fmax(t.largest, fmax(nearest[0], nearest[1]));
    }
    return t;
}

/// The upper orbit is found up to its fold, in all rows, from the places where few starts reach it; a single round does
/// not get so far.
static void the_upper_orbit_is_followed_to_its_fold(void **state) {
    static double seen[PLACES][2][2];
    whirl_coexistence found;
    (void)state;
    follow_springs(seen);
    whirl_result *result = run_springs(1000, false), *one = run_springs(1, false), *none = run_springs(0, false);
    require_ok(whirl_table_coexistence(&result->tables[0], &found));
    const tally all = compare_springs(&result->tables[0], &found, seen);
    check_within("neighbours",
                 "hardening spring: places with two orbits (brute force, carried up and down) in a map of 17 x 4",
                 (double)all.several, (double)(found.count - PLACES), 0.0);
    check_within("neighbours", "... places where 3 starts and those from neighbours find another number of orbits", 0.0,
                 (double)all.differing, 0.0);
    check_within("neighbours", "... largest distance of an orbit of brute force from the nearest of these", 0.0,
                 all.largest, 1e-5);
    check_within("neighbours", "... places whose shares do not make 1", 0.0, (double)all.shares, 0.0);
    whirl_coexistence_free(&found);
    require_ok(whirl_table_coexistence(&none->tables[0], &found));
    const tally few = compare_springs(&none->tables[0], &found, seen);
    check_holds("neighbours", "... without neighbours most of the second orbits are missed",
                2 * few.differing > all.several);
    check_within("neighbours", "... second orbits that are found from neighbours alone", (double)few.differing,
                 (double)all.alone, 0.0);
    check_holds("neighbours", "... one round asks for less",
                one->tables[0].count < result->tables[0].count && one->tables[0].count > none->tables[0].count);
    whirl_coexistence_free(&found);
    whirl_result_free(none);
    whirl_result_free(one);
    whirl_result_free(result);
}

/// Neighbours from plane to plane give the same as neighbours from row to row.
static void planes_are_neighbours(void **state) {
    whirl_coexistence one, other;
    (void)state;
    whirl_result *rows = run_springs(2, false), *planes = run_springs(2, true);
    const whirl_table *a = &rows->tables[0], *b = &planes->tables[0];
    require_ok(whirl_table_coexistence(a, &one));
    require_ok(whirl_table_coexistence(b, &other));
    assert_int_equal(LEVELS, whirl_table_planes(b));
    assert_true(a->count == b->count && a->count > (size_t)PLACES * FEW && one.count == other.count);
    assert_int_equal(one.attractors, other.attractors);
    for (size_t i = 0; i < a->count; i++)
        assert_true(whirl_table_slot(a, i) == whirl_table_slot(b, i) && one.labels[i] == other.labels[i] &&
                    whirl_table_second(a, i) == whirl_table_third(b, i) &&
                    section_distance(a, i, whirl_table_field(b, i, "poincare/section", 0)) == 0.0);
    for (size_t k = 0; k < one.count; k++)
        assert_true(one.items[k].number == other.items[k].number && one.items[k].share == other.items[k].share);
    whirl_coexistence_free(&one);
    whirl_coexistence_free(&other);
    whirl_result_free(rows);
    whirl_result_free(planes);
}

// ---------------------------------------------------------------- the paper's rotor

static const char *const paper_study =
    "study:\n"
    "  sweep: {parameter: r_k, from: 0.49, to: 0.5, points: 9}\n"
    "  starts: {count: 6, within: {disc: {x: [-1.1, 1.1], y: [-1.1, 1.1]}}, neighbours: 20}\n"
    "  integrate: {method: dop853, rtol: 1e-6, transient: 8000, record: 100}\n"
    "  analyze: [poincare, regime, lyapunov, orbit, rub, floquet]\n";
enum { RATIOS = 9, MIDDLE = 6, PAPER_STEPS = 1024 };

static double ratio_at(double place) {
    return 0.49 + 0.00125 * place;
}

/// Returns the largest x of the section of the P-5 whose disc reaches the stator (above .3 clearances), else NaN.
static double largest_of_rubbing(const outcome *o) {
    double largest = -9.0;
    for (int n = 0; n < SEEN; n++) largest = fmax(largest, o->section[n][0]);
    return o->period == 5 && largest > 0.3 ? largest : (double)NAN;
}

/// Computes a state on that P-5 at the middle place, from the first start by which brute force reaches it.
static void meet_rubbing(double *x) {
    const brute b = {brute_paper_rotor, ratio_at(MIDDLE), 8, PAPER_STEPS, 300};
    for (int start = 1; start < 200; start++) {
        memset(x, 0, 8 * sizeof *x);
        for (int i = 0; i < 2; i++) x[i] = -1.1 + 2.2 * brute_mirrored(start, i ? 3 : 2);
        const outcome o = brute_follow(&b, x, 1e-4);
        if (!isnan(largest_of_rubbing(&o))) return;
    }
    fail();
}

/// Computes the largest x of the section of that P-5 at every place, carried from the middle to both sides in small
/// steps; NaN where it does not exist.
static void follow_rubbing(double *largest) {
    double middle[MAX_STATE];
    const int parts = 4;
    meet_rubbing(middle);
    for (int side = -1; side <= 1; side += 2) {
        double x[MAX_STATE];
        memcpy(x, middle, sizeof x);
        for (int step = 0; MIDDLE * parts + side * step >= 0 && MIDDLE * parts + side * step <= (RATIOS - 1) * parts;
             step++) {
            const int at = MIDDLE * parts + side * step;
            const brute b = {brute_paper_rotor, ratio_at((double)at / parts), 8, PAPER_STEPS,
                             at % parts == 0 ? 300 : 60};
            const outcome o = brute_follow(&b, x, 1e-4);
            if (at % parts == 0) largest[at / parts] = largest_of_rubbing(&o);
        }
    }
}

/// Returns the largest x of that P-5 at a place as whirl found it; *starts is the number of own starts of the place
/// that led to it.
static double found_rubbing(const whirl_table *table, const whirl_coexistence *found, size_t place, size_t *starts) {
    const whirl_field *field = whirl_layout_field(&table->layout, "poincare/section");
    for (size_t k = 0; k < found->count; k++) {
        const whirl_coexisting *one = &found->items[k];
        const whirl_verdict verdict = whirl_table_verdict(table, one->first);
        const double *section = whirl_table_field(table, one->first, "poincare/section", 0);
        double largest = -9.0;
        for (size_t row = 0; row < field->rows; row++) largest = fmax(largest, section[row * field->columns]);
        if (one->place != place || verdict.regime != WHIRL_PERIODIC || verdict.period != 5 || largest < 0.3) continue;
        *starts = one->starts;
        return largest;
    }
    return (double)NAN;
}

/// At some ratios of stiffness the P-5 of the rub coexists with the attractor of most starts; at some of these 6 starts
/// miss it.
static void the_rubbing_orbit_is_followed(void **state) {
    double largest[RATIOS], away = 0.0;
    whirl_case *object = brute_paper_case(paper_study);
    whirl_study study;
    whirl_result *result;
    whirl_coexistence found;
    const whirl_run_options options = {.threads = 2};
    int there = 0, differing = 0, alone = 0;
    (void)state;
    follow_rubbing(largest);
    require_ok(whirl_case_study(object, &study));
    require_ok(whirl_study_run(&study, &options, &result));
    require_ok(whirl_table_coexistence(&result->tables[0], &found));
    for (size_t place = 0; place < RATIOS; place++) {
        size_t starts = 1;
        const double own = found_rubbing(&result->tables[0], &found, place, &starts);
        there += !isnan(largest[place]);
        differing += isnan(largest[place]) != isnan(own);
        if (!isnan(own) && !isnan(largest[place])) away = fmax(away, fabs(own - largest[place]));
        alone += starts == 0;
    }
    check_holds("neighbours",
                words("paper, r_k = .49 to .5: the P-5 with rub is there at some of 9 ratios, by brute "
                      "force at %d",
                      there),
                there > 0 && there < RATIOS);
    check_within("neighbours", "... ratios at which 6 starts and those from neighbours find otherwise", 0.0,
                 (double)differing, 0.0);
    check_within("neighbours", "... largest difference of the largest x of its section (clearances)", 0.0, away, 1e-4);
    check_holds("neighbours", words("... at %d of them none of the 6 starts leads there", alone), alone > 0);
    whirl_coexistence_free(&found);
    whirl_result_free(result);
    whirl_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_upper_orbit_is_followed_to_its_fold),
                                       cmocka_unit_test(planes_are_neighbours),
                                       cmocka_unit_test(the_rubbing_orbit_is_followed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
