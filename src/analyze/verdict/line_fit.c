// Lines of a few frequencies, fitted by least squares. All lines are fitted at once, so that neighbours do not disturb
// each other as they do in a windowed spectrum. Samples have the weights of Hann's window, so that lines of higher
// orders, which are not fitted, do not disturb them either. Consider a line of amplitude c whose order is off by d,
// wanders by w per revolution, and whose amplitude grows by g. With the time t from the middle of the record, it adds
// the parts (g + 2 pi i d) t c and pi i w t^2 c. Orders are refined by d (method of Gauss and Newton).
#include "line_fit.h"
#include "two_pi.h"

#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"

enum {
    MAX_ONE = 8,
    MAX_BOTH = 4,
    LOW = 3,
    MAX_FITTED = 40,
    PARTS = 2, ///< parts with t and with t^2
    MAX_UNKNOWNS = 1 + 2 * MAX_FITTED + 2 * 2 * PARTS,
    ROUNDS = 6,
    MIN_SAMPLES = 16
};

/// Orders of combinations that are added, and bins between lines that a fit tells apart.
static const double highest_added = 2.0, told_apart = 1.0;

line_combination line_combination_of(const line_bases *bases, double order, double resolution) {
    const double within = 0.2 * resolution;
    line_combination best = {.matches = false};
    double away = within;
    int least = MAX_ONE + 1;
    const int most = bases->count > 1 ? MAX_BOTH : MAX_ONE, others = bases->count > 1 ? MAX_BOTH : 0;
    for (int j = -most; j <= most; j++)
        for (int k = -others; k <= others; k++) {
            const int size = (j < 0 ? -j : j) + (k < 0 ? -k : k);
            const double off = order - j * bases->orders[0] - k * bases->orders[1];
            const double distance = fabs(off - round(off));
            if (size > most || distance > within || size > least || (size == least && distance >= away)) continue;
            best = (line_combination){true, {j, k}, round(off)};
            least = size;
            away = distance;
        }
    return best;
}

/// The unknowns of a fit: a constant, a forward and a backward amplitude of every line, and their parts with t and t^2
/// of the bases' own lines.
typedef struct fit_plan {
    size_t line_count, base_count, unknowns;
    line_combination lines[MAX_FITTED];
    double orders[MAX_FITTED]; ///< as they are found; those of combinations follow the bases
    size_t own[2];             ///< places of the lines of the bases
    bool moves;                ///< the parts with t and t^2 are fitted, too
} fit_plan;

/// Adds a line that the fit can tell from those before it and from a constant.
static void plan_add(fit_plan *plan, double order, const line_combination *of, double apart) {
    if (plan->line_count == MAX_FITTED || order < apart) return;
    for (size_t i = 0; i < plan->line_count; i++)
        if (fabs(plan->orders[i] - order) < apart) return;
    plan->orders[plan->line_count] = order;
    plan->lines[plan->line_count++] = *of;
}

/// Lists the lines; returns false if the bases' own are not among them.
static bool plan_make(const whirl_spectrum *spectrum, const line_bases *bases, fit_plan *plan) {
    const double apart = told_apart * spectrum->resolution;
    bool there[2] = {false, bases->count < 2};
    *plan = (fit_plan){.base_count = bases->count};
    // Add the lines of the spectrum, the largest first; then combinations up to the third.
    for (size_t i = 0; i < spectrum->line_count; i++) {
        const line_combination of = line_combination_of(bases, spectrum->lines[i].order, spectrum->resolution);
        plan_add(plan, spectrum->lines[i].order, &of, apart);
    }
    for (int j = -LOW; j <= LOW; j++)
        for (int k = bases->count > 1 ? -LOW : 0; k <= (bases->count > 1 ? LOW : 0); k++)
            for (int whole = -LOW; whole <= LOW; whole++) {
                const line_combination of = {true, {j, k}, whole};
                const double order = j * bases->orders[0] + k * bases->orders[1] + whole;
                const int size = (j < 0 ? -j : j) + (k < 0 ? -k : k);
                if (size <= LOW && order < highest_added) plan_add(plan, order, &of, apart);
            }
    for (size_t i = 0; i < plan->line_count; i++)
        for (size_t b = 0; b < bases->count; b++) {
            const line_combination *of = &plan->lines[i];
            if (of->matches && of->times[b] == 1 && of->times[1 - b] == 0 && of->whole == 0.0)
                plan->own[b] = i, there[b] = true;
        }
    return there[0] && there[1];
}

/// Writes the functions of all unknowns at a time t, in revolutions from the middle. The parts use t/half. Those with t
/// have a factor i, so that all functions at -t are the conjugates of those at t.
static void plan_functions(const fit_plan *plan, const line_bases *bases, double t, double half, double complex *at) {
    const double scaled = t / half;
    at[0] = 1.0;
    for (size_t i = 0; i < plan->line_count; i++) {
        const line_combination *of = &plan->lines[i];
        const double order = of->times[0] * bases->orders[0] + of->times[1] * bases->orders[1] + of->whole;
        const double angle = two_pi * (of->matches ? order : plan->orders[i]) * t;
        at[1 + 2 * i] = cos(angle) + I * sin(angle);
        at[2 + 2 * i] = conj(at[1 + 2 * i]);
    }
    double complex *part = at + 1 + 2 * plan->line_count;
    for (size_t b = 0; plan->moves && b < plan->base_count; b++)
        for (size_t k = 0; k < 2; k++) {
            const double complex own = at[1 + 2 * plan->own[b] + k];
            *part++ = I * scaled * own;
            *part++ = scaled * scaled * own;
        }
}

static double square_of(double complex value) {
    return creal(value) * creal(value) + cimag(value) * cimag(value);
}

/// Sums for the normal equations. Their matrix is real, because functions at -t are the conjugates of those at t.
typedef struct fit_sums {
    double gram[MAX_UNKNOWNS * MAX_UNKNOWNS], right[2 * MAX_UNKNOWNS]; ///< right: real parts, then imaginary ones
    double square, about_mean; ///< weighted sums of squares of the samples, and of these about their mean
} fit_sums;

static void fit_gather(const fit_plan *plan, const line_bases *bases, const whirl_record *record, size_t station,
                       fit_sums *sums) {
    const size_t per_revolution = record->samples_per_revolution, count = record->sample_count, n = plan->unknowns;
    const double *x = record->waveform + 2 * station * count, *y = x + count;
    double complex sum = 0.0, at[MAX_UNKNOWNS];
    double weights = 0.0;
    // A few samples per revolution resolve the lines.
    size_t stride = 1;
    while (per_revolution % (2 * stride) == 0 && per_revolution / (2 * stride) >= MIN_SAMPLES) stride *= 2;
    const size_t pairs = count / stride / 2;
    const double step = (double)stride / (double)per_revolution;
    memset(sums, 0, sizeof *sums);
    for (size_t p = 0; p < pairs; p++) {
        const double t = (double)p + 0.5, w = 0.5 + 0.5 * cos(0.5 * two_pi * t / (double)pairs);
        const size_t later = stride * (pairs + p), earlier = stride * (pairs - 1 - p);
        const double complex after = x[later] + I * y[later], before = x[earlier] + I * y[earlier];
        plan_functions(plan, bases, t * step, (double)pairs * step, at);
        for (size_t k = 0; k < n; k++) {
            const double real = w * creal(at[k]), imaginary = w * cimag(at[k]);
            sums->right[k] += real * creal(after + before) + imaginary * cimag(after - before);
            sums->right[n + k] += real * cimag(after + before) - imaginary * creal(after - before);
            for (size_t l = 0; l <= k; l++)
                sums->gram[k * n + l] += 2.0 * (real * creal(at[l]) + imaginary * cimag(at[l]));
        }
        weights += 2.0 * w;
        sum += w * (after + before);
        sums->square += w * (square_of(after) + square_of(before));
    }
    sums->about_mean = sums->square - square_of(sum) / weights;
}

/// Amplitudes of a base's forward and backward lines, and of their linear and quadratic parts, at t/half = 1.
typedef struct base_solved {
    double complex own[2], linear[2], square[2];
} base_solved;

/// Returns the phase by which a base's line is ahead at a time t/half, in turns: the mean over both directions,
/// weighted by their power.
static double ahead_at(const base_solved *of, double scaled) {
    double complex turned = 0.0;
    for (size_t k = 0; k < 2; k++) {
        const double complex there = of->own[k] + I * scaled * of->linear[k] + scaled * scaled * of->square[k];
        turned += k == 0 ? conj(of->own[k]) * there : of->own[k] * conj(there);
    }
    return carg(turned) / two_pi;
}

/// Solves a fit; `solved` has the lines of the bases.
static bool fit_solve(const fit_plan *plan, const fit_sums *sums, base_solved solved[2], double *unexplained) {
    const size_t n = plan->unknowns, parts = 1 + 2 * plan->line_count;
    double values[2 * MAX_UNKNOWNS], explained = 0.0;
    memcpy(values, sums->right, 2 * n * sizeof *values);
    if (!matrix_solve_definite(n, sums->gram, 2, values)) return false;
    for (size_t k = 0; k < 2 * n; k++) explained += values[k] * sums->right[k];
    *unexplained = sums->about_mean > 0.0 ? fmax(sums->square - explained, 0.0) / sums->about_mean : (double)NAN;
    for (size_t b = 0; plan->moves && b < plan->base_count; b++)
        for (size_t k = 0; k < 2; k++) {
            const size_t own = 1 + 2 * plan->own[b] + k, part = parts + 4 * b + 2 * k;
            solved[b].own[k] = values[own] + I * values[n + own];
            solved[b].linear[k] = values[part] + I * values[n + part];
            solved[b].square[k] = values[part + 1] + I * values[n + part + 1];
        }
    return true;
}

/// Refines the frequencies by a round. Returns the most by which one moves, in bins; infinity if lines cannot be
/// distinguished.
static double fit_refine(const fit_plan *plan, const whirl_record *record, size_t station, fit_sums *sums,
                         line_fit *fit) {
    const double revolutions = (double)record->record_count, half = 0.5 * revolutions;
    base_solved solved[2];
    double most = 0.0;
    fit_gather(plan, &fit->bases, record, station, sums);
    if (!fit_solve(plan, sums, solved, &fit->unexplained)) return INFINITY;
    for (size_t b = 0; b < plan->base_count; b++) {
        const base_solved *of = &solved[b];
        const double square = square_of(of->own[0]) + square_of(of->own[1]);
        const double complex grown = conj(of->own[0]) * of->linear[0], turned = conj(of->own[1]) * of->linear[1];
        const double off = creal(grown - turned) / square / half / two_pi;
        const double quarter = 0.5; // of the record, over its half
        fit->trend[b] = -cimag(grown + turned) / square / half;
        fit->wander[b] = (ahead_at(of, quarter) + ahead_at(of, -quarter)) / pow(quarter * half, 2.0);
        fit->bases.orders[b] += off;
        most = fmax(most, fabs(off) * revolutions);
    }
    return most;
}

line_fit line_fit_record(const whirl_record *record, size_t station, const whirl_spectrum *spectrum,
                         const line_bases *bases) {
    const double close = 1e-6, farthest = 0.5; // bins
    line_fit fit = {.bases = *bases, .wander = {NAN, NAN}, .trend = {NAN, NAN}, .unexplained = NAN};
    fit_plan plan;
    if (!plan_make(spectrum, bases, &plan)) return fit;
    fit_sums *sums = malloc(sizeof *sums);
    if (!sums) return fit;
    // Fit the frequencies, and how they and their amplitudes change.
    plan.moves = true;
    plan.unknowns = 1 + 2 * plan.line_count + 2 * (size_t)PARTS * plan.base_count;
    double most = INFINITY;
    for (int round = 0; round < ROUNDS && most > close; round++) {
        most = fit_refine(&plan, record, station, sums, &fit);
        if (!(most <= farthest)) break;
    }
    // Compute the remainder of lines with constant amplitudes.
    if (most <= farthest) {
        plan.moves = false;
        plan.unknowns = 1 + 2 * plan.line_count;
        fit_gather(&plan, &fit.bases, record, station, sums);
        fit.found = fit_solve(&plan, sums, NULL, &fit.unexplained);
    }
    free(sums);
    return fit;
}
