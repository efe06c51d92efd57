// A point has the same bits whatever else runs: threads, lanes, vector widths, order and number of points.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "machines.h"

static const char *const fused[] = {"fma", "avx2", "avx512"};
static const char *const unfused[] = {"scalar", "simd128"};

static bool present(const char *isa, const whirl_system *system) {
    const whirl_integrate_options options = whirl_integrate_default();
    whirl_ensemble *ensemble;
    setenv("WHIRL_ISA", isa, 1);
    const bool there = whirl_ensemble_new(system, &options, 1, &ensemble).code == WHIRL_OK;
    whirl_ensemble_free(ensemble);
    return there;
}

// ---------------------------------------------------------------- the paper's rotor as a family over r_k

typedef struct rotor_machine {
    whirl_rotor *rotor;
    double start[8];
} rotor_machine;

static void release(void *owner) {
    rotor_machine *own = owner;
    whirl_rotor_free(own->rotor);
    free(own);
}

/// Points beyond r_k = 2 start outside their bearing: their film is not a number from the first step.
static whirl_status machine(const void *family, const whirl_batch *batch, double value, whirl_machine *out) {
    (void)family, (void)batch;
    rotor_machine *own = calloc(1, sizeof *own);
    assert_non_null(own);
    own->rotor = paper_rotor(value);
    own->start[1] = -0.1;
    own->start[3] = value > 2 ? -1.5 : -0.1;
    *out = (whirl_machine){
        .system = whirl_rotor_system(own->rotor), .start = own->start, .owner = own, .release = release};
    return whirl_ok();
}

static const char *const methods[] = {"rk4", "located rk4", "dop853", "rodas5p"};
enum { METHODS = 4 };

static void set_method(whirl_integrate_options *options, const char *method) {
    options->located = strcmp(method, "located rk4") == 0;
    strcpy(options->method, options->located ? "rk4" : method);
}

static whirl_result *run(const char *method, const double *values, size_t count, int threads, const char *isa) {
    whirl_study study = {.batch_count = 1, .machine = machine};
    whirl_batch *batch = &study.batches[0];
    whirl_result *result;
    *batch = (whirl_batch){.name = "sweep", .parameter = "r_k", .count = count, .values = values};
    batch->integrate = whirl_integrate_default();
    set_method(&batch->integrate, method);
    batch->integrate.steps_per_revolution = 256;
    batch->record = whirl_record_default();
    batch->record.transient = 30;
    batch->record.record = 10;
    batch->record.waveform_revolutions = 2;
    // Where all perturbations are followed the others do not run in lanes.
    batch->record.growth = strcmp(method, "rk4") == 0 ? WHIRL_GROWTH_ALL : WHIRL_GROWTH_LARGEST;
    for (const whirl_analysis *analysis = whirl_analyses(); analysis->name; analysis++)
        if (analysis->kind->moves &&
            (batch->record.growth == WHIRL_GROWTH_ALL || strcmp(analysis->name, "exponents") != 0))
            assert_true(whirl_analysis_add(&batch->analyses, analysis->name));
    if (isa)
        setenv("WHIRL_ISA", isa, 1);
    else
        unsetenv("WHIRL_ISA");
    must(whirl_study_run(&study, &(whirl_run_options){.threads = threads}, &result));
    return result;
}

static uint64_t hash(const void *bytes, size_t size) {
    const unsigned char *byte = bytes;
    uint64_t sum = 1469598103934665603u; // FNV-1a
    for (size_t i = 0; i < size; i++) sum = (sum ^ byte[i]) * 1099511628211u;
    return sum;
}

static uint64_t point_hash(const whirl_result *result, size_t point) {
    const size_t size = result->tables[0].layout.size;
    return hash(result->tables[0].blocks + point * size, size * sizeof(double));
}

enum { POINTS = 21 };

static void sweep_values(double values[POINTS]) {
    for (int i = 0; i < POINTS; i++) values[i] = 1.0 - 0.04 * i;
}

static void expect_same(const whirl_result *a, const whirl_result *b, size_t count) {
    for (size_t i = 0; i < count; i++) assert_true(point_hash(a, i) == point_hash(b, i));
}

static void test_threads(void **state) {
    double values[POINTS];
    (void)state;
    sweep_values(values);
    for (int m = 0; m < METHODS; m++) {
        whirl_result *one = run(methods[m], values, POINTS, 1, NULL);
        for (int threads = 2; threads <= 7; threads += 5) {
            whirl_result *more = run(methods[m], values, POINTS, threads, NULL);
            expect_same(one, more, POINTS);
            whirl_result_free(more);
        }
        whirl_result_free(one);
    }
}

/// Checks that the instruction sets agree to the bit, as far as the processor has them.
static void expect_same_widths(const char *method, const char *const *names, int count) {
    double values[POINTS];
    whirl_rotor *rotor = paper_rotor(0.5);
    whirl_result *reference = NULL;
    sweep_values(values);
    for (int i = 0; i < count; i++) {
        if (!present(names[i], whirl_rotor_system(rotor))) {
            printf("%s: not on this processor\n", names[i]);
            continue;
        }
        whirl_result *result = run(method, values, POINTS, 2, names[i]);
        if (reference) expect_same(reference, result, POINTS);
        printf("%s %-7s %016llx\n", method, names[i], (unsigned long long)point_hash(result, POINTS - 1));
        if (reference)
            whirl_result_free(result);
        else
            reference = result;
    }
    whirl_result_free(reference);
    whirl_rotor_free(rotor);
}

static void test_widths(void **state) {
    (void)state;
    for (int m = 0; m < METHODS; m++) {
        expect_same_widths(methods[m], fused, 3);
        expect_same_widths(methods[m], unfused, 2);
    }
}

static void test_order_and_number_of_points(void **state) {
    double values[POINTS], backward[POINTS];
    (void)state;
    sweep_values(values);
    for (int i = 0; i < POINTS; i++) backward[i] = values[POINTS - 1 - i];
    for (int m = 0; m < METHODS; m++) {
        whirl_result *all = run(methods[m], values, POINTS, 2, NULL);
        whirl_result *reversed = run(methods[m], backward, POINTS, 2, NULL);
        for (size_t i = 0; i < POINTS; i++) {
            whirl_result *alone = run(methods[m], values + i, 1, 1, NULL);
            assert_true(point_hash(all, i) == point_hash(reversed, POINTS - 1 - i));
            assert_true(point_hash(all, i) == point_hash(alone, 0));
            whirl_result_free(alone);
        }
        whirl_result_free(all);
        whirl_result_free(reversed);
    }
}

static void test_a_lane_that_is_not_a_number_touches_no_other(void **state) {
    double values[POINTS], poisoned[POINTS];
    (void)state;
    sweep_values(values);
    memcpy(poisoned, values, sizeof values);
    for (int i = 0; i < POINTS; i += 4) poisoned[i] = 3;
    for (int m = 0; m < METHODS; m++) {
        whirl_result *clean = run(methods[m], values, POINTS, 1, NULL);
        whirl_result *dirty = run(methods[m], poisoned, POINTS, 1, NULL);
        for (size_t i = 0; i < POINTS; i++) {
            const whirl_verdict verdict = whirl_table_verdict(&dirty->tables[0], i);
            if (i % 4 == 0)
                assert_true(verdict.regime == WHIRL_DIVERGING && verdict.diverged_at == 1.0);
            else
                assert_true(point_hash(clean, i) == point_hash(dirty, i));
        }
        whirl_result_free(clean);
        whirl_result_free(dirty);
    }
}

static void test_fused_and_unfused_agree(void **state) {
    const double values[] = {0.6, 0.8, 1.0};
    whirl_rotor *rotor = paper_rotor(0.5);
    (void)state;
    const bool fuses = present("fma", whirl_rotor_system(rotor));
    whirl_rotor_free(rotor);
    if (!fuses) skip();
    for (int m = 0; m < METHODS; m++) {
        whirl_result *a = run(methods[m], values, 3, 1, "fma"), *b = run(methods[m], values, 3, 1, "scalar");
        for (size_t i = 0; i < 3; i++) {
            const double *x = whirl_table_field(&a->tables[0], i, "poincare/section", 0);
            const double *y = whirl_table_field(&b->tables[0], i, "poincare/section", 0);
            for (int k = 0; k < 40; k++) assert_true(fabs(x[k] - y[k]) < 1e-9);
        }
        whirl_result_free(a);
        whirl_result_free(b);
    }
}

// ---------------------------------------------------------------- against the integrator that runs alone

/// Makes a chain of `count` stations on shafts: every third one in a film, every other of these films of finite length,
/// every fourth with a rub that follows the slip.
static whirl_rotor *long_rotor(size_t count) {
    char name[32], pair[64];
    whirl_design *design;
    whirl_rotor *rotor;
    must(whirl_design_new(1, 1, &design));
    for (size_t i = 0; i < count; i++) {
        snprintf(name, sizeof name, "s%zu", i);
        const whirl_setting station[] = {
            {"mass", 1 + 0.1 * (double)i, 0}, {"damping", 0.1, 0}, {"eccentricity", 0.05, 0}};
        must(whirl_design_station(design, name, station, 3));
        const whirl_setting film[] = {{"at", 0, name}, {"clearance", 2, 0}, {"load", 0.3, 0}};
        const whirl_setting rub[] = {{"at", 0, name},       {"gap", 0.02, 0},   {"stiffness", 3, 0},
                                     {"friction", 0.2, 0},  {"law", 0, "slip"}, {"radius", 0.05, 0},
                                     {"slip_speed", 0.1, 0}};
        const whirl_setting finite[] = {{"at", 0, name},  {"clearance", 2, 0}, {"law", 0, "finite"},
                                        {"radius", 1, 0}, {"length", 1.5, 0},  {"viscosity", 1.5, 0}};
        if (i % 6 == 0) must(whirl_design_element(design, "film", film, 3));
        if (i % 6 == 3) must(whirl_design_element(design, "film", finite, 6));
        if (i % 4 == 0) must(whirl_design_element(design, "rub", rub, 7));
        if (i == 0) continue;
        snprintf(pair, sizeof pair, "s%zu, s%zu", i - 1, i);
        const whirl_setting shaft[] = {{"between", 0, pair}, {"k1", 20, 0}, {"k2", 25, 0}};
        must(whirl_design_element(design, "shaft", shaft, 3));
    }
    must(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Compares five revolutions in lanes and alone, from the same state.
static void expect_agreement(size_t stations, const char *method, double tolerance) {
    whirl_rotor *rotor = long_rotor(stations);
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *alone;
    whirl_ensemble *lanes;
    double *x = calloc(system->dimension, sizeof *x), *y = calloc(system->dimension, sizeof *y);
    set_method(&options, method);
    options.steps_per_revolution = 500;
    options.rtol = 1e-11;
    options.atol = 1e-14;
    for (size_t i = 0; i < system->dimension / 2; i++) x[i] = 0.01 * (double)(i % 3);
    must(whirl_integrator_new(system, &options, &alone));
    must(whirl_ensemble_new(system, &options, 0, &lanes));
    const size_t count = whirl_ensemble_lanes(lanes);
    for (size_t lane = 0; lane < count; lane++) must(whirl_ensemble_load(lanes, lane, system, x));
    for (int i = 0; i < 5; i++) {
        assert_int_equal(whirl_integrator_revolve(alone, x, NULL, NULL), WHIRL_BOUNDED);
        whirl_ensemble_revolve(lanes, count, NULL);
    }
    for (size_t lane = 0; lane < count; lane++) {
        whirl_ensemble_state(lanes, lane, y);
        for (size_t i = 0; i < system->dimension; i++)
            if (!(fabs(x[i] - y[i]) < tolerance)) fail_msg("%s: %g apart", method, fabs(x[i] - y[i]));
    }
    free(x);
    free(y);
    whirl_ensemble_free(lanes);
    whirl_integrator_free(alone);
    whirl_rotor_free(rotor);
}

static void test_lanes_against_the_integrator(void **state) {
    const size_t stations[] = {1, 2, 10, 50};
    (void)state;
    unsetenv("WHIRL_ISA");
    for (size_t s = 0; s < 4; s++) {
        expect_agreement(stations[s], "rk4", 1e-11);
        expect_agreement(stations[s], "located rk4", 1e-9);
        expect_agreement(stations[s], "dop853", 1e-9); // each takes steps of its own
        if (stations[s] <= 10) expect_agreement(stations[s], "rodas5p", 1e-9);
    }
}

static void expect_close(double a, double b, double tolerance) {
    if (!(fabs(a - b) <= tolerance)) fail_msg("%.17g and %.17g are further apart than %g", a, b, tolerance);
}

/// The record of a rubbing motion in lanes is that of the same motion alone.
static void test_records_in_lanes_and_alone(void **state) {
    (void)state;
    whirl_rotor *rotor = paper_rotor(0.3);
    whirl_system alone = *whirl_rotor_system(rotor);
    alone.lanes = NULL;
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    const double start[8] = {0, -0.1, 0, -0.1};
    whirl_record *a, *b;
    strcpy(integrate.method, "dop853");
    integrate.rtol = 1e-11;
    integrate.atol = 1e-14;
    options.transient = 2;
    options.record = 4;
    options.growth = false;
    must(whirl_record_motion(whirl_rotor_system(rotor), &integrate, &options, start, NULL, &a));
    must(whirl_record_motion(&alone, &integrate, &options, start, NULL, &b));
    assert_int_equal(a->sample_count, b->sample_count);
    assert_true(a->sample_count > 0);
    const size_t capacity = a->record_count * a->samples_per_revolution;
    for (size_t i = 0; i < 2 * a->probe_count * capacity; i++) expect_close(a->waveform[i], b->waveform[i], 1e-9);
    for (size_t i = 0; i < 8; i++) {
        expect_close(a->low[i], b->low[i], 1e-9);
        expect_close(a->high[i], b->high[i], 1e-9);
        expect_close(a->end[i], b->end[i], 1e-9);
    }
    for (size_t i = 0; i < a->probe_count; i++) {
        expect_close(a->max_radius[i], b->max_radius[i], 1e-9);
        expect_close(a->min_radius[i], b->min_radius[i], 1e-9);
        expect_close(a->mean[2 * i], b->mean[2 * i], 1e-9);
        expect_close(a->backward[i], b->backward[i], 0.0);
    }
    assert_true(a->contact_number[0] >= 2.0);
    expect_close(a->contact_number[0], b->contact_number[0], 0.0);
    // Alone the share is that of instants; in lanes it is that of time, between the located ends.
    expect_close(a->contact_share[0], b->contact_share[0], 2.0 * a->contact_number[0] / (4.0 * 1024.0));
    expect_close(a->contact_force[0], b->contact_force[0], 1e-6 * b->contact_force[0]);
    whirl_record_free(a);
    whirl_record_free(b);
    whirl_rotor_free(rotor);
}

/// Makes a disc whose friction follows the slip sharply: it slides over its stator, and rolls on it at times. Its
/// records in lanes and alone are compared.
static whirl_rotor *rolling_rotor(double friction) {
    whirl_design *design;
    whirl_rotor *rotor;
    const whirl_setting disc[] = {{"mass", 1, 0}, {"damping", 0.1, 0}, {"eccentricity", 0.5, 0}};
    const whirl_setting shaft[] = {{"between", 0, "disc, ground"}, {"k1", 1, 0}};
    const whirl_setting rub[] = {{"at", 0, "disc"},         {"gap", 0.5, 0},    {"stiffness", 20, 0},
                                 {"friction", friction, 0}, {"law", 0, "slip"}, {"radius", 0.3, 0}};
    must(whirl_design_new(1, 1, &design));
    must(whirl_design_station(design, "disc", disc, 3));
    must(whirl_design_element(design, "shaft", shaft, 2));
    must(whirl_design_element(design, "rub", rub, 6));
    must(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

enum { ROLLING = 5, ROLLED = 8 };

static void carry_rolling(const whirl_integrate_options *options, const whirl_rotor *const *rotors, size_t count,
                          double (*ends)[4]) {
    whirl_ensemble *lanes;
    must(whirl_ensemble_new(whirl_rotor_system(rotors[0]), options, count, &lanes));
    for (size_t l = 0; l < count; l++)
        must(whirl_ensemble_load(lanes, l, whirl_rotor_system(rotors[l]), (double[4]){0.6, 0, 0, -1.2}));
    for (int i = 0; i < ROLLED; i++) whirl_ensemble_revolve(lanes, count, NULL);
    for (size_t l = 0; l < count; l++) {
        whirl_ensemble_state(lanes, l, ends[l]);
        assert_int_equal(whirl_ensemble_motion(lanes, l), WHIRL_BOUNDED);
    }
    whirl_ensemble_free(lanes);
}

static void test_sliding_in_lanes_and_alone(void **state) {
    (void)state;
    const whirl_rotor *rotors[ROLLING];
    whirl_integrate_options options = whirl_integrate_default();
    options.rtol = 1e-11;
    options.atol = 1e-14;
    unsetenv("WHIRL_ISA");
    for (int l = 0; l < ROLLING; l++) rotors[l] = rolling_rotor(0.1 + 0.1 * l);
    for (int m = 2; m < METHODS; m++) {
        double together[ROLLING][4], alone[1][4];
        set_method(&options, methods[m]);
        carry_rolling(&options, rotors, ROLLING, together);
        for (int l = 0; l < ROLLING; l++) {
            whirl_integrator *integrator;
            double x[4] = {0.6, 0, 0, -1.2};
            carry_rolling(&options, &rotors[l], 1, alone);
            assert_memory_equal(together[l], alone[0], sizeof alone[0]);
            must(whirl_integrator_new(whirl_rotor_system(rotors[l]), &options, &integrator));
            for (int i = 0; i < ROLLED; i++)
                assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
            for (int d = 0; d < 4; d++)
                if (!(fabs(x[d] - alone[0][d]) < 1e-9)) fail_msg("%s: %g apart", methods[m], x[d] - alone[0][d]);
            whirl_integrator_free(integrator);
        }
    }
    for (int l = 0; l < ROLLING; l++) whirl_rotor_free((whirl_rotor *)(uintptr_t)rotors[l]);
}

/// Compares structures: that of the paper has its own loops, in every order of its stations; as a list of elements it
/// must give the same bits.
static void compare_structures(whirl_rotor *(*other)(double r_k), size_t swap) {
    enum { LANES = 21 };
    whirl_rotor *own[LANES], *listed[LANES];
    whirl_integrate_options options = whirl_integrate_default();
    options.steps_per_revolution = 256;
    for (int l = 0; l < LANES; l++) {
        own[l] = paper_rotor(1.0 - 0.04 * l);
        listed[l] = other(1.0 - 0.04 * l);
    }
    for (size_t p = 0; p < 2; p++)
        assert_int_equal(whirl_rotor_system(own[0])->probes[p].x, whirl_rotor_system(listed[0])->probes[p ^ swap].x);
    for (int isa = 0; isa < 5; isa++) {
        whirl_ensemble *a, *b;
        const char *name = isa < 3 ? fused[isa] : unfused[isa - 3];
        if (!present(name, whirl_rotor_system(own[0]))) continue;
        must(whirl_ensemble_new(whirl_rotor_system(own[0]), &options, LANES, &a));
        must(whirl_ensemble_new(whirl_rotor_system(listed[0]), &options, LANES, &b));
        for (size_t l = 0; l < LANES; l++) {
            must(whirl_ensemble_load(a, l, whirl_rotor_system(own[l]), (double[8]){1.19, -0.1, 0, -0.1}));
            must(whirl_ensemble_load(b, l, whirl_rotor_system(listed[l]), (double[8]){1.19, -0.1, 0, -0.1}));
        }
        for (int i = 0; i < 5; i++) {
            whirl_ensemble_revolve(a, LANES, NULL);
            whirl_ensemble_revolve(b, LANES, NULL);
        }
        for (size_t k = 0; k < 8; k++)
            assert_memory_equal(whirl_ensemble_coordinate(a, k), whirl_ensemble_coordinate(b, k),
                                LANES * sizeof(double));
        whirl_ensemble_free(a);
        whirl_ensemble_free(b);
    }
    for (int l = 0; l < LANES; l++) {
        whirl_rotor_free(own[l]);
        whirl_rotor_free(listed[l]);
    }
}

static void test_own_loops_against_the_list(void **state) {
    (void)state;
    compare_structures(paper_rotor_listed, 0);
}

static void test_order_of_stations(void **state) {
    (void)state;
    compare_structures(paper_rotor_journal_first, 1);
}

static void test_other_structures_are_refused(void **state) {
    whirl_rotor *two = paper_rotor(0.5), *ten = long_rotor(10);
    const whirl_integrate_options options = whirl_integrate_default();
    const double x[40] = {0};
    whirl_ensemble *lanes;
    (void)state;
    must(whirl_ensemble_new(whirl_rotor_system(two), &options, 8, &lanes));
    assert_int_equal(whirl_ensemble_load(lanes, 0, whirl_rotor_system(ten), x).code, WHIRL_BAD_INPUT);
    whirl_ensemble_free(lanes);
    setenv("WHIRL_ISA", "avx1024", 1);
    const whirl_status status = whirl_ensemble_new(whirl_rotor_system(two), &options, 8, &lanes);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_non_null(strstr(status.message, "avx512"));
    whirl_rotor_free(two);
    whirl_rotor_free(ten);
}

enum { CHANGED_MASS = 1, CHANGED_SHAFT = 2, CHANGED_FILM = 4, CHANGED_ALL = 7 };

/// Makes three equal stations, shafts and films, except for the number `changed` of the last.
static whirl_rotor *rotor_of_equals(int changed) {
    static const char *const names[] = {"a", "b", "c"}, *const pairs[] = {"a, ground", "a, b", "b, c"};
    whirl_design *design;
    whirl_rotor *rotor;
    must(whirl_design_new(1, 1, &design));
    for (int i = 0; i < 3; i++) {
        const int other = i == 2 ? changed : 0;
        const whirl_setting station[] = {
            {"mass", other & CHANGED_MASS ? 1.5 : 1, 0}, {"damping", 0.1, 0}, {"eccentricity", 0.05, 0}};
        const whirl_setting shaft[] = {{"between", 0, pairs[i]}, {"k1", other & CHANGED_SHAFT ? 30 : 20, 0}};
        const whirl_setting film[] = {
            {"at", 0, names[i]}, {"clearance", 2, 0}, {"load", other & CHANGED_FILM ? 0.4 : 0.3, 0}};
        must(whirl_design_station(design, names[i], station, 3));
        must(whirl_design_element(design, "shaft", shaft, 2));
        must(whirl_design_element(design, "film", film, 3));
    }
    must(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Equal parts of machines share their numbers until a machine with other numbers comes. The bits are those of the same
/// machines in lanes where nothing was shared.
static void test_parts_that_share_numbers(void **state) {
    static const int changes[] = {CHANGED_MASS, CHANGED_SHAFT, CHANGED_FILM, CHANGED_ALL};
    const whirl_integrate_options options = whirl_integrate_default();
    const double start[12] = {0.1, 0, 0, 0.1, 0.05};
    whirl_rotor *equals = rotor_of_equals(0), *different = rotor_of_equals(CHANGED_ALL);
    (void)state;
    unsetenv("WHIRL_ISA");
    for (int i = 0; i < 4; i++) {
        whirl_ensemble *sharing, *apart;
        whirl_rotor *other = rotor_of_equals(changes[i]);
        must(whirl_ensemble_new(whirl_rotor_system(equals), &options, 2, &sharing));
        must(whirl_ensemble_new(whirl_rotor_system(different), &options, 2, &apart));
        must(whirl_ensemble_load(sharing, 0, whirl_rotor_system(equals), start));
        whirl_ensemble_revolve(sharing, 1, NULL);
        whirl_ensemble_place(sharing, 0, start);
        must(whirl_ensemble_load(sharing, 1, whirl_rotor_system(other), start));
        must(whirl_ensemble_load(apart, 0, whirl_rotor_system(different), start));
        must(whirl_ensemble_load(apart, 0, whirl_rotor_system(equals), start));
        must(whirl_ensemble_load(apart, 1, whirl_rotor_system(other), start));
        whirl_ensemble_revolve(sharing, 2, NULL);
        whirl_ensemble_revolve(apart, 2, NULL);
        for (size_t d = 0; d < 12; d++)
            for (size_t lane = 0; lane < 2; lane++)
                assert_true(whirl_ensemble_coordinate(sharing, d)[lane] == whirl_ensemble_coordinate(apart, d)[lane]);
        assert_true(whirl_ensemble_coordinate(apart, 4)[0] != whirl_ensemble_coordinate(apart, 4)[1]);
        whirl_ensemble_free(sharing);
        whirl_ensemble_free(apart);
        whirl_rotor_free(other);
    }
    whirl_rotor_free(equals);
    whirl_rotor_free(different);
}

/// Makes a disc that touches its stator once a revolution, or all the time.
static whirl_rotor *rub_rotor(double speed, double damping) {
    whirl_design *design;
    whirl_rotor *rotor;
    const whirl_setting disc[] = {{"mass", 1, 0}, {"damping", 0.2, 0}, {"eccentricity", 0.9, 0}};
    const whirl_setting shaft[] = {{"between", 0, "disc, ground"}, {"k1", 1, 0}};
    const whirl_setting rub[] = {
        {"at", 0, "disc"}, {"gap", 1, 0}, {"stiffness", 10, 0}, {"friction", 0.05, 0}, {"damping", damping, 0}};
    const whirl_setting gravity[] = {{"acceleration", 0.5, 0}};
    must(whirl_design_new(speed, 1, &design));
    must(whirl_design_station(design, "disc", disc, 3));
    must(whirl_design_element(design, "shaft", shaft, 2));
    must(whirl_design_element(design, "rub", rub, damping < 0 ? 4 : 5));
    must(whirl_design_element(design, "gravity", gravity, 1));
    must(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static whirl_record *record_rub(const whirl_system *system) {
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    whirl_record *record;
    const double start[4] = {0.1, -0.2, 0, 0};
    options.transient = 300;
    options.record = 20;
    integrate.steps_per_revolution = 512;
    must(whirl_record_motion(system, &integrate, &options, start, NULL, &record));
    return record;
}

static void test_damped_contacts_in_lanes_and_alone(void **state) {
    (void)state;
    unsetenv("WHIRL_ISA");
    double largest = 0.0;
    for (int i = 0; i < 4; i++) {
        whirl_rotor *rotor = rub_rotor(i % 2 ? 3.8 : 1.5, i < 2 ? 0.8 : 0.0);
        whirl_system alone = *whirl_rotor_system(rotor);
        alone.lanes = NULL;
        whirl_record *one = record_rub(whirl_rotor_system(rotor)), *other = record_rub(&alone);
        assert_true(one->contact_share[0] > 0.05);
        // The last bits decide whether an instant at the border of a contact counts.
        assert_true(fabs(one->contact_share[0] - other->contact_share[0]) <= 2.0 / (20.0 * 512.0));
        assert_true(one->contact_number[0] == other->contact_number[0]);
        assert_true(fabs(one->contact_force[0] / other->contact_force[0] - 1.0) < 1e-6);
        // The damper pushes too, while the stator is pressed in.
        const double elastic = 10.0 * (one->max_radius[0] - 1.0);
        largest = fmax(largest, one->contact_force[0] / elastic);
        if (i >= 2) assert_true(fabs(one->contact_force[0] / elastic - 1.0) < 1e-12);
        whirl_record_free(one);
        whirl_record_free(other);
        whirl_rotor_free(rotor);
    }
    assert_true(largest > 1.01);
}

static whirl_record *record_growths(const whirl_system *system, const double *start) {
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    whirl_record *record;
    integrate.steps_per_revolution = 1024;
    options.transient = 10;
    options.record = options.watch = 12;
    options.growth = WHIRL_GROWTH_ALL;
    must(whirl_record_motion(system, &integrate, &options, start, NULL, &record));
    return record;
}

/// All perturbations in lanes agree with those of the integrator's interface, a revolution at a time.
static void test_perturbations_in_lanes_and_alone(void **state) {
    const double start[8] = {0, -0.1, 0, -0.1};
    (void)state;
    unsetenv("WHIRL_ISA");
    for (int i = 0; i < 2; i++) {
        whirl_rotor *rotor = i ? rub_rotor(3.8, -1.0) : paper_rotor(0.6);
        whirl_system alone = *whirl_rotor_system(rotor);
        alone.lanes = NULL;
        whirl_record *one = record_growths(whirl_rotor_system(rotor), start), *other = record_growths(&alone, start);
        assert_int_equal(one->growth_count, 12);
        for (size_t n = 0; n < one->growth_count; n++) {
            double sum = 0.0;
            for (size_t k = 0; k < one->dimension; k++) {
                const double a = one->growths[n * one->dimension + k], b = other->growths[n * one->dimension + k];
                assert_true(fabs(a - b) < 1e-7 * fmax(1.0, fabs(b)));
                sum += a;
            }
            assert_true(one->growth[n] == one->growths[n * one->dimension]);
            assert_true(fabs(one->volume[n] - other->volume[n]) < 1e-9 * fabs(other->volume[n]));
            assert_true(fabs(sum - one->volume[n]) < 1e-3 * fabs(sum)); // the method's own error
        }
        whirl_record_free(one);
        whirl_record_free(other);
        whirl_rotor_free(rotor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_threads),
        cmocka_unit_test(test_widths),
        cmocka_unit_test(test_order_and_number_of_points),
        cmocka_unit_test(test_a_lane_that_is_not_a_number_touches_no_other),
        cmocka_unit_test(test_fused_and_unfused_agree),
        cmocka_unit_test(test_lanes_against_the_integrator),
        cmocka_unit_test(test_damped_contacts_in_lanes_and_alone),
        cmocka_unit_test(test_records_in_lanes_and_alone),
        cmocka_unit_test(test_sliding_in_lanes_and_alone),
        cmocka_unit_test(test_own_loops_against_the_list),
        cmocka_unit_test(test_order_of_stations),
        cmocka_unit_test(test_parts_that_share_numbers),
        cmocka_unit_test(test_perturbations_in_lanes_and_alone),
        cmocka_unit_test(test_other_structures_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
