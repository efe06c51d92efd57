// Run-ups through thresholds of stability: small changes begin to grow at the speed that `modes` names, within what the
// rate allows.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/result.h"
#include "whirl/engine/study.h"

#include <math.h>
#include <stdio.h>

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

enum { SIZE = 4096 };

/// Machines that lose their stability as they turn faster, without unbalance.
static const struct {
    const char *name, *rotor;
    double from, to; ///< speeds of the run around the threshold, rad/s
} machines[] = {
    {"rigid journal in a film",
     "  stations: {journal: {mass: 30 kg}}\n"
     "  elements:\n"
     "    - gravity: {}\n"
     "    - film: {at: journal, clearance: 0.1 mm, viscosity: 20 mPa.s, radius: 25 mm, length: 20 mm}\n",
     720.0, 880.0},
    {"shaft of finite elements in two films, its disc overhung",
     "  shafts: {main: {modes: 6, stiffness_damping: 2e-6 s}}\n"
     "  stations: {left: {position: 100 mm}, right: {position: 500 mm}, disc: {position: 750 mm}}\n"
     "  elements:\n"
     "    - segment: {length: 100 mm, outer: 40 mm, elements: 3}\n"
     "    - segment: {length: 400 mm, outer: 50 mm, elements: 10}\n"
     "    - segment: {length: 250 mm, outer: 45 mm, elements: 7}\n"
     "    - disc: {at: disc, outer: 300 mm, inner: 45 mm, width: 25 mm}\n"
     "    - film: {at: left, clearance: 80 um, viscosity: 20 mPa.s, radius: 20 mm, length: 20 mm}\n"
     "    - film: {at: right, clearance: 80 um, viscosity: 20 mPa.s, radius: 25 mm, length: 25 mm}\n"
     "    - gravity: {}\n",
     450.0, 600.0},
    {"shaft of finite elements between two films",
     "  shafts: {main: {modes: 4, stiffness_damping: 2e-6 s}}\n"
     "  stations: {left: {position: 0 m}, disc: {position: 0.4 m, mass: 60 kg, diametral: 0.4 kg m2, polar: 0.7 kg m2},"
     " right: {position: 1 m}}\n"
     "  elements:\n"
     "    - segment: {length: 1 m, outer: 60 mm, elements: 10}\n"
     "    - film: {at: left, clearance: 0.1 mm, viscosity: 20 mPa.s, radius: 30 mm, length: 30 mm}\n"
     "    - film: {at: right, clearance: 0.1 mm, viscosity: 20 mPa.s, radius: 30 mm, length: 30 mm}\n"
     "    - gravity: {}\n",
     410.0, 550.0}};

static whirl_result *run_machine(size_t which, const char *rotation, const char *study) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\nparameters: {omega: %g rad/s}\nrotor:\n  speed: = omega\n  length_scale: 0.1 mm\n"
             "  rotation: %s\n%sstudy:\n%s",
             machines[which].from, rotation, machines[which].rotor, study);
    return result_of_text(text);
}

/// A threshold of stability: its speed, rad/s, and by how much the growth rises there with the speed, 1/s over rad/s.
typedef struct threshold {
    double speed, slope;
} threshold;

static double largest_growth(const whirl_table *modes, size_t point) {
    const whirl_field *field = whirl_layout_field(&modes->layout, WHIRL_FIELD_MODES_GROWTH);
    double largest = -INFINITY;
    const double *growth = whirl_table_field(modes, point, WHIRL_FIELD_MODES_GROWTH, 0);
    for (size_t i = 0; i < field->rows * field->columns; i++) largest = fmax(largest, growth[i]); // of NaN the other
    return largest;
}

static threshold threshold_of(size_t which, const char *rotation) {
    const double from = machines[which].from, to = machines[which].to;
    threshold found = {NAN, NAN};
    char study[SIZE];
    snprintf(study, sizeof study, "  modes: {parameter: omega, from: %g rad/s, to: %g rad/s, points: 2}\n", from, to);
    whirl_result *result = run_machine(which, rotation, study);
    const whirl_table *modes = whirl_result_table(result, "modes");
    const whirl_field *field = whirl_layout_field(&modes->layout, WHIRL_FIELD_MODES_CRITICAL);
    for (size_t point = 0; point < modes->count; point++)
        for (size_t i = 0; i < field->rows; i++) {
            const double *row = whirl_table_field(modes, point, WHIRL_FIELD_MODES_CRITICAL, 0) + i * field->columns;
            if (row[0] == WHIRL_ONSET && isnan(found.speed)) found.speed = row[1];
        }
    found.slope = (largest_growth(modes, 1) - largest_growth(modes, 0)) / (to - from);
    whirl_result_free(result);
    return found;
}

/// The speed at which a small change begins to grow while the shaft runs up past a speed, rad/s.
static double growth_begins(size_t which, const char *rotation, double rate, double past, double around) {
    const double from = past - 3.0 * around, to = past + 2.0 * around;
    char study[SIZE];
    snprintf(study, sizeof study,
             "  runup: {rate: %g rad/s2, speed_from: %.17g rad/s, speed_to: %.17g rad/s, sensitivity: yes, "
             "begin: steady, settle: 20, rows: 10, samples: 32}\n",
             rate, from, to);
    whirl_result *result = run_machine(which, rotation, study);
    const double begins = first_number(result, WHIRL_FIELD_RUNUP_SENSITIVITY, 0, 1);
    whirl_result_free(result);
    return from + rate * begins;
}

/// Small changes shrink up to the threshold of the modes and grow from there on. A change that whirls on an ellipse may
/// hide a growth by a factor below 2, which is reached where slope times the square of the distance to the threshold is
/// 2 ln 2 times the rate.
static void whirl_begins_at_the_threshold(void **state) {
    static const double rates[] = {80.0, 5.0};
    static const char *const rotations[] = {"counter-clockwise", "clockwise"};
    (void)state;
    for (size_t which = 0; which < COUNT_OF(machines); which++)
        for (size_t way = 0; way < 2; way++) {
            const threshold own = threshold_of(which, rotations[way]);
            double lag[2];
            for (size_t k = 0; k < 2; k++) {
                const double allowed = sqrt(2.0 * log(2.0) * rates[k] / own.slope);
                const double begins = growth_begins(which, rotations[way], rates[k], own.speed, allowed);
                lag[k] = fabs(begins - own.speed);
                check_within(
                    "Run whirl",
                    words("%s, %s: growth begins, rad/s, at %g rad/s2", machines[which].name, rotations[way], rates[k]),
                    own.speed, begins, allowed);
            }
            check_holds("Run whirl", words("%s: a slower run comes nearer", machines[which].name),
                        lag[1] < 0.5 * lag[0]);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(whirl_begins_at_the_threshold)};
    return cmocka_run_group_tests_name("whirl of runs", tests, NULL, NULL);
}
