// Run-ups: speeds that change by a rate or by a drive, rubs, lost blades, against digits of independent computations.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/result.h"
#include "whirl/engine/study.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

enum { SIZE = 4096 };

static const double two_pi = 6.283185307179586476925;

// ---------------------------------------------------------------- a drive

/// Runs two discs with unbalances at 0 and 120 degrees on one shaft that a drive turns, from rest.
static whirl_result *run_two(double weight, double duration, const char *more, const char *rotor) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\n"
             "rotor:\n"
             "  speed: 1 rad/s\n"
             "  length_scale: 1 m\n"
             "%s"
             "  stations:\n"
             "    one: {mass: 1 kg, damping: 0.06 N.s/m, eccentricity: 1 m}\n"
             "    two: {mass: 1.5 kg, damping: 0.06 N.s/m, eccentricity: 0.6 m, eccentricity_angle: %s120 deg}\n"
             "  elements:\n"
             "    - spring: {between: [one, ground], stiffness: 1 N/m}\n"
             "    - spring: {between: [one, two], stiffness: 0.8 N/m}\n"
             "    - spring: {between: [two, ground], stiffness: 1.2 N/m}\n"
             "    - gravity: %g m/s2\n"
             "    - drive: {inertia: 900 kg.m2, torque: 60 N.m, no_load_speed: 4 rad/s, load_quadratic: 2 N.m.s2}\n"
             "study:\n"
             "  runup: {duration: %g s, rtol: 1e-12, rows: 20, samples: 16%s}\n",
             rotor, *rotor ? "-" : "", weight, duration, more);
    return result_of_text(text);
}

/// The digits are those of two programs that agree to 1e-10: a Schur complement by extrapolation, and a mass matrix
/// solved at every instant.
static void two_discs_on_one_shaft(void **state) {
    static const struct {
        double weight, duration;
        const char *angle, *speed, *place[4];
    } known[] = {
        {0.0, 50.0, "57.1892569817", "1.729858933", {"-10.0321147", "-4.70468235", "5.17220671", "2.92984634"}},
        {0.0, 100.0, "171.671747326", "2.607955117", {"-1.28121349", "-2.49948742", "1.51329468", ".9745196"}},
        {0.0, 800.0, "2173.35404703", "2.872403117", {"-1.0593108", ".8193033", ".0199108", "-.7745873"}},
        {0.8, 50.0, "57.2018502489", "1.72966893", {"-9.97295396", "-5.67145004", "5.14719525", "2.04465552"}},
        {0.8, 300.0, "737.204417205", "2.871638962", {".595681", "-2.0551468", ".3157369", "-.2395997"}},
        {0.8, 800.0, "2173.38077384", "2.872297725", {"-1.0807642", "-.0741124", ".0405602", "-1.7197182"}},
    };
    (void)state;
    for (size_t i = 0; i < COUNT_OF(known); i++) {
        whirl_result *result = run_two(known[i].weight, known[i].duration, "", "");
        char at[64];
        snprintf(at, sizeof at, "two discs, weight %g, at %g s", known[i].weight, known[i].duration);
        check_digits("Run-up", words("%s: angle", at), known[i].angle,
                     two_pi * first_number(result, WHIRL_FIELD_RUNUP_END_TURNS, 0, 0));
        check_digits("Run-up", words("%s: speed", at), known[i].speed,
                     first_number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0));
        for (size_t k = 0; k < 4; k++)
            check_digits("Run-up", words("%s: %s%zu", at, k % 2 ? "y" : "x", k / 2 + 1), known[i].place[k],
                         first_number(result, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2));
        whirl_result_free(result);
    }
}

/// A shaft with a million turns behind it moves as one that begins: its angle is exact to 1e-9 rad there.
static void a_million_turns_behind(void **state) {
    char more[64];
    (void)state;
    snprintf(more, sizeof more, ", angle: %.17g rad", 1e6 * two_pi);
    whirl_result *own = run_two(0.8, 50.0, "", ""), *later = run_two(0.8, 50.0, more, "");
    check_within("Run-up", "speed after a million turns", first_number(own, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0),
                 first_number(later, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0), 1e-9);
    for (size_t k = 0; k < 4; k++)
        check_within("Run-up", words("place %zu after a million turns", k),
                     first_number(own, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2),
                     first_number(later, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2), 5e-8);
    whirl_result_free(own);
    whirl_result_free(later);
}

/// Mirrored rotation and another method change nothing.
static void two_discs_otherwise(void **state) {
    (void)state;
    whirl_result *own = run_two(0.8, 50.0, "", ""), *other = run_two(0.8, 50.0, ", method: rodas5p", "");
    check_within("Run-up", "speed, by rodas5p", first_number(own, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0),
                 first_number(other, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0), 1e-8);
    whirl_result_free(own);
    whirl_result_free(other);
    // Without weight nothing tells left from right.
    own = run_two(0.0, 50.0, "", "");
    whirl_result *mirrored = run_two(0.0, 50.0, "", "  rotation: clockwise\n");
    check_within("Run-up", "speed, mirrored", first_number(own, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0),
                 first_number(mirrored, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0), 1e-12);
    for (size_t k = 0; k < 4; k++)
        check_within("Run-up", words("place %zu, mirrored", k),
                     (k % 2 ? -1.0 : 1.0) * first_number(own, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2),
                     first_number(mirrored, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2), 1e-9);
    whirl_result_free(own);
    whirl_result_free(mirrored);
}

static const char disc[] = "whirl: 1\n"
                           "rotor:\n"
                           "  speed: 1 rad/s\n"
                           "  length_scale: %s\n"
                           "  stations:\n"
                           "    disc: {mass: 1 kg, damping: %g N.s/m, eccentricity: %g m}\n"
                           "  elements:\n"
                           "    - spring: {between: [disc, ground], stiffness: 1 N/m}\n"
                           "    - %s\n"
                           "study:\n"
                           "  runup: {%s, rtol: 1e-13, rows: 20, samples: 64}\n";

/// An eccentricity that appears at once is a blade that is lost: closed form in 40 digits.
static void eccentricity_appears(void **state) {
    static const char text[] = "whirl: 1\n"
                               "parameters: {e: 0 m}\n"
                               "rotor:\n"
                               "  speed: 1 rad/s\n"
                               "  length_scale: 1 m\n"
                               "  stations:\n"
                               "    disc: {mass: 1 kg, damping: 0.04 N.s/m, eccentricity: = e}\n"
                               "  elements:\n"
                               "    - spring: {between: [disc, ground], stiffness: 1 N/m}\n"
                               "study:\n"
                               "  runup: {rate: 1e-14 rad/s2, speed_from: 3 rad/s, duration: 40 s, change: {e: 1 m}, "
                               "change_time: 10.01 s, rtol: 1e-13, rows: 20, samples: 64}\n";
    (void)state;
    whirl_result *result = result_of_text(text);
    check_digits("Run-up", "eccentricity appears: largest radius", "4.39626100286",
                 first_number(result, WHIRL_FIELD_RUNUP_PEAK, 0, 0));
    check_digits("Run-up", "eccentricity appears: when", "1.56098834",
                 first_number(result, WHIRL_FIELD_RUNUP_PEAK_TIME, 0, 0) - 10.01);
    check_within("Run-up", "eccentricity appears: instant of the change", 10.01,
                 first_number(result, WHIRL_FIELD_RUNUP_EVENTS, 0, 2), 1e-12);
    whirl_result_free(result);
}

static whirl_result *run_disc(const char *scale, double damping, double eccentricity, const char *element,
                              const char *study) {
    char text[SIZE];
    snprintf(text, sizeof text, disc, scale, damping, eccentricity, element, study);
    return result_of_text(text);
}

/// Sommerfeld's effect: DOP853 at 1e-12 and LSODA agree on these to 9 digits.
static void sommerfeld(void **state) {
    static const struct {
        double torque, duration;
        const char *speed;
    } known[] = {{20.0, 200.0, ".950068125"},   {20.0, 1000.0, ".977329471"},  {20.0, 1500.0, ".977594196"},
                 {25.0, 200.0, ".975819831"},   {25.0, 1000.0, ".981264955"},  {25.0, 1500.0, ".981636508"},
                 {30.0, 200.0, "1.430713435"},  {30.0, 1000.0, "1.989096267"}, {40.0, 100.0, "1.151010995"},
                 {40.0, 1000.0, "1.992782895"}, {52.0, 100.0, "1.402691107"},  {52.0, 1000.0, "1.994523861"}};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(known); i++) {
        char element[SIZE / 8], study[SIZE / 8];
        snprintf(element, sizeof element, "drive: {inertia: 2000 kg.m2, torque: %g N.m, no_load_speed: 2 rad/s}",
                 known[i].torque);
        snprintf(study, sizeof study, "duration: %g s", known[i].duration);
        whirl_result *result = run_disc("1 m", 0.04, 1.0, element, study);
        check_digits("Run-up", words("Sommerfeld, T0 %g, speed at %g", known[i].torque, known[i].duration),
                     known[i].speed, first_number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0));
        whirl_result_free(result);
    }
}

/// The balance T0 (1 - w/2) = 2 z w^5/((1 - w^2)^2 + (2 z w)^2), z .02: roots of its derivative in 40 digits. Printed
/// are the same torques (50.0801604496, .7648998278) at 1.0008019274 and 1.4485214491, where the torque is flat.
static void stationary_speeds(void **state) {
    static const struct {
        double torque;
        size_t speeds; ///< at which the torques balance
    } known[] = {{20.0, 3}, {30.0, 3}, {52.0, 1}};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(known); i++) {
        char element[SIZE / 8], at[64];
        snprintf(element, sizeof element, "drive: {inertia: 2000 kg.m2, torque: %g N.m, no_load_speed: 2 rad/s}",
                 known[i].torque);
        snprintf(at, sizeof at, "stationary speeds, T0 %g", known[i].torque);
        whirl_result *result = run_disc("1 m", 0.04, 1.0, element, "duration: 1 s");
        const double *speeds = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUNUP_STATIONARY, 0);
        const double *folds = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUNUP_FOLD, 0);
        assert_non_null(speeds);
        assert_non_null(folds);
        size_t count = 0;
        for (; count < 8 && isfinite(speeds[3 * count]); count++) {
            const double w = speeds[3 * count], apart = 1.0 - w * w;
            check_within("Run-up", words("%s: torque less resistance at %.4f", at, w),
                         2.0 * 0.02 * pow(w, 5.0) / (apart * apart + 0.0016 * w * w), known[i].torque * (1.0 - w / 2.0),
                         1e-9);
            check_within("Run-up", words("%s: holds at %.4f", at, w), count == 1 ? 0.0 : 1.0, speeds[3 * count + 2],
                         0.0);
        }
        check_within("Run-up", words("%s: number", at), (double)known[i].speeds, (double)count, 0.0);
        check_digits("Run-up", words("%s: released at", at), "1.00080192772", folds[0]);
        check_digits("Run-up", words("%s: released by", at), "50.08016044965", known[i].torque * folds[1]);
        check_digits("Run-up", words("%s: captured at", at), "1.4485214455", folds[3]);
        check_digits("Run-up", words("%s: captured by", at), ".76489982777", known[i].torque * folds[4]);
        whirl_result_free(result);
    }
}

/// Samples show a run and do not change it: a motor against dry friction, from rest, past a stator.
static void samples_change_nothing(void **state) {
    static const char drive[] = "drive: {inertia: 100 kg.m2, torque: 5 N.m, no_load_speed: 2 rad/s, load: 2 N.m}\n"
                                "    - rub: {at: disc, gap: 4 m, stiffness: 1 N/m, friction: 0.05, law: paper, radius: "
                                "1 m}";
    (void)state;
    whirl_result *own = run_disc("1 m", 0.1, 1.0, drive, "duration: 100 s");
    char text[SIZE];
    snprintf(text, sizeof text, disc, "1 m", 0.1, 1.0, drive, "duration: 100 s");
    char *samples = strstr(text, "samples: 64");
    assert_non_null(samples);
    memcpy(samples, "samples: 16", 11);
    whirl_result *few = result_of_text(text);
    check_within("Run-up", "speed at the end by 16 and by 64 samples",
                 first_number(own, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0),
                 first_number(few, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0), 1e-10);
    check_within("Run-up", "largest radius by 16 and by 64 samples", first_number(own, WHIRL_FIELD_RUNUP_PEAK, 0, 0),
                 first_number(few, WHIRL_FIELD_RUNUP_PEAK, 0, 0), 1e-9);
    whirl_result_free(own);
    whirl_result_free(few);
}

/// Runs two discs of 2 kg, 40 cm apart, with unbalances, on a shaft that a drive turns from rest.
static whirl_result *run_unbalances(const char *rotor, const char *unbalances) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n%s"
             "  stations: {a: {mass: 2 kg, damping: 50 N.s/m}, b: {mass: 2 kg, damping: 50 N.s/m}}\n"
             "  elements:\n"
             "    - spring: {between: [a, ground], stiffness: 5e4 N/m}\n"
             "    - spring: {between: [b, ground], stiffness: 6e4 N/m}\n"
             "    - spring: {between: [a, b], stiffness: 2e4 N/m}\n"
             "    - drive: {inertia: 0.05 kg.m2, torque: 6 N.m, no_load_speed: 300 rad/s}\n"
             "%s"
             "study: {runup: {duration: 1.5 s, rtol: 1e-12, rows: 20, samples: 32}}\n",
             rotor, unbalances);
    return result_of_text(text);
}

/// The same unbalances, written in other ways, and their mirror image turn the shaft alike.
static void unbalances_written_in_other_ways(void **state) {
    static const struct {
        const char *what, *rotor[2], *unbalances[2];
        double mirrored; ///< sign of y in the second
    } pairs[] = {
        {"ratio 1",
         {"", ""},
         {"    - unbalance: {at: a, moment: 6e-3 kg.m, angle: 40 deg}\n",
          "    - unbalance: {at: a, moment: 6e-3 kg.m, angle: 40 deg, ratio: 1}\n"},
         1.0},
        {"grade",
         {"", ""},
         {"    - unbalance: {at: a, moment: 4e-3 kg.m}\n    - unbalance: {at: b, moment: 4e-3 kg.m}\n",
          "    - unbalance_grade: {planes: [a, b], grade: 200 mm/s, service_speed: 100 rad/s, mass: 4 kg, to_first: "
          "0.2 "
          "m, to_second: 0.2 m}\n"},
         1.0},
        {"mirrored, ratio 1.7",
         {"", "  rotation: clockwise\n"},
         {"    - unbalance: {at: a, moment: 5e-3 kg.m, ratio: 1.7}\n    - unbalance: {at: b, moment: 4e-3 kg.m}\n",
          "    - unbalance: {at: a, moment: 5e-3 kg.m, ratio: 1.7}\n    - unbalance: {at: b, moment: 4e-3 kg.m}\n"},
         -1.0},
        {"mirrored, ratio -1.7",
         {"", "  rotation: clockwise\n"},
         {"    - unbalance: {at: b, moment: 5e-3 kg.m, ratio: -1.7}\n",
          "    - unbalance: {at: b, moment: 5e-3 kg.m, ratio: -1.7}\n"},
         -1.0},
    };
    (void)state;
    for (size_t i = 0; i < COUNT_OF(pairs); i++) {
        whirl_result *one = run_unbalances(pairs[i].rotor[0], pairs[i].unbalances[0]);
        whirl_result *other = run_unbalances(pairs[i].rotor[1], pairs[i].unbalances[1]);
        check_within("Run-up", words("unbalances, %s: speed", pairs[i].what),
                     first_number(one, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0),
                     first_number(other, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0), 1e-8);
        for (size_t k = 0; k < 4; k++)
            check_within("Run-up", words("unbalances, %s: place %zu", pairs[i].what, k),
                         (k % 2 ? pairs[i].mirrored : 1.0) * first_number(one, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2),
                         first_number(other, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2), 1e-8);
        whirl_result_free(one);
        whirl_result_free(other);
    }
}

// ---------------------------------------------------------------- sensitivity

/// Runs Ueda's oscillator, x'' + 0.05 x' + x^3 = 7.5 cos t, as a disc at a constant speed, with a tolerance.
static whirl_result *run_ueda(double duration, const char *tolerance) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\nrotor:\n  speed: 1 rad/s\n  length_scale: 1 m\n"
             "  stations: {disc: {mass: 1 kg, moves: x, damping: 0.05 N.s/m, eccentricity: 7.5 m}}\n  elements:\n"
             "    - cubic_spring: {between: [disc, ground], along: x, cubic: 1 N/m3}\n"
             "study:\n  runup: {speeds: [[0 s, 1 rad/s], [400 s, 1 rad/s]], duration: %g s, rtol: %s, rows: 10, "
             "sensitivity: yes}\n",
             duration, tolerance);
    return result_of_text(text);
}

/// Returns the difference of the last displacements at two tolerances, over the largest radius.
static double difference_of_tolerances(double duration) {
    whirl_result *const both[] = {run_ueda(duration, "1e-10"), run_ueda(duration, "1e-11")};
    double place[2][2], radius = 0.0;
    for (size_t i = 0; i < 2; i++) {
        for (size_t k = 0; k < 2; k++) place[i][k] = first_number(both[i], WHIRL_FIELD_RUNUP_PLACE, 0, k);
        radius = fmax(radius, first_number(both[i], WHIRL_FIELD_RUNUP_PEAK, 0, 0));
        whirl_result_free(both[i]);
    }
    return hypot(place[0][0] - place[1][0], place[0][1] - place[1][1]) / radius;
}

/// Where the perturbed copy reports that a run has lost its digits, two tolerances differ; before half of that time
/// they agree. A rub that releases keeps its digits, and so does a damped linear rotor.
static void sensitive_runs(void **state) {
    static const char rub[] = "rub: {at: disc, gap: 4 m, stiffness: 1 N/m, friction: 0.05, law: paper}";
    (void)state;
    whirl_result *result = run_ueda(400.0, "1e-10");
    const double at = first_number(result, WHIRL_FIELD_RUNUP_SENSITIVITY, 0, 3);
    check_holds("Run-up", "Ueda's oscillator is sensitive", at > 50.0 && at < 390.0);
    whirl_result_free(result);
    check_holds("Run-up", "two tolerances differ by a hundredth at its end", difference_of_tolerances(400.0) > 0.01);
    check_within("Run-up", "two tolerances agree before half of the time", 0.0, difference_of_tolerances(0.5 * at),
                 1e-3);
    result = run_disc("1 m", 0.1, 1.0, rub, "rate: 0.003 rad/s2, duration: 700 s");
    check_holds("Run-up", "a rub of one contact is not sensitive",
                isnan(first_number(result, WHIRL_FIELD_RUNUP_SENSITIVITY, 0, 3)) &&
                    first_number(result, WHIRL_FIELD_RUNUP_SENSITIVITY, 0, 0) < log(1e3));
    whirl_result_free(result);
    result = run_disc("1 m", 0.1, 1.0, "gravity: 0", "rate: 0.003 rad/s2, duration: 700 s, sensitivity: yes");
    check_holds("Run-up", "small changes of a damped linear rotor decay",
                first_number(result, WHIRL_FIELD_RUNUP_SENSITIVITY, 0, 0) < log(10.0));
    whirl_result_free(result);
}

// ---------------------------------------------------------------- a rate

/// Lewis 1932, up from rest and down from a steady motion.
static void lewis(void **state) {
    static const struct {
        const char *study;
        double radius;
        const char *speed;
    } known[] = {
        {"rate: 0.001 rad/s2, speed_to: 1.3 rad/s, begin: centre", 20.283729640233, "1.0492"},
        {"rate: 0.005 rad/s2, speed_to: 1.3 rad/s, begin: centre", 13.999741706287, "1.1314"},
        {"rate: 0.002 rad/s2, speed_from: 1.8 rad/s, speed_to: 0.5 rad/s, begin: steady", 16.623628889, ".929121"}};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(known); i++) {
        whirl_result *result = run_disc("1 m", 0.04, 1.0, "gravity: 0", known[i].study);
        check_within("Run-up", words("Lewis, %s: largest radius", known[i].study), known[i].radius,
                     first_number(result, WHIRL_FIELD_RUNUP_PEAK, 0, 0), 1e-8);
        check_digits("Run-up", words("Lewis, %s: speed there", known[i].study), known[i].speed,
                     first_number(result, WHIRL_FIELD_RUNUP_PEAK_SPEED, 0, 0));
        whirl_result_free(result);
    }
}

/// Both of two computations locate every contact: 12 digits. The second last release is printed as 352.7364653655,
/// which the time in contact contradicts (155.2863251016 from first to second, 5.7399497916 after it); the classical
/// method in extended precision has 352.73646535555.
static void rubs(void **state) {
    static const struct {
        double gap, stiffness, friction;
        const char *study, *radius, *time, *speed, *first, *last, *closed, *x, *y;
        double count; ///< of contacts
    } known[] = {{4.0, 1.0, 0.05, "rate: 0.003 rad/s2, duration: 700 s", "10.022906757", "441.292571", "1.3238777136",
                  "309.551555367", "469.81618010", "160.26462473", "-1.28768909", ".09284857", 1.0},
                 {4.0, 2.0, 0.02, "rate: 0.005 rad/s2, duration: 500 s", "12.321112867", "322.588338", "1.6129416883",
                  "188.943563081", "352.736465356", "161.02627489", "1.17974485", "-.1519799", 2.0},
                 {4.0, 5.0, 0.1,
                  "rate: 0.003 rad/s2, speed_from: 2 rad/s, speed_to: 0.1 rad/s, begin: steady, duration: 500 s",
                  "4.80191054767", "305.560076", "1.08331977", "291.500588548", "366.625073446", "74.201688578",
                  "-.328343966", ".068588858", 2.0}};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(known); i++)
        for (size_t unit = 0; unit < 2; unit++) {
            char rub[SIZE / 8];
            snprintf(rub, sizeof rub, "rub: {at: disc, gap: %g m, stiffness: %g N/m, friction: %g, law: paper}",
                     known[i].gap, known[i].stiffness, known[i].friction);
            const double length = unit ? 3.7 : 1.0;
            whirl_result *result = run_disc(unit ? "3.7 m" : "1 m", 0.1, 1.0, rub, known[i].study);
            char at[64];
            snprintf(at, sizeof at, "rub %zu, length scale %g", i + 1, length);
            check_digits("Run-up", words("%s: largest radius", at), known[i].radius,
                         length * first_number(result, WHIRL_FIELD_RUNUP_PEAK, 0, 0));
            check_digits("Run-up", words("%s: when", at), known[i].time,
                         first_number(result, WHIRL_FIELD_RUNUP_PEAK_TIME, 0, 0));
            check_digits("Run-up", words("%s: speed there", at), known[i].speed,
                         first_number(result, WHIRL_FIELD_RUNUP_PEAK_SPEED, 0, 0));
            check_digits("Run-up", words("%s: first contact", at), known[i].first,
                         first_number(result, WHIRL_FIELD_RUNUP_CONTACT, 0, 0));
            check_digits("Run-up", words("%s: last release", at), known[i].last,
                         first_number(result, WHIRL_FIELD_RUNUP_CONTACT, 0, 1));
            check_within("Run-up", words("%s: contacts", at), known[i].count,
                         first_number(result, WHIRL_FIELD_RUNUP_CONTACT_NUMBER, 0, 0), 0.0);
            check_digits("Run-up", words("%s: time in contact", at), known[i].closed,
                         first_number(result, WHIRL_FIELD_RUNUP_CONTACT, 0, 2));
            check_digits("Run-up", words("%s: x at the end", at), known[i].x,
                         length * first_number(result, WHIRL_FIELD_RUNUP_PLACE, 0, 0));
            check_digits("Run-up", words("%s: y at the end", at), known[i].y,
                         length * first_number(result, WHIRL_FIELD_RUNUP_PLACE, 0, 1));
            whirl_result_free(result);
        }
}

// ---------------------------------------------------------------- events

/// A blade is lost at constant speed: closed form, complex exponentials in 40 digits.
static void blade_loss(void **state) {
    static const struct {
        double damping;
        const char *study, *radius, *time;
    } known[] = {{0.04, "rate: 1e-14 rad/s2, speed_from: 3 rad/s, duration: 30 s", "4.39626100286", "1.56098834404"},
                 {0.10, "rate: 1e-14 rad/s2, speed_from: 1.5 rad/s, duration: 30 s", "3.6979511037", "4.9633293014"}};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(known); i++) {
        char study[SIZE / 8];
        snprintf(study, sizeof study, "%s, loss_at: disc, loss_moment: 1 kg.m", known[i].study);
        whirl_result *result = run_disc("1 m", known[i].damping, 0.0, "gravity: 0", study);
        check_digits("Run-up", words("blade loss %zu: largest radius", i + 1), known[i].radius,
                     first_number(result, WHIRL_FIELD_RUNUP_PEAK, 0, 0));
        check_digits("Run-up", words("blade loss %zu: when", i + 1), known[i].time,
                     first_number(result, WHIRL_FIELD_RUNUP_PEAK_TIME, 0, 0));
        whirl_result_free(result);
    }
}

/// The blade is lost, and with it the drive: a machine at 3 with an unbalance of .05 gets 1, and runs down.
static void blade_loss_and_trip(void **state) {
    (void)state;
    whirl_result *result = run_disc(
        "1 m", 0.04, 0.05, "drive: {inertia: 2000 kg.m2, torque: 36 N.m, load_quadratic: 4 N.m.s2}",
        "speed_from: 3 rad/s, speed_to: 0.01 rad/s, begin: steady, settle: 400, duration: 800 s, loss_at: disc, "
        "loss_moment: 0.95 kg.m, trip_time: 1e-12 s");
    check_digits("Run-up", "trip: passing", "12.43539666", first_number(result, WHIRL_FIELD_RUNUP_PEAK, 0, 0));
    check_digits("Run-up", "trip: when", "321.60073", first_number(result, WHIRL_FIELD_RUNUP_PEAK_TIME, 0, 0));
    check_digits("Run-up", "trip: speed there", ".85917618", first_number(result, WHIRL_FIELD_RUNUP_PEAK_SPEED, 0, 0));
    check_digits("Run-up", "trip: speed at 800", ".47735942", first_number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0));
    whirl_result_free(result);
}

/// Two events at one instant both happen, at a time within a turn.
static void events_at_one_instant(void **state) {
    (void)state;
    whirl_result *result = run_disc("1 m", 0.04, 0.05, "drive: {inertia: 2000 kg.m2, torque: 36 N.m}",
                                    "speed_from: 3 rad/s, speed_to: 9 rad/s, duration: 40 s, loss_at: disc, loss_time: "
                                    "17 s, loss_moment: 0.95 kg.m, trip_time: 17 s");
    check_within("Run-up", "trip at", 17.0, first_number(result, WHIRL_FIELD_RUNUP_EVENTS, 0, 0), 1e-11);
    check_within("Run-up", "loss at", 17.0, first_number(result, WHIRL_FIELD_RUNUP_EVENTS, 0, 1), 1e-11);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- compared with a steady machine

/// A slow run through a shaft of finite elements with a disc, and bearings whose coefficients are a table over the
/// speed, meets the response at constant speed; the difference falls with the rate.
static void slow_runs_meet_the_response(void **state) {
    static const char machine[] =
        "whirl: 1\n"
        "parameters: {omega: 200 rad/s}\n"
        "rotor:\n"
        "  speed: = omega\n"
        "  length_scale: 1 mm\n"
        "  stations:\n"
        "    a: {position: 0 m}\n"
        "    b: {position: 0.6 m}\n"
        "    c: {position: 1 m}\n"
        "  elements:\n"
        "    - segment: {length: 1 m, outer: 50 mm}\n"
        "    - disc: {at: b, outer: 0.4 m, inner: 50 mm, width: 60 mm, eccentricity: 10 um}\n"
        "    - bearing: {at: a, speeds: [100 rad/s, 150 rad/s, 400 rad/s], kxx: [1e7 N/m, 2e7 N/m, 3e7 N/m], kyy: [2e7 "
        "N/m, 3e7 N/m, 5e7 N/m], cxx: [3e4 N.s/m, 2e4 N.s/m, 1e4 N.s/m], cyy: [3e4 N.s/m, 2e4 N.s/m, 1e4 N.s/m]}\n"
        "    - bearing: {at: c, kxx: 2e7 N/m, kyy: 2e7 N/m, cxx: 2e4 N.s/m, cyy: 2e4 N.s/m}\n"
        "study:\n";
    static const double rates[] = {8.0, 2.0};
    double misses[COUNT_OF(rates)] = {0.0};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(rates); i++) {
        char text[SIZE];
        snprintf(text, sizeof text,
                 "%s  runup: {rate: %g rad/s2, speed_from: 230 rad/s, speed_to: 260 rad/s, begin: steady, rows: 12, "
                 "samples: 32}\n",
                 machine, rates[i]);
        whirl_result *run = result_of_text(text);
        const double *speeds = whirl_table_field(&run->tables[0], 0, WHIRL_FIELD_RUNUP_SPEED, 0);
        const double *sizes = whirl_table_field(&run->tables[0], 0, WHIRL_FIELD_RUNUP_AMPLITUDE, 1);
        for (size_t row = 3; row < 12; row += 4) {
            snprintf(text, sizeof text, "%s  unbalance: {parameter: omega, values: [%.17g]}\n", machine, speeds[row]);
            whirl_result *steady = result_of_text(text);
            const double *response = whirl_table_field(&steady->tables[0], 0, WHIRL_FIELD_UNBALANCE_AMPLITUDE, 1);
            assert_non_null(response);
            misses[i] = fmax(misses[i], fabs(sizes[8 * row] / response[0] - 1.0));
            whirl_result_free(steady);
        }
        check_within("Run-up", words("at %g rad/s2, off the response at constant speed, share", rates[i]), 0.0,
                     misses[i], 0.02 * rates[i] / 8.0);
        whirl_result_free(run);
    }
    check_holds("Run-up", "a slower run is nearer to the response", misses[1] < 0.5 * misses[0]);
}

/// From standstill, through speeds at which dimensionless numbers, dampings and stiffnesses of a part grow differently
/// over the speed: below its critical speed a machine never moves further than its response at the highest speed.
static void parts_over_the_speed_from_standstill(void **state) {
    static const char *const parts[] = {
        "seal: {at: disc, law: black, clearance: 0.3 mm, radius: 40 mm, length: 30 mm, density: 1000, viscosity: 1e-3, "
        "pressure: 1e6}",
        "seal: {at: disc, law: black, clearance: 0.3 mm, radius: 40 mm, length: 30 mm, density: 1000, viscosity: 1e-3, "
        "pressure: 1e4}",
        "bearing: {at: disc, speeds: [0.1, 20, 60, 200], kxx: [2e6, 1e6, 1.5e6, 2e6], cxx: [9e3, 8e3, 6e3, 5e3]}"};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(parts); i++) {
        char machine[SIZE / 2], text[SIZE];
        snprintf(machine, sizeof machine,
                 "whirl: 1\n"
                 "parameters: {omega: 200}\n"
                 "rotor:\n"
                 "  speed: = omega\n"
                 "  length_scale: 1e-4\n"
                 "  stations: {disc: {mass: 10, damping: 200, eccentricity: 5e-6}}\n"
                 "  elements:\n"
                 "    - spring: {between: [disc, ground], stiffness: 1e6}\n"
                 "    - %s\n"
                 "study:\n",
                 parts[i]);
        snprintf(text, sizeof text, "%s  runup: {rate: 500, speed_to: 200, method: rodas5p}\n", machine);
        whirl_result *run = result_of_text(text);
        snprintf(text, sizeof text, "%s  unbalance: {parameter: omega, values: [200]}\n", machine);
        whirl_result *steady = result_of_text(text);
        const double *response = whirl_table_field(&steady->tables[0], 0, WHIRL_FIELD_UNBALANCE_AMPLITUDE, 0);
        assert_non_null(response);
        const double largest = first_number(run, WHIRL_FIELD_RUNUP_PEAK, 0, 0);
        check_within("Run-up", words("from standstill, largest radius over the response, %.40s", parts[i]), 1.0,
                     largest / response[0], 0.05);
        whirl_result_free(steady);
        whirl_result_free(run);
    }
}

/// A speed that falls within a turn so fast that it would reach 0 before the turn's end, had its table no corner: the
/// turns are the integral of the table.
static void falls_with_corners(void **state) {
    (void)state;
    for (int end = 80; end <= 130; end += 5) {
        char text[SIZE];
        snprintf(text, sizeof text,
                 "whirl: 1\nrotor:\n  speed: 1 rad/s\n  length_scale: 1 m\n"
                 "  stations: {disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: 0.1 m}}\n"
                 "  elements: [{spring: {between: [disc, ground], stiffness: 1 N/m}}]\n"
                 "study:\n  runup: {speeds: [[0 s, 1.2], [60 s, 1.2], [%d s, 0.35]], duration: 200 s, settle: 8}\n",
                 end);
        whirl_result *run = result_of_text(text);
        const double turns = (60.0 * 1.2 + 0.5 * (end - 60.0) * (1.2 + 0.35) + (200.0 - end) * 0.35) / two_pi;
        check_within("Run-up", words("corner at %d s, turns", end), turns,
                     first_number(run, WHIRL_FIELD_RUNUP_END_TURNS, 0, 0), 1e-10 * turns);
        whirl_result_free(run);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(falls_with_corners),
                                       cmocka_unit_test(sensitive_runs),
                                       cmocka_unit_test(two_discs_on_one_shaft),
                                       cmocka_unit_test(two_discs_otherwise),
                                       cmocka_unit_test(a_million_turns_behind),
                                       cmocka_unit_test(unbalances_written_in_other_ways),
                                       cmocka_unit_test(sommerfeld),
                                       cmocka_unit_test(stationary_speeds),
                                       cmocka_unit_test(samples_change_nothing),
                                       cmocka_unit_test(lewis),
                                       cmocka_unit_test(rubs),
                                       cmocka_unit_test(blade_loss),
                                       cmocka_unit_test(blade_loss_and_trip),
                                       cmocka_unit_test(eccentricity_appears),
                                       cmocka_unit_test(events_at_one_instant),
                                       cmocka_unit_test(slow_runs_meet_the_response),
                                       cmocka_unit_test(parts_over_the_speed_from_standstill)};
    return cmocka_run_group_tests_name("run-ups", tests, NULL, NULL);
}
