// Reported numbers do not depend on the side from which a machine is seen, the length scale, the units of a case, and
// the order of its stations and elements. The tests compare all fields of the tables, at rest and in motion, of one
// small machine for each element.
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
#include "support_machines.h"
#include "support_same.h"
#include "support_study.h"

/// Studies about rest, and motions of a few revolutions. Machines whose coefficients turn have no response about rest.
static const char at_rest[] = "  modes: {parameter: n, values: [700 rad/s, 900 rad/s]}\n"
                              "  unbalance: {parameter: n, values: [700 rad/s, 900 rad/s]}\n  stability: {}\n";
static const char in_motion[] =
    "  sweep: {parameter: n, values: [700 rad/s, 900 rad/s], start: rest}\n"
    "  integrate: {method: rk4, steps_per_revolution: 256, transient: 60, record: 10, watch: 60, settle: no}\n"
    "  keep: {waveform: 1, samples: 16, highest_order: 3}\n"
    "  analyze: [poincare, orbit, rub, spectrum, lyapunov, regime, winding, evidence, floquet]\n";

/// Revolutions over which motions have a perturbed copy. Rates that differ by less than 1 / revolutions have not
/// parted, and a copy in another direction has another mean of them (MACHINE_SLOW; test_slow.c has its closed form).
static const double watched = 60.0;

static whirl_result *run(const element_machine *of, machine_view as, const char *study) {
    char text[MACHINE_TEXT];
    machine_text(of, as, study, text);
    return result_of_text(text);
}

static bool rests(const element_machine *of) {
    return !(of->flags & (MACHINE_TURNS | MACHINE_NO_REST));
}

/// Compares a study of a machine in its own frame with that in the other frame.
static size_t compare(const char *how, const element_machine *of, machine_view as, const char *study, same_rule rule) {
    whirl_result *one = run(of, (machine_view){0}, study), *other = run(of, as, study);
    if (of->flags & MACHINE_SLOW && as.mirrored) rule.of_growth = 1.0 / watched;
    const size_t wrong = same_results(words("%s, %s", how, of->name), one, other, &rule);
    whirl_result_free(one);
    whirl_result_free(other);
    return wrong;
}

/// Checks both studies of all machines, to within `rest` and `motion` of the largest number of every field.
static void check(const char *how, machine_view as, double rest, double motion) {
    size_t wrong = 0;
    for (const element_machine *of = element_machines; of->name; of++) {
        if (rests(of)) wrong += compare(how, of, as, at_rest, (same_rule){rest, 1e-5, as.mirrored, NULL});
        wrong += compare(how, of, as, in_motion, (same_rule){motion, 1e-5, as.mirrored, NULL});
    }
    assert_int_equal(wrong, 0);
}

static void the_mirror(void **state) {
    (void)state;
    check("mirrored", (machine_view){.mirrored = true}, 1e-9, 1e-8);
}

static void the_length_scale(void **state) {
    (void)state;
    check("by another length", (machine_view){.length = "0.37 mm"}, 1e-9, 1e-8);
}

/// Runs the motion of a machine by a method with tolerances, in another length scale.
static whirl_result *run_in(const element_machine *of, const char *length, const char *method) {
    char study[512];
    snprintf(study, sizeof study,
             "  response: {}\n  integrate: {method: %s, transient: 40, record: 20}\n"
             "  analyze: [poincare, orbit, regime]\n",
             method);
    return run(of, (machine_view){.length = length}, study);
}

static double number_of(const whirl_result *result, const char *field) {
    return *whirl_table_field(&result->tables[0], 0, field, 0);
}

/// Returns true if a station has a clearance or a gap.
static bool has_gap(const whirl_result *result) {
    for (size_t i = 0; i < result->station_count; i++)
        if (result->stations[i].clearance > 0.0 || result->stations[i].gap > 0.0) return true;
    return false;
}

/// The absolute tolerance is a share of the length scale, so that a motion is coarse next to a scale that is far too
/// large. It follows the smallest clearance or gap. Where there is none, a verdict may differ with low confidence only.
static void no_length_scale_is_wrong_in_silence(void **state) {
    static const struct {
        const char *method, *length;
    } others[] = {{"dop853", "1 um"}, {"dop853", "1 km"}, {"rodas5p", "1 km"}, {"dop853", "1e4 km"}};
    size_t wrong = 0;
    (void)state;
    for (const element_machine *of = element_machines; of->name; of++) {
        whirl_result *one = run_in(of, "0.1 mm", "dop853");
        for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
            whirl_result *other = run_in(of, others[i].length, others[i].method);
            const bool same = number_of(one, WHIRL_FIELD_REGIME_CODE) == number_of(other, WHIRL_FIELD_REGIME_CODE) &&
                              number_of(one, WHIRL_FIELD_REGIME_PERIOD) == number_of(other, WHIRL_FIELD_REGIME_PERIOD);
            if (!same && (has_gap(one) || number_of(other, WHIRL_FIELD_REGIME_CONFIDENCE) > WHIRL_LOW)) {
                wrong++;
                print_error("%s by %s, length scale %s: regime %g for %g\n", of->name, others[i].method,
                            others[i].length, number_of(other, WHIRL_FIELD_REGIME_CODE),
                            number_of(one, WHIRL_FIELD_REGIME_CODE));
            }
            whirl_result_free(other);
        }
        whirl_result_free(one);
    }
    assert_int_equal(wrong, 0);
}

static void the_order(void **state) {
    (void)state;
    check("in the other order", (machine_view){.reversed = true}, 1e-9, 1e-8);
}

/// Motions of every machine in inches; in the other systems, without WHIRL_SOAK, of those that have no rest alone.
static void the_units(void **state) {
    static const struct {
        const char *name;
        const unit_pair *units;
    } systems[] = {{"inches", units_inch}, {"feet", units_feet}, {"millimetres", units_millimetre}, {"SI", units_si}};
    size_t wrong = 0;
    (void)state;
    for (size_t i = 0; i < sizeof systems / sizeof *systems; i++)
        for (const element_machine *of = element_machines; of->name; of++) {
            const machine_view as = {.units = systems[i].units};
            if (rests(of)) wrong += compare(systems[i].name, of, as, at_rest, (same_rule){1e-10, 1e-5, false, NULL});
            if (i == 0 || !rests(of) || getenv("WHIRL_SOAK"))
                wrong += compare(systems[i].name, of, as, in_motion, (same_rule){1e-8, 1e-5, false, NULL});
        }
    assert_int_equal(wrong, 0);
}

/// A segment is equivalent to two halves.
static void the_pieces_of_a_shaft(void **state) {
    static const char whole[] = "segment: {from: rotor, to: stator, length: 400 mm, outer: 30 mm, elements: 4}",
                      halves[] = "segment: {from: rotor, length: 200 mm, outer: 30 mm, elements: 2}\n"
                                 "    - segment: {to: stator, length: 200 mm, outer: 30 mm, elements: 2}";
    static const char discs[] = "disc: {at: rotor, outer: 200 mm, width: 10 mm}\n"
                                "    - disc: {at: stator, outer: 100 mm, width: 10 mm}\n    - ";
    char one[1024], two[1024];
    size_t wrong = 0;
    (void)state;
    snprintf(one, sizeof one, "%s%s", discs, whole);
    snprintf(two, sizeof two, "%s%s", discs, halves);
    const element_machine machines[] = {{"segment", one, 0}, {"segment", two, 0}};
    for (int moves = 0; moves < 2; moves++) {
        const same_rule rule = {1e-9, 1e-5, false, NULL};
        whirl_result *a = run(&machines[0], (machine_view){0}, moves ? in_motion : at_rest);
        whirl_result *b = run(&machines[1], (machine_view){0}, moves ? in_motion : at_rest);
        wrong += same_results("in halves", a, b, &rule);
        whirl_result_free(a);
        whirl_result_free(b);
    }
    assert_int_equal(wrong, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_mirror),
                                       cmocka_unit_test(the_length_scale),
                                       cmocka_unit_test(no_length_scale_is_wrong_in_silence),
                                       cmocka_unit_test(the_order),
                                       cmocka_unit_test(the_units),
                                       cmocka_unit_test(the_pieces_of_a_shaft)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
