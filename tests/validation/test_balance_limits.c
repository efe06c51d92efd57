// Weights that minimize the largest vibration, and weights within limits: against Lawson's algorithm, against random
// weights nearby, and against the closed form for one weight set.
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
#include "whirl/internal/balance.h"

static const char *const id = "balance limits";

enum { PLANES = 3, ROWS = 8 };

/// A rotor: influence coefficients in m/(kg m), readings in m, limits in kg m (infinite: no limit).
typedef struct rotor {
    size_t planes, rows;
    double complex effect[ROWS][PLANES], before[ROWS];
    double limit[PLANES];
} rotor;

static double uniform(void) {
    static uint64_t state = 88172645463325252u; // xorshift: Marsaglia 2003
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53;
}

static double complex any(double size) {
    return size * (2.0 * uniform() - 1.0 + I * (2.0 * uniform() - 1.0));
}

static rotor any_rotor(size_t planes, size_t rows, bool limited) {
    rotor of = {.planes = planes, .rows = rows};
    for (size_t r = 0; r < rows; r++) {
        of.before[r] = any(5e-6);
        for (size_t p = 0; p < planes; p++) of.effect[r][p] = any(3e-3);
    }
    for (size_t p = 0; p < planes; p++) of.limit[p] = limited && p != 1 ? 5e-5 + 4e-4 * uniform() : (double)INFINITY;
    return of;
}

static void append(char *text, size_t size, const char *format, ...) {
    va_list arguments;
    const size_t used = strlen(text);
    va_start(arguments, format);
    vsnprintf(text + used, size - used, format, arguments);
    va_end(arguments);
}

/// Solves the file of a rotor. Freed by whirl_balance_free and whirl_correction_free.
static whirl_correction *solve(const rotor *of, const char *least, const char *more, whirl_balance **balance) {
    static char text[16384];
    whirl_correction *found;
    text[0] = '\0';
    append(text, sizeof text, "balance: 1\nangles: with\nphases: lead\nleast: %s\nplanes:\n", least);
    for (size_t p = 0; p < of->planes; p++) {
        append(text, sizeof text, "  - {name: p%zu", p);
        if (isfinite(of->limit[p])) append(text, sizeof text, ", limit: %.17g", of->limit[p]);
        append(text, sizeof text, "}\n");
    }
    append(text, sizeof text, "%s", more);
    if (!*more) append(text, sizeof text, "coefficients:\n");
    for (size_t r = 0; r < of->rows && !*more; r++)
        for (size_t p = 0; p < of->planes; p++)
            append(text, sizeof text, "  - {plane: p%zu, speed: 300, probe: s%zu, amplitude: %.17g, phase: %.17g}\n", p,
                   r, cabs(of->effect[r][p]), carg(of->effect[r][p]));
    append(text, sizeof text, "vibration:\n");
    for (size_t r = 0; r < of->rows; r++)
        append(text, sizeof text, "  - {run: 1, speed: 300, probe: s%zu, amplitude: %.17g, phase: %.17g}\n", r,
               cabs(of->before[r]), carg(of->before[r]));
    for (size_t r = 0; r < of->rows && *more; r++)
        append(text, sizeof text, "  - {run: 2, speed: 300, probe: s%zu, amplitude: %.17g, phase: %.17g}\n", r,
               cabs(of->before[r] + of->effect[r][0]), carg(of->before[r] + of->effect[r][0]));
    require_ok(whirl_balance_parse(text, strlen(text), "rotor.yaml", NULL, balance));
    require_ok(whirl_balance_solve(*balance, NULL, &found));
    return found;
}

/// Returns the largest residual vibration with these weights, or with `squares` the root of the sum of squares.
static double left(const rotor *of, const double complex *weights, bool squares) {
    double largest = 0.0, sum = 0.0;
    for (size_t r = 0; r < of->rows; r++) {
        double complex after = of->before[r];
        for (size_t p = 0; p < of->planes; p++) after += of->effect[r][p] * weights[p];
        largest = fmax(largest, cabs(after));
        sum += creal(after * conj(after));
    }
    return squares ? sqrt(sum) : largest;
}

/// Solves weighted least squares, by elimination in real numbers.
static void weighted(const rotor *of, const double *weight, double complex *x) {
    double matrix[4 * PLANES * PLANES] = {0.0}, side[2 * PLANES] = {0.0};
    const size_t n = 2 * of->planes;
    for (size_t r = 0; r < of->rows; r++)
        for (size_t i = 0; i < n; i++) {
            const double complex a = conj(i % 2 ? I * of->effect[r][i / 2] : of->effect[r][i / 2]);
            side[i] -= weight[r] * creal(a * of->before[r]);
            for (size_t k = 0; k < n; k++)
                matrix[i * n + k] += weight[r] * creal(a * (k % 2 ? I * of->effect[r][k / 2] : of->effect[r][k / 2]));
        }
    solve_linear(n, matrix, side);
    for (size_t p = 0; p < of->planes; p++) x[p] = side[2 * p] + I * side[2 * p + 1];
}

/// Runs Lawson's algorithm (1961): the weight of each row is multiplied by its residual. The least possible value of
/// the largest residual is between the root of the weighted mean square (`below`) and the largest residual (`above`).
static void lawson(const rotor *of, double *below, double *above) {
    double weight[ROWS];
    double complex x[PLANES];
    *below = 0.0, *above = INFINITY;
    for (size_t r = 0; r < of->rows; r++) weight[r] = 1.0 / (double)of->rows;
    for (int k = 0; k < 20000; k++) {
        double sum = 0.0, mean = 0.0;
        weighted(of, weight, x);
        for (size_t r = 0; r < of->rows; r++) {
            double complex after = of->before[r];
            for (size_t p = 0; p < of->planes; p++) after += of->effect[r][p] * x[p];
            mean += weight[r] * creal(after * conj(after));
            weight[r] *= cabs(after);
            sum += weight[r];
        }
        *below = fmax(*below, sqrt(mean));
        *above = fmin(*above, left(of, x, false));
        for (size_t r = 0; r < of->rows; r++) weight[r] /= sum;
        if (*above - *below < 1e-7 * *above) return;
    }
}

static void least_max(void **state) {
    double outside = 0.0, wide = 0.0;
    (void)state;
    for (int k = 0; k < 24; k++) {
        const rotor of = any_rotor(1 + (size_t)k % PLANES, 5 + (size_t)k % 4, false);
        whirl_balance *balance;
        double below, above;
        whirl_correction *found = solve(&of, "max", "", &balance);
        lawson(&of, &below, &above);
        outside = fmax(outside, fmax(below - found->left, found->left - above) / above);
        wide = fmax(wide, (above - below) / above);
        whirl_correction_free(found);
        whirl_balance_free(balance);
    }
    check_within(id, "24 rotors: what is left, outside of the bounds by Lawson's algorithm", 0.0, fmax(outside, 0.0),
                 1e-9);
    check_holds(id, words("these bounds are within %.1g of each other", wide), wide < 1e-4);
}

/// Returns the relative reduction of the residual by the best of 14000 random sets of weights near the found ones,
/// within their limits; 0 if none is better.
static double gain_nearby(const rotor *of, const double complex *weights, bool squares) {
    const double here = left(of, weights, squares);
    double best = here;
    for (int scale = 1; scale <= 7; scale++)
        for (int k = 0; k < 2000; k++) {
            double complex other[PLANES];
            for (size_t p = 0; p < of->planes; p++) {
                other[p] = weights[p] + any(1e-3 * pow(10.0, -scale));
                if (cabs(other[p]) > of->limit[p]) other[p] *= of->limit[p] / cabs(other[p]);
            }
            best = fmin(best, left(of, other, squares));
        }
    return (here - best) / here;
}

static void within_limits(void **state) {
    double beyond = 0.0, gain = 0.0, unlike = 0.0;
    size_t at_limit = 0;
    (void)state;
    for (int k = 0; k < 12; k++) {
        const rotor of = any_rotor(1 + (size_t)k % PLANES, 5 + (size_t)k % 4, true);
        whirl_balance *balance;
        whirl_correction *found = solve(&of, "max", "", &balance);
        double complex weights[PLANES];
        for (size_t p = 0; p < of.planes; p++) {
            weights[p] = found->moment[p][0] + I * found->moment[p][1];
            beyond = fmax(beyond, cabs(weights[p]) / of.limit[p] - 1.0);
            at_limit += cabs(weights[p]) > (1.0 - 1e-6) * of.limit[p];
        }
        unlike = fmax(unlike, fabs(found->left / left(&of, weights, false) - 1.0));
        gain = fmax(gain, gain_nearby(&of, weights, false));
        whirl_correction_free(found);
        whirl_balance_free(balance);
    }
    check_within(id, "12 rotors: weights beyond their limits", 0.0, fmax(beyond, 0.0), 1e-12);
    check_holds(id, words("%zu weights are at their limits", at_limit), at_limit > 3);
    check_within(id, "12 rotors: reported remaining vibration", 0.0, unlike, 1e-12);
    check_within(id, "12 rotors: what the best of 14000 weights nearby gains", 0.0, gain, 1e-9);
}

/// One weight set: with limits the least-squares amount is that without limits, reduced until the first plane meets its
/// limit.
static void sets_within_limits(void **state) {
    (void)state;
    for (int plane = 0; plane < 3; plane++) {
        rotor of = any_rotor(3, 6, false);
        static const double shape[3] = {0.5, 1.0, -0.7};
        // Run 2 has 1 kg m of the set, so effect[r][0] is the effect of the whole set.
        const char *const more =
            "modes:\n  - {speed: 300, shape: [0.5, 1, -0.7]}\ntrials:\n  - {run: 2, set: 1, moment: 1, angle: 0}\n";
        double complex best = 0.0;
        double square = 0.0;
        for (size_t r = 0; r < of.rows; r++) {
            best -= conj(of.effect[r][0]) * of.before[r];
            square += creal(of.effect[r][0] * conj(of.effect[r][0]));
        }
        best /= square;
        whirl_balance *balance;
        whirl_correction *free_one = solve(&of, "squares", more, &balance);
        const double share = hypot(free_one->sets[0][plane][0], free_one->sets[0][plane][1]);
        check_within(id, "one set without limits, over its closed form", 1.0,
                     hypot(free_one->amount[0][0], free_one->amount[0][1]) / cabs(best), 1e-9);
        check_holds(id, words("plane %d has a part in the set, %.3g (shape %.1f)", plane, share, shape[plane]),
                    share > 0.0);
        whirl_correction_free(free_one);
        whirl_balance_free(balance);
        of.limit[plane] = 0.4 * cabs(best) * share;
        whirl_correction *found = solve(&of, "squares", more, &balance);
        const double complex amount = found->amount[0][0] + I * found->amount[0][1];
        check_within(id, words("one set, plane %d at its limit: error over the closed form", plane), 0.0,
                     cabs(amount / (0.4 * best) - 1.0), 1e-6);
        check_within(id, words("one set, plane %d: its weight over its limit", plane), 1.0,
                     hypot(found->moment[plane][0], found->moment[plane][1]) / of.limit[plane], 1e-6);
        whirl_correction_free(found);
        whirl_balance_free(balance);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(least_max), cmocka_unit_test(within_limits),
                                       cmocka_unit_test(sets_within_limits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
