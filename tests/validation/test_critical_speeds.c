// Critical speeds without damping, all at once: against an independent program's digits at the same mesh, the exact
// ones of Timoshenko's beam by transfer matrices (forward, Friswell et al. 2010, example 5.9.1 over bearing stiffness),
// closed forms, and where modes found along the speed meet it.
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
#include "whirl/engine/case.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/rotor.h"

enum { TEXT_SIZE = 4096, MAX_SPEEDS = 32 };

static whirl_case *parse(const char *text) {
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    const whirl_status status = whirl_case_parse(text, strlen(text), "critical", &problems, &object);
    for (size_t i = 0; i < problems.count; i++) {
        char line[600];
        whirl_problem_text(&problems, i, line, sizeof line);
        print_error("%s\n", line);
    }
    require_ok(status);
    whirl_problems_free(&problems);
    return object;
}

/// Makes the case of two discs on a shaft of 1.5 m of `elements` elements, in two bearings.
static whirl_case *friswell(int elements, const char *reduction, const char *bearing, const char *study) {
    char text[TEXT_SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\nparameters: {omega: 100 rad/s, k: 1e6 N/m}\nrotor:\n  speed: = omega\n  length_scale: 1 mm\n"
             "  shafts: {main: {%s}}\n  stations:\n    left: {position: 0 m}\n"
             "    one: {position: 0.5 m, mass: 32.589728 kg, diametral: 0.17808928 kg m2, polar: 0.32956362 kg m2}\n"
             "    two: {position: 1 m, mass: 51.525261 kg, diametral: 0.42358058 kg m2, polar: 0.80508220 kg m2}\n"
             "    right: {position: 1.5 m}\n  elements:\n    - segment: {length: 1.5 m, outer: 50 mm, elements: %d}\n"
             "    - bearing: {at: left, %s}\n    - bearing: {at: right, %s}\nstudy:\n  %s\n",
             reduction, elements, bearing, bearing, study);
    return parse(text);
}

static whirl_result *run(const whirl_case *object) {
    whirl_result *result;
    require_ok(whirl_case_run(object, &(whirl_run_options){.threads = 1}, &result));
    return result;
}

/// Writes the speeds of a direction of a point, at most MAX_SPEEDS, and returns their number.
static size_t speeds_of(const whirl_result *result, size_t point, int direction, double speeds[MAX_SPEEDS]) {
    const whirl_table *table = &result->tables[0];
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED);
    const double *found = whirl_table_field(table, point, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, 0);
    const double *whirls = whirl_table_field(table, point, WHIRL_FIELD_CRITICAL_SPEEDS_DIRECTION, 0);
    size_t count = 0;
    for (size_t i = 0; i < field->rows && isfinite(found[i]) && count < MAX_SPEEDS; i++)
        if (direction == 0 || whirls[i] * direction > 0.0) speeds[count++] = found[i];
    return count;
}

static const char map[] = "critical_speeds: {parameter: k, values: [1e5, 1e6, 1e8]}";
static const double stiffness[] = {1e5, 1e6, 1e8};

/// Computes the lowest three forward speeds at every stiffness.
static void compute_map(int elements, double found[3][3]) {
    whirl_case *object = friswell(elements, "reduce: no", "kxx: = k", map);
    whirl_result *result = run(object);
    for (size_t point = 0; point < 3; point++) {
        double speeds[MAX_SPEEDS];
        assert_true(speeds_of(result, point, 1, speeds) >= 3);
        memcpy(found[point], speeds, sizeof found[point]);
    }
    whirl_result_free(result);
    whirl_case_free(object);
}

static void compare_map(const char *what, const double expected[3][3], const double found[3][3], double tolerance) {
    for (size_t point = 0; point < 3; point++)
        for (size_t i = 0; i < 3; i++)
            check_within("CS", words("%s: forward critical speed %zu at %g N/m, rad/s", what, i + 1, stiffness[point]),
                         expected[point][i], found[point][i], tolerance * expected[point][i]);
}

/// Returns the limit of meshes of 12, 24 and 48 elements; errors decrease with the square and the fourth power of their
/// length.
static double extrapolated(double a, double b, double c) {
    return (16.0 * (4.0 * c - b) - (4.0 * b - a)) / 45.0;
}

static void over_bearing_stiffness(void **unused) {
    static const double six[3][3] = {{40.319814, 110.456896, 640.147178},
                                     {86.904250, 288.616813, 925.781851},
                                     {111.624378, 446.412525, 3411.921756}};
    static const double exact[3][3] = {{40.31980128, 110.45632076, 639.893771},
                                       {86.90414706, 288.60950895, 925.007915},
                                       {111.62418131, 446.40007853, 3373.480383}};
    double coarse[3][3], fine[3][3];
    (void)unused;
    compute_map(6, coarse);
    compare_map("5.9.1, 6 elements", six, (const double(*)[3])coarse, 2e-8);
    double coarser[3][3];
    compute_map(12, coarser);
    compute_map(24, coarse);
    compute_map(48, fine);
    for (size_t i = 0; i < 9; i++)
        fine[i / 3][i % 3] = extrapolated(coarser[i / 3][i % 3], coarse[i / 3][i % 3], fine[i / 3][i % 3]);
    compare_map("5.9.1, exact (12, 24, 48 elements, extrapolated)", exact, (const double(*)[3])fine, 3e-7);
}

/// Computes the lowest three backward speeds on bearings of 1e6 N/m.
static void compute_backward(int elements, double found[MAX_SPEEDS]) {
    whirl_case *object = friswell(elements, "reduce: no", "kxx: = k", "critical_speeds: {}");
    whirl_result *result = run(object);
    assert_true(speeds_of(result, 0, -1, found) >= 3);
    whirl_result_free(result);
    whirl_case_free(object);
}

static void backward_too(void **unused) {
    static const double six[] = {86.407811, 260.517497, 563.335592};
    static const double exact[] = {86.40771082, 260.51304515, 563.276858};
    static const int elements[] = {6, 12, 24, 48};
    double speeds[4][MAX_SPEEDS];
    (void)unused;
    for (size_t i = 0; i < 4; i++) compute_backward(elements[i], speeds[i]);
    for (size_t i = 0; i < 3; i++) {
        check_within("CS", words("5.9.1, 6 elements: backward critical speed %zu, rad/s", i + 1), six[i], speeds[0][i],
                     1e-8 * six[i]);
        check_within(
            "CS", words("5.9.1, exact (12, 24, 48 elements, extrapolated): backward critical speed %zu, rad/s", i + 1),
            exact[i], extrapolated(speeds[1][i], speeds[2][i], speeds[3][i]), 3e-7 * exact[i]);
    }
}

/// Speeds at which damped frequencies equal the speed agree with those from modes that are followed. The bearings have
/// two stiffnesses, so that orbits are ellipses.
static void as_modes_meet_the_speed(void **unused) {
    static const char bearing[] = "kxx: 1 MN/m, kyy: 0.2 MN/m";
    double speeds[MAX_SPEEDS];
    size_t found = 0;
    (void)unused;
    whirl_case *direct = friswell(6, "reduce: no", bearing, "critical_speeds: {}");
    whirl_case *search = friswell(6, "reduce: no", bearing, "modes: {parameter: omega, from: 10, to: 900, points: 30}");
    whirl_result *result = run(direct), *modes = run(search);
    const size_t count = speeds_of(result, 0, 0, speeds);
    const whirl_table *table = &modes->tables[0];
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    for (size_t point = 0; point < table->count; point++) {
        const double *row = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; i < field->rows; i++, row += field->columns) {
            if (row[0] != WHIRL_CRITICAL_SPEED) continue;
            assert_true(found < count);
            check_within("CS",
                         words("5.9.3: critical speed %zu, expected by the search along the speed, rad/s", found + 1),
                         row[2], speeds[found], 1e-8 * row[2]);
            found++;
        }
    }
    check_holds("CS", "5.9.3 has six critical speeds up to 900 rad/s", found == 6 && speeds[6] > 900.0);
    whirl_result_free(result);
    whirl_result_free(modes);
    whirl_case_free(direct);
    whirl_case_free(search);
}

/// Masses on springs have equal speeds forward and backward, sqrt(k/m); two equal ones have each speed twice.
static void masses_on_springs(void **unused) {
    double speeds[MAX_SPEEDS];
    (void)unused;
    whirl_case *object = parse(
        "whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n  stations: {a: {mass: 2 kg}, b: {mass: 2 kg}, "
        "c: {mass: 5 kg}}\n  elements:\n    - bearing: {at: a, kxx: 1e6 N/m}\n    - bearing: {at: b, kxx: 1e6 N/m}\n"
        "    - bearing: {at: c, kxx: 1e6 N/m}\nstudy:\n  critical_speeds: {}\n");
    whirl_result *result = run(object);
    const double expected[] = {sqrt(2e5), sqrt(5e5), sqrt(5e5)};
    for (int direction = 1; direction >= -1; direction -= 2) {
        assert_int_equal(speeds_of(result, 0, direction, speeds), 3);
        for (size_t i = 0; i < 3; i++)
            check_within(
                "CS",
                words("masses on springs: %s critical speed %zu, rad/s", direction > 0 ? "forward" : "backward", i + 1),
                expected[i], speeds[i], 1e-12 * expected[i]);
    }
    const double *whirls = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_CRITICAL_SPEEDS_DIRECTION, 0);
    static const double directions[] = {1, -1, 1, 1, -1, -1};
    for (size_t i = 0; i < 6; i++)
        check_within("CS", words("masses on springs: direction of whirl %zu", i + 1), directions[i], whirls[i], 1e-9);
    whirl_result_free(result);
    whirl_case_free(object);
}

/// A rotor of mass m on bearings of stiffness k on a pedestal of mass s on a stiffness K, in series: at a critical
/// speed m w^2 = k (K - s w^2) / (k + K - s w^2).
static void pedestals_in_series(void **unused) {
    static const double m = 100.0, pedestal = 30.0, below = 5e7, k[] = {1e6, 2e7, 1e9};
    (void)unused;
    whirl_case *object = parse("whirl: 1\nparameters: {k: 1e6 N/m}\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n"
                               "  stations: {rotor: {mass: 100 kg}, pedestal: {mass: 30 kg}}\n  elements:\n"
                               "    - bearing: {at: rotor, from: pedestal, kxx: 7 MN/m, cxx: 10 kN.s/m}\n"
                               "    - spring: {between: [pedestal, ground], stiffness: 50 MN/m}\n"
                               "study:\n  critical_speeds: {parameter: k, values: [1e6, 2e7, 1e9], bearings: yes}\n");
    whirl_result *result = run(object);
    for (size_t i = 0; i < 3; i++) {
        // x = w^2 is a root of m s x^2 - (m (k + K) + k s) x + k K = 0.
        const double a = m * pedestal, b = m * (k[i] + below) + k[i] * pedestal, c = k[i] * below;
        const double root = sqrt(b * b - 4.0 * a * c),
                     expected[] = {sqrt(2.0 * c / (b + root)), sqrt((b + root) / (2.0 * a))};
        for (int direction = 1; direction >= -1; direction -= 2) {
            double speeds[MAX_SPEEDS];
            assert_int_equal(speeds_of(result, i, direction, speeds), 2);
            for (size_t n = 0; n < 2; n++)
                check_within("CS",
                             words("pedestal in series with bearings of %g N/m: %s critical speed %zu, rad/s", k[i],
                                   direction > 0 ? "forward" : "backward", n + 1),
                             expected[n], speeds[n], 1e-10 * expected[n]);
        }
    }
    whirl_result_free(result);
    whirl_case_free(object);
}

/// A disc on a massless cantilever: translation and tilt are coupled by the flexibility of the beam; of synchronous
/// forward whirl 1 = w^2 (m a11 + (Id - Ip) a22) - w^4 m (Id - Ip) (a11 a22 - a12^2), one positive root where Ip > Id;
/// backward with Id + Ip, two.
static void a_disc_on_a_cantilever(void **unused) {
    const double length = 0.4, modulus = 2.1e11, d = 0.03, pi = 3.14159265358979323846;
    const double bending = modulus * pi * pow(d, 4) / 64.0, mass = 12.0, diametral = 0.05, polar = 0.1;
    const double a11 = pow(length, 3) / (3 * bending), a12 = length * length / (2 * bending), a22 = length / bending;
    double speeds[MAX_SPEEDS];
    (void)unused;
    whirl_case *object =
        parse("whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n"
              "  stations: {disc: {mass: 12 kg, diametral: 0.05 kg m2, polar: 0.1 kg m2}}\n  elements:\n"
              "    - beam: {between: [ground, disc], length: 0.4 m, diameter: 30 mm, modulus: 210 GPa}\n"
              "study:\n  critical_speeds: {}\n");
    whirl_result *result = run(object);
    for (int direction = 1; direction >= -1; direction -= 2) {
        const double inertia = diametral - direction * polar, b = mass * a11 + inertia * a22;
        const double c = mass * inertia * (a11 * a22 - a12 * a12), root = sqrt(b * b - 4.0 * c);
        double expected[2];
        size_t count = 0;
        const double both[] = {(b - root) / (2.0 * c), (b + root) / (2.0 * c)};
        for (size_t i = 0; i < 2; i++)
            if (both[i] > 0.0) expected[count++] = sqrt(both[i]);
        if (count == 2 && expected[0] > expected[1]) {
            const double first = expected[0];
            expected[0] = expected[1];
            expected[1] = first;
        }
        assert_int_equal(count, direction > 0 ? 1 : 2);
        assert_int_equal(speeds_of(result, 0, direction, speeds), count);
        for (size_t i = 0; i < count; i++)
            check_within("CS",
                         words("disc on a cantilever: %s critical speed %zu, rad/s",
                               direction > 0 ? "forward" : "backward", i + 1),
                         expected[i], speeds[i], 1e-9 * expected[i]);
    }
    whirl_result_free(result);
    whirl_case_free(object);
}

/// Without bearings a shaft has four rigid-body modes, which are left out; a statement reports them.
static void free_shafts(void **unused) {
    double speeds[MAX_SPEEDS], held[MAX_SPEEDS];
    (void)unused;
    whirl_case *object = friswell(6, "reduce: no", "kxx: = k", "critical_speeds: {parameter: k, values: [0, 1e-3]}");
    whirl_result *result = run(object);
    const double *rigid = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_CRITICAL_SPEEDS_RIGID_BODY, 0);
    check_within("CS", "5.9.1 without bearings: rigid-body modes", 4.0, *rigid, 0.0);
    assert_true(speeds_of(result, 0, 1, speeds) > 0 && speeds_of(result, 1, 1, held) > 0);
    for (size_t i = 0; held[i] < 1.0; i++) // those of the soft bearings
        memmove(held + i, held + i + 1, (MAX_SPEEDS - i - 1) * sizeof *held), i--;
    check_within("CS", "5.9.1 without bearings, expected by very soft ones: lowest forward critical speed, rad/s",
                 held[0], speeds[0], 1e-6 * held[0]);
    whirl_result_free(result);
    whirl_case_free(object);
}

/// Free motions are those that nothing holds, not those that are slow compared with the stiffest part of the machine:
/// masses of 1 kg on springs of 1 N/m and of `stiff` N/m, and one that nothing holds. Closed form sqrt(k/m).
static void slow_is_not_free(void **unused) {
    static const double stiff[] = {1e4, 1e12, 1e18, 1e24};
    (void)unused;
    for (size_t i = 0; i < sizeof stiff / sizeof *stiff; i++) {
        double worst = 0.0;
        bool counted = true;
        for (size_t loose = 0; loose < 2; loose++) {
            char text[TEXT_SIZE];
            double speeds[MAX_SPEEDS];
            snprintf(text, sizeof text,
                     "whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n  stations: {a: {mass: 1 kg}, "
                     "b: {mass: 1 kg}%s}\n  elements:\n    - bearing: {at: a, kxx: 1 N/m}\n"
                     "    - bearing: {at: b, kxx: %g N/m}\nstudy:\n  critical_speeds: {}\n",
                     loose ? ", c: {mass: 1 kg}" : "", stiff[i]);
            whirl_case *object = parse(text);
            whirl_result *result = run(object);
            const double *rigid = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_CRITICAL_SPEEDS_RIGID_BODY, 0);
            counted = counted && *rigid == (loose ? 2.0 : 0.0) && speeds_of(result, 0, 1, speeds) == 2;
            if (counted) worst = fmax(worst, fmax(fabs(speeds[0] - 1.0), fabs(speeds[1] / sqrt(stiff[i]) - 1.0)));
            whirl_result_free(result);
            whirl_case_free(object);
        }
        check_holds("CS", words("1 N/m and %g N/m: no rigid-body mode, two with a loose mass", stiff[i]), counted);
        check_within("CS", words("1 N/m and %g N/m: largest relative error of the speeds", stiff[i]), 0.0, worst,
                     1e-12);
    }
}

/// Springs replace the bearings, of whatever kind, and seals and impellers are left out: the map is that of springs. It
/// also shows the stiffness of the bearings, here in proportion to the speed.
static void springs_stand_for_bearings(void **unused) {
    static const char table[] = "kxx: [2e5 N/m, 4e6 N/m], kyy: [1e5 N/m, 2e6 N/m], kxy: 1e5 N/m, cxx: 2 kN.s/m, "
                                "mxx: 5 kg, speeds: [1 rad/s, 700 rad/s]}\n"
                                "    - bearing: {at: two, role: impeller, kxy: 1e6 N/m, kyx: -1e6 N/m}\n"
                                "    - seal: {at: one, clearance: 1 mm, stiffness: 1e5 N/m, ratio: 0.4}\n"
                                "    - bearing: {at: one, role: seal, kxx: 1e6 N/m";
    static const char on_springs[] =
        "critical_speeds: {parameter: k, values: [1e5, 1e6, 1e8], bearings: yes, count: 8}";
    (void)unused;
    whirl_case *plain = friswell(6, "reduce: no", "kxx: = k", map), *own = friswell(6, "reduce: no", table, on_springs);
    whirl_result *expected = run(plain), *found = run(own);
    double worst = 0.0, speeds[2][MAX_SPEEDS], errors = 0.0;
    size_t looked = 0;
    for (size_t point = 0; point < 3; point++) {
        const size_t count = speeds_of(found, point, 0, speeds[1]);
        speeds_of(expected, point, 0, speeds[0]);
        for (size_t i = 0; i < count; i++) worst = fmax(worst, fabs(speeds[1][i] / speeds[0][i] - 1.0));
        const double *laid = whirl_table_field(&found->tables[0], point, WHIRL_FIELD_CRITICAL_SPEEDS_BEARINGS, 0);
        for (size_t i = 0; i < 6; i++) {
            const double speed = speeds[1][i], kxx = 2e5 + (speed - 1.0) / 699.0 * 3.8e6;
            const bool there = speed >= 1.0 && speed <= 700.0;
            if (isfinite(laid[2 * i]) != there) errors = INFINITY;
            if (!there) continue;
            errors = fmax(errors, fmax(fabs(laid[2 * i] / kxx - 1.0), fabs(laid[2 * i + 1] / (0.5 * kxx) - 1.0)));
            looked++;
        }
    }
    check_within("CS", "5.9.1 on springs in place of its bearings: largest relative difference of 24 speeds", 0.0,
                 worst, 1e-9);
    check_within("CS", words("stiffness of tables at %zu of these speeds, largest relative difference", looked), 0.0,
                 errors, 1e-9);
    whirl_result_free(expected);
    whirl_result_free(found);
    whirl_case_free(plain);
    whirl_case_free(own);
}

/// Finds the place where the film carries `load` times F0, by Newton's method on whirl_film_force with differences.
static void rest_in_film(double load, double at[2]) {
    const double h = 1e-6;
    at[0] = 0.3, at[1] = -0.3;
    for (int n = 0; n < 60; n++) {
        double f[2], fx[2], fy[2];
        whirl_film_force(at[0], at[1], 0.0, 0.0, f);
        whirl_film_force(at[0] + h, at[1], 0.0, 0.0, fx);
        whirl_film_force(at[0], at[1] + h, 0.0, 0.0, fy);
        const double a = (fx[0] - f[0]) / h, b = (fy[0] - f[0]) / h, c = (fx[1] - f[1]) / h, d = (fy[1] - f[1]) / h;
        const double r[2] = {f[0], f[1] - load}, det = a * d - b * c;
        at[0] -= 0.5 * (d * r[0] - b * r[1]) / det;
        at[1] -= 0.5 * (a * r[1] - c * r[0]) / det;
    }
}

/// The stiffness of a film is the derivative of its force at the journal's position of rest at that speed.
static void stiffness_of_films(void **unused) {
    (void)unused;
    whirl_case *object =
        parse("whirl: 1\nparameters: {k: 1e7 N/m}\nrotor:\n  speed: 100 rad/s\n  length_scale: 50 um\n"
              "  stations: {a: {mass: 50 kg}}\n  elements:\n"
              "    - film: {at: a, viscosity: 0.02 Pa s, radius: 25 mm, length: 20 mm, clearance: 50 um}\n"
              "    - gravity: 9.81 m/s2\nstudy:\n  critical_speeds: {parameter: k, values: [1e6, 1e7], "
              "bearings: yes}\n");
    whirl_result *result = run(object);
    for (size_t point = 0; point < 2; point++) {
        const double speed = sqrt((point ? 1e7 : 1e6) / 50.0), scale = 0.02 * speed * 0.025 * 8e-6 / (4.0 * 25e-10);
        const double *laid = whirl_table_field(&result->tables[0], point, WHIRL_FIELD_CRITICAL_SPEEDS_BEARINGS, 0);
        double at[2], up[2], down[2], speeds[MAX_SPEEDS], h = 1e-5;
        rest_in_film(50.0 * 9.81 / scale, at);
        assert_int_equal(speeds_of(result, point, 0, speeds), 2);
        check_within("CS", words("mass on a spring in place of its film: critical speed %zu, rad/s", point + 1), speed,
                     speeds[0], 1e-9 * speed);
        for (size_t c = 0; c < 2; c++) {
            whirl_film_force(at[0] + (c ? 0.0 : h), at[1] + (c ? h : 0.0), 0.0, 0.0, up);
            whirl_film_force(at[0] - (c ? 0.0 : h), at[1] - (c ? h : 0.0), 0.0, 0.0, down);
            const double expected = -scale / 50e-6 * (up[c] - down[c]) / (2.0 * h);
            check_within("CS", words("film at %.4g rad/s: %s, N/m", speed, c ? "kyy" : "kxx"), expected, laid[c],
                         1e-6 * fabs(expected));
        }
    }
    whirl_result_free(result);
    whirl_case_free(object);
}

/// Machines without such speeds are refused, with the reason.
static void refusals(void **unused) {
    static const struct {
        const char *elements, *reason;
    } rows[] = {{"    - bearing: {at: a, kxx: 1e6 N/m, kxy: 1e5 N/m, kyx: -1e5 N/m}\n", "cross-coupled"},
                {"    - film: {at: a, viscosity: 0.02 Pa s, radius: 25 mm, length: 20 mm, clearance: 50 um}\n"
                 "    - gravity\n",
                 "changes with the speed"}};
    (void)unused;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[TEXT_SIZE];
        whirl_result *result = NULL;
        snprintf(text, sizeof text,
                 "whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 50 um\n  stations: {a: {mass: 2 kg}}\n"
                 "  elements:\n%sstudy:\n  critical_speeds: {}\n",
                 rows[i].elements);
        whirl_case *object = parse(text);
        const whirl_status status = whirl_case_run(object, &(whirl_run_options){.threads = 1}, &result);
        check_holds("CS", words("critical speeds are refused: %s", rows[i].reason),
                    status.code == WHIRL_BAD_INPUT && strstr(status.message, rows[i].reason));
        whirl_result_free(result);
        whirl_case_free(object);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(over_bearing_stiffness),
        cmocka_unit_test(backward_too),
        cmocka_unit_test(as_modes_meet_the_speed),
        cmocka_unit_test(masses_on_springs),
        cmocka_unit_test(pedestals_in_series),
        cmocka_unit_test(a_disc_on_a_cantilever),
        cmocka_unit_test(free_shafts),
        cmocka_unit_test(slow_is_not_free),
        cmocka_unit_test(springs_stand_for_bearings),
        cmocka_unit_test(stiffness_of_films),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
