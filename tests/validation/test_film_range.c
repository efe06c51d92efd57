// Range of the law of short bearings: its force compared with that of films of finite length, by Reynolds' equation.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine/rotor.h"

static const double pi = 3.14159265358979323846;

/// The force on a journal at rest at eccentricity e along its displacement and across it, in mu omega R L (R/c)^2, of a
/// film of `ratio` = L/2R with Guembel's condition. With h = 1 + e cos t and p = sum p_k(t) cos((2k + 1) pi z/L),
///     (h^3 p_k')' - (R/L)^2 ((2k + 1) pi)^2 h^3 p_k = -6 e sin t 4 (-1)^k/((2k + 1) pi),
/// where p_k is odd in t: differences over half the film, which is that of positive pressure.
static void film_of_finite_length(double ratio, double e, double force[2]) {
    enum { PARTS = 400, TERMS = 60 };
    const double d = pi / PARTS, q = 1.0 / (4.0 * ratio * ratio);
    double mean[PARTS] = {0.0};
    for (int k = 0; k < TERMS; k++) {
        const double wave = (2 * k + 1) * pi, share = (k % 2 ? -4.0 : 4.0) / wave;
        double above[PARTS] = {0.0}, p[PARTS + 1] = {0.0}; // Thomas's elimination
        for (int i = 1; i < PARTS; i++) {
            const double t = i * d, h = 1.0 + e * cos(t);
            const double low = pow(1.0 + e * cos(t - 0.5 * d), 3.0) / (d * d);
            const double high = pow(1.0 + e * cos(t + 0.5 * d), 3.0) / (d * d);
            const double pivot = -(low + high) - q * wave * wave * h * h * h - low * above[i - 1];
            above[i] = high / pivot;
            p[i] = (-6.0 * e * sin(t) * share - low * p[i - 1]) / pivot;
        }
        for (int i = PARTS - 1; i > 0; i--) {
            p[i] -= above[i] * p[i + 1];
            mean[i] += 0.5 * share * p[i];
        }
    }
    force[0] = force[1] = 0.0;
    for (int i = 1; i < PARTS; i++) {
        force[0] += mean[i] * cos(i * d) * d;
        force[1] += mean[i] * sin(i * d) * d;
    }
}

/// Returns the same force by the short law.
static double short_force(double ratio, double e) {
    double force[2];
    whirl_film_force(e, 0.0, 0.0, 0.0, force);
    return ratio * ratio * hypot(force[0], force[1]);
}

static void finite_lengths_have_both_limits(void **unused) {
    (void)unused;
    double force[2];
    for (double e = 0.2; e < 0.85; e += 0.3) {
        film_of_finite_length(0.01, e, force);
        check_within("A5", words("L/D = .01 over the short law at e = %g", e), 1.0,
                     hypot(force[0], force[1]) / short_force(0.01, e), 1e-3);
        // Half of Sommerfeld's film; ends take about .6 D/L of it.
        const double p = 1.0 - e * e, radial = 12.0 * e * e / ((2.0 + e * e) * p);
        const double tangential = 6.0 * pi * e / ((2.0 + e * e) * sqrt(p));
        film_of_finite_length(50.0, e, force);
        check_within("A5", words("L/D = 50 over the long film at e = %g", e), 1.0,
                     hypot(force[0], force[1]) / hypot(radial, tangential), 0.02);
    }
}

/// The shares of the load in the table of docs/theory.md.
static void the_short_law_is_too_strong_beyond_its_range(void **unused) {
    (void)unused;
    static const struct {
        double ratio, e;
        const char *share;
    } rows[] = {{0.25, 0.2, ".97"}, {0.25, 0.5, ".93"}, {0.25, 0.8, ".79"}, {0.5, 0.2, ".89"},
                {0.5, 0.5, ".79"},  {0.5, 0.8, ".54"},  {1.0, 0.2, ".68"},  {1.0, 0.5, ".53"},
                {1.0, 0.8, ".26"},  {2.0, 0.2, ".36"},  {2.0, 0.5, ".25"},  {2.0, 0.8, ".10"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double force[2];
        film_of_finite_length(rows[i].ratio, rows[i].e, force);
        check_digits("A5", words("film of L/D = %g over the short law at e = %g", rows[i].ratio, rows[i].e),
                     rows[i].share, hypot(force[0], force[1]) / short_force(rows[i].ratio, rows[i].e));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(finite_lengths_have_both_limits),
                                       cmocka_unit_test(the_short_law_is_too_strong_beyond_its_range)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
