// Machines that rest in more than one place: a table steps from one to another, and its points say so
// (ranges/elsewhere) where the rest of a neighbouring value leads to another place. Closed forms of two wells and of a
// magnet between stops.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/case.h"

/// Returns the case of a station that moves along x, pulled by F with the acceleration |F| along or against x.
static const char *machine_on(const char *elements, const char *study) {
    static char text[4096];
    snprintf(text, sizeof text,
             "whirl: 1\nparameters: {F: 1}\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n"
             "  stations: {j: {mass: 2 kg, moves: x, damping: 10 N.s/m}}\n  elements:\n%s"
             "    - gravity: {acceleration: = abs(F), direction: \"= 1.5707963267948966 * (1 - sign(F))\"}\n"
             "study:\n%s",
             elements, study);
    return text;
}

/// Finds the equilibria of a spring of stiffness -k and cubic k3 under a pull: the roots of k3 x^3 - k x = pull, the
/// least first.
static void wells(double k, double k3, double pull, double root[3]) {
    const double p = k / k3, q = pull / k3, size = 2.0 * sqrt(p / 3.0);
    const double angle = acos(4.0 * q / (size * size * size)) / 3.0;
    for (int i = 0; i < 3; i++) root[i] = size * cos(angle + 2.0943951023931953 * (i + 1));
    if (root[0] > root[1]) {
        const double other = root[0];
        root[0] = root[1];
        root[1] = other;
    }
}

/// A buckled spring: below the fold, |pull| < 2 k sqrt(k/(27 k3)) = 0.385 N, the search ends in the middle, which is
/// unstable; from the value beyond the fold it leads into the well there.
static void two_wells(void **state) {
    static const double pulls[] = {-0.25, -0.16, -0.05, 0.05, 0.16, 0.25};
    (void)state;
    whirl_result *result =
        result_of_text(machine_on("    - cubic_spring: {between: [j, ground], stiffness: -1 kN/m, cubic: 1e9}\n",
                                  "  modes: {parameter: F, values: [-0.25, -0.16, -0.05, 0.05, 0.16, 0.25]}\n"));
    const whirl_table *table = &result->tables[0];
    for (size_t i = 0; i < 6; i++) {
        double root[3];
        const double apart = table_number(table, i, WHIRL_FIELD_RANGES_ELSEWHERE, 0);
        const double rest = table_number(table, i, WHIRL_FIELD_MODES_REST, 0);
        wells(1e3, 1e9, 2.0 * pulls[i], root);
        if (i != 1 && i != 4) {
            check_holds("Rests elsewhere", words("%g m/s2: no place except the neighbours'", pulls[i]), isnan(apart));
            continue;
        }
        const double other = root[pulls[i] > 0.0 ? 2 : 0];
        check_within("Rests elsewhere", words("%g m/s2: in the middle, m", pulls[i]), root[1], 1e-3 * rest, 1e-12);
        check_within("Rests elsewhere", words("%g m/s2: in a well, m", pulls[i]), other, 1e-3 * (rest + apart), 1e-12);
        // m x'' + c x' + (3 k3 x^2 - k) x = 0 beside it.
        check_within("Rests elsewhere", words("%g m/s2: growth in the well, 1/s", pulls[i]), -2.5,
                     table_number(table, i, WHIRL_FIELD_RANGES_ELSEWHERE_GROWTH, 0), 1e-9);
    }
    whirl_left left;
    assert_int_equal(whirl_table_elsewhere(table, &left), 2);
    assert_int_equal(left.first, 1);
    whirl_result_free(result);
}

/// A magnet of 2 - 1 MN/m that pulls outwards between stops of 5 MN/m at 0.2 mm: pressed against either of them, x =
/// (5e6 gap +- pull)/(5e6 - 1e6).
static void magnet_between_stops(void **state) {
    static const double pulls[] = {-50.0, -20.0, 20.0, 50.0};
    (void)state;
    whirl_result *result = result_of_text(machine_on(
        "    - magnetic: {at: j, law: linear, current_stiffness: 200 N/A, displacement_stiffness: 2 MN/m, "
        "proportional: 5000 A/m}\n    - contact: {at: j, gap: 0.2 mm, stiffness: 5e6, law: hertz, power: 1}\n",
        "  initial: {j: {x: \"= 0.3 * sign(F)\"}}\n"
        "  modes: {parameter: F, values: [-50, -20, 20, 50]}\n"));
    const whirl_table *table = &result->tables[0];
    for (size_t i = 0; i < 4; i++) {
        const double side = pulls[i] > 0.0 ? 1.0 : -1.0, pull = 2.0 * fabs(pulls[i]);
        const double rest = side * (1000.0 + pull) / 4e6, other = -side * (1000.0 - pull) / 4e6;
        const double apart = table_number(table, i, WHIRL_FIELD_RANGES_ELSEWHERE, 0);
        check_within("Rests elsewhere", words("%g m/s2: at one stop, m", pulls[i]), rest,
                     1e-3 * table_number(table, i, WHIRL_FIELD_MODES_REST, 0), 1e-12);
        if (i == 0 || i == 3)
            check_holds("Rests elsewhere", words("%g m/s2: its neighbour rests there, too", pulls[i]), isnan(apart));
        else
            check_within("Rests elsewhere", words("%g m/s2: at the other stop, m", pulls[i]), other - rest,
                         1e-3 * apart, 1e-12);
    }
    whirl_result_free(result);
}

/// One place of rest, or none that a force brings back to: nothing is found.
static void no_other_equilibrium(void **state) {
    static const char *const elements[] = {
        "    - spring: {between: [j, ground], stiffness: 1 kN/m}\n",
        "    - cubic_spring: {between: [j, ground], stiffness: 1 kN/m, cubic: 1e9}\n",
        "    - spring: {between: [j, ground], stiffness: 1 kN/m}\n    - contact: {at: j, gap: 1 mm, stiffness: 1e5}\n"};
    (void)state;
    for (size_t i = 0; i < sizeof elements / sizeof *elements; i++) {
        whirl_left left;
        whirl_result *result =
            result_of_text(machine_on(elements[i], "  modes: {parameter: F, values: [-2, -1, -0.1, 0.1, 1, 2]}\n"));
        assert_int_equal(whirl_table_elsewhere(&result->tables[0], &left), 0);
        whirl_result_free(result);
    }
}

/// Runs a journal in five tilting pads at 27 speeds. Returns the number of points at which it has another equilibrium.
static size_t pads_elsewhere(const char *pivots, double preload, double mass, const char *spring) {
    char text[2048];
    whirl_left left;
    snprintf(text, sizeof text,
             "whirl: 1\nparameters: {omega: 3000 rpm}\nrotor:\n  speed: = omega\n  length_scale: 145 um\n"
             "  stations: {j: {mass: %g kg}}\n  elements:\n"
             "    - tilting_pad: {at: j, pivots: [%s], preload: %g, arc: 60 deg, clearance: 145 um, radius: 57.15 mm, "
             "length: 57.15 mm, viscosity: 10 mPa.s%s}\n    - gravity: 9.81 m/s2\n"
             "study:\n  modes: {parameter: omega, from: 1000 rpm, to: 14000 rpm, points: 27, count: 2}\n",
             mass, pivots, preload, spring);
    whirl_result *result = result_of_text(text);
    const size_t count = whirl_table_elsewhere(&result->tables[0], &left);
    whirl_result_free(result);
    return count;
}

/// Upper pads carry nothing: how they stand follows from the search, and what is left of their films moves the journal
/// by up to 3e-3 of the clearance. That is no other place of rest. With a spring such a pad stands in its film or on
/// its spring, at one speed, and the machine does rest in two places.
static void pads_that_carry_nothing(void **state) {
    static const char *const pivots[] = {"18 deg, 90 deg, 162 deg, 234 deg, 306 deg",
                                         "54 deg, 126 deg, 198 deg, 270 deg, 342 deg"};
    static const double preloads[] = {0.0, 0.15, 0.3}, masses[] = {40.0, 360.0};
    size_t loose = 0, held = 0;
    (void)state;
    for (size_t i = 0; i < 12; i++) {
        const char *layout = pivots[i / 6];
        loose += pads_elsewhere(layout, preloads[i / 2 % 3], masses[i % 2], "");
    }
    for (size_t i = 0; i < 2; i++) held += pads_elsewhere(pivots[i], 0.15, 40.0, ", tilt_stiffness: 20 N.m/rad") > 0;
    check_within("Rests elsewhere", "12 bearings without springs: points with another rest", 0.0, (double)loose, 0.0);
    check_within("Rests elsewhere", "pads on springs: layouts with two places of rest", 2.0, (double)held, 0.0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(pads_that_carry_nothing), cmocka_unit_test(two_wells),
                                       cmocka_unit_test(magnet_between_stops), cmocka_unit_test(no_other_equilibrium)};
    return cmocka_run_group_tests_name("rests elsewhere", tests, NULL, NULL);
}
