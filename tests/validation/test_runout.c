// Runout: what probes see over the motion, in waveforms, full spectra and the response to unbalance; and the unbalance
// that a balance quality grade allows.
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
#include "support_study.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/case.h"
#include "whirl/engine/rotor.h"
#include "whirl/internal/spectrum.h"

static const double pi = 3.14159265358979323846;

/// Runs a shaft with runout, at rest or with an unbalance.
static whirl_result *run_out(bool clockwise, double eccentricity, const char *runout) {
    char text[4096];
    snprintf(
        text, sizeof text,
        "whirl: 1\nrotor:\n  speed: 100 rad/s\n  rotation: %s\n  length_scale: 0.1 mm\n  stations:\n"
        "    disc: {mass: 2 kg, eccentricity: %g m, eccentricity_angle: 0.3}\n  elements:\n"
        "    - spring: {between: [disc, ground], stiffness: 50 kN/m, damping: 60 N.s/m}\n%s"
        "study:\n  response: {}\n  unbalance: {probe: 45 deg}\n  integrate: {method: rk4, steps_per_revolution: 256, "
        "transient: 40, record: 8}\n  keep: {waveform: 2, samples: 64}\n  analyze: [waveform, spectrum, orbit]\n",
        clockwise ? "clockwise" : "counter-clockwise", eccentricity, runout);
    return result_of_text(text);
}

static const whirl_table *table_of(const whirl_result *result, const char *field) {
    for (size_t i = 0; i < result->table_count; i++)
        if (whirl_layout_field(&result->tables[i].layout, field)) return &result->tables[i];
    return NULL;
}

// ---------------------------------------------------------------- a surface that passes

/// A shaft at rest whose surface is 3 cos(psi - .5) + 2 cos 2 (psi + .2) + cos 3 psi um: probes at alpha see it at psi
/// = alpha -+ tau. Orders 1, 5, ... look like whirl with the rotation, 3, 7, ... against it, even ones like both.
static void a_surface_that_passes(void **unused) {
    (void)unused;
    static const char surface[] = "    - runout: {at: disc, amplitude: 3 um, angle: 0.5}\n"
                                  "    - runout: {at: disc, amplitude: 2 um, order: 2, angle: -0.2}\n"
                                  "    - runout: {at: disc, amplitude: 1 um, order: 3}\n";
    for (int clockwise = 0; clockwise < 2; clockwise++) {
        whirl_result *result = run_out(clockwise, 0.0, surface);
        const whirl_table *table = table_of(result, WHIRL_FIELD_WAVEFORM_SAMPLES);
        const double *samples = whirl_table_field(table, 0, WHIRL_FIELD_WAVEFORM_SAMPLES, 0);
        double worst = 0.0;
        for (int j = 0; j < 128; j++)
            for (int axis = 0; axis < 2; axis++) {
                const double tau = 2.0 * pi * (j + 1) / 64.0, psi = 0.5 * pi * axis - (clockwise ? -tau : tau);
                const double r = 3.0 * cos(psi - 0.5) + 2.0 * cos(2.0 * (psi + 0.2)) + cos(3.0 * psi);
                worst = fmax(worst, fabs(samples[2 * j + axis] - 0.01 * r));
            }
        const char *way = clockwise ? "clockwise" : "counter-clockwise";
        check_within("Runout", words("%s: waveform of a surface of three orders, length scales", way), 0.0, worst,
                     1e-14);
        const double *lines = whirl_table_field(table, 0, WHIRL_FIELD_SPECTRUM_LINES, 0);
        const double whirl[3][3] = {{1.0, 0.03, 0.0}, {2.0, 0.01, 0.01}, {3.0, 0.0, 0.01}};
        for (int n = 0; n < 3; n++) { // a motion to and fro of amplitude a is two circles of a/2; x = -y here: sqrt 2
            double found[2] = {NAN, NAN};
            for (int l = 0; l < WHIRL_MAX_LINES; l++)
                if (fabs(lines[5 * l] - whirl[n][0]) < 1e-9) found[0] = lines[5 * l + 3], found[1] = lines[5 * l + 4];
            const double both = n == 1 ? sqrt(2.0) : 1.0;
            check_within("Runout", words("%s: order %d of the full spectrum, forward", way, n + 1), both * whirl[n][1],
                         found[0], 1e-12);
            check_within("Runout", words("%s: order %d, backward", way, n + 1), both * whirl[n][2], found[1], 1e-12);
        }
        const double *radius = whirl_table_field(table, 0, WHIRL_FIELD_ORBIT_MAX_RADIUS, 0);
        check_within("Runout", words("%s: the shaft itself rests", way), 0.0, radius[0], 1e-15);
        whirl_result_free(result);
    }
}

/// A profile of 12 heights of the same surface has the same waveform; one of slow-roll vectors of each probe.
static void profiles_and_vectors(void **unused) {
    (void)unused;
    char text[1024] = "    - runout: {at: disc, profile: [";
    for (int j = 0; j < 12; j++) {
        const double psi = 2.0 * pi * j / 12.0;
        const size_t used = strlen(text);
        snprintf(text + used, sizeof text - used, "%.17g%s",
                 1e-6 * (7.0 + 3.0 * cos(psi - 0.5) + 2.0 * cos(2.0 * (psi + 0.2))), j < 11 ? ", " : "]}\n");
    }
    whirl_result *one_by_one = run_out(false, 1e-5, text),
                 *same = run_out(false, 1e-5,
                                 "    - runout: {at: disc, amplitude: 3 um, angle: 0.5}\n"
                                 "    - runout: {at: disc, amplitude: 2 um, order: 2, angle: -0.2}\n"),
                 *apart = run_out(false, 1e-5,
                                  "    - runout: {at: disc, amplitude: 3 um, angle: 0.5, seen_by: first}\n"
                                  "    - runout: {at: disc, amplitude: 3 um, angle: 0.5, seen_by: second}\n"
                                  "    - runout: {at: disc, amplitude: 2 um, order: 2, angle: -0.2}\n");
    const double *samples[3];
    double worst[2] = {0.0, 0.0};
    whirl_result *const all[] = {one_by_one, same, apart};
    for (int i = 0; i < 3; i++)
        samples[i] =
            whirl_table_field(table_of(all[i], WHIRL_FIELD_WAVEFORM_SAMPLES), 0, WHIRL_FIELD_WAVEFORM_SAMPLES, 0);
    for (int i = 0; i < 256; i++) {
        worst[0] = fmax(worst[0], fabs(samples[0][i] - samples[1][i]));
        worst[1] = fmax(worst[1], fabs(samples[2][i] - samples[1][i]));
    }
    check_within("Runout", "a profile of 12 heights and its harmonics, length scales", 0.0, worst[0], 1e-14);
    check_within("Runout", "both probes given one by one", 0.0, worst[1], 1e-14);
    for (int i = 0; i < 3; i++) whirl_result_free(all[i]);
}

/// The response with runout is the vector sum: amplitude and lag of m e w^2/(k - m w^2 + i w c) at the angle of the
/// probes, 45 and 135 degrees, and of the surface there.
static void responses(void **unused) {
    (void)unused;
    const double e = 2e-5, w = 100.0, m = 2.0, k = 5e4, c = 60.0;
    for (int clockwise = 0; clockwise < 2; clockwise++) {
        whirl_result *result = run_out(clockwise, e, "    - runout: {at: disc, amplitude: 3 um, angle: 0.5}\n");
        const whirl_table *table = table_of(result, WHIRL_FIELD_UNBALANCE_SEEN);
        assert_non_null(table);
        const double *probe = whirl_table_field(table, 0, WHIRL_FIELD_UNBALANCE_PROBE, 0);
        const double *seen = whirl_table_field(table, 0, WHIRL_FIELD_UNBALANCE_SEEN, 0);
        const double *lag = whirl_table_field(table, 0, WHIRL_FIELD_UNBALANCE_SEEN_LAG, 0);
        for (int nth = 0; nth < 2; nth++) {
            const double alpha = 0.25 * pi + 0.5 * pi * nth, way = clockwise ? -1.0 : 1.0;
            const double complex h = m * e * w * w / (k - m * w * w + I * w * c);
            // Both turn: what points to beta at t = 0 passes a probe at alpha as exp(i (tau - way (alpha - beta))).
            const double complex motion = h * cexp(-I * way * (alpha - 0.3)),
                                 surface = 3e-6 * cexp(-I * way * (alpha - 0.5));
            const char *of = nth == 0 ? "first" : "second", *turning = clockwise ? "clockwise" : "counter-clockwise";
            check_within("Runout", words("%s, %s probe: compensated amplitude, length scales", turning, of),
                         cabs(motion) / 1e-4, probe[nth], 1e-13);
            check_within("Runout", words("%s, %s probe: amplitude with runout", turning, of),
                         cabs(motion + surface) / 1e-4, seen[nth], 1e-13);
            check_within("Runout", words("%s, %s probe: lag with runout, deg", turning, of),
                         fmod(720.0 - carg(motion + surface) * 180.0 / pi, 360.0), lag[nth], 1e-9);
        }
        whirl_result_free(result);
    }
}

// ---------------------------------------------------------------- grades

static whirl_rotor *allowed(const whirl_setting *settings, size_t count) {
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(100.0, 1e-3, &design));
    require_ok(whirl_design_station(design, "left", (whirl_setting[]){{"mass", 30.0, NULL}}, 1));
    require_ok(whirl_design_station(design, "right", (whirl_setting[]){{"mass", 20.0, NULL}}, 1));
    require_ok(whirl_design_element(design, "unbalance_grade", settings, count));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static void unbalance_of_a_grade(void **unused) {
    (void)unused;
    static const struct {
        double first, second, share;
    } distances[] = {{1.0, 1.0, 0.5}, {0.4, 0.6, 0.6}, {0.1, 1.9, 0.7}, {1.9, 0.1, 0.3}};
    for (int i = 0; i < 4; i++) {
        const whirl_setting settings[] = {{"planes", 0.0, "left, right"},
                                          {"grade", 2.5, NULL},
                                          {"service_speed", 120.0 * pi, NULL},
                                          {"mass", 50.0, NULL},
                                          {"to_first", distances[i].first, NULL},
                                          {"to_second", distances[i].second, NULL},
                                          {"angle", 0.4, NULL},
                                          {"second_angle", 2.0, NULL}};
        whirl_rotor *rotor = allowed(settings, 8);
        char text[WHIRL_MESSAGE_SIZE];
        double all, slope[8], x[8] = {0};
        assert_true(whirl_rotor_note(rotor, 0, text));
        assert_int_equal(
            sscanf(text, "unbalance_grade at left: by ISO 21940-11 (check which edition counts) %lf g mm", &all), 1);
        check_digits("Grade", "50 kg, G 2.5, 3600 rpm: g mm", "331.572798108", all);
        // Accelerations over the square of the speed are unbalance over mass and length.
        evaluate_rhs(whirl_rotor_system(rotor), 0.7, x, slope);
        for (int plane = 0; plane < 2; plane++) {
            const double share = plane == 0 ? distances[i].share : 1.0 - distances[i].share;
            const double complex expected = 331.572798108e-6 * share * cexp(I * (0.7 + (plane == 0 ? 0.4 : 2.0)));
            const double complex found =
                (slope[4 + 2 * plane] + I * slope[5 + 2 * plane]) * 1e-3 * (plane == 0 ? 30.0 : 20.0);
            check_within("Grade",
                         words("centre %g m and %g m from the planes: share of plane %d, part", distances[i].first,
                               distances[i].second, plane + 1),
                         0.0, cabs(found - expected) / cabs(expected), 1e-12);
        }
        whirl_rotor_free(rotor);
    }
}

/// A shaft of 1 m, a cone, with a disc: mass and centre of mass of its drawing.
static void a_shaft_by_its_drawing(void **unused) {
    (void)unused;
    const double rho = 7800.0, disc = 30.0, at = 0.7;
    const double thin = rho * 0.25 * pi * 0.06 * 0.06 * 0.6, thick = rho * 0.25 * pi * 0.1 * 0.1 * 0.4;
    const double mass = disc + thin + thick, centre = (disc * at + thin * 0.3 + thick * 0.8) / mass;
    whirl_case *object;
    whirl_rotor *rotor;
    char text[WHIRL_MESSAGE_SIZE];
    double all, first, second;
    static const char drawing[] =
        "whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n"
        "  materials: {steel: {modulus: 200 GPa, poisson: 0.3, density: 7800 kg/m3}}\n"
        "  shafts: {shaft: {material: steel}}\n  stations:\n    left: {position: 0.1 m}\n"
        "    disc: {position: 0.7 m, mass: 30 kg}\n    right: {position: 1 m}\n  elements:\n"
        "    - segment: {length: 0.6 m, outer: 60 mm, elements: 3}\n"
        "    - segment: {length: 0.4 m, outer: 100 mm, elements: 2}\n"
        "    - unbalance_grade: {planes: [right, left], grade: 6.3, service_speed: 200 rad/s, "
        "factor: 0.5}\nstudy: {response: {}}\n";
    require_ok(whirl_case_parse(drawing, strlen(drawing), "case", NULL, &object));
    require_ok(whirl_case_rotor(object, NULL, NAN, &rotor));
    assert_true(whirl_rotor_note(rotor, 0, text));
    assert_int_equal(sscanf(text,
                            "unbalance_grade at right: by ISO 21940-11 (check which edition counts) %lf g mm in all, "
                            "%lf in the first plane, %lf",
                            &all, &first, &second),
                     3);
    const double expected = 1e6 * 0.5 * 6.3e-3 * mass / 200.0;
    check_within("Grade", "of a stepped shaft with a disc: half of G 6.3, g mm", expected, all, 1e-9);
    check_within("Grade", "in the first plane, by the distance of the second", expected * (centre - 0.1) / 0.9, first,
                 1e-9);
    check_within("Grade", "in the second plane", expected * (1.0 - centre) / 0.9, second, 1e-9);
    whirl_rotor_free(rotor);
    whirl_case_free(object);
}

static void refusals(void **unused) {
    (void)unused;
    static const struct {
        const char *element, *sentence;
    } wrong[] = {
        {"runout: {at: disc}", "has neither amplitude nor profile, expected one of them"},
        {"runout: {at: disc, profile: [1e-6, 2e-6]}", "has a profile of 2 heights, expected 3 to 128"},
        {"runout: {at: disc, profile: [1e-6, 2e-6, 0], order: 2}",
         "has order and a profile, which replaces it, expected one of them"},
        {"unbalance_grade: {planes: [disc, disc], grade: 1, service_speed: 1}",
         "has both planes at one station, expected two stations"},
        {"unbalance_grade: {planes: [disc, ring], grade: 1, service_speed: 1, mass: 1 kg}",
         "has planes that do not lie on one shaft of finite elements, expected mass, to_first and to_second as well"}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char text[1024], problems[4096] = "";
        whirl_case *object = NULL;
        snprintf(
            text, sizeof text,
            "whirl: 1\nrotor:\n  speed: 1 rad/s\n  length_scale: 1 m\n  stations: {disc: {mass: 1 kg}, ring: {mass: 1 "
            "kg}}\n  elements:\n    - %s\nstudy: {response: {}}\n",
            wrong[i].element);
        assert_int_not_equal(whirl_case_check(text, strlen(text), "case.yaml", problems, sizeof problems, &object).code,
                             WHIRL_OK);
        check_holds("Runout", wrong[i].sentence, strstr(problems, wrong[i].sentence) != NULL);
        whirl_case_free(object);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_surface_that_passes), cmocka_unit_test(profiles_and_vectors),   cmocka_unit_test(responses),
        cmocka_unit_test(unbalance_of_a_grade),  cmocka_unit_test(a_shaft_by_its_drawing), cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests_name("runout", tests, NULL, NULL);
}
