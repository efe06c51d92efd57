// A machine at standstill is the limit of slow rotation. A small machine with each element of the registry, in both
// rotations, has the same numbers in all fields at speed 0 and at 1e-9 rad/s. test_invariant_frames.c and
// test_invariant_runs.c test other changes that must not change a number.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_machines.h"
#include "support_same.h"
#include "support_study.h"
#include "whirl/engine/case.h"
#include "whirl/engine/rotor.h"

static void every_element_has_a_machine(void **state) {
    (void)state;
    for (const whirl_group *const *group = whirl_element_groups(); *group; group++) {
        bool known = false;
        for (const element_machine *of = element_machines; of->name; of++)
            known = known || strcmp(of->name, (*group)->name) == 0;
        if (!known) fail_msg("%s has no machine in support_machines.c", (*group)->name);
    }
}

static void at_rest_as_at_the_slowest_turning(void **state) {
    static const char *const places[] = {WHIRL_FIELD_MODES_SPEED, WHIRL_FIELD_MODES_BEFORE, NULL};
    const same_rule rule = {.tolerance = 1e-7, .left_out = places};
    size_t wrong = 0;
    (void)state;
    for (const element_machine *of = element_machines; of->name; of++) {
        if (of->flags & (MACHINE_TURNS | MACHINE_NO_REST))
            continue; // coefficients that turn, or no rest: no limit at 0
        for (int mirrored = 0; mirrored < 2; mirrored++) {
            char text[MACHINE_TEXT];
            machine_text(of, (machine_view){.mirrored = mirrored}, "  modes: {parameter: n, values: [0, 1e-9]}\n",
                         text);
            whirl_result *result = result_of_text(text);
            wrong += same_points(words("%s%s", of->name, mirrored ? ", mirrored" : ""), result, 0, 0, result, 1, &rule);
            whirl_result_free(result);
        }
    }
    assert_int_equal(wrong, 0);
}

/// Checks the natural frequencies of a mass of 10 kg on an element whose stiffnesses are `one` and `other` (N/m) while
/// the shaft stands still.
static void check_standing(const char *name, const char *part, double one, double other) {
    char text[MACHINE_TEXT];
    snprintf(
        text, sizeof text,
        "whirl: 1\nrotor:\n  speed: 0 rad/s\n  length_scale: 1 mm\n  stations: {mass: {mass: 10 kg}}\n  elements:\n"
        "    - %s\nstudy: {modes: {}}\n",
        part);
    whirl_result *result = result_of_text(text);
    const double stiffness[] = {one, other};
    for (size_t i = 0; i < 2; i++)
        check_within("invariance", words("%s: frequency %zu, rad/s", name, i + 1), sqrt(stiffness[i] / 10.0),
                     whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_MODES_FREQUENCY, 0)[i], 1e-9);
    whirl_result_free(result);
}

/// At standstill everything that turns with the shaft stays at its angle of t = 0.
static void turning_parts_at_standstill(void **state) {
    (void)state;
    check_standing("unequal stiffness", "shaft: {between: [mass, ground], k1: 1 MN/m, k2: 1.3 MN/m}", 1e6, 1.3e6);
    // The crack points up, away from the load; down, along the load; and to the side.
    check_standing("a crack that is closed",
                   "crack: {between: [mass, ground], stiffness: 1 MN/m, loss: 0.3, angle: 90 deg}", 1e6, 1e6);
    check_standing("an open crack", "crack: {between: [mass, ground], stiffness: 1 MN/m, loss: 0.3, angle: -90 deg}",
                   0.7e6, 1e6);
    check_standing("a crack half open",
                   "crack: {between: [mass, ground], stiffness: 1 MN/m, loss: 0.3, loss_across: 0.1}", 0.85e6, 0.95e6);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_element_has_a_machine),
                                       cmocka_unit_test(at_rest_as_at_the_slowest_turning),
                                       cmocka_unit_test(turning_parts_at_standstill)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
