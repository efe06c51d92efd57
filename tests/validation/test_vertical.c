// Machines that stand: weight along the shafts, against the series of a heavy cantilever (an independent solution of
// its differential equation), Greenhill's column, the hanging chain, and sums of masses.
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
#include "whirl/engine/analyze.h"
#include "whirl/engine/case.h"
#include "whirl/engine/result.h"

enum { SIZE = 4096, TERMS = 160 };
static const char table[] = "Vertical";
static const double pi = 3.14159265358979323846;
static const double modulus = 2e11, density = 7800.0, diameter = 0.02, L = 3.0;

/// Returns the mass of the shaft per length, kg/m; `bending` is its stiffness, N m2.
static double line_mass(void) {
    return density * pi * diameter * diameter / 4.0;
}
static double bending(void) {
    return modulus * pi * pow(diameter, 4.0) / 64.0;
}

// ---------------------------------------------------------------- the heavy cantilever

/// Returns a function that is 0 at the natural frequencies of a cantilever clamped at x = 0 and free at x = 1, whose
/// weight pulls it (pull > 0: it hangs) or presses it: w'''' = pull ((1 - x) w')' + square w, by a power series about
/// the clamp; pull is q L^3/EI and square is omega^2 m L^4/EI.
static double free_end(double pull, double square) {
    long double bent[2] = {0.0L, 0.0L}, sheared[2] = {0.0L, 0.0L};
    for (int which = 0; which < 2; which++) {
        long double a[TERMS + 4] = {0.0L};
        a[2 + which] = 1.0L;
        for (int n = 0; n < TERMS; n++)
            a[n + 4] +=
                (pull * ((n + 2) * (n + 1) * a[n + 2] - (long double)(n + 1) * (n + 1) * a[n + 1]) + square * a[n]) /
                ((long double)(n + 4) * (n + 3) * (n + 2) * (n + 1));
        for (int n = 2; n < TERMS + 4; n++) {
            bent[which] += (long double)n * (n - 1) * a[n];
            sheared[which] += (long double)n * (n - 1) * (n - 2) * a[n];
        }
    }
    return (double)(bent[0] * sheared[1] - bent[1] * sheared[0]);
}

/// Returns the zero of `free_end` over the square, which is between `low` and `high`.
static double square_between(double pull, double low, double high) {
    const bool rises = free_end(pull, low) < 0.0;
    if (rises == (free_end(pull, high) < 0.0)) return NAN;
    for (int i = 0; i < 200; i++) {
        const double middle = 0.5 * (low + high);
        *((free_end(pull, middle) < 0.0) == rises ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

/// Computes a cantilever that is clamped at one of its ends; `top`: start or end.
static whirl_result *cantilever(double pull, bool clamp_at_start, const char *top, const char *more) {
    char text[SIZE];
    const double g = fabs(pull) * bending() / (line_mass() * L * L * L);
    snprintf(
        text, sizeof text,
        "whirl: 1\nrotor:\n  speed: 0 rad/s\n  length_scale: 1 mm\n"
        "  materials: {steel: {modulus: %.17g Pa, poisson: 0.3, density: %.17g kg/m3}}\n"
        "  shafts: {shaft: {material: steel, shear: none, rotary_inertia: no, gyroscopic: no, %s}}\n"
        "  stations:\n    clamp: {position: %.17g m}\n    middle: {position: %.17g m}\n    free: {position: %.17g m}\n"
        "  elements:\n    - segment: {length: %.17g m, outer: %.17g m, elements: 24}\n"
        "    - spring: {between: [clamp, ground], stiffness: 1e10 N/m}\n"
        "    - spring: {between: [clamp, ground], stiffness: 1e10, along: tilts}\n"
        "    - gravity: {acceleration: %.17g m/s2, axis: vertical, held_at: clamp, top: %s}\n"
        "study:\n  modes: {count: 8}\n",
        modulus, density, more, clamp_at_start ? 0.0 : L, 0.5 * L, clamp_at_start ? L : 0.0, L, diameter, g, top);
    return result_of_text(text);
}

/// Returns the frequency of mode `which` of one plane, rad/s; both planes have each.
static double frequency_of(const whirl_result *result, size_t which) {
    const double *all = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_MODES_FREQUENCY, 0);
    return all ? all[2 * which] : (double)NAN;
}

/// Returns omega^2 m L^4/EI of that mode.
static double square_of(const whirl_result *result, size_t which) {
    return pow(frequency_of(result, which), 2.0) * line_mass() * pow(L, 4.0) / bending();
}

/// Frequencies of a hanging and of a standing cantilever, with the shaft listed in either direction.
static void own_weight(void **state) {
    static const double weights[] = {5.0, 40.0};
    (void)state;
    for (size_t i = 0; i < sizeof weights / sizeof *weights; i++)
        for (int hangs = 0; hangs < 2; hangs++)
            for (int clamp_at_start = 0; clamp_at_start < 2; clamp_at_start++) {
                const double pull = hangs ? weights[i] : -weights[i];
                if (pull < -7.8) continue;
                // Its clamp is at the top where it hangs.
                const char *top = clamp_at_start == hangs ? "start" : "end";
                whirl_result *result = cantilever(pull, clamp_at_start, top, "reduce: no");
                for (size_t mode = 0; mode < 2; mode++) {
                    const double found = square_of(result, mode);
                    const double expected = square_between(pull, 0.99 * found, 1.01 * found);
                    check_within(
                        table,
                        words("weight q L^3/EI = %g, top at the %s: omega^2 m L^4/EI of mode %zu", pull, top, mode + 1),
                        expected, found, 5e-6 * expected);
                }
                whirl_result_free(result);
            }
}

/// A column buckles under its own weight at q L^3/EI = 7.8373474 (Greenhill 1881, of the first zero of J_-1/3).
static void greenhill(void **state) {
    static const double critical = 7.8373474;
    (void)state;
    for (int beyond = 0; beyond < 2; beyond++) {
        whirl_result *result = cantilever(-critical * (beyond ? 1.0 + 1e-4 : 1.0 - 1e-4), true, "end", "reduce: no");
        const double growth = table_number(&result->tables[0], 0, WHIRL_FIELD_MODES_STABILITY, 0);
        // omega^2 m L^4/EI falls nearly in proportion, from 12.36 without weight to 0: 1e-4 of that away from the
        // point.
        const double rate = sqrt(12.36e-4 * bending() / (line_mass() * pow(L, 4.0)));
        if (beyond) {
            check_within(table, "a column of Greenhill's weight plus 1e-4 of it falls over: rate, 1/s", rate, growth,
                         0.02 * rate);
        } else {
            check_within(table, "a column of Greenhill's weight less 1e-4 of it sways: frequency, rad/s", rate,
                         frequency_of(result, 0), 0.02 * rate);
            check_holds(table, "and does not fall over", growth < 1e-3 * rate);
        }
        whirl_result_free(result);
    }
}

/// A thin shaft that hangs from one bearing swings as a chain: j_0,1/2 sqrt(g/L); what it bends adds a share of
/// (EI/q L^3)^(1/2) at most.
static void chain(void **state) {
    char text[SIZE];
    (void)state;
    snprintf(text, sizeof text,
             "whirl: 1\nrotor:\n  speed: 0 rad/s\n  length_scale: 1 mm\n"
             "  materials: {steel: {modulus: %.17g Pa, poisson: 0.3, density: %.17g kg/m3}}\n"
             "  shafts: {shaft: {material: steel, reduce: no}}\n"
             "  stations: {top: {position: 0 m}, bottom: {position: 40 m}}\n"
             "  elements:\n    - segment: {length: 40 m, outer: 2 mm, elements: 80}\n"
             "    - bearing: {at: top, kxx: 1e9 N/m}\n"
             "    - gravity: {acceleration: 9.81 m/s2, axis: vertical, held_at: top}\n"
             "study:\n  modes: {count: 8}\n",
             modulus, density);
    whirl_result *result = result_of_text(text);
    const double zeros[] = {2.404825557695773, 5.520078110286311};
    const double share =
        sqrt(modulus * pi * pow(0.002, 4.0) / 64.0 / (density * pi * 0.002 * 0.002 / 4.0 * 9.81 * pow(40.0, 3.0)));
    for (size_t mode = 0; mode < 2; mode++) {
        const double expected = 0.5 * zeros[mode] * sqrt(9.81 / 40.0);
        check_within(table, words("hanging chain: frequency %zu, rad/s", mode + 1), expected,
                     frequency_of(result, mode), share * expected);
    }
    whirl_result_free(result);
}

// ---------------------------------------------------------------- axial forces and bearings

/// Returns number `which` of a field of statics at a station.
static double at(const whirl_result *result, const char *field, size_t station, size_t which) {
    const double *numbers = whirl_table_field(&result->tables[0], 0, field, station);
    return numbers ? numbers[which] : (double)NAN;
}

/// Two layers, a coupling, an impeller and a given axial force: what is below a place hangs on it, what is above
/// presses it; bearings carry nothing across.
static void axial_forces(void **state) {
    static const double g = 9.81, given = 1000.0;
    char text[SIZE];
    (void)state;
    for (int mirrored = 0; mirrored < 2; mirrored++) {
        snprintf(text, sizeof text,
                 "whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n"
                 "  materials: {steel: {modulus: %.17g Pa, poisson: 0.3, density: %.17g kg/m3}}\n"
                 "  shafts: {shaft: {material: steel}}\n"
                 "  stations: {a: {position: %g m, mass: 2 kg}, b: {position: %g m, mass: 40 kg}, c: {position: %g m}, "
                 "d: {position: %g m, mass: 10 kg}}\n"
                 "  elements:\n    - segment: {start: %g m, length: 1.2 m, outer: 20 mm, axial_force: %g N}\n"
                 "    - segment: {start: %g m, length: 0.8 m, outer: 20 mm}\n"
                 "    - segment: {start: %g m, length: 0.7 m, outer: 30 mm, inner: 20 mm}\n"
                 "    - bearing: {at: b, kxx: 1e7 N/m}\n    - bearing: {at: d, kxx: 1e7 N/m}\n"
                 "    - gravity: {acceleration: %g m/s2, axis: vertical, held_at: c, top: %s}\n"
                 "study:\n  statics: {}\n",
                 modulus, density, mirrored ? 2.0 : 0.0, mirrored ? 1.5 : 0.5, mirrored ? 0.8 : 1.2,
                 mirrored ? 0.0 : 2.0, mirrored ? 0.8 : 0.0, given, mirrored ? 0.0 : 1.2, mirrored ? 0.8 : 0.5, g,
                 mirrored ? "end" : "start");
        whirl_result *result = result_of_text(text);
        const char *which = mirrored ? "mirrored" : "as given";
        const double m = line_mass(), sleeve = density * pi * (0.03 * 0.03 - 0.02 * 0.02) / 4.0;
        const double mass = 2.0 * m + 0.7 * sleeve + 52.0, above = 1.2 * m + 0.7 * sleeve + 42.0;
        const double expected[4][2] = {{0.0, given - 2.0 * g},
                                       {given - g * (0.5 * m + 2.0), given - g * (0.5 * m + 42.0)},
                                       {given - g * above, g * (0.8 * m + 10.0)},
                                       {g * 10.0, 0.0}};
        for (size_t station = 0; station < 4; station++)
            for (size_t side = 0; side < 2; side++)
                check_within(table,
                             words("axial force, %s: station %zu, %s, N", which, station + 1, side ? "below" : "above"),
                             expected[station][side],
                             at(result, WHIRL_FIELD_STATICS_AXIAL_FORCE, station, mirrored ? 1 - side : side), 1e-9);
        check_within(table, words("%s: mass that is held, kg", which), mass,
                     at(result, WHIRL_FIELD_STATICS_THRUST_MASS, 2, 0), 1e-9);
        check_within(table, words("%s: axial load where it is held, N", which), g * mass,
                     at(result, WHIRL_FIELD_STATICS_THRUST, 2, 0), 1e-9);
        check_holds(table, words("%s: no other station holds it, bearings carry nothing and nothing sags", which),
                    isnan(at(result, WHIRL_FIELD_STATICS_THRUST, 0, 0)) &&
                        at(result, WHIRL_FIELD_STATICS_LOAD, 1, 0) == 0.0 &&
                        at(result, WHIRL_FIELD_STATICS_LOAD, 3, 0) == 0.0 &&
                        at(result, WHIRL_FIELD_STATICS_DEFLECTION, 0, 0) == 0.0 &&
                        at(result, WHIRL_FIELD_STATICS_MOMENT, 2, 0) == 0.0);
        whirl_result_free(result);
    }
}

/// Three bearings a span l apart, the middle one raised by e: it carries 48 EI e/(2 l)^3 where no weight acts across;
/// masses to both sides are those of a shaft that lies.
static void raised_without_weight(void **state) {
    static const char *const gravities[] = {"", "    - gravity: 0 m/s2\n",
                                            "    - gravity: {acceleration: 1e-6 m/s2, axis: vertical, held_at: b}\n"};
    static const double l = 1.5, e = 1e-3;
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        char text[SIZE];
        snprintf(text, sizeof text,
                 "whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n"
                 "  materials: {steel: {modulus: %.17g Pa, poisson: 0.3, density: %.17g kg/m3}}\n"
                 "  shafts: {shaft: {material: steel, shear: none}}\n"
                 "  stations: {a: {position: 0 m}, b: {position: 1.5 m}, c: {position: 3 m}}\n"
                 "  elements:\n    - segment: {length: 3 m, outer: %.17g m, elements: 8}\n"
                 "    - bearing: {at: a, kxx: 1e7 N/m}\n    - bearing: {at: b, kxx: 1e7 N/m, elevation: %.17g m}\n"
                 "    - bearing: {at: c, kxx: 1e7 N/m}\n%sstudy:\n  statics: {}\n",
                 modulus, density, diameter, e, gravities[i]);
        whirl_result *result = result_of_text(text);
        const double force = 48.0 * bending() * e / pow(2.0 * l, 3.0);
        check_within(table, words("raised bearing without weight (%zu): its load, N", i), force,
                     at(result, WHIRL_FIELD_STATICS_LOAD, 1, 0), 1e-8 * force);
        check_within(table, words("raised bearing without weight (%zu): load of the next, N", i), -0.5 * force,
                     at(result, WHIRL_FIELD_STATICS_LOAD, 2, 0), 1e-8 * force);
        check_within(table, words("raised bearing without weight (%zu): how far it is up, mm", i), 1e3 * e,
                     at(result, WHIRL_FIELD_STATICS_DEFLECTION, 1, 0), 1e-12);
        check_within(table, words("raised bearing without weight (%zu): mass to its left, kg", i), 1.5 * line_mass(),
                     at(result, WHIRL_FIELD_STATICS_MASS, 1, 0), 1e-9);
        whirl_result_free(result);
    }
}

/// Critical speeds keep the weight along the shaft where springs stand for its bearings, and in reduced shafts.
static void on_springs(void **state) {
    char text[SIZE];
    (void)state;
    snprintf(text, sizeof text,
             "whirl: 1\nparameters: {k: 0.1 MN/m}\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n"
             "  materials: {steel: {modulus: %.17g Pa, poisson: 0.3, density: %.17g kg/m3}}\n"
             "  shafts: {shaft: {material: steel, modes: 12}}\n"
             "  stations: {a: {position: 0 m}, b: {position: 1.5 m, mass: 60 kg}, c: {position: 3 m}}\n"
             "  elements:\n    - segment: {length: 3 m, outer: 20 mm, elements: 16}\n"
             "    - bearing: {at: a, kxx: = k}\n    - bearing: {at: c, kxx: = k}\n"
             "    - gravity: {axis: vertical, held_at: a}\n"
             "study:\n  critical_speeds:\n    - {name: own, parameter: k, values: [0.1 MN/m], count: 2}\n"
             "    - {name: springs, parameter: k, values: [0.1 MN/m], bearings: yes, count: 2}\n",
             modulus, density);
    whirl_result *result = result_of_text(text);
    const double own = table_number(&result->tables[0], 0, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, 0);
    check_within(table, "a disc that hangs: first critical speed on springs in place of its bearings, rad/s", own,
                 table_number(&result->tables[1], 0, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, 0), 1e-9 * own);
    // A massless string under T above the disc and nothing below would add 2 T/L to the 48 EI/L^3 of its bending.
    const double without = sqrt(48.0 * bending() / pow(3.0, 3.0) / (60.0 + 0.5 * 3.0 * line_mass()));
    check_holds(table, "a disc that hangs has a higher critical speed than the bending of its shaft gives",
                own > 1.05 * without);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(own_weight),
        cmocka_unit_test(greenhill),
        cmocka_unit_test(chain),
        cmocka_unit_test(axial_forces),
        cmocka_unit_test(raised_without_weight),
        cmocka_unit_test(on_springs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
