// Shafts of finite elements: closed forms of uniform shafts, a commercial program's numbers, and their reduction.
#include <complex.h>
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
#include "support_flow.h"
#include "whirl/engine.h"

static const double pi = 3.14159265358979323846;

// ---------------------------------------------------------------- machines and their frequencies

/// Makes a rotor from the text of `rotor:` below its length scale.
static whirl_rotor *rotor_from(const char *text) {
    char whole[16384];
    whirl_case *object;
    whirl_rotor *rotor;
    const int length =
        snprintf(whole, sizeof whole, "whirl: 1\nrotor:\n  length_scale: 1 mm\n%s\nstudy: {response: {}}\n", text);
    assert_true(length > 0 && (size_t)length < sizeof whole);
    require_ok(whirl_case_parse(whole, (size_t)length, "text", NULL, &object));
    require_ok(whirl_case_rotor(object, NULL, 0.0, &rotor));
    whirl_case_free(object);
    return rotor;
}

/// Returns the exact Jacobian at rest [n][n], with the forcing at t, or without.
static double *jacobian_of(const whirl_system *system, const double *t) {
    const size_t n = system->dimension;
    double *rest = calloc(n, sizeof *rest), *unit = calloc(n * n, sizeof *unit),
           *matrix = calloc(n * n, sizeof *matrix);
    double *columns = calloc(n * n, sizeof *columns), forcing[WHIRL_MAX_FORCING] = {0};
    for (size_t i = 0; i < n; i++) unit[i * n + i] = 1.0;
    if (t) system->forcing(system->model, *t, forcing);
    system->tangent(system->model, 0.0, forcing, rest, NULL, n, unit, columns);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) matrix[j * n + i] = columns[i * n + j];
    free(rest);
    free(unit);
    free(columns);
    return matrix;
}

static int by_frequency(const void *one, const void *other) {
    const double a = cimag(*(const double complex *)one), b = cimag(*(const double complex *)other);
    return a < b ? -1 : a > b;
}

enum { MAX_MODES = 2048 };

/// Writes the eigenvalues with positive frequencies, rad/s, by rising frequency; returns their number.
static size_t frequencies_at(const whirl_rotor *rotor, const double *t, double complex found[MAX_MODES]) {
    const whirl_system *system = whirl_rotor_system(rotor);
    const size_t n = system->dimension;
    double *matrix = jacobian_of(system, t);
    double complex *all = calloc(n, sizeof *all);
    size_t count = 0;
    eigenvalues(n, matrix, all);
    for (size_t i = 0; i < n; i++)
        if (cimag(all[i]) > 0.0) found[count++] = all[i] * whirl_rotor_clock(rotor);
    qsort(found, count, sizeof *found, by_frequency);
    free(matrix);
    free(all);
    return count;
}

static size_t frequencies(const whirl_rotor *rotor, double complex found[MAX_MODES]) {
    return frequencies_at(rotor, NULL, found);
}

// ---------------------------------------------------------------- uniform shafts

/// Makes a uniform shaft, L = 1 m, d = 80 mm, simply supported by springs that yield by less than 1e-9 of the shaft's
/// deflection.
static whirl_rotor *uniform_shaft(const char *keys, const char *segment, int elements, double speed) {
    char text[2048];
    snprintf(text, sizeof text,
             "  speed: %.17g\n  shafts: {main: {reduce: no%s}}\n"
             "  stations: {a: {position: 0}, b: {position: 1}}\n  elements:\n"
             "    - segment: {length: 1, outer: 0.08, elements: %d%s}\n"
             "    - bearing: {at: a, kxx: 1e16}\n    - bearing: {at: b, kxx: 1e16}\n",
             speed, keys, elements, segment);
    return rotor_from(text);
}

/// Returns the root w of w^2 (1 + (n pi/L)^2 I/A) - 2 Omega w (n pi/L)^2 I/A = (EI/rho A)(n pi/L)^4: forward above
/// zero, backward below.
static double rayleigh_whirl(int n, double speed, int sign) {
    const double k = n * pi, gyration = 0.08 * 0.08 / 16.0, a = 1.0 + k * k * gyration, b = speed * k * k * gyration;
    const double c = 2.11e11 / 7810.0 * gyration * k * k * k * k;
    return (b + sign * sqrt(b * b + a * c)) / a;
}

/// Errors of a Rayleigh shaft that turns at 3000 rad/s fall with the fourth power of the elements' length.
static void a_rayleigh_shaft_converges_in_order_four(void **state) {
    static const int elements[] = {8, 16};
    double last[4] = {0};
    (void)state;
    for (int e = 0; e < 2; e++) {
        double complex found[MAX_MODES];
        whirl_rotor *rotor = uniform_shaft(", shear: none", "", elements[e], 3000.0);
        assert_true(frequencies(rotor, found) >= 4);
        for (int i = 0; i < 4; i++) {
            const double expected = fabs(rayleigh_whirl(1 + i / 2, 3000.0, i % 2 == 0 ? -1 : 1));
            const double error = cimag(found[i]) / expected - 1.0;
            // Of a cubic beam (k h)^4/1440 (Leung 1978), k the wave number and h the length of an element.
            const double leung = pow((1 + i / 2) * pi / elements[e], 4.0) / 1440.0;
            check_within("FE1", words("mode %d, %d elements: error over (k h)^4/1440", i + 1, elements[e]), 1.0,
                         error / leung, 0.05);
            if (e > 0)
                check_within("FE1", words("mode %d: order from %d to %d elements", i + 1, elements[e - 1], elements[e]),
                             4.0, log2(last[i] / error), 0.06);
            last[i] = error;
        }
        whirl_rotor_free(rotor);
    }
}

/// w_n^2 grows by 1 + N L^2/(n^2 pi^2 EI) under an axial force N.
static void an_axial_force_raises_frequencies(void **state) {
    double complex free_of[MAX_MODES], pulled[MAX_MODES];
    const double ei = 2.11e11 * pi / 64.0 * pow(0.08, 4.0);
    (void)state;
    whirl_rotor *rotor = uniform_shaft(", shear: none, rotary_inertia: no", "", 16, 1.0);
    frequencies(rotor, free_of);
    whirl_rotor_free(rotor);
    rotor = uniform_shaft(", shear: none, rotary_inertia: no", ", axial_force: 1 MN", 16, 1.0);
    frequencies(rotor, pulled);
    whirl_rotor_free(rotor);
    for (int n = 1; n <= 2; n++)
        check_within("FE2", words("mode pair %d with 1 MN over that without", n),
                     sqrt(1.0 + 1e6 / (n * n * pi * pi * ei)), cimag(pulled[2 * n - 2]) / cimag(free_of[2 * n - 2]),
                     1e-6);
}

static double complex nearest(const double complex *found, size_t count, double complex to) {
    double complex best = found[0];
    for (size_t i = 1; i < count; i++)
        if (cabs(found[i] - to) < cabs(best - to)) best = found[i];
    return best;
}

/// Returns the root of s^2 + (alpha + beta w^2) s + eta w^2 (s - i W) + w^2 ((1 + h) - i h)/sqrt(1 + h^2) = 0 near i w:
/// a mode of the undamped shaft with proportional and internal damping (Zorzi, Nelson 1977).
static double complex damped_root(double w, double speed, double alpha, double beta, double eta, double h) {
    const double complex b = alpha + (beta + eta) * w * w;
    const double complex c = w * w * ((1.0 + h - I * h) / sqrt(1.0 + h * h) - I * eta * speed);
    return 0.5 * (-b + csqrt(b * b - 4.0 * c));
}

static void damping_is_that_of_its_law(void **state) {
    static const struct {
        const char *name, *keys;
        double alpha, beta, eta, h;
    } laws[] = {{"proportional to mass", ", mass_damping: 3", 3.0, 0.0, 0.0, 0.0},
                {"proportional to stiffness", ", stiffness_damping: 2e-5", 0.0, 2e-5, 0.0, 0.0},
                {"internal, viscous", ", viscous_damping: 2e-4", 0.0, 0.0, 2e-4, 0.0},
                {"internal, hysteretic", ", hysteretic_damping: 2e-4", 0.0, 0.0, 0.0, 2e-4}};
    static const char plain[] = ", shear: none, rotary_inertia: no, gyroscopic: no";
    const double speed = 900.0; // between the first and the second critical speed
    double complex undamped[MAX_MODES], found[MAX_MODES];
    char keys[200];
    (void)state;
    whirl_rotor *rotor = uniform_shaft(plain, "", 4, speed);
    frequencies(rotor, undamped);
    whirl_rotor_free(rotor);
    for (size_t l = 0; l < sizeof laws / sizeof *laws; l++) {
        snprintf(keys, sizeof keys, "%s%s", plain, laws[l].keys);
        rotor = uniform_shaft(keys, "", 4, speed);
        const size_t count = frequencies(rotor, found);
        assert_true(count >= 4);
        for (size_t n = 0; n < 2; n++) {
            const double w = cimag(undamped[2 * n]);
            const double complex forward = damped_root(w, speed, laws[l].alpha, laws[l].beta, laws[l].eta, laws[l].h);
            const double complex obtained = nearest(found, count, forward);
            check_within("FE3", words("%s, pair %zu: decay, 1/s", laws[l].name, n + 1), creal(forward), creal(obtained),
                         2e-7 * w);
            check_within("FE3", words("%s, pair %zu: frequency, rad/s", laws[l].name, n + 1), cimag(forward),
                         cimag(obtained), 2e-7 * w);
        }
        whirl_rotor_free(rotor);
    }
}

/// Where the normal of the flats lies along x the shaft is softer that way, by the ratio of its second moments.
static void flats_make_its_stiffness_unequal(void **state) {
    const double s = asin(0.9), softer = s / 2.0 - sin(4.0 * s) / 8.0;
    const double stiffer = s / 2.0 + sin(2.0 * s) / 3.0 + sin(4.0 * s) / 24.0;
    (void)state;
    whirl_rotor *rotor =
        uniform_shaft(", shear: none, rotary_inertia: no", ", flats: 72 mm, flats_angle: 30 deg", 4, 100.0);
    for (int i = 0; i < 3; i++) {
        const double t = 2.0 * pi * i / 7.0;
        double complex found[MAX_MODES];
        assert_true(frequencies_at(rotor, &t, found) >= 2);
        check_within("FE4", words("stiffer over softer frequency, turned by %d/7", i), sqrt(stiffer / softer),
                     cimag(found[1]) / cimag(found[0]), 1e-9);
    }
    // Of a station in the middle, along the normal at 30 degrees and across it.
    const whirl_system *system = whirl_rotor_system(rotor);
    const double t = 0.0;
    double *matrix = jacobian_of(system, &t);
    const size_t n = system->dimension, d = n / 2, x = 4; // the first hidden node: x, y
    const double xx = matrix[(d + x) * n + x], xy = matrix[(d + x) * n + x + 1], yy = matrix[(d + x + 1) * n + x + 1];
    check_within("FE4", "direction of the softer axis at t = 0, deg", 30.0,
                 90.0 / pi * atan2(-2.0 * xy, yy - xx) < 0.0 ? 90.0 / pi * atan2(-2.0 * xy, yy - xx) + 90.0
                                                             : 90.0 / pi * atan2(-2.0 * xy, yy - xx),
                 1e-9);
    free(matrix);
    whirl_rotor_free(rotor);
}

/// A shaft of another speed has the modes that it would have alone at that speed.
static void a_second_shaft_turns_at_its_own_speed(void **state) {
    double complex own[MAX_MODES], other[MAX_MODES];
    (void)state;
    whirl_rotor *rotor = uniform_shaft("", "", 4, 700.0), *second = uniform_shaft(", ratio: -1.4", "", 4, 500.0);
    const size_t count = frequencies(rotor, own);
    assert_int_equal(frequencies(second, other), count);
    for (size_t i = 0; i < 6; i++)
        check_within("FE5", words("mode %zu at 500 x -1.4, over that at 700", i + 1), 1.0,
                     cimag(other[i]) / cimag(own[i]), 1e-9);
    whirl_rotor_free(rotor);
    whirl_rotor_free(second);
}

/// A mesh to a frequency has errors below 1e-4 up to there.
static void a_mesh_is_as_fine_as_it_must(void **state) {
    double complex found[MAX_MODES];
    (void)state;
    whirl_rotor *rotor = uniform_shaft(", shear: none, rotary_inertia: no, mesh_to: 2 kHz", "", 1, 1.0);
    const size_t count = frequencies(rotor, found);
    const double gyration = 0.02; // of a circle: d/4
    size_t checked = 0;
    for (size_t i = 0; i < count && cimag(found[i]) < 4000.0 * pi; i += 2, checked++) {
        const double k = (double)(i / 2 + 1) * pi, expected = k * k * gyration * sqrt(2.11e11 / 7810.0);
        check_within("FE6", words("mode pair %zu over closed form, mesh to 2 kHz", i / 2 + 1), 1.0,
                     cimag(found[i]) / expected, 1e-4);
    }
    assert_in_range(checked, 3, 4); // 163 Hz times 1, 4, 9
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- a commercial program

/// Makes ROSS's example rotor: example 5.9.2 of Friswell et al. 2010.
static whirl_rotor *example_rotor(const char *mass) {
    char text[2048];
    snprintf(text, sizeof text,
             "  speed: 500 rpm\n  shafts: {main: {reduce: no, mass: %s}}\n"
             "  stations: {a: {position: 0}, one: {position: 0.5, mass: 32.58972765, diametral: 0.17808928, polar: "
             "0.32956362}, two: {position: 1, mass: 32.58972765, diametral: 0.17808928, polar: 0.32956362}, b: "
             "{position: 1.5}}\n"
             "  elements:\n    - segment: {length: 1.5, outer: 0.05, elements: 6}\n"
             "    - bearing: {at: a, kxx: 1e6, kyy: 0.8e6}\n    - bearing: {at: b, kxx: 1e6, kyy: 0.8e6}\n",
             mass);
    return rotor_from(text);
}

static void masses_are_lumped_and_consistent_as_elsewhere(void **state) {
    static const char *const consistent[] = {"14.609", "15.325", "43.676", "47.211", "114.790", "122.001", "170.229"};
    static const char *const lumped[] = {"14.617", "15.330", "43.356", "46.938", "105.911", "112.770", "151.032"};
    static const double rappid[] = {14.6152, 15.3284, 43.3459, 46.9251, 105.902, 112.760, 150.907};
    double complex found[MAX_MODES];
    (void)state;
    whirl_rotor *rotor = example_rotor("consistent");
    frequencies(rotor, found);
    whirl_rotor_free(rotor);
    for (int i = 0; i < 7; i++)
        check_digits("FE7", words("mode %d, Hz, consistent (ROSS)", i + 1), consistent[i],
                     cimag(found[i]) / (2.0 * pi));
    rotor = example_rotor("lumped");
    frequencies(rotor, found);
    whirl_rotor_free(rotor);
    for (int i = 0; i < 7; i++) {
        check_digits("FE7", words("mode %d, Hz, lumped (ROSS)", i + 1), lumped[i], cimag(found[i]) / (2.0 * pi));
        // RAPPID's own model differs in the sixth digit, as ROSS found.
        check_within("FE7", words("mode %d, Hz, lumped (RAPPID)", i + 1), rappid[i], cimag(found[i]) / (2.0 * pi),
                     1e-3 * rappid[i]);
    }
}

// ---------------------------------------------------------------- reduction

/// Makes an overhung rotor of 20 elements; `keys` of the shaft, `more` elements.
static whirl_rotor *overhung(const char *keys, const char *more) {
    char text[4096];
    snprintf(text, sizeof text,
             "  speed: 4000 rpm\n  shafts: {main: {%s}}\n"
             "  stations: {left: {position: 0.1}, right: {position: 0.5}, disc: {position: 0.75}}\n"
             "  elements:\n    - segment: {length: 0.1, outer: 0.04, elements: 3}\n"
             "    - segment: {length: 0.4, outer: 0.05, elements: 10}\n"
             "    - segment: {length: 0.25, outer: 0.045, elements: 7}\n"
             "    - disc: {at: disc, outer: 0.3, inner: 0.045, width: 0.025, eccentricity: 2e-5}\n    - gravity\n%s",
             keys, more);
    return rotor_from(text);
}

static const char springs[] = "    - bearing: {at: left, kxx: 2e7, cxx: 2e3}\n"
                              "    - bearing: {at: right, kxx: 3e7, kyy: 2e7, cxx: 2e3}\n";

/// Computes the displacements of the three stations under the weight: J x = -f.
static void sag_of(const whirl_rotor *rotor, double sag[6]) {
    const whirl_system *system = whirl_rotor_system(rotor);
    const size_t n = system->dimension;
    double *matrix = jacobian_of(system, NULL), *x = calloc(n, sizeof *x), *rest = calloc(n, sizeof *rest);
    const double forcing[WHIRL_MAX_FORCING] = {0};
    system->rhs(system->model, 0.0, forcing, rest, x);
    for (size_t i = 0; i < n; i++) x[i] = -x[i];
    solve_linear(n, matrix, x);
    memcpy(sag, x, 6 * sizeof *sag);
    free(matrix);
    free(x);
    free(rest);
}

static void static_displacements_are_exact(void **state) {
    static const char *const keys[] = {"modes: 0", "modes: 1", "modes: 3", "modes: 8"};
    double full[6], reduced[6];
    (void)state;
    whirl_rotor *rotor = overhung("reduce: no", springs);
    sag_of(rotor, full);
    whirl_rotor_free(rotor);
    for (int i = 0; i < 4; i++) {
        rotor = overhung(keys[i], springs);
        sag_of(rotor, reduced);
        whirl_rotor_free(rotor);
        for (int s = 0; s < 3; s++)
            check_within("CB1", words("sag of station %d with %s, over the full model", s + 1, keys[i]), 1.0,
                         reduced[2 * s + 1] / full[2 * s + 1], 1e-11);
    }
}

/// The error of the first six frequencies falls as more modes are kept; with all modes the model is the full one.
static void frequencies_come_nearer_as_more_is_kept(void **state) {
    static const char *const keys[] = {"modes: 0", "modes: 2", "modes: 4", "modes: 8", "modes: 512"};
    double complex full[MAX_MODES], reduced[MAX_MODES];
    double last = INFINITY;
    (void)state;
    whirl_rotor *rotor = overhung("reduce: no", springs);
    frequencies(rotor, full);
    whirl_rotor_free(rotor);
    for (int i = 0; i < 5; i++) {
        double worst = 0.0;
        rotor = overhung(keys[i], springs);
        assert_true(frequencies(rotor, reduced) >= 6);
        whirl_rotor_free(rotor);
        for (int m = 0; m < 6; m++) worst = fmax(worst, cabs(reduced[m] / full[m] - 1.0));
        check_holds("CB2", words("%s: the worst of six eigenvalues errs by %.2g", keys[i], worst), worst < last);
        last = worst;
    }
    check_within("CB2", "with all modes", 0.0, last, 1e-9);
}

/// Makes two shafts of their own speeds with a bearing between them; modes in which no node moves are among those that
/// are kept.
static whirl_rotor *two_shafts(const char *reduce) {
    char text[2048];
    snprintf(text, sizeof text,
             "  speed: 3000 rpm\n  shafts: {lp: {reduce: %s}, hp: {ratio: 1.4, reduce: %s}}\n"
             "  stations: {a: {shaft: lp, position: 0}, b: {shaft: lp, position: 0.8}, c: {shaft: hp, position: 0}, "
             "d: {shaft: hp, position: 0.3}}\n  elements:\n"
             "    - segment: {shaft: lp, length: 0.8, outer: 0.03, elements: 4}\n"
             "    - segment: {shaft: hp, length: 0.3, outer: 0.06, inner: 0.05, elements: 2}\n"
             "    - bearing: {at: a, kxx: 1e7}\n    - bearing: {at: b, kxx: 1e7}\n"
             "    - bearing: {at: c, from: a, kxx: 1e7}\n    - bearing: {at: d, kxx: 1e7}\n",
             reduce, reduce);
    return rotor_from(text);
}

/// Two discs in free space that a coupling joins: sqrt(2 k/m), and of tilts sqrt(2 k/I_d).
static void a_coupling_joins_offsets_and_tilts(void **state) {
    double complex found[MAX_MODES];
    (void)state;
    whirl_rotor *rotor =
        rotor_from("  speed: 1000 rpm\n  stations: {a: {mass: 3, diametral: 0.02}, b: {mass: 3, diametral: "
                   "0.02}}\n  elements:\n    - coupling: {between: [a, b], radial: 6e5, tilt: 9e3, "
                   "radial_damping: 30, tilt_damping: 0.04}\n");
    const size_t count = frequencies(rotor, found);
    whirl_rotor_free(rotor);
    const double decay = 30.0 / 3.0, turned = 0.04 / 0.02;
    const double complex radial = -decay + I * sqrt(2.0 * 6e5 / 3.0 - decay * decay);
    const double complex tilt = -turned + I * sqrt(2.0 * 9e3 / 0.02 - turned * turned);
    check_within("FE8", "radial mode of two coupled discs", 0.0, cabs(nearest(found, count, radial) / radial - 1.0),
                 1e-12);
    check_within("FE8", "tilting mode of two coupled discs", 0.0, cabs(nearest(found, count, tilt) / tilt - 1.0),
                 1e-12);
}

/// Checks the modes of a machine in free space: 4 rigid-body modes, and the lowest frequency of the others, rad/s.
static void check_free(const char *what, const char *text, double lowest, double tolerance) {
    whirl_modes *modes;
    whirl_rotor *rotor = rotor_from(text);
    const whirl_system *system = whirl_rotor_system(rotor);
    double *start = calloc(system->dimension, sizeof *start);
    require_ok(whirl_modes_new(system, start, &modes));
    check_within("FE9", words("%s: rigid-body modes", what), 4.0, (double)modes->free, 0.0);
    check_within("FE9", words("%s: lowest frequency of the others", what), 1.0,
                 modes->modes[0].imaginary * whirl_rotor_clock(rotor) / lowest, tolerance);
    whirl_modes_free(modes);
    whirl_rotor_free(rotor);
    free(start);
}

/// A shaft and coupled discs in free space move along and tilt about two axes at no frequency. The lowest mode of a
/// free shaft has cosh(k L) cos(k L) = 1, k L = 4.730040745 (Rao 2007, 11.5); spinning discs tilt together
/// at I_p/I_d times the speed; two tilts have no frequency.
static void rigid_body_modes_are_recognised(void **state) {
    static const char *const reduced[] = {"reduce: no", "modes: 16"};
    const double area = pi / 4.0 * 0.08 * 0.08, ei = 2.11e11 * pi / 64.0 * pow(0.08, 4.0);
    (void)state;
    for (int i = 0; i < 2; i++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "  speed: 1\n  shafts: {main: {%s, shear: none, rotary_inertia: no}}\n"
                 "  stations: {a: {position: 0}, b: {position: 1}}\n"
                 "  elements:\n    - segment: {length: 1, outer: 0.08, elements: 16}\n",
                 reduced[i]);
        // The elements err by (k h)^4/1440 = 5.3e-6 (Leung 1978), so many component modes by little more.
        check_free(words("free shaft, %s", reduced[i]), text, pow(4.730040745, 2.0) * sqrt(ei / (7810.0 * area)), 1e-5);
    }
    check_free("coupled discs",
               "  speed: 1000 rpm\n  stations: {a: {mass: 3, diametral: 0.02, polar: 0.01}, b: {mass: 3, diametral: "
               "0.02, polar: 0.01}}\n  elements:\n    - coupling: {between: [a, b], radial: 6e5, tilt: 9e3}\n",
               0.5 * 1000.0 * pi / 30.0, 1e-9);
}

static void two_shafts_are_reduced_side_by_side(void **state) {
    double complex full[MAX_MODES], reduced[MAX_MODES];
    (void)state;
    whirl_rotor *rotor = two_shafts("no");
    const size_t count = frequencies(rotor, full);
    whirl_rotor_free(rotor);
    rotor = two_shafts("yes");
    assert_int_equal(frequencies(rotor, reduced), count);
    whirl_rotor_free(rotor);
    for (size_t i = 0; i < 8; i++)
        check_within("CB6", words("mode %zu with all modes, over the full model", i + 1), 1.0,
                     cimag(reduced[i]) / cimag(full[i]), 1e-9);
}

/// RK4 neither gains nor loses what its polynomial does not: amplitudes of a conservative gyroscopic rotor after 50
/// revolutions are those of |1 + z + z^2/2 + z^3/6 + z^4/24|, z = i w h.
static void energy_is_kept_to_the_order_of_the_method(void **state) {
    enum { STEPS = 1024, REVOLUTIONS = 50 };
    char text[1024];
    (void)state;
    snprintf(
        text, sizeof text,
        "  speed: 4000 rpm\n  shafts: {main: {modes: 1}}\n  stations: {left: {position: 0.1}, disc: {position: 0.6}}\n"
        "  elements:\n    - segment: {length: 0.6, outer: 0.05, elements: 6}\n"
        "    - disc: {at: disc, outer: 0.3, width: 0.03}\n    - bearing: {at: left, kxx: 2e7}\n"
        "    - bearing: {at: disc, kxx: 3e6}\n");
    whirl_rotor *rotor = rotor_from(text);
    const whirl_system *system = whirl_rotor_system(rotor);
    const size_t n = system->dimension;
    double *matrix = jacobian_of(system, NULL), *x = calloc(n, sizeof *x), *step = calloc(n * n, sizeof *step);
    double *power = calloc(n * n, sizeof *power), *y = calloc(n, sizeof *y);
    const double h = 2.0 * pi / STEPS;
    whirl_integrator *integrator = make_integrator(system, "rk4", STEPS);
    // The polynomial of the matrix, applied a step at a time in long double, is what RK4 is of a linear system.
    long double *exact = calloc(n, sizeof *exact), *term = calloc(n, sizeof *term), *next = calloc(n, sizeof *next);
    x[1] = 0.3, exact[1] = 0.3;
    for (int i = 0; i < REVOLUTIONS * STEPS; i++) {
        memcpy(term, exact, n * sizeof *term);
        for (int order = 1; order <= 4; order++) {
            for (size_t r = 0; r < n; r++) {
                next[r] = 0.0L;
                for (size_t c = 0; c < n; c++) next[r] += matrix[r * n + c] * term[c];
            }
            for (size_t r = 0; r < n; r++) {
                term[r] = next[r] * h / order;
                exact[r] += term[r];
            }
        }
    }
    revolve(integrator, x, REVOLUTIONS);
    for (size_t i = 0; i < 4; i++)
        check_within("CB3", words("coordinate %zu after 50 revolutions", i + 1), (double)exact[i], x[i], 1e-11);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
    free(matrix), free(x), free(step), free(power), free(y), free(exact), free(term), free(next);
}

static const char films[] = "    - film: {at: left, clearance: 1e-4, viscosity: 0.03, radius: 0.02, length: 0.025}\n"
                            "    - film: {at: right, clearance: 1e-4, viscosity: 0.03, radius: 0.025, length: 0.03}\n"
                            "    - rub: {at: disc, gap: 1e-4, stiffness: 3e6, damping: 200, friction: 0.05}\n";

/// Computes the displacements [6] of the stations after some revolutions.
static void carried(const char *keys, const char *method, double rtol, int revolutions, double x[6]) {
    char all[100];
    snprintf(all, sizeof all, "%s, stiffness_damping: 1e-5",
             keys); // as steel has: stiff methods need not follow all modes
    whirl_rotor *rotor = overhung(all, films);
    const whirl_system *system = whirl_rotor_system(rotor);
    double *start = calloc(system->dimension, sizeof *start);
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    snprintf(options.method, sizeof options.method, "%s", method);
    options.rtol = rtol;
    options.atol = 1e-3 * rtol;
    require_ok(whirl_integrator_new(system, &options, &integrator));
    start[1] = -0.02, start[3] = -0.06, start[5] = -0.07;
    revolve(integrator, start, revolutions);
    memcpy(x, start, 6 * sizeof *x);
    free(start);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

static double distance_of(const double one[6], const double other[6]) {
    double sum = 0.0;
    for (int i = 0; i < 6; i++) sum += (one[i] - other[i]) * (one[i] - other[i]);
    return sqrt(sum);
}

/// Fifty revolutions in films, with rub.
static void the_reduced_rotor_comes_nearer_to_the_full_one(void **state) {
    static const char *const keys[] = {"modes: 0", "modes: 1", "modes: 2"};
    double full[6], reduced[6], last = INFINITY;
    (void)state;
    carried("reduce: no", "rodas5p", 1e-6, 50, full);
    check_holds("CB4",
                words("the disc rubs: it is %.4f mm from the middle, the gap is 0.1 mm", hypot(full[4], full[5])),
                isfinite(full[4]));
    for (int i = 0; i < 3; i++) {
        carried(keys[i], "rodas5p", 1e-6, 50, reduced);
        const double apart = distance_of(full, reduced);
        check_holds("CB4", words("%s: %.3g mm from the full model after 50 revolutions", keys[i], apart),
                    apart < 0.5 * last);
        last = apart;
    }
}

static void the_full_rotor_is_that_of_sundials(void **state) {
    double own[6], sundials[6];
    (void)state;
    carried("reduce: no", "rodas5p", 1e-9, 1, own);
    carried("reduce: no", "cvode-bdf", 1e-10, 1, sundials);
    for (int i = 0; i < 6; i++)
        check_within("CB5", words("coordinate %d of the full model after a revolution, mm", i + 1), sundials[i], own[i],
                     1e-8);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rayleigh_shaft_converges_in_order_four),
        cmocka_unit_test(an_axial_force_raises_frequencies),
        cmocka_unit_test(damping_is_that_of_its_law),
        cmocka_unit_test(flats_make_its_stiffness_unequal),
        cmocka_unit_test(a_second_shaft_turns_at_its_own_speed),
        cmocka_unit_test(a_mesh_is_as_fine_as_it_must),
        cmocka_unit_test(masses_are_lumped_and_consistent_as_elsewhere),
        cmocka_unit_test(static_displacements_are_exact),
        cmocka_unit_test(frequencies_come_nearer_as_more_is_kept),
        cmocka_unit_test(a_coupling_joins_offsets_and_tilts),
        cmocka_unit_test(rigid_body_modes_are_recognised),
        cmocka_unit_test(two_shafts_are_reduced_side_by_side),
        cmocka_unit_test(energy_is_kept_to_the_order_of_the_method),
        cmocka_unit_test(the_reduced_rotor_comes_nearer_to_the_full_one),
        cmocka_unit_test(the_full_rotor_is_that_of_sundials),
    };
    return cmocka_run_group_tests_name("shafts", tests, NULL, NULL);
}
