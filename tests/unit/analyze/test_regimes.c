// Verdicts on maps whose regime is known, for records as short as those of a sweep and as long as those of one point.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "synthetic.h"

static const double two_pi = 6.283185307179586;

/// Revolutions watched and recorded.
static const size_t lengths[][2] = {{650, 100}, {1600, 100}, {7500, 6000}};

static void assert_verdict(const map_system *system, size_t transient, const char *expected) {
    for (size_t l = 0; l < sizeof lengths / sizeof *lengths; l++) {
        whirl_record *record = record_map(system, transient, lengths[l][0], lengths[l][1]);
        const whirl_verdict verdict = whirl_judge(record);
        char name[64], reason[256];
        whirl_verdict_name(&verdict, name, sizeof name);
        whirl_verdict_reason(&verdict, reason, sizeof reason);
        if (strcmp(name, expected) != 0) {
            fail_msg("parameters %g, %g, %zu watched: %s, expected %s; %s", system->parameters[0],
                     system->parameters[1], lengths[l][0], name, expected, reason);
        }
        free(record);
    }
}

static map_system logistic(double r) {
    return (map_system){
        .map = logistic_map, .dimension = 1, .section_dimension = 1, .parameters = {r}, .start = {0.3123}};
}

static map_system henon(double a) {
    return (map_system){
        .map = henon_map, .dimension = 2, .section_dimension = 2, .parameters = {a, 0.3}, .start = {0.1, 0.1}};
}

static map_system circle(double omega, double k) {
    return (map_system){.map = circle_map,
                        .embed = on_circle,
                        .dimension = 1,
                        .section_dimension = 2,
                        .parameters = {omega, k},
                        .start = {0.1}};
}

static map_system delayed(double a) {
    return (map_system){
        .map = delayed_logistic_map, .dimension = 2, .section_dimension = 2, .parameters = {a}, .start = {0.3, 0.31}};
}

/// The cascade r = 3, 3.4495, 3.5441, 3.5644, 3.5688, ... and the windows of the logistic map (May 1976).
static void periodic(void **state) {
    (void)state;
    const struct {
        double r;
        const char *name;
    } windows[] = {{2.8, "P-1"},     {3.2, "P-2"},   {3.5, "P-4"},   {3.55, "P-8"}, {3.566, "P-16"},
                   {3.5692, "P-32"}, {3.83, "P-3"},  {3.845, "P-6"}, {3.74, "P-5"}, {3.906, "P-5"},
                   {3.9605, "P-4"},  {3.627, "P-6"}, {3.7017, "P-7"}};
    for (size_t i = 0; i < sizeof windows / sizeof *windows; i++) {
        const map_system system = logistic(windows[i].r);
        assert_verdict(&system, 5000, windows[i].name);
    }
    const map_system systems[] = {henon(0.2),   henon(0.9),        henon(1.0),      henon(1.3),
                                  delayed(1.9), circle(0.05, 0.9), circle(0.5, 0.9)};
    const char *names[] = {"P-1", "P-2", "P-4", "P-7", "P-1", "P-1", "P-2"};
    for (size_t i = 0; i < 7; i++) assert_verdict(&systems[i], 3000, names[i]);
}

static void chaotic(void **state) {
    (void)state;
    const double r[] = {3.6, 3.65, 3.7, 3.75, 3.8, 3.87, 3.9, 3.95, 3.99};
    for (size_t i = 0; i < sizeof r / sizeof *r; i++) {
        const map_system system = logistic(r[i]);
        assert_verdict(&system, 1000, "chaotic");
    }
    const map_system systems[] = {henon(1.1),
                                  henon(1.2),
                                  henon(1.4),
                                  delayed(2.27),
                                  {.map = standard_map,
                                   .embed = on_circle,
                                   .dimension = 2,
                                   .section_dimension = 2,
                                   .parameters = {6.0},
                                   .start = {0.1, 0.2}}};
    for (size_t i = 0; i < 5; i++) assert_verdict(&systems[i], 3000, "chaotic");
}

/// Off the tongues of the circle map, and past the Neimark-Sacker bifurcation of the delayed logistic map.
static void quasi_periodic(void **state) {
    (void)state;
    const double omegas[] = {0.38196601125, 0.41, 0.412, 0.427, 0.4371, 0.588, 0.7391, 0.3181};
    for (size_t i = 0; i < sizeof omegas / sizeof *omegas; i++) {
        const map_system system = circle(omegas[i], 0.3);
        assert_verdict(&system, 100, "quasi-periodic (1 curve)");
    }
    const double a[] = {2.03, 2.05, 2.1};
    for (size_t i = 0; i < 3; i++) {
        const map_system system = delayed(a[i]);
        assert_verdict(&system, 5000, "quasi-periodic (1 curve)");
    }
}

/// Computes the next point on p[1] curves, visited in turn, each a rotation by p[0]; z = (phase, curve, number of
/// curves).
static void turning_map(const double *p, size_t step, double *z, double *v) {
    (void)step;
    z[0] = fmod(z[0] + p[0], 1.0);
    z[1] = fmod(z[1] + 1.0, p[1]);
    z[2] = p[1];
    v[1] = v[2] = 0.0;
}

static void on_ovals(const double *z, double *section) {
    const double around = two_pi * z[1] / z[2], along = two_pi * z[0], radius = 0.6 / z[2];
    const double x = cos(around) + 0.3 * cos(3.0 * around), y = 1.2 * sin(around);
    section[0] = x + radius * (cos(along) + 0.1 * cos(2.0 * along));
    section[1] = y + 0.7 * radius * sin(along + 0.3);
    section[2] = 0.3 * x + radius * sin(along - 1.0);
    section[3] = 0.5 * y + 0.4 * radius * cos(along + 0.5) * cos(along);
}

static void several_curves(void **state) {
    (void)state;
    for (int curves = 1; curves <= 10; curves++) {
        const map_system system = {.map = turning_map,
                                   .embed = on_ovals,
                                   .dimension = 3,
                                   .section_dimension = 4,
                                   .parameters = {curves == 8 ? 0.2247 : 0.38196601125, curves},
                                   .start = {0.1}};
        char expected[64];
        snprintf(expected, sizeof expected, "quasi-periodic (%d curve%s)", curves, curves == 1 ? "" : "s");
        assert_verdict(&system, 10, expected);
    }
}

static void off_centre(const double *z, double *section) {
    section[0] = 1.0 + z[0];
    section[1] = z[1] - 2.0;
    section[2] = 0.5 * z[0] + 0.2 * z[1] * z[1];
}

/// A spiral that still turns in or out, near a resonance or not, is never judged a torus, chaos, or a higher period,
/// however slowly it moves. It is undetermined until it is at rest, or until the fitted map of its section shows that
/// it will come to rest. Then it is P-1, with fair confidence at most while it is far from rest.
static void spirals(void **state) {
    (void)state;
    const double moduli[] = {0.9, 0.99, 0.999, 0.9999, 0.99999, 1.0005, 1.002, 1.005, 1.01};
    const double angles[] = {0.2, 0.25, 1.0 / 3.0, 0.41, 0.38196601125, 0.5, 0.125, 0.4000001};
    const size_t transients[] = {100, 1100, 12000};
    for (size_t i = 0; i < 9 * 8 * 3; i++) {
        const double modulus = moduli[i % 9];
        const size_t transient = modulus > 1.0 ? 100 : transients[i / 72];
        map_system system = {.map = spiral_map,
                             .embed = off_centre,
                             .dimension = 2,
                             .section_dimension = 3,
                             .parameters = {modulus, angles[i / 9 % 8]},
                             .start = {modulus > 1.0 ? 1e-6 : 0.5, 0.0}};
        whirl_record *record = record_map(&system, transient, 650, 100);
        const whirl_verdict verdict = whirl_judge(record);
        const bool at_rest = pow(modulus, (double)transient + 522.0) < 1e-6;
        const bool on_its_way = modulus < 1.0 && verdict.settles && verdict.confidence < WHIRL_HIGH &&
                                fabs(verdict.settling.value - log(modulus)) <= 6.0 * verdict.settling.error + 1e-9;
        if (verdict.regime != WHIRL_UNDETERMINED &&
            !((at_rest || on_its_way) && verdict.regime == WHIRL_PERIODIC && verdict.period == 1)) {
            fail_msg("modulus %g, angle %g: %s, period %d", modulus, angles[i / 9 % 8],
                     whirl_regime_name(verdict.regime), verdict.period);
        }
        if (pow(modulus, (double)transient) < 1e-14) assert_int_equal(verdict.regime, WHIRL_PERIODIC);
        free(record);
    }
}

/// A motion that starts exactly on an unstable one stays there however long it runs: the advice is another start. The
/// spiral's point at rest has the exponent ln 1.01, that of the logistic map for r = 4 at 3/4 (exact in binary) ln 2.
static void starts_on_unstable(void **state) {
    (void)state;
    map_system rest = {.map = spiral_map, .dimension = 2, .section_dimension = 2, .parameters = {1.01, 0.31}};
    map_system fixed = logistic(4.0);
    fixed.start[0] = 0.75;
    const map_system *const systems[] = {&rest, &fixed};
    const double exponents[] = {log(1.01), log(2.0)};
    for (size_t i = 0; i < 2; i++) {
        char text[512];
        whirl_record *record = record_map(systems[i], 1100, 650, 100);
        const whirl_verdict verdict = whirl_judge(record);
        assert_int_equal(verdict.regime, WHIRL_UNDETERMINED);
        assert_int_equal(verdict.advice.remedy, WHIRL_OTHER_START);
        assert_true(fabs(verdict.exponent.value - exponents[i]) <= 1e-12);
        whirl_verdict_reason(&verdict, text, sizeof text);
        assert_non_null(
            strstr(text, "stays where it started, on an unstable motion that nothing pushes it off (largest exponent"));
        whirl_verdict_advice(&verdict, text, sizeof text);
        assert_string_equal(text, "start near this motion (initial)");
        free(record);
    }
    rest.start[0] = 1e-9; // near it, and moving towards it
    whirl_record *record = record_map(&rest, 100, 650, 100);
    assert_int_not_equal(whirl_judge(record).advice.remedy, WHIRL_OTHER_START);
    free(record);
    rest.start[0] = 0.0;
    rest.parameters[0] = 0.99; // stable: it is at rest
    record = record_map(&rest, 100, 650, 100);
    assert_int_equal(whirl_judge(record).regime, WHIRL_PERIODIC);
    free(record);
}

/// Without a perturbation only returns to rounding errors count.
static void without_perturbation(void **state) {
    (void)state;
    const map_system systems[] = {logistic(3.5), logistic(3.8)};
    const whirl_regime expected[] = {WHIRL_PERIODIC, WHIRL_UNDETERMINED};
    for (size_t i = 0; i < 2; i++) {
        whirl_record *record = record_map(&systems[i], 3000, 650, 100);
        record->growth_count = 0;
        assert_int_equal(whirl_judge(record).regime, expected[i]);
        free(record);
    }
}

static void diverged(void **state) {
    (void)state;
    const whirl_record record = {.motion = WHIRL_DIVERGED, .diverged_at = 17.0};
    const whirl_verdict verdict = whirl_judge(&record);
    assert_int_equal(verdict.regime, WHIRL_DIVERGING);
    char text[64], shortened[5];
    whirl_verdict_name(&verdict, text, sizeof text);
    assert_string_equal(text, "diverged at revolution 17");
    whirl_verdict_name(&verdict, shortened, sizeof shortened);
    assert_string_equal(shortened, "dive");
    assert_string_equal(whirl_regime_name(verdict.regime), "diverged");
}

/// Motions that diverge at once, or much earlier at one step size than at the other, may diverge by unstable steps: the
/// verdict is not trusted.
static void diverged_at_once_or_apart(void **state) {
    (void)state;
    const double first[] = {17.0, 1.0, 17.0}, other[] = {18.0, 1.0, 40.0};
    const whirl_confidence expected[] = {WHIRL_HIGH, WHIRL_FAIR, WHIRL_LOW};
    for (int i = 0; i < 3; i++) {
        const whirl_record a = {.motion = WHIRL_DIVERGED, .diverged_at = first[i]};
        const whirl_record b = {.motion = WHIRL_DIVERGED, .diverged_at = other[i]};
        whirl_verdict verdict = whirl_judge(&a);
        const whirl_verdict second = whirl_judge(&b);
        whirl_verdict_confirm(&verdict, &second);
        assert_int_equal(verdict.confidence, expected[i]);
    }
}

/// Records of one revolution and of a few have no verdict.
static void too_short(void **state) {
    (void)state;
    for (size_t watch = 1; watch < 12; watch++) {
        const map_system system = logistic(3.8);
        whirl_record *record = record_map(&system, 100, watch, 1);
        const whirl_verdict verdict = whirl_judge(record);
        assert_int_equal(verdict.regime, WHIRL_UNDETERMINED);
        char reason[256];
        whirl_verdict_reason(&verdict, reason, sizeof reason);
        assert_true(strlen(reason) > 20);
        free(record);
    }
}

/// Quantities that could not be computed from few points appear in no sentence.
static void reasons_have_numbers_alone(void **state) {
    (void)state;
    const map_system systems[] = {logistic(3.8), logistic(3.5), logistic(3.56994)};
    for (size_t i = 0; i < sizeof systems / sizeof *systems; i++)
        for (size_t watch = 1; watch < 130; watch++) {
            whirl_record *record = record_map(&systems[i], 100, watch, 1);
            const whirl_verdict verdict = whirl_judge(record);
            char reason[256];
            whirl_verdict_reason(&verdict, reason, sizeof reason);
            if (strstr(reason, "nan")) fail_msg("%s", reason);
            free(record);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(periodic),
        cmocka_unit_test(chaotic),
        cmocka_unit_test(quasi_periodic),
        cmocka_unit_test(several_curves),
        cmocka_unit_test(spirals),
        cmocka_unit_test(without_perturbation),
        cmocka_unit_test(diverged),
        cmocka_unit_test(diverged_at_once_or_apart),
        cmocka_unit_test(too_short),
        cmocka_unit_test(starts_on_unstable),
        cmocka_unit_test(reasons_have_numbers_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
