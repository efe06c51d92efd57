// Winding and the sense of whirl, on paths whose answers are plain.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "near.h"
#include "whirl/engine/analyze.h"

static const double two_pi = 6.283185307179586;

enum { REVOLUTIONS = 20, SAMPLES = 64, COUNT = REVOLUTIONS * SAMPLES };

/// Numbers of the analysis for one station.
typedef struct answer {
    double winding, backward, direction, contact, dry_whip;
} answer;

/// x, y at a time in revolutions.
typedef void path_fn(double revolution, double *x, double *y);

static answer analyse(path_fn *path, double gap) {
    static double waveform[2 * COUNT];
    const whirl_probe probe = {.name = "disc", .x = 0, .y = 1, .vx = 2, .vy = 3, .gap = gap};
    const whirl_system system = {.dimension = 4, .period = two_pi, .probe_count = 1, .probes = &probe};
    const whirl_record record = {.dimension = 4,
                                 .probe_count = 1,
                                 .probes = &probe,
                                 .sample_count = COUNT,
                                 .samples_per_revolution = SAMPLES,
                                 .waveform = waveform};
    const whirl_integrate_options integrate = whirl_integrate_default();
    const whirl_record_options options = whirl_record_default();
    whirl_analysis_set set = 0;
    whirl_layout layout;
    double block[8];
    for (size_t j = 0; j < COUNT; j++) path((double)(j + 1) / SAMPLES, &waveform[j], &waveform[COUNT + j]);
    assert_true(whirl_analysis_add(&set, "winding"));
    assert_int_equal(whirl_layout_new(&system, &integrate, &options, set, &layout).code, WHIRL_OK);
    assert_true(layout.size <= 8);
    assert_int_equal(whirl_analyze(&record, &options, set, &layout, block).code, WHIRL_OK);
    return (answer){block[whirl_layout_field(&layout, "winding/winding")->offset],
                    block[whirl_layout_field(&layout, "winding/backward")->offset],
                    block[whirl_layout_field(&layout, "winding/direction")->offset],
                    block[whirl_layout_field(&layout, "winding/contact")->offset],
                    block[whirl_layout_field(&layout, "winding/dry_whip")->offset]};
}

/// Computes a forward circle about a centre far from (0, 0), as of a journal that hangs in its bearing.
static void forward_off_centre(double t, double *x, double *y) {
    *x = 3.0 + 0.2 * cos(two_pi * t);
    *y = -2.0 + 0.1 * sin(two_pi * t);
}

static void half_speed(double t, double *x, double *y) {
    *x = cos(0.5 * two_pi * t);
    *y = sin(0.5 * two_pi * t);
}

static void backward_whip(double t, double *x, double *y) {
    *x = 1.2 * cos(-0.73 * two_pi * t);
    *y = 1.2 * sin(-0.73 * two_pi * t);
}

static void backward_synchronous(double t, double *x, double *y) {
    *x = 1.2 * cos(two_pi * t);
    *y = -1.2 * sin(two_pi * t);
}

/// z = e^(it) + 1.5 e^(-2it): the angular momentum 1 - 4.5 - 1.5 cos 3t is below 0 at all times.
static void mixture_that_is_backward(double t, double *x, double *y) {
    *x = cos(two_pi * t) + 1.5 * cos(2.0 * two_pi * t);
    *y = sin(two_pi * t) - 1.5 * sin(2.0 * two_pi * t);
}

/// z = e^(it) + 0.7 e^(-2it): angular momentum 1 - 0.98 - 0.7 cos 3t, backward while cos 3t > 0.02/0.7, that is for
/// acos(0.02/0.7)/pi = 0.4909 of the time; the forward part is larger, so it winds once.
static void mixed(double t, double *x, double *y) {
    *x = cos(two_pi * t) + 0.7 * cos(2.0 * two_pi * t);
    *y = sin(two_pi * t) - 0.7 * sin(2.0 * two_pi * t);
}

static void resting(double t, double *x, double *y) {
    (void)t;
    *x = 0.3;
    *y = -0.4;
}

static void senses(void **state) {
    (void)state;
    const double whole = 2.0 / COUNT; // the way to the first sample is not seen
    answer a = analyse(forward_off_centre, 0.0);
    assert_near(a.winding, 1.0, whole);
    assert_near(a.direction, 1.0, 0.0);
    assert_near(a.backward, 0.0, 0.0);
    assert_true(isnan(a.contact) && isnan(a.dry_whip));
    assert_near(analyse(half_speed, 0.0).winding, 0.5, 1e-9);
    a = analyse(mixture_that_is_backward, 0.0);
    assert_near(a.winding, -2.0, whole);
    assert_near(a.direction, -1.0, 0.0);
    assert_near(a.backward, 1.0, 0.0);
    a = analyse(mixed, 0.0);
    assert_near(a.winding, 1.0, whole);
    assert_near(a.direction, 0.0, 0.0);
    assert_near(a.backward, acos(0.02 / 0.7) / (0.5 * two_pi), 0.02);
    a = analyse(resting, 1.0);
    assert_true(isnan(a.winding) && isnan(a.direction));
    assert_near(a.contact, 0.0, 0.0);
    assert_near(a.dry_whip, 0.0, 0.0);
}

/// Dry whip needs lasting contact, backward whirl and a frequency that is not the shaft's.
static void dry_whip(void **state) {
    (void)state;
    answer a = analyse(backward_whip, 1.0);
    assert_near(a.winding, -0.73, 1e-3);
    assert_near(a.contact, 1.0, 1e-12);
    assert_near(a.dry_whip, 1.0, 0.0);
    assert_near(analyse(backward_whip, 1.3).dry_whip, 0.0, 0.0);
    a = analyse(backward_synchronous, 1.0);
    assert_near(a.direction, -1.0, 0.0);
    assert_near(a.dry_whip, 0.0, 0.0);
    assert_near(analyse(half_speed, 0.9).dry_whip, 0.0, 0.0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(senses), cmocka_unit_test(dry_whip)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
