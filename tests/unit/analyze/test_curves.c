// Sets of points that are closed curves, and sets that are not.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "curves.h"
#include "section.h"

static const double two_pi = 6.283185307179586, golden = 0.6180339887498949;

enum { COUNT = 900 };

/// A twisted oval in three dimensions, filled by a rotation that is fast where the oval is thin.
static void oval(double phase, double *point) {
    const double angle = two_pi * (phase + 0.08 * sin(two_pi * phase));
    point[0] = 2.0 * cos(angle);
    point[1] = sin(angle) + 0.3 * cos(2.0 * angle);
    point[2] = 0.5 * sin(2.0 * angle);
}

static void closed(void **state) {
    (void)state;
    static double points[COUNT][3];
    const size_t curves[] = {1, 2, 3, 5, 7, 12};
    for (size_t c = 0; c < 6; c++) {
        for (size_t n = 0; n < COUNT; n++) {
            oval(fmod((double)(n / curves[c]) * golden, 1.0), points[n]);
            points[n][2] += 5.0 * (double)(n % curves[c]);
        }
        const section all = {COUNT, 3, points[0]};
        assert_int_equal(curves_find(&all).count, curves[c]);
    }
}

/// Two curves that are not visited in turn are not the section of one torus.
static void out_of_turn(void **state) {
    (void)state;
    static double points[COUNT][3];
    for (size_t n = 0; n < COUNT; n++) {
        oval(fmod((double)n * golden, 1.0), points[n]);
        points[n][2] += n % 3 == 0 ? 9.0 : 0.0;
    }
    const section all = {COUNT, 3, points[0]};
    assert_int_equal(curves_find(&all).count, 0);
}

static void open_or_thick(void **state) {
    (void)state;
    static double points[COUNT][3];
    const section all = {COUNT, 3, points[0]};
    for (size_t n = 0; n < COUNT; n++) oval(0.8 * fmod((double)n * golden, 1.0), points[n]); // an arc
    assert_int_equal(curves_find(&all).count, 0);
    for (size_t n = 0; n < COUNT; n++) { // a disc
        const double radius = sqrt(fmod((double)n * 0.7548776662, 1.0)),
                     angle = two_pi * fmod((double)n * 0.5698402910, 1.0);
        points[n][0] = radius * cos(angle);
        points[n][1] = radius * sin(angle);
        points[n][2] = 0.0;
    }
    assert_int_equal(curves_find(&all).count, 0);
    for (size_t n = 0; n < COUNT; n++) oval((double)(n % 5) / 5.0, points[n]); // five points
    assert_int_equal(curves_find(&all).count, 0);
    for (size_t n = 0; n < COUNT; n++) points[n][0] = points[n][1] = points[n][2] = 1.0; // one
    assert_int_equal(curves_find(&all).count, 0);
}

/// A rotation close to 2/5 that has filled only five short arcs does not show its curve, let alone five curves.
static void half_filled(void **state) {
    (void)state;
    static double points[COUNT][3];
    for (size_t n = 0; n < COUNT; n++) oval(fmod((double)n * (0.4 + 2e-5), 1.0), points[n]);
    const section all = {COUNT, 3, points[0]};
    assert_int_equal(curves_find(&all).count, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed),
        cmocka_unit_test(out_of_turn),
        cmocka_unit_test(open_or_thick),
        cmocka_unit_test(half_filled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
