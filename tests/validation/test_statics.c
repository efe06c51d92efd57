// Effect of the weight on shafts, against closed forms: sag, moments and loads of uniform beams, influence of
// elevations, and the alignment of two rotors at a rigid coupling.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine/rotor.h"

enum { MAX_STATIONS = 8 };
static const double g = 9.80665, modulus = 2.1e11, density = 7800.0, diameter = 0.3;
static const double pi = 3.14159265358979323846;

/// Returns the mass of the shaft per length, kg/m; `bending` is its stiffness, N m2.
static double line_mass(void) {
    return density * pi * diameter * diameter / 4.0;
}
static double bending(void) {
    return modulus * pi * pow(diameter, 4.0) / 64.0;
}

static whirl_setting number(const char *key, double value) {
    return (whirl_setting){.key = key, .number = value};
}

static whirl_setting word(const char *key, const char *value) {
    return (whirl_setting){.key = key, .text = value};
}

/// Checks a number to a relative tolerance.
static void check_relative(const char *id, const char *what, double expected, double obtained, double share) {
    check_within(id, what, expected, obtained, share * fabs(expected));
}

/// Computes a uniform shaft without shear, with stations at rising places and bearings at those of `bearing`; the mesh
/// has `elements` pieces between two stations. mass: of the last station.
static whirl_status lay(double length, size_t count, const double *places, const bool *bearing, int elements,
                        double mass, const char *couplings, whirl_station_statics *out, double *influence) {
    static const char *const names[MAX_STATIONS] = {"a", "b", "c", "d", "e", "f", "g", "h"};
    whirl_design *design;
    assert_int_equal(whirl_design_new(100.0, 1e-3, &design).code, WHIRL_OK);
    const whirl_setting steel[] = {number("modulus", modulus), number("poisson", 0.3), number("density", density)};
    const whirl_setting shaft[] = {word("shear", "none"), word("material", "steel")};
    assert_int_equal(whirl_design_material(design, "steel", steel, 3).code, WHIRL_OK);
    assert_int_equal(whirl_design_shaft(design, "shaft", shaft, 2).code, WHIRL_OK);
    for (size_t i = 0; i < count; i++) {
        const whirl_setting at[] = {number("position", places[i]), number("mass", mass)};
        assert_int_equal(whirl_design_station(design, names[i], at, mass > 0.0 && i + 1 == count ? 2 : 1).code,
                         WHIRL_OK);
    }
    const whirl_setting segment[] = {number("length", length), number("outer", diameter), number("elements", elements)};
    assert_int_equal(whirl_design_element(design, "segment", segment, 3).code, WHIRL_OK);
    for (size_t i = 0; i < count; i++) {
        const whirl_setting spring[] = {word("at", names[i]), number("kxx", 1e8)};
        if (bearing[i]) assert_int_equal(whirl_design_element(design, "bearing", spring, 2).code, WHIRL_OK);
    }
    assert_int_equal(whirl_design_element(design, "gravity", NULL, 0).code, WHIRL_OK);
    const whirl_status status = whirl_design_statics(design, couplings, out, influence);
    whirl_design_free(design);
    return status;
}

/// A beam on two bearings with a mass that hangs over.
static void beam_with_overhang(void **unused) {
    static const double places[] = {0.0, 1.0, 2.0, 2.5}, L = 2.0, a = 0.5, m = 120.0;
    static const bool bearing[] = {true, false, true, false};
    whirl_station_statics at[MAX_STATIONS];
    double influence[MAX_STATIONS * MAX_STATIONS];
    (void)unused;
    assert_int_equal(lay(2.5, 4, places, bearing, 5, m, "", at, influence).code, WHIRL_OK);
    const double q = line_mass() * g, P = m * g, EI = bending();
    const double right = (q * 2.5 * 2.5 / 2.0 + P * 2.5) / L, left = q * 2.5 + P - right;
    const double end = -q * a * a / 2.0 - P * a, middle = q * L * L / 8.0 + end / 2.0;
    check_relative("B14", "overhanging beam: load of the left bearing, N", left, at[0].load, 1e-9);
    check_relative("B14", "overhanging beam: load of the right bearing, N", right, at[2].load, 1e-9);
    check_relative("B14", "overhanging beam: moment at the right bearing, N m", end, at[2].moment, 1e-9);
    check_relative("B14", "overhanging beam: moment in the middle, N m", middle, at[1].moment, 1e-9);
    check_relative("B14", "overhanging beam: deflection in the middle, m",
                   -5.0 * q * pow(L, 4.0) / (384.0 * EI) - end * L * L / (16.0 * EI), at[1].deflection, 1e-9);
    check_relative("B14", "overhanging beam: mass beyond the right bearing, kg", line_mass() * a + m, at[2].mass[1],
                   1e-9);
    check_relative("B14", "overhanging beam: mass left of the middle, kg", line_mass(), at[1].mass[0], 1e-9);
    check_within("B14", "overhanging beam: load by raising its bearings, N/m", 0.0, influence[2], 1e-3);
}

/// Three equal bearings: 3/16, 10/16 and 3/16 of the weight; raising the middle one by e brings it 48 EI e/(2 l)^3.
static void three_bearings(void **unused) {
    static const double places[] = {0.0, 2.0, 4.0}, l = 2.0;
    static const bool bearing[] = {true, true, true};
    whirl_station_statics at[MAX_STATIONS];
    double influence[MAX_STATIONS * MAX_STATIONS];
    (void)unused;
    assert_int_equal(lay(4.0, 3, places, bearing, 4, 0.0, "", at, influence).code, WHIRL_OK);
    const double weight = line_mass() * g * 4.0;
    check_relative("B14", "three bearings: load of the first, share of the weight", 3.0 / 16.0, at[0].load / weight,
                   1e-9);
    check_relative("B14", "three bearings: load of the second, share of the weight", 10.0 / 16.0, at[1].load / weight,
                   1e-9);
    check_relative("B14", "three bearings: load of the second by raising it, N/m", 48.0 * bending() / pow(2.0 * l, 3.0),
                   influence[1 * 3 + 1], 1e-9);
    check_relative("B14", "three bearings: load of the first by raising the second, N/m",
                   -24.0 * bending() / pow(2.0 * l, 3.0), influence[0 * 3 + 1], 1e-9);
}

/// Two equal rotors, each on two bearings a span L apart, joined rigidly at the ends of their overhangs a.
static void aligned_rotors(void **unused) {
    static const double L = 3.0, a = 0.4;
    static const double places[] = {0.0, 3.0, 3.4, 3.8, 6.8};
    static const bool bearing[] = {true, true, false, true, true};
    whirl_station_statics at[MAX_STATIONS];
    double influence[MAX_STATIONS * MAX_STATIONS];
    (void)unused;
    assert_int_equal(lay(6.8, 5, places, bearing, 4, 0.0, "c", at, influence).code, WHIRL_OK);
    const double q = line_mass() * g,
                 slope = q * (pow(L, 3.0) / 24.0 - a * a * L / 6.0 - pow(a, 3.0) / 6.0) / bending();
    check_relative("B14", "two rotors: slope of a face, rad", 6.697827798519e-5, slope, 1e-12);
    check_relative("B14", "two rotors: slope at the coupling, of the first", slope, at[2].slope, 1e-8);
    check_relative("B14", "two rotors: inner bearing of the second, m", 5.358262239e-5, at[3].elevation, 1e-8);
    check_relative("B14", "two rotors: outer bearing of the second, m", 4.554522903e-4, at[4].elevation, 1e-8);
    check_within("B14", "two rotors: moment at the coupling over that in the spans", 0.0,
                 at[2].moment / (q * L * L / 8.0), 1e-7);
    check_within("B14", "two rotors: shear at the coupling over a bearing's load", 0.0, at[2].shear[0] / (q * (L + a)),
                 1e-7);
    const double inner = q * (L + a) * (L + a) / (2.0 * L),
                 loads[] = {q * (L + a) - inner, inner, NAN, inner, q * (L + a) - inner};
    for (size_t i = 0; i < 5; i++)
        if (bearing[i])
            check_relative("B14", words("two rotors: load of bearing %zu, N", i), loads[i], at[i].load, 1e-7);
}

/// A sleeve on a shaft: the moment and the masses are those of both, and so is the load.
static void two_layers(void **unused) {
    static const double L = 2.0, sleeve = 0.4;
    whirl_design *design;
    whirl_station_statics at[3];
    double influence[9];
    (void)unused;
    assert_int_equal(whirl_design_new(100.0, 1e-3, &design).code, WHIRL_OK);
    const whirl_setting steel[] = {number("modulus", modulus), number("poisson", 0.3), number("density", density)};
    const whirl_setting shaft[] = {word("shear", "none"), word("material", "steel")};
    assert_int_equal(whirl_design_material(design, "steel", steel, 3).code, WHIRL_OK);
    assert_int_equal(whirl_design_shaft(design, "shaft", shaft, 2).code, WHIRL_OK);
    for (size_t i = 0; i < 3; i++) {
        const whirl_setting place = number("position", 0.5 * L * (double)i);
        assert_int_equal(whirl_design_station(design, (const char *[]){"a", "b", "c"}[i], &place, 1).code, WHIRL_OK);
    }
    const whirl_setting inner[] = {number("length", L), number("outer", diameter)};
    const whirl_setting outer[] = {number("length", L), number("start", 0.0), number("outer", sleeve),
                                   number("inner", diameter)};
    assert_int_equal(whirl_design_element(design, "segment", inner, 2).code, WHIRL_OK);
    assert_int_equal(whirl_design_element(design, "segment", outer, 4).code, WHIRL_OK);
    for (size_t i = 0; i < 3; i += 2) {
        const whirl_setting spring[] = {word("at", i == 0 ? "a" : "c"), number("kxx", 1e8)};
        assert_int_equal(whirl_design_element(design, "bearing", spring, 2).code, WHIRL_OK);
    }
    assert_int_equal(whirl_design_element(design, "gravity", NULL, 0).code, WHIRL_OK);
    assert_int_equal(whirl_design_statics(design, "", at, influence).code, WHIRL_OK);
    whirl_design_free(design);
    const double line = density * pi * sleeve * sleeve / 4.0;
    check_relative("B14", "two layers: load of a bearing, N", 0.5 * line * g * L, at[0].load, 1e-9);
    check_relative("B14", "two layers: moment in the middle, N m", line * g * L * L / 8.0, at[1].moment, 1e-9);
    check_relative("B14", "two layers: mass left of the middle, kg", 0.5 * line * L, at[1].mass[0], 1e-9);
}

static void wrong_input_is_refused(void **unused) {
    static const double places[] = {0.0, 1.0, 2.0};
    static const bool two[] = {true, false, true}, one[] = {true, false, false};
    whirl_station_statics at[MAX_STATIONS];
    double influence[MAX_STATIONS * MAX_STATIONS];
    (void)unused;
    whirl_status status = lay(2.0, 3, places, one, 2, 0.0, "", at, influence);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, "shaft 'shaft' lies on 1 bearing, expected two at least for its weight");
    status = lay(2.0, 3, places, two, 2, 0.0, "b", at, influence);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, "no elevations of 0 bearings behind the first two relieve 1 coupling of moment "
                                        "and shear, expected two a coupling at least");
    status = lay(2.0, 3, places, two, 2, 0.0, "x", at, influence);
    assert_string_equal(status.message, "coupling: 'x' is no station");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(beam_with_overhang),     cmocka_unit_test(three_bearings),
        cmocka_unit_test(aligned_rotors),         cmocka_unit_test(two_layers),
        cmocka_unit_test(wrong_input_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
