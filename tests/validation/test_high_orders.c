// Spectra reach the orders at which parts of a machine act by themselves: blades, rolling elements, harmonic forces,
// couplings and runout; a given order stays.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/case.h"
#include "whirl/engine/fields.h"
#include "whirl/internal/spectrum.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))
static const char *const id = "high orders";

static const char *text_of(const char *element, const char *rotor, const char *study) {
    static char text[2048];
    const int used =
        snprintf(text, sizeof text,
                 "whirl: 1\nparameters: {speed: 100 rad/s}\nrotor:\n  speed: = speed\n  length_scale: 1 mm\n%s  "
                 "stations: {disc: "
                 "{mass: 10, diametral: 0.1, eccentricity: 1e-4}, end: {mass: 5, diametral: 0.1}}\n  elements:\n"
                 "    - spring: {between: [disc, ground], stiffness: 1e6, damping: 300}\n"
                 "    - spring: {between: [end, ground], stiffness: 1e6, damping: 300}\n    - %s\nstudy:\n%s",
                 rotor, element, study);
    assert_true(used > 0 && (size_t)used < sizeof text);
    return text;
}

static void reached(void **state) {
    const char *const response = "  response: {}\n", *const given = "  response: {}\n  keep: {highest_order: 3}\n";
    const char *const sweep = "  sweep: {parameter: speed, values: [50 rad/s, 100 rad/s]}\n";
    const char *const poincare = "  response: {}\n  analyze: [poincare]\n";
    const struct {
        const char *what, *element, *study;
        double order;
    } cases[] = {
        {"nothing above 1X", "spring: {between: [disc, end], stiffness: 1e6}", response, 5},
        {"7 blades", "blade_rub: {at: disc, blades: 7, radius: 0.3, gap: 1e-3, stiffness: 1e6}", response, 8},
        {"7 blades, and a given order", "blade_rub: {at: disc, blades: 7, radius: 0.3, gap: 1e-3, stiffness: 1e6}",
         given, 3},
        {"7 blades, and no spectrum", "blade_rub: {at: disc, blades: 7, radius: 0.3, gap: 1e-3, stiffness: 1e6}",
         poincare, 5},
        {"60 blades, for which samples are taken more often",
         "blade_rub: {at: disc, blades: 60, radius: 0.3, gap: 1e-3, stiffness: 1e6}", response, 61},
        {"9 balls: BPFI is 9 (1 - 0.4) = 5.4",
         "ball_bearing: {at: disc, balls: 9, stiffness: 1e9, cage: 0.4, damping: 200}", response, 7},
        {"a force of 6.5 times the speed", "force: {at: disc, amplitude: 1, ratio: 6.5}", response, 8},
        {"a force of 100 Hz at 50 and 100 rad/s", "force: {at: disc, amplitude: 1, frequency: 100}", sweep, 14},
        {"an unbalance of a shaft 8 times as fast", "unbalance: {at: disc, moment: 1e-6, ratio: -8}", response, 9},
        {"reactions up to 6X",
         "coupling_load: {between: [disc, end], distance: 0.05, x1: 1e-4, bending_stiffness: 150, "
         "orders: [1, 0, 0, 0, 0, 0, 0.1]}",
         response, 7},
        {"runout of 9 high places", "runout: {at: disc, order: 9, amplitude: 1e-6}", response, 10},
    };
    (void)state;
    for (size_t i = 0; i < COUNT_OF(cases); i++)
        for (int way = 0; way < 2; way++) {
            whirl_study study;
            whirl_case *object =
                case_of_text(text_of(cases[i].element, way ? "  rotation: clockwise\n" : "", cases[i].study));
            require_ok(whirl_case_study(object, &study));
            check_within(id, words("%s%s: spectra reach", cases[i].what, way ? ", clockwise" : ""), cases[i].order,
                         study.batches[0].record.highest_order, 0.0);
            whirl_case_free(object);
        }
}

/// A force of .2 N at 7.3 times the speed on 10 kg at 1e5 N/m a kg: its line is |F/(k - m w^2 + i c w)|, 1e-4 of the
/// unbalance's, so that the lines below hold all of the motion but 1e-8.
static void a_small_line(void **state) {
    const double w = 730.0, k = 1e6, m = 10.0, c = 300.0, force = 0.2;
    const double expected = force / hypot(k - m * w * w, c * w) / 1e-3;
    double order = NAN, amplitude = NAN;
    (void)state;
    whirl_result *result = result_of_text(
        text_of("force: {at: disc, amplitude: 0.2, ratio: 7.3}", "",
                "  response: {}\n  integrate: {method: dop853, transient: 200, record: 100}\n  analyze: [spectrum]\n"));
    const whirl_table *table = &result->tables[0];
    const double *lines = whirl_table_field(table, 0, WHIRL_FIELD_SPECTRUM_LINES, 0);
    assert_non_null(lines);
    for (size_t line = 0; line < WHIRL_MAX_LINES && !(fabs(order - 7.3) < 0.1); line++) {
        order = lines[5 * line];
        amplitude = lines[5 * line + 1];
    }
    check_within(id, "order of a line of 1e-4 of the motion", 7.3, order, 1e-5);
    check_within(id, "its amplitude over the closed form", 1.0, amplitude / expected, 1e-3);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(reached), cmocka_unit_test(a_small_line)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
