// Motions locked on P-q that are still on their way, and motions that are not locked: a forced oscillator (Adler 1946)
// whose phase psi = q phi - 2 pi p t obeys psi' = delta + s sin psi. It is locked where |delta| < s.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "synthetic.h"

static const double two_pi = 6.283185307179586;

/// Carries phi, in turns, and its tangent over a revolution by RK4; p = {s, delta, p, q}.
static void adler_map(const double *p, size_t step, double *z, double *v) {
    enum { STEPS = 4 };
    const double h = 1.0 / STEPS;
    double psi = two_pi * p[3] * z[0], u = 1.0;
    (void)step;
    for (int i = 0; i < STEPS; i++) {
        const double a = p[1] + p[0] * sin(psi), da = p[0] * cos(psi) * u;
        const double b = p[1] + p[0] * sin(psi + 0.5 * h * a), db = p[0] * cos(psi + 0.5 * h * a) * (u + 0.5 * h * da);
        const double c = p[1] + p[0] * sin(psi + 0.5 * h * b), dc = p[0] * cos(psi + 0.5 * h * b) * (u + 0.5 * h * db);
        const double d = p[1] + p[0] * sin(psi + h * c), dd = p[0] * cos(psi + h * c) * (u + h * dc);
        psi += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        u += h / 6.0 * (da + 2.0 * db + 2.0 * dc + dd);
    }
    v[0] *= u;
    z[0] = (psi / two_pi + p[2]) / p[3];
    z[0] -= floor(z[0]);
}

/// A curve that is not a circle, and is not gone round evenly.
static void on_oval(const double *z, double *point) {
    const double angle = two_pi * (z[0] + 0.05 * sin(two_pi * z[0]));
    point[0] = 2.0 * cos(angle);
    point[1] = sin(angle) + 0.3 * cos(2.0 * angle);
    point[2] = 0.5 * sin(2.0 * angle + 0.4);
}

/// Counts of verdicts on an ensemble: quasi-periodic with low, fair or high confidence, by one record; periodic;
/// neither.
typedef struct tally {
    int quasi[WHIRL_HIGH + 1], periodic, open, count;
} tally;

static whirl_verdict judge(const map_system *system, size_t transient, size_t watch, tally *sum) {
    whirl_record *record = record_map(system, transient, watch, 100);
    record->revolutions = (double)(transient + watch);
    const whirl_verdict verdict = whirl_judge(record);
    free(record);
    sum->count++;
    sum->periodic += verdict.regime == WHIRL_PERIODIC;
    sum->open += verdict.regime == WHIRL_UNDETERMINED;
    if (verdict.regime == WHIRL_QUASI_PERIODIC) sum->quasi[verdict.agreement]++;
    return verdict;
}

static void tell(const char *what, const tally *sum) {
    printf("verdicts | %s, %d motions | - | quasi-periodic: %d high, %d fair, %d low; %d periodic, %d undetermined | - "
           "| -\n",
           what, sum->count, sum->quasi[WHIRL_HIGH], sum->quasi[WHIRL_FAIR], sum->quasi[WHIRL_LOW], sum->periodic,
           sum->open);
}

static map_system oscillator(double s, double delta, int p, int q) {
    return (map_system){
        .map = adler_map, .embed = on_oval, .dimension = 1, .section_dimension = 3, .parameters = {s, delta, p, q}};
}

static bool soaks(void) {
    return getenv("WHIRL_SOAK") != NULL;
}

enum { TONGUES = 12 };

/// Motions locked on P-q, seen on their way from all round the curve, for weak and for strong tongues, in their middle
/// and at their edges. None may be called quasi-periodic with high confidence, nor chaotic, and none of its locks on
/// P-q counts as excluded.
static void check_locked(const char *what, const int tongues[TONGUES][2]) {
    static const double strengths[] = {1e-4, 3e-4, 1e-3, 2e-3, 3e-3, 5e-3, 0.01, 0.02, 0.05};
    static const double places[] = {0.0, 0.3, 0.9, -0.5, 0.6, 0.99};
    static const size_t transients[] = {1100, 100, 550, 3000};
    const size_t stride = soaks() ? 1 : 29;
    tally sum = {0};
    for (size_t i = 0; i < TONGUES * 9 * 6 * 4 * 12; i += stride) {
        const int *tongue = tongues[i % TONGUES];
        const double s = strengths[i / TONGUES % 9], place = places[i / (TONGUES * 9) % 6];
        map_system system = oscillator(s, place * s, tongue[0], tongue[1]);
        system.start[0] = ((double)(i / (TONGUES * 9 * 24)) / 12.0 + 0.01) / tongue[1];
        const whirl_verdict verdict = judge(&system, transients[i / (TONGUES * 9 * 6) % 4], 650, &sum);
        if (verdict.regime == WHIRL_QUASI_PERIODIC && verdict.agreement == WHIRL_HIGH)
            fail_msg("P-%d, s = %g, delta = %g s, psi = %g: quasi-periodic, high", tongue[1], s, place,
                     system.start[0]);
        assert_true(verdict.regime != WHIRL_CHAOTIC);
        assert_true(verdict.unlocked < tongue[1]);
        assert_true(verdict.regime != WHIRL_PERIODIC || verdict.period == tongue[1]);
    }
    tell(what, &sum);
    assert_true(sum.quasi[WHIRL_FAIR] + sum.quasi[WHIRL_LOW] > 0); // the trap is set
}

static void locked(void **state) {
    static const int tongues[TONGUES][2] = {{2, 5},   {3, 7},   {3, 8},   {4, 9},   {5, 13},  {8, 21},
                                            {13, 34}, {21, 55}, {27, 64}, {19, 71}, {31, 80}, {34, 89}};
    (void)state;
    check_locked("locked on P-5 to P-89, on their way", tongues);
}

/// Motions locked on periods up to a third of the revolutions watched.
static void locked_on_long_periods(void **state) {
    static const int tongues[TONGUES][2] = {{34, 97},  {37, 98},  {37, 101}, {34, 111}, {50, 121}, {55, 144},
                                            {61, 150}, {64, 167}, {41, 173}, {70, 187}, {80, 207}, {89, 216}};
    (void)state;
    check_locked("locked on P-97 to P-216, on their way", tongues);
}

/// Rotations by any number, and oscillators beyond their tongues, fast and slow ones: most of them show that they are
/// not locked. The shares are those of the verification manual.
static void not_locked(void **state) {
    static const size_t watches[] = {650, 1000, 2000};
    static const double least_rotations[] = {0.7, 0.8, 0.9}, least_oscillators[] = {0.2, 0.4, 0.6};
    const int count = soaks() ? 400 : 60;
    (void)state;
    for (size_t w = 0; w < (soaks() ? 3 : 2); w++) {
        tally free_ones = {0}, slow_ones = {0};
        char what[96];
        for (int i = 0; i < count; i++) {
            const double u = fmod(0.5 + i * 0.7548776662466927, 1.0), v = fmod(0.5 + i * 0.5698402909980532, 1.0);
            const map_system rotation = oscillator(0.0, two_pi * u, 0, 1);
            judge(&rotation, 100, watches[w], &free_ones);
            const int q = 1 + i % 13;
            const map_system slow = oscillator(0.3 * v, 0.3 * v * (1.01 + 3.0 * u), q / 2, q);
            judge(&slow, 100, watches[w], &slow_ones);
        }
        snprintf(what, sizeof what, "rotations by any number, %zu watched", watches[w]);
        tell(what, &free_ones);
        snprintf(what, sizeof what, "oscillators past their tongues, %zu watched", watches[w]);
        tell(what, &slow_ones);
        assert_int_equal(free_ones.periodic + slow_ones.periodic, 0);
        assert_true(free_ones.quasi[WHIRL_HIGH] >= least_rotations[w] * count);
        assert_true(slow_ones.quasi[WHIRL_HIGH] >= least_oscillators[w] * count);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(locked), cmocka_unit_test(locked_on_long_periods),
                                       cmocka_unit_test(not_locked)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
