// Amplitude and phase at the running speed against closed forms: the Jeffcott rotor's response to unbalance, also
// with the unbalance at an angle, and the full annular rub of case C2, where the answer is not linear.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_cases.h"
#include "support_check.h"
#include "support_rotor.h"
#include "whirl/engine/analyze.h"
#include "whirl/internal/spectrum.h"

enum { X, Y, FORWARD, BACKWARD };

static const double degree = 3.14159265358979323846 / 180.0;

/// Returns the synchronous part after 500 revolutions, over 20.
static whirl_synchronous synchronous_of(whirl_rotor *rotor, const double *start, const char *method) {
    whirl_record_options options = whirl_record_default();
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record *record;
    whirl_spectrum *spectrum;
    strcpy(integrate.method, method);
    integrate.rtol = 1e-12;
    integrate.atol = 1e-14;
    options.transient = 500;
    options.record = 20;
    options.growth = WHIRL_GROWTH_NONE;
    require_ok(whirl_record_motion(whirl_rotor_system(rotor), &integrate, &options, start, NULL, &record));
    require_ok(whirl_spectrum_new(record, 0, 5.0, &spectrum));
    const whirl_synchronous found = spectrum->synchronous;
    whirl_spectrum_free(spectrum);
    whirl_record_free(record);
    whirl_rotor_free(rotor);
    return found;
}

/// Returns the relative error of z = amplitude e^(-i lag).
static double distance(const whirl_synchronous *found, int part, double complex expected) {
    const double complex z = found->amplitude[part] * cexp(-I * found->lag[part] * degree);
    return cabs(z - expected) / cabs(expected);
}

/// The synchronous part of x = Re(H e^(i tau)), H = e r^2 e^(i angle)/(1 - r^2 + 2 i zeta r): y lags x by a quarter
/// turn; the circle is forward.
static void jeffcott(void **state) {
    (void)state;
    static const struct {
        double ratio, zeta, angle;
    } rows[] = {{0.3, 0.05, 0.0}, {0.95, 0.05, 0.0}, {1.0, 0.05, 0.0}, {1.05, 0.05, 0.0},
                {2.5, 0.05, 0.0}, {1.0, 0.2, 1.2},   {1.3, 0.1, -2.0}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double r = rows[i].ratio, start[4] = {0.0, 0.0, 0.0, 0.0};
        const shaft_case jeffcott = {.speed = r,
                                     .damping = 2.0 * rows[i].zeta,
                                     .k1 = 1.0,
                                     .k2 = 1.0,
                                     .eccentricity = 0.1,
                                     .angle = rows[i].angle};
        const whirl_synchronous found = synchronous_of(make_shaft_rotor(&jeffcott), start, "dop853");
        const double complex expected =
            0.1 * r * r * cexp(I * rows[i].angle) / (1.0 - r * r + 2.0 * I * rows[i].zeta * r);
        // y lags x by a quarter of a turn, and the circle has no backward part.
        const double parts = fmax(fmax(distance(&found, X, expected), distance(&found, Y, -I * expected)),
                                  distance(&found, FORWARD, expected));
        const double backward = found.amplitude[BACKWARD] / cabs(expected);
        check_within("B5", words("1X at r = %g, zeta = %g, unbalance at %g rad", r, rows[i].zeta, rows[i].angle), 0.0,
                     fmax(parts, backward), 1e-11);
    }
}

/// [1 + kap (1 - 1/A)(1 + i mu) - w^2 + 2 i zeta w] A e^(-i psi) = e w^2, on the stable circles.
static void annular_rub(void **state) {
    (void)state;
    for (size_t row = 0; row < CASE_C2_ROWS; row++) {
        if (*case_c2[row].growth == '+') continue;
        double start[4];
        const rub_case p = start_case_c2(row, start);
        const double w = p.speed, radius = strtod(case_c2[row].radius, NULL);
        const double complex stiffness =
            1.0 + p.kappa * (1.0 - 1.0 / radius) * (1.0 + I * p.friction) - w * w + 2.0 * I * p.zeta * w;
        const whirl_synchronous found = synchronous_of(make_rub_rotor(&p), start, "dop853");
        check_within("B5", words("1X of the full annular rub, %s", case_c2[row].name), 0.0,
                     distance(&found, FORWARD, p.eccentricity * w * w / stiffness), 1e-11);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(jeffcott), cmocka_unit_test(annular_rub)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
