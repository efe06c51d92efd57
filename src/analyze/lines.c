// Lines between the bins of a spectrum.
//
// A peak of the transform gives a first guess. The transform is then evaluated in double precision half a bin to
// either side of the guess: there the main lobe W of the window falls with slope 2/3 of ln W per 1/2 bin, so the
// ratio of the two values tells how far off the guess is. What the other lines (and a line's own mirror image at the
// negative frequency) leak to where one is measured is known in closed form and subtracted; a few rounds settle it.
// Side lobes need no care when peaks are picked: at whole bins the transform of one sinusoid falls monotonically.
#include "lines.h"

#include <complex.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

static const double two_pi = 6.283185307179586476925;

/// Lines below this share of the largest are taken for noise or leakage.
static const double smallest_share = 1e-4;

/// A sinusoid a e^(i theta) + conj(a) e^(-i theta) in each coordinate, theta = 2 pi bin j/count.
typedef struct sinusoid {
    size_t peak; ///< whole bin where it was found
    double bin;
    double complex x, y;
} sinusoid;

typedef struct pair_transform {
    double complex x, y;
} pair_transform;

/// The transform of the windowed signal at a frequency between bins, so scaled that a sinusoid there gives its `a`.
static pair_transform transform_at(const windowed_pair *signal, double bin) {
    enum { ANCHOR = 128 }; // the turned phasor is set anew so that rounding does not pile up
    double xr = 0.0, xi = 0.0, yr = 0.0, yi = 0.0;
    const double turn = two_pi * bin / (double)signal->count;
    const double turn_cos = cos(turn), turn_sin = sin(turn);
    for (size_t start = 0; start < signal->count; start += ANCHOR) {
        const double phase = two_pi * fmod(bin * (double)start / (double)signal->count, 1.0);
        double c = cos(phase), s = sin(phase);
        const size_t end = start + ANCHOR < signal->count ? start + ANCHOR : signal->count;
        for (size_t j = start; j < end; j++) {
            xr += signal->x[j] * c;
            xi -= signal->x[j] * s;
            yr += signal->y[j] * c;
            yi -= signal->y[j] * s;
            const double next = c * turn_cos - s * turn_sin;
            s = s * turn_cos + c * turn_sin;
            c = next;
        }
    }
    const double scale = 2.0 / (double)signal->count; // the window sums to count/2
    return (pair_transform){scale * (xr + I * xi), scale * (yr + I * yi)};
}

/// Transform of the rectangular window, 1 at its centre.
static double complex rectangle_lobe(double bins, double count) {
    const double angle = 0.5 * two_pi * bins;
    const double below = count * sin(angle / count);
    if (fabs(below) < 1e-12) return 1.0;
    return cexp(-I * angle * (count - 1.0) / count) * (sin(angle) / below);
}

/// Transform of the Hann window `bins` from its centre, where it is 1 (Harris 1978).
static double complex hann_lobe(double bins, double count) {
    return rectangle_lobe(bins, count) - 0.5 * rectangle_lobe(bins - 1.0, count) -
           0.5 * rectangle_lobe(bins + 1.0, count);
}

static void subtract(pair_transform *value, const sinusoid *line, double at, double count, bool main_lobe) {
    const double complex there = main_lobe ? hann_lobe(at - line->bin, count) : 0.0;
    const double complex mirror = hann_lobe(at + line->bin, count);
    value->x -= line->x * there + conj(line->x) * mirror;
    value->y -= line->y * there + conj(line->y) * mirror;
}

/// The transform at `at` less what all lines but `own` leak there. Lines whose main lobes overlap that of `own` stay.
static pair_transform isolated(const windowed_pair *signal, const sinusoid *lines, size_t count, size_t own,
                               double at) {
    pair_transform value = transform_at(signal, at);
    for (size_t m = 0; m < count; m++) {
        if (m == own) {
            subtract(&value, &lines[m], at, (double)signal->count, false);
        } else if (fabs(lines[m].bin - lines[own].bin) >= 2.5) {
            subtract(&value, &lines[m], at, (double)signal->count, true);
        }
    }
    return value;
}

static double pair_power(pair_transform value) {
    return creal(value.x * conj(value.x)) + creal(value.y * conj(value.y));
}

/// One round for one line: its frequency from the two sides of the lobe, then its amplitudes.
static void refine(const windowed_pair *signal, sinusoid *lines, size_t count, size_t own) {
    sinusoid *line = &lines[own];
    const double above = pair_power(isolated(signal, lines, count, own, line->bin + 0.5));
    const double below = pair_power(isolated(signal, lines, count, own, line->bin - 0.5));
    if (above > 0.0 && below > 0.0) {
        const double moved = line->bin + 0.375 * log(above / below);
        line->bin = fmin(fmax(moved, (double)line->peak - 0.75), (double)line->peak + 0.75);
    }
    const pair_transform value = isolated(signal, lines, count, own, line->bin);
    line->x = value.x;
    line->y = value.y;
}

/// The largest local maxima of `power`, largest first.
static size_t pick_peaks(const double *power, size_t bins, sinusoid *lines) {
    double largest = 0.0;
    for (size_t k = 2; k < bins; k++) largest = fmax(largest, power[k]);
    size_t count = 0;
    for (size_t k = 2; k + 1 < bins; k++) {
        if (power[k] < power[k - 1] || power[k] <= power[k + 1]) continue;
        if (power[k] < smallest_share * smallest_share * largest) continue;
        size_t place = count < WHIRL_MAX_LINES ? count++ : count;
        if (place == WHIRL_MAX_LINES && power[k] <= power[lines[--place].peak]) continue;
        for (; place > 0 && power[lines[place - 1].peak] < power[k]; place--) lines[place] = lines[place - 1];
        lines[place] = (sinusoid){.peak = k, .bin = (double)k};
    }
    return count;
}

static whirl_line line_of(const sinusoid *s) {
    return (whirl_line){.order = s->bin,
                        .x = 2.0 * cabs(s->x),
                        .y = 2.0 * cabs(s->y),
                        .forward = cabs(s->x + I * s->y),
                        .backward = cabs(s->x - I * s->y)};
}

static double line_size(const whirl_line *line) {
    return fmax(line->x, line->y);
}

static int larger_first(const void *a, const void *b) {
    const double first = line_size(a), second = line_size(b);
    return (first < second) - (first > second);
}

size_t spectrum_lines(const windowed_pair *signal, const double *power, size_t bins, whirl_line *lines) {
    enum { ROUNDS = 5 };
    sinusoid found[WHIRL_MAX_LINES];
    const size_t count = pick_peaks(power, bins, found);
    for (int round = 0; round < ROUNDS; round++) {
        for (size_t l = 0; l < count; l++) refine(signal, found, count, l);
    }
    for (size_t l = 0; l < count; l++) lines[l] = line_of(&found[l]);
    qsort(lines, count, sizeof *lines, larger_first);
    size_t kept = count;
    while (kept > 0 && line_size(&lines[kept - 1]) < smallest_share * line_size(&lines[0])) kept--;
    return kept;
}
