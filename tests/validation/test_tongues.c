// Arnold tongues: where an oscillator locks to its drive. Its phase turns by 2 pi Omega in the first third of a
// period, is drawn towards 0 by theta' = -K sin theta in the second and towards 0 and pi by theta' = -K/2 sin 2 theta
// in the last, so that the map from section to section is known in closed form: tan(theta/2) and tan(theta) shrink by
// exp(-K). Tongues' boundaries are found from that map, to all digits.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_branch.h"
#include "support_check.h"
#include "whirl/engine/study.h"

static const double pi = 3.14159265358979323846;

// ---------------------------------------------------------------- the map

/// Returns half of the increase of an angle 2h whose tangent tan(h) shrinks by exp(-K).
static double gain(double h, double K) {
    const double c = cos(h), s = sin(h), shrunk = exp(-K);
    return atan2((shrunk - 1.0) * s * c, c * c + shrunk * s * s);
}

/// Turns by which the phase has come further after q periods than p turns, from a phase.
static double excess(double omega, double K, int p, int q, double phase) {
    double theta = phase;
    for (int i = 0; i < q; i++) {
        theta += 2.0 * pi * omega;
        theta += 2.0 * gain(0.5 * theta, K);
        theta += gain(theta, K);
    }
    return (theta - phase) / (2.0 * pi) - p;
}

/// Returns the largest excess of all phases (`side` 1) or the smallest (-1): scanned, then by golden section.
static double extreme_excess(double omega, double K, int p, int q, int side) {
    enum { SCAN = 400, SECTIONS = 60 };
    const double golden = 0.5 * (sqrt(5.0) - 1.0), step = 2.0 * pi / SCAN;
    double best = -INFINITY, at = 0.0;
    for (int i = 0; i < SCAN; i++) {
        const double value = side * excess(omega, K, p, q, step * i);
        if (value > best) {
            best = value;
            at = step * i;
        }
    }
    double low = at - step, high = at + step;
    for (int i = 0; i < SECTIONS; i++) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        if (side * excess(omega, K, p, q, left) > side * excess(omega, K, p, q, right))
            high = right;
        else
            low = left;
    }
    return excess(omega, K, p, q, 0.5 * (low + high));
}

/// Returns the Omega at which the tongue p/q begins (side 1) or ends (side -1). The excess grows with Omega, and orbits
/// exist while its largest value is positive and its least one negative.
static double boundary(double K, int p, int q, int side) {
    double low = (double)p / q - 0.5, high = (double)p / q + 0.5;
    while (high - low > 1e-14) {
        const double middle = 0.5 * (low + high);
        if (extreme_excess(middle, K, p, q, side) > 0.0)
            high = middle;
        else
            low = middle;
        if (middle == low && middle == high) break;
    }
    return 0.5 * (low + high);
}

// ---------------------------------------------------------------- the oscillator

enum { OMEGA, STRENGTH };

/// Computes windows of each third of a period: (1 - cos 3t)^3, five times smooth, of integral 1.
static void windows(const void *model, double t, double *forcing) {
    const double w = 1.0 - cos(3.0 * t), third = 2.0 * pi / 3.0;
    (void)model;
    for (int i = 0; i < 3; i++) forcing[i] = t >= third * i && t < third * (i + 1) ? 0.6 / pi * w * w * w : 0.0;
}

/// Computes the slope of the phase as a point of the unit circle, which attracts nearby points.
static void rhs(const void *model, double t, const double *f, const double *x, double *dx) {
    const double *p = model, back = 1.0 - x[0] * x[0] - x[1] * x[1];
    const double rate = 2.0 * pi * p[OMEGA] * f[0] - p[STRENGTH] * x[1] * (f[1] + f[2] * x[0]);
    (void)t;
    dx[0] = back * x[0] - rate * x[1];
    dx[1] = back * x[1] + rate * x[0];
}

static void tangent(const void *model, double t, const double *f, const double *x, const double *sides, size_t count,
                    const double *u, double *out) {
    const double *p = model, back = 1.0 - x[0] * x[0] - x[1] * x[1];
    const double rate = 2.0 * pi * p[OMEGA] * f[0] - p[STRENGTH] * x[1] * (f[1] + f[2] * x[0]);
    (void)t, (void)sides;
    for (size_t k = 0; k < count; k++, u += 2, out += 2) {
        const double d_back = -2.0 * (x[0] * u[0] + x[1] * u[1]);
        const double d_rate = -p[STRENGTH] * (u[1] * (f[1] + f[2] * x[0]) + x[1] * f[2] * u[0]);
        out[0] = d_back * x[0] + back * u[0] - d_rate * x[1] - rate * u[1];
        out[1] = d_back * x[1] + back * u[1] + d_rate * x[0] + rate * u[0];
    }
}

static const whirl_probe probe = {.name = "phase", .x = 0, .y = 1, .vx = 0, .vy = 1};

static test_family oscillators(double omega, double K) {
    return (test_family){.system = {.dimension = 2,
                                    .period = 2.0 * pi,
                                    .forcing_count = 3,
                                    .forcing = windows,
                                    .rhs = rhs,
                                    .tangent = tangent,
                                    .probe_count = 1,
                                    .probes = &probe},
                         .p = {omega, K},
                         .varied = OMEGA,
                         .start = {0.6, 0.8}};
}

// ---------------------------------------------------------------- a map of regimes

enum { COLUMNS = 56, ROWS = 5, POINTS = COLUMNS * ROWS, LONGEST = 6 };

static const double cell = 0.01;

static whirl_status machine_at(const void *context, const whirl_batch *batch, double value, whirl_machine *machine) {
    const test_family family = oscillators(value, batch->second_value);
    const whirl_family machines = family_of(&family);
    (void)context;
    return machines.machine(machines.context, value, machine);
}

static whirl_result *run(const double *omegas, const double *strengths) {
    static const char *const analyses[] = {"poincare", "lyapunov", "orbit", "regime", "floquet"};
    whirl_study study = {.batch_count = 1, .machine = machine_at};
    whirl_batch *batch = &study.batches[0];
    whirl_result *result;
    const whirl_run_options options = {.threads = 2};
    *batch = (whirl_batch){.name = "map", .parameter = "Omega", .second = "K", .count = POINTS, .row = COLUMNS};
    batch->values = omegas;
    batch->second_values = strengths;
    batch->integrate = whirl_integrate_default();
    strcpy(batch->integrate.method, "dop853");
    batch->integrate.rtol = 1e-9;
    batch->record = whirl_record_default();
    batch->record.transient = 1000;
    batch->record.record = 100;
    batch->record.settle = true;
    for (size_t i = 0; i < sizeof analyses / sizeof *analyses; i++)
        assert_true(whirl_analysis_add(&batch->analyses, analyses[i]));
    whirl_analysis_needs(batch->analyses, &batch->record);
    require_ok(whirl_study_run(&study, &options, &result));
    return result;
}

/// The tongues p/q of up to LONGEST periods, at one strength.
typedef struct tongue {
    int q;
    double from, to;
} tongue;

static size_t tongues_at(double K, tongue tongues[16]) {
    size_t count = 0;
    for (int q = 1; q <= LONGEST; q++)
        for (int p = 0; 2 * p <= q + 1; p++) {
            int a = p, b = q;
            while (b != 0) {
                const int rest = a % b;
                a = b;
                b = rest;
            }
            if (a == 1) tongues[count++] = (tongue){q, boundary(K, p, q, 1), boundary(K, p, q, -1)};
        }
    return count;
}

/// Returns the expected period of a point: that of its tongue, 0 outside of all, -1 within a cell of a boundary.
static int expected_at(const tongue *tongues, size_t count, double omega) {
    int expected = 0;
    for (size_t i = 0; i < count; i++) {
        if (fabs(omega - tongues[i].from) <= cell || fabs(omega - tongues[i].to) <= cell) return -1;
        if (omega > tongues[i].from && omega < tongues[i].to) expected = tongues[i].q;
    }
    return expected;
}

/// Points by what is expected of them: how many there are, how many have another verdict, and how many none.
typedef struct tally {
    size_t seen, wrong, undetermined;
} tally;

/// Counts a verdict: outside of the tongues motions are quasi-periodic, or locked in a tongue of more than LONGEST
/// periods.
static void count_verdict(whirl_verdict verdict, int expected, tally *points) {
    const bool locked = verdict.regime == WHIRL_PERIODIC;
    const bool right = expected > 0 ? locked && verdict.period == expected
                                    : verdict.regime == WHIRL_QUASI_PERIODIC || (locked && verdict.period > LONGEST);
    points->seen++;
    if (verdict.regime == WHIRL_UNDETERMINED)
        points->undetermined++;
    else
        points->wrong += !right;
}

static void check_tally(const tally *points, int period) {
    if (points->seen == 0) return;
    const char *where = period > 0 ? words("in tongues of %d", period) : "outside of them";
    check_within("tongues", words("map, %zu points %s: wrong", points->seen, where), 0.0, (double)points->wrong, 0.0);
    check_within("tongues", words("... undetermined"), 0.0, (double)points->undetermined,
                 period > 0 ? 0.0 : 0.2 * (double)points->seen);
}

/// Every point further than a cell from all boundaries is locked if its tongue says so, and else not. Next to tongues
/// of more periods the section fills its curve slowly: there a verdict may be missing, but never wrong.
static void regimes_are_those_of_the_tongues(void **state) {
    double omegas[POINTS], strengths[POINTS];
    tally tallies[LONGEST + 1] = {0};
    (void)state;
    for (size_t i = 0; i < POINTS; i++) {
        omegas[i] = cell * (double)(i % COLUMNS) - 0.003;
        strengths[i] = 0.2 + 0.2 * (double)(i / COLUMNS);
    }
    whirl_result *result = run(omegas, strengths);
    for (size_t row = 0; row < ROWS; row++) {
        tongue tongues[16];
        const size_t count = tongues_at(strengths[row * COLUMNS], tongues);
        for (size_t i = row * COLUMNS; i < (row + 1) * COLUMNS; i++) {
            const int expected = expected_at(tongues, count, omegas[i]);
            if (expected >= 0) count_verdict(whirl_table_verdict(&result->tables[0], i), expected, &tallies[expected]);
        }
    }
    for (int q = 0; q <= LONGEST; q++) check_tally(&tallies[q], q);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- boundaries as curves

/// A tongue p/q with the branch of its orbits, at a strength.
typedef struct locked {
    int p, q;
    double K, middle;
    test_family family;
    whirl_branch_options options;
    whirl_branch *branch;
} locked;

static void follow_orbits(locked *l) {
    l->middle = 0.5 * (boundary(l->K, l->p, l->q, 1) + boundary(l->K, l->p, l->q, -1));
    l->family = oscillators(l->middle, l->K);
    l->options = whirl_branch_default(l->middle - 0.3, l->middle + 0.3);
    l->options.orbit.integrate.rtol = 1e-11;
    l->options.orbit.integrate.atol = 1e-13;
    whirl_orbit *start = find_orbit(&l->family, (size_t)l->q, &l->options.orbit);
    l->branch = follow_branch(&l->family, start, 1, &l->options);
    whirl_orbit_free(start);
}

/// Checks the fold on that side of the middle, and the curve through it over the strength.
static void check_side(const locked *l, int side) {
    const whirl_branch_point *fold = NULL;
    double worst = 0.0;
    for (size_t i = 0; i < l->branch->count; i++)
        if (l->branch->points[i].special == WHIRL_FOLD && side * (l->middle - l->branch->points[i].value) > 0.0)
            fold = &l->branch->points[i];
    assert_non_null(fold);
    check_within("tongues", words("tongue %d/%d, K = %g: %s", l->p, l->q, l->K, side > 0 ? "begins at" : "ends at"),
                 boundary(l->K, l->p, l->q, side), fold->value, 1e-8);
    whirl_branch *curve = follow_curve(&l->family, STRENGTH, fold, -1, 0.2, 1.0, &l->options);
    assert_true(curve->count > 10);
    for (size_t i = 0; i < curve->count; i++)
        worst = fmax(worst, fabs(curve->points[i].value - boundary(curve->points[i].second, l->p, l->q, side)));
    check_within("tongues",
                 words("... the curve through it over K from .2 to 1, %zu points: furthest off", curve->count), 0.0,
                 worst, 1e-8);
    whirl_branch_free(curve);
}

/// Orbits of a tongue fold at its boundaries, and curves of these folds over the strength stay on them.
static void curves_are_the_boundaries(void **state) {
    static const int tongues[][2] = {{0, 1}, {1, 2}, {1, 3}, {2, 5}};
    (void)state;
    for (size_t k = 0; k < sizeof tongues / sizeof *tongues; k++) {
        locked l = {.p = tongues[k][0], .q = tongues[k][1], .K = 0.8};
        follow_orbits(&l);
        check_side(&l, 1);
        check_side(&l, -1);
        whirl_branch_free(l.branch);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(regimes_are_those_of_the_tongues),
                                       cmocka_unit_test(curves_are_the_boundaries)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
