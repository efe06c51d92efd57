// Shafts and bearings at rest, against closed forms: journals in their films, bent shafts that turn, raised bearings,
// and the first critical speed on rigid supports with the screening diagram of stability.
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
#include "whirl/engine/rotor.h"
#include "whirl/internal/response_peaks.h"

enum { SIZE = 4096 };
static const double pi = 3.14159265358979323846, g = 9.80665;

static void relative(const char *table, const char *what, double expected, double obtained, double share) {
    check_within(table, what, expected, obtained, share * fabs(expected));
}

// ---------------------------------------------------------------- journals in films

/// A shaft between two films rests at the eccentricity ratio at which each film carries half of the weight.
static void films(void **state) {
    static const double ratios[] = {0.2, 0.6, 0.85};
    (void)state;
    for (size_t i = 0; i < 3; i++)
        for (int clockwise = 0; clockwise < 2; clockwise++) {
            char text[SIZE];
            double force[2];
            const double e = ratios[i], phi = atan2(pi * sqrt(1.0 - e * e), 4.0 * e);
            whirl_film_force(e * sin(phi), -e * cos(phi), 0.0, 0.0, force);
            const double mass = 200.0 + 7800.0 * pi * 0.1 * 0.1 / 4.0,
                         load = 0.5 * mass * g / hypot(force[0], force[1]);
            snprintf(text, sizeof text,
                     "whirl: 1\nrotor:\n  speed: 300 rad/s\n  rotation: %s\n  length_scale: 0.1 mm\n"
                     "  materials: {steel: {modulus: 200 GPa, poisson: 0.3, density: 7800 kg/m3}}\n"
                     "  shafts: {shaft: {material: steel}}\n  stations:\n    left: {position: 0 m}\n    disc: "
                     "{position: 0.5 m, mass: 200 kg}\n"
                     "    right: {position: 1 m}\n  elements:\n    - segment: {length: 1 m, outer: 100 mm}\n"
                     "    - film: {at: left, clearance: 0.2 mm, load: %.17g N}\n"
                     "    - film: {at: right, clearance: 0.2 mm, load: %.17g N}\n    - gravity: %.17g m/s2\n"
                     "study:\n  statics: {}\n",
                     clockwise ? "clockwise" : "counter-clockwise", load, load, g);
            whirl_result *result = result_of_text(text);
            const whirl_table *table = &result->tables[0];
            const char *way = clockwise ? "clockwise" : "counter-clockwise";
            relative("Films at rest", words("eccentricity ratio %g, %s: found", e, way), e,
                     whirl_table_number(table, 0, WHIRL_FIELD_STATICS_ECCENTRICITY, 0), 1e-9);
            relative("Films at rest", words("eccentricity ratio %g, %s: attitude, deg", e, way), phi * 180.0 / pi,
                     whirl_table_number(table, 0, WHIRL_FIELD_STATICS_ATTITUDE, 2), 1e-8);
            relative("Films at rest", words("eccentricity ratio %g, %s: least thickness, mm", e, way), 0.2 * (1.0 - e),
                     0.1 * whirl_table_number(table, 0, WHIRL_FIELD_STATICS_FILM, 2), 1e-8);
            check_holds("Films at rest", "no film at the disc",
                        isnan(whirl_table_number(table, 0, WHIRL_FIELD_STATICS_FILM, 1)));
            whirl_result_free(result);
        }
}

// ---------------------------------------------------------------- journals in housings that move

/// Computes eccentricity ratio, attitude and least thickness of the film at a station.
static void film_state(const char *text, size_t station, double out[3]) {
    static const char *const names[] = {WHIRL_FIELD_STATICS_ECCENTRICITY, WHIRL_FIELD_STATICS_ATTITUDE,
                                        WHIRL_FIELD_STATICS_FILM};
    whirl_result *result = result_of_text(text);
    for (size_t i = 0; i < 3; i++) out[i] = whirl_table_number(&result->tables[0], 0, names[i], station);
    whirl_result_free(result);
}

/// Returns the text of a case: a disc of 40 kg between two bearings. Each has a housing of 5 kg on a spring k, or one
/// that does not move (k = 0). Floating rings are at stations "ring_left" and "ring_right".
static const char *in_housings(const char *bearing, const char *inner, bool clockwise, double k) {
    static char text[SIZE];
    static const char *const sides[] = {"left", "right"};
    const bool ring = strcmp(bearing, "floating_ring") == 0;
    size_t used = (size_t)snprintf(text, sizeof text,
                                   "whirl: 1\nrotor:\n  speed: 300 rad/s\n  rotation: %s\n  length_scale: 0.1 mm\n"
                                   "  materials: {light: {modulus: 200 GPa, poisson: 0.3, density: 1e-4 kg/m3}}\n"
                                   "  shafts: {shaft: {material: light}}\n  stations:\n    left: {position: 0 m}\n"
                                   "    disc: {position: 0.1 m, mass: 40 kg}\n    right: {position: 0.2 m}\n",
                                   clockwise ? "clockwise" : "counter-clockwise");
    for (size_t i = 0; i < 2; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s%s%s%s%s", ring ? "    ring_" : "",
                                 ring ? sides[i] : "", ring ? ": {mass: 0.4 kg}\n" : "", k > 0.0 ? "    housing_" : "",
                                 k > 0.0 ? sides[i] : "", k > 0.0 ? ": {mass: 5 kg}\n" : "");
    used += (size_t)snprintf(text + used, sizeof text - used,
                             "  elements:\n    - gravity: {}\n    - segment: {length: 0.2 m, outer: 40 mm}\n");
    for (size_t i = 0; i < 2; i++) {
        used += (size_t)snprintf(text + used, sizeof text - used, "    - %s: {at: %s%s%s%s%s, %s}\n", bearing, sides[i],
                                 ring ? ", ring: ring_" : "", ring ? sides[i] : "", k > 0.0 ? ", from: housing_" : "",
                                 k > 0.0 ? sides[i] : "", inner);
        if (k > 0.0)
            used += (size_t)snprintf(text + used, sizeof text - used,
                                     "    - spring: {between: [housing_%s, ground], stiffness: %.17g}\n", sides[i], k);
    }
    snprintf(text + used, sizeof text - used, "study:\n  statics: {}\n");
    return text;
}

/// A film carries the same load in a housing on springs as in a fixed one, so its eccentricity is the same. The springs
/// yield by .025 and by 2500 clearances.
static void films_in_housings(void **state) {
#define OIL_IN "clearance: 0.1 mm, viscosity: 10 mPa.s, radius: 20 mm, length: 20 mm"
    static const struct {
        const char *name, *bearing, *inner;
    } bearings[] = {{"short film", "film", "law: short, " OIL_IN},
                    {"film of finite length", "film", "law: finite, " OIL_IN},
                    {"pads", "pad_bearing", "shape: three-lobe, preload: 0.4, " OIL_IN},
                    {"tilting pads", "tilting_pad", "shape: tilting-4, preload: 0.3, " OIL_IN},
                    {"floating ring", "floating_ring",
                     "inertia: 1e-5 kg.m2, outer_clearance: 0.12 mm, outer_radius: 26 mm, "
                     "outer_length: 20 mm, " OIL_IN}};
    static const double k[] = {1e8, 1e3};
    (void)state;
    for (size_t i = 0; i < sizeof bearings / sizeof *bearings; i++)
        for (int clockwise = 0; clockwise < 2; clockwise++) {
            double stands[3], moves[3];
            film_state(in_housings(bearings[i].bearing, bearings[i].inner, clockwise, 0.0), 0, stands);
            for (size_t n = 0; n < 2; n++) {
                film_state(in_housings(bearings[i].bearing, bearings[i].inner, clockwise, k[n]), 0, moves);
                const char *const what = words("%s, %s, housing on %g N/m", bearings[i].name,
                                               clockwise ? "clockwise" : "counter-clockwise", k[n]);
                relative("Films in housings", words("%s: eccentricity ratio", what), stands[0], moves[0], 1e-6);
                check_within("Films in housings", words("%s: attitude, deg", what), stands[1], moves[1], 1e-4);
                relative("Films in housings", words("%s: least thickness", what), stands[2], moves[2], 1e-6);
            }
        }
}

/// Returns the load of a short film that covers half of the circumference (Ocvirk), over mu omega R L (L/c)^2. If both
/// sides turn, omega is the sum of their speeds.
static double short_load(double e) {
    const double q = 1.0 - e * e;
    return e * sqrt(16.0 * e * e + pi * pi * q) / (4.0 * q * q);
}

/// Returns the eccentricity ratio at which short_load is `load`.
static double short_place(double load) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 100; i++) *(short_load(0.5 * (low + high)) < load ? &low : &high) = 0.5 * (low + high);
    return low;
}

/// Closed forms of the short film in a housing that moves, and of both films of a floating ring: their loads, and
/// Petroff's drags, which balance at the speed of the ring.
static void housings_closed(void **state) {
    const double mu = 0.01, c[] = {1e-4, 1.2e-4}, R[] = {0.02, 0.026}, L = 0.02, mass = 20.0, ring_mass = 0.4;
    double size[2], drag[2], e[2], low = 0.0, high = 1.0, found[3];
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        size[i] = mu * 300.0 * R[i] * L * L * L / (c[i] * c[i]);
        drag[i] = pow(R[i], 3.0) / c[i];
    }
    film_state(in_housings("film", "law: short, " OIL_IN, false, 1e4), 0, found);
    const double alone = short_place(mass * g / size[0]);
    relative("Films in housings", "short film on 1e4 N/m, Ocvirk: eccentricity ratio", alone, found[0], 1e-6);
    relative("Films in housings", "short film on 1e4 N/m, Ocvirk: attitude, deg",
             atan2(pi * sqrt(1.0 - alone * alone), 4.0 * alone) * 180.0 / pi, found[1], 1e-5);
    relative("Films in housings", "short film on 1e4 N/m, Ocvirk: least thickness", 1.0 - alone, found[2], 1e-5);
    for (int i = 0; i < 100; i++) {
        const double r = 0.5 * (low + high);
        e[0] = short_place(mass * g / ((1.0 + r) * size[0]));
        e[1] = short_place((mass + ring_mass) * g / (r * size[1]));
        const double drive = drag[0] * (1.0 - r) / sqrt(1.0 - e[0] * e[0]),
                     hold = drag[1] * r / sqrt(1.0 - e[1] * e[1]);
        *(drive > hold ? &low : &high) = r;
    }
    const char *const inner = "inertia: 1e-5 kg.m2, outer_clearance: 0.12 mm, outer_radius: 26 mm, "
                              "outer_length: 20 mm, " OIL_IN;
    for (size_t i = 0; i < 2; i++) {
        const char *const name = i == 0 ? "within a ring" : "around a ring";
        film_state(in_housings("floating_ring", inner, false, 1e5), i == 0 ? 0 : 3, found);
        relative("Films in housings", words("%s: eccentricity ratio", name), e[i], found[0], 1e-6);
        relative("Films in housings", words("%s: attitude, deg", name),
                 atan2(pi * sqrt(1.0 - e[i] * e[i]), 4.0 * e[i]) * 180.0 / pi, found[1], 1e-5);
        relative("Films in housings", words("%s: least thickness", name), (1.0 - e[i]) * c[i] / 1e-4, found[2], 1e-5);
    }
}

// ---------------------------------------------------------------- bows

/// Computes the unbalance response of a shaft almost without mass, bent by `bow` in the middle, with a disc of 50 kg
/// there and springs as bearings.
static whirl_result *bent(double bow, double angle, double eccentricity, double ratio, double *stiffness) {
    const double modulus = 200e9, d = 0.04, kb = 5e7, mass = 50.0, zeta = 0.05;
    const double shaft = 48.0 * modulus * pi * pow(d, 4.0) / 64.0, k = shaft * 2.0 * kb / (shaft + 2.0 * kb);
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\nrotor:\n  speed: %.17g rad/s\n  length_scale: 0.1 mm\n"
             "  materials: {light: {modulus: 200 GPa, poisson: 0.3, density: 1e-4 kg/m3}}\n"
             "  shafts: {shaft: {material: light, shear: none}}\n"
             "  stations:\n    left: {position: 0 m, bow: 0 m}\n"
             "    disc: {position: 0.5 m, mass: 50 kg, damping: %.17g N.s/m, eccentricity: %.17g m, bow: %.17g m, "
             "bow_angle: %.17g rad}\n"
             "    right: {position: 1 m, bow: 0 m}\n  elements:\n    - segment: {length: 1 m, outer: 40 mm}\n"
             "    - bearing: {at: left, kxx: 50 MN/m}\n    - bearing: {at: right, kxx: 50 MN/m}\n"
             "study:\n  unbalance: {}\n",
             ratio * sqrt(k / mass), 2.0 * zeta * sqrt(k * mass), eccentricity, bow, angle);
    *stiffness = k;
    return result_of_text(text);
}

/// (e r^2 + delta exp(i phi))/(1 - r^2 + 2 i zeta r): Nicholas, Gunter, Allaire 1976.
static void jeffcott_with_a_bow(void **state) {
    static const double ratios[] = {0.1, 0.7, 1.0, 1.4, 3.0}, angles[] = {0.0, 1.0, 3.14159265358979323846};
    const double e = 30e-6, bow = 50e-6, zeta = 0.05;
    double worst = 0.0, lag = 0.0, k;
    (void)state;
    for (size_t i = 0; i < 5; i++)
        for (size_t j = 0; j < 3; j++) {
            const double r = ratios[i], a = 1.0 - r * r, b = 2.0 * zeta * r;
            const double x = e * r * r + bow * cos(angles[j]), y = bow * sin(angles[j]);
            whirl_result *result = bent(bow, angles[j], e, r, &k);
            const double *found = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_UNBALANCE_AMPLITUDE, 1);
            const double *lags = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_UNBALANCE_LAG, 1);
            worst = fmax(worst, fabs(1e-4 * found[0] / (hypot(x, y) / hypot(a, b)) - 1.0));
            const double expected = fmod(720.0 + (atan2(b, a) - atan2(y, x)) * 180.0 / pi, 360.0);
            lag = fmax(lag, fabs(remainder(lags[0] - expected, 360.0)));
            whirl_result_free(result);
        }
    check_within("Bows", "disc with eccentricity and bow at 5 speeds and 3 angles: largest relative difference", 0.0,
                 worst, 1e-7);
    check_within("Bows", "the same: largest difference of the lag, deg", 0.0, lag, 1e-5);
    whirl_result *result = bent(bow, pi, e, sqrt(bow / e), &k);
    check_within("Bows", "bow against the eccentricity at r^2 = delta/e: amplitude over the bow", 0.0,
                 1e-4 * whirl_table_number(&result->tables[0], 0, WHIRL_FIELD_UNBALANCE_AMPLITUDE, 1) / bow, 1e-6);
    whirl_result_free(result);
}

/// A bent shaft that turns slowly, on bearings at stations without bow, moves by the bow that is given at each station,
/// whatever its segments are.
static void slow_roll(void **state) {
    static const char text[] =
        "whirl: 1\nrotor:\n  speed: 0.01 rad/s\n  length_scale: 0.1 mm\n  stations:\n"
        "    nose: {position: 0 m, bow: -30 um, bow_angle: 20 deg}\n    left: {position: 0.2 m, bow: 0 m}\n"
        "    disc: {position: 0.6 m, bow: 80 um}\n    wheel: {position: 0.8 m, bow: 60 um, bow_angle: 30 deg}\n"
        "    right: {position: 1.1 m, bow: 0 m}\n  elements:\n    - segment: {length: 0.5 m, outer: 60 mm}\n"
        "    - segment: {length: 0.6 m, outer: 80 mm, inner: 20 mm}\n    - bearing: {at: left, kxx: 3 MN/m}\n"
        "    - bearing: {at: right, kxx: 9 MN/m}\nstudy:\n  unbalance: {}\n";
    static const double expected[] = {0.3, 0.0, 0.8, 0.6, 0.0}, angles[] = {200.0, 0.0, 0.0, 30.0, 0.0};
    (void)state;
    whirl_result *result = result_of_text(text);
    for (size_t s = 0; s < 5; s++) {
        check_within("Bows", words("slow roll, station %zu: amplitude, 0.1 mm", s), expected[s],
                     whirl_table_number(&result->tables[0], 0, WHIRL_FIELD_UNBALANCE_AMPLITUDE, s), 1e-8);
        if (expected[s] > 0.0)
            check_within(
                "Bows", words("slow roll, station %zu: lag, deg", s), 0.0,
                remainder(whirl_table_number(&result->tables[0], 0, WHIRL_FIELD_UNBALANCE_LAG, s) + angles[s], 360.0),
                1e-5);
    }
    whirl_result_free(result);
}

// ---------------------------------------------------------------- raised bearings

/// A uniform shaft on three bearings at equal distances L: if the middle one is raised by h, its load grows by
/// 6 EI h/L^3.
static void raised(void **state) {
    const double L = 2.0, d = 0.3, h = 2e-3, q = 7800.0 * pi * d * d / 4.0 * g, EI = 2e11 * pi * pow(d, 4.0) / 64.0;
    char text[SIZE];
    (void)state;
    snprintf(text, sizeof text,
             "whirl: 1\nparameters: {h: 2 mm}\nrotor:\n  speed: 100 rad/s\n  length_scale: 0.1 mm\n"
             "  materials: {steel: {modulus: 200 GPa, poisson: 0.3, density: 7800 kg/m3}}\n"
             "  shafts: {shaft: {material: steel, shear: none}}\n  stations:\n    a: {position: 0 m}\n    b: "
             "{position: 2 m}\n"
             "    c: {position: 4 m}\n  elements:\n    - segment: {length: 4 m, outer: 300 mm}\n"
             "    - bearing: {at: a, kxx: 1e14 N/m}\n    - bearing: {at: b, kxx: 1e14 N/m, elevation: = h}\n"
             "    - bearing: {at: c, kxx: 1e14 N/m}\n    - gravity: %.17g m/s2\n"
             "study:\n  statics: {parameter: h, values: [0 mm, 2 mm]}\n  modes: {parameter: h, values: [0 mm, 2 mm]}\n",
             g);
    whirl_result *result = result_of_text(text);
    const whirl_table *statics = &result->tables[0], *modes = &result->tables[1];
    if (whirl_layout_field(&modes->layout, WHIRL_FIELD_STATICS_LOAD)) {
        statics = &result->tables[1];
        modes = &result->tables[0];
    }
    relative("Raised bearings", "three bearings in line: load of the middle one, N", 1.25 * q * L,
             whirl_table_number(statics, 0, WHIRL_FIELD_STATICS_LOAD, 1), 1e-9);
    relative("Raised bearings", "the middle one raised by 2 mm: its load, N", 1.25 * q * L + 6.0 * EI * h / (L * L * L),
             whirl_table_number(statics, 1, WHIRL_FIELD_STATICS_LOAD, 1), 1e-9);
    relative("Raised bearings", "the middle one raised by 2 mm: load of the first, N",
             0.375 * q * L - 3.0 * EI * h / (L * L * L), whirl_table_number(statics, 1, WHIRL_FIELD_STATICS_LOAD, 0),
             1e-9);
    check_within("Raised bearings", "the middle one raised by 2 mm: elevation, 0.1 mm", 20.0,
                 whirl_table_number(statics, 1, WHIRL_FIELD_STATICS_ELEVATION, 1), 1e-11);
    const double *rest = whirl_table_field(modes, 1, WHIRL_FIELD_MODES_REST, 1);
    check_within("Raised bearings", "the same machine at rest on its springs: height in the middle, 0.1 mm", 20.0,
                 rest[1], 1e-4);
    whirl_result_free(result);
}

/// A disc in a housing on a spring: the elevation of the housing's bearing also raises the disc, although the disc's
/// bearing has cross-coupled stiffness.
static void raised_in_a_housing(void **state) {
    static const char text[] =
        "whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n  stations:\n    disc: {mass: 10 kg}\n"
        "    housing: {mass: 20 kg}\n  elements:\n"
        "    - bearing: {at: disc, from: housing, kxx: 2 MN/m, kxy: 1 MN/m, kyx: -1 MN/m, kyy: 3 MN/m, elevation: 0.3 "
        "mm}\n"
        "    - bearing: {at: housing, kxx: 5 MN/m, elevation: 0.5 mm}\nstudy:\n  modes: {}\n";
    (void)state;
    whirl_result *result = result_of_text(text);
    const double *disc = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_MODES_REST, 0);
    const double *housing = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_MODES_REST, 1);
    check_within("Raised bearings", "disc in a raised housing: along x, mm", 0.0, disc[0], 1e-12);
    check_within("Raised bearings", "disc in a raised housing: along y, mm", 0.8, disc[1], 1e-12);
    check_within("Raised bearings", "the housing: along y, mm", 0.5, housing[1], 1e-12);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- rigid supports

/// A uniform beam on soft bearings in soft pedestals: on rigid supports w = (pi/L)^2 sqrt(EI/(rho A)).
static void screening(void **state) {
    static const struct {
        double density, ratio;
    } bounds[] = {{0.0, 2.5}, {16.53, 2.5}, {38.265, 2.25}, {60.0, 2.0}, {60.1, 0.0}};
    const double L = 2.0, d = 0.1, rigid = pi * pi / (L * L) * sqrt(2e11 * d * d / 16.0 / 7800.0);
    char text[SIZE];
    (void)state;
    for (size_t i = 0; i < 5; i++)
        check_within("Screening", words("ratio between the regions at %g kg/m3", bounds[i].density), bounds[i].ratio,
                     whirl_screening_ratio(bounds[i].density), 1e-12);
    for (int dense = 0; dense < 2; dense++) {
        snprintf(text, sizeof text,
                 "whirl: 1\nrotor:\n  speed: %.17g rad/s\n  length_scale: 0.1 mm\n"
                 "  materials: {steel: {modulus: 200 GPa, poisson: 0.3, density: 7800 kg/m3}}\n"
                 "  shafts: {shaft: {material: steel, shear: none, rotary_inertia: no, gyroscopic: no, reduce: no}}\n"
                 "  stations:\n    left: {position: 0 m}\n    middle: {position: 1 m}\n    right: {position: 2 m}\n"
                 "    pedestal: {mass: 30 kg}\n  elements:\n    - segment: {length: 2 m, outer: 100 mm, elements: 16}\n"
                 "    - bearing: {at: left, kxx: 20 MN/m, cxx: 10 kN.s/m}\n"
                 "    - bearing: {at: right, from: pedestal, kxx: 20 MN/m, cxx: 10 kN.s/m}\n"
                 "    - spring: {between: [pedestal, ground], stiffness: 10 MN/m}\n"
                 "    - stage: {at: middle, power: 100 kW, diameter: 0.4 m, width: 10 mm}\n"
                 "study:\n  stability: {density: %d kg/m3}\n",
                 2.2 * rigid, dense ? 50 : 30);
        whirl_result *result = result_of_text(text);
        const whirl_table *table = &result->tables[0];
        relative("Screening", "beam: first critical speed on rigid supports, rad/s", rigid,
                 whirl_table_number(table, 0, WHIRL_FIELD_STABILITY_RIGID, 0), 2e-6);
        relative("Screening", "beam: critical speed ratio", 2.2,
                 whirl_table_number(table, 0, WHIRL_FIELD_STABILITY_RATIO, 0), 2e-6);
        check_within("Screening", dense ? "beam, 50 kg/m3: region B" : "beam, 30 kg/m3: region A", dense,
                     whirl_table_number(table, 0, WHIRL_FIELD_STABILITY_REGION, 0), 0.0);
        whirl_result_free(result);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(films),
                                       cmocka_unit_test(films_in_housings),
                                       cmocka_unit_test(housings_closed),
                                       cmocka_unit_test(jeffcott_with_a_bow),
                                       cmocka_unit_test(slow_roll),
                                       cmocka_unit_test(raised),
                                       cmocka_unit_test(raised_in_a_housing),
                                       cmocka_unit_test(screening)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
