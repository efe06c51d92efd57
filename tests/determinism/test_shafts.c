// Rotors with shafts of finite elements give the same bits whatever else runs: threads, vector widths, lanes.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "machines.h"

typedef whirl_rotor *rotor_at(double speed);

/// Makes a shaft with every kind of term: internal and proportional damping, flats, a disc that tilts, weight; not
/// reduced, so that all its masses are coupled.
static whirl_rotor *flat_rotor(double speed) {
    whirl_design *design;
    whirl_rotor *rotor;
    const whirl_setting shaft[] = {{"reduce", 0, "no"},
                                   {"viscous_damping", 1e-7, 0},
                                   {"hysteretic_damping", 1e-3, 0},
                                   {"stiffness_damping", 1e-7, 0},
                                   {"mass_damping", 3.0, 0}};
    const whirl_setting round[] = {{"length", 0.2, 0}, {"outer", 0.05, 0}, {"elements", 2, 0}};
    const whirl_setting flat[] = {{"length", 0.3, 0}, {"outer", 0.05, 0}, {"flats", 0.04, 0}, {"elements", 2, 0}};
    const whirl_setting disc[] = {
        {"at", 0, "disc"}, {"outer", 0.2, 0}, {"inner", 0.05, 0}, {"width", 0.02, 0}, {"eccentricity", 2e-5, 0}};
    must(whirl_design_new(speed, 1e-4, &design));
    must(whirl_design_shaft(design, "main", shaft, 5));
    must(whirl_design_station(design, "left", &(whirl_setting){"position", 0.0, 0}, 1));
    must(whirl_design_station(design, "disc", &(whirl_setting){"position", 0.35, 0}, 1));
    must(whirl_design_station(design, "right", &(whirl_setting){"position", 0.5, 0}, 1));
    must(whirl_design_element(design, "segment", round, 3));
    must(whirl_design_element(design, "segment", flat, 4));
    must(whirl_design_element(design, "disc", disc, 5));
    for (int i = 0; i < 2; i++) {
        const whirl_setting bearing[] = {
            {"at", 0, i == 0 ? "left" : "right"}, {"kxx", 2e7, 0}, {"kyy", 3e7, 0}, {"cxx", 3e3, 0}, {"cyy", 3e3, 0}};
        must(whirl_design_element(design, "bearing", bearing, 5));
    }
    must(whirl_design_element(design, "gravity", NULL, 0));
    must(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static const struct {
    const char *name, *method;
    rotor_at *rotor;
    int steps;
} kinds[] = {{"reduced, two films and a rub", "rk4", overhung_rotor, 512},
             {"reduced, two films and a rub", "rodas5p", overhung_rotor, 512},
             {"not reduced, flats and internal damping", "rk4", flat_rotor, 16384}};
enum { KINDS = sizeof kinds / sizeof *kinds, POINTS = 19, REVOLUTIONS = 2, MAX_DIMENSION = 4 * WHIRL_MAX_STATIONS * 2 };

static double speed_of(size_t point) {
    return 628.0 + 20.0 * (double)point;
}

/// Computes the states of `count` machines after some revolutions, side by side in one ensemble, from the first machine
/// on.
static void carry(int kind, size_t first, size_t count, double *ends) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_rotor *rotors[POINTS] = {NULL};
    whirl_ensemble *lanes;
    static double start[MAX_DIMENSION];
    snprintf(options.method, sizeof options.method, "%s", kinds[kind].method);
    options.steps_per_revolution = kinds[kind].steps;
    for (size_t i = 0; i < count; i++) rotors[i] = kinds[kind].rotor(speed_of(first + i));
    must(whirl_ensemble_new(whirl_rotor_system(rotors[0]), &options, count, &lanes));
    const size_t dimension = whirl_rotor_system(rotors[0])->dimension;
    assert_true(dimension <= MAX_DIMENSION);
    for (size_t i = 0; i < count; i++) must(whirl_ensemble_load(lanes, i, whirl_rotor_system(rotors[i]), start));
    for (int n = 0; n < REVOLUTIONS; n++) whirl_ensemble_revolve(lanes, count, NULL);
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(whirl_ensemble_motion(lanes, i), WHIRL_BOUNDED);
        whirl_ensemble_state(lanes, i, ends + i * MAX_DIMENSION);
    }
    whirl_ensemble_free(lanes);
    for (size_t i = 0; i < count; i++) whirl_rotor_free(rotors[i]);
}

static bool present(const char *isa) {
    const whirl_integrate_options options = whirl_integrate_default();
    whirl_rotor *rotor = overhung_rotor(speed_of(0));
    whirl_ensemble *ensemble;
    setenv("WHIRL_ISA", isa, 1);
    const bool there = whirl_ensemble_new(whirl_rotor_system(rotor), &options, 1, &ensemble).code == WHIRL_OK;
    whirl_ensemble_free(ensemble);
    whirl_rotor_free(rotor);
    return there;
}

/// Checks that all instruction sets that agree give the same bits for all machines side by side, and the first one for
/// each machine alone.
static void expect_same(int kind, const char *const *names, size_t count) {
    static double reference[POINTS * MAX_DIMENSION], ends[POINTS * MAX_DIMENSION];
    bool any = false;
    memset(reference, 0, sizeof reference);
    memset(ends, 0, sizeof ends);
    for (size_t n = 0; n < count; n++) {
        if (!present(names[n])) {
            printf("%s: not on this processor\n", names[n]);
            continue;
        }
        carry(kind, 0, POINTS, any ? ends : reference);
        if (any) assert_memory_equal(ends, reference, sizeof ends);
        for (size_t i = 0; i < POINTS; i += any ? 6 : 1) {
            carry(kind, i, 1, ends);
            assert_memory_equal(ends, reference + i * MAX_DIMENSION, MAX_DIMENSION * sizeof *ends);
        }
        any = true;
    }
    assert_true(any && reference[1] != 0.0);
}

static void bits_do_not_depend_on_widths_and_neighbours(void **state) {
    static const char *const fused[] = {"fma", "avx2", "avx512"}, *const unfused[] = {"scalar", "simd128"};
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        printf("%s, %s\n", kinds[kind].name, kinds[kind].method);
        if (present("fma")) expect_same(kind, fused, 3);
        expect_same(kind, unfused, 2);
    }
    unsetenv("WHIRL_ISA");
}

// ---------------------------------------------------------------- threads

static void release(void *owner) {
    whirl_rotor_free(owner);
}

static whirl_status machine(const void *family, const whirl_batch *batch, double value, whirl_machine *out) {
    static const double start[MAX_DIMENSION];
    (void)family, (void)batch;
    whirl_rotor *rotor = overhung_rotor(value);
    *out = (whirl_machine){.system = whirl_rotor_system(rotor), .start = start, .owner = rotor, .release = release};
    return whirl_ok();
}

static whirl_result *run(int threads) {
    static double values[POINTS];
    whirl_study study = {.batch_count = 1, .machine = machine};
    whirl_batch *batch = &study.batches[0];
    whirl_result *result;
    for (size_t i = 0; i < POINTS; i++) values[i] = speed_of(i);
    *batch = (whirl_batch){.name = "sweep", .parameter = "omega", .count = POINTS, .values = values};
    batch->integrate = whirl_integrate_default();
    snprintf(batch->integrate.method, sizeof batch->integrate.method, "rk4");
    batch->integrate.steps_per_revolution = 512;
    batch->record = whirl_record_default();
    batch->record.transient = 5;
    batch->record.record = 5;
    assert_true(whirl_analysis_add(&batch->analyses, "poincare"));
    assert_true(whirl_analysis_add(&batch->analyses, "orbit"));
    must(whirl_study_run(&study, &(whirl_run_options){.threads = threads}, &result));
    return result;
}

static void bits_do_not_depend_on_threads(void **state) {
    (void)state;
    whirl_result *one = run(1);
    const size_t size = POINTS * one->tables[0].layout.size * sizeof(double);
    for (int threads = 2; threads <= 5; threads += 3) {
        whirl_result *more = run(threads);
        assert_memory_equal(one->tables[0].blocks, more->tables[0].blocks, size);
        whirl_result_free(more);
    }
    whirl_result_free(one);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(bits_do_not_depend_on_widths_and_neighbours),
                                       cmocka_unit_test(bits_do_not_depend_on_threads)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
