// Lines between the bins of a spectrum.
//
// A peak of the transform gives a first guess. The transform is then evaluated half a bin to either side of the guess: there the main lobe W of the window falls with slope 2/3 of ln W per 1/2 bin, so the
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
    wave_amplitudes a;
} sinusoid;

/// Transform of the Hann window `bins` from its centre, where it is 1 (Harris 1978). That of the rectangular window is
/// e^(-i angle (count - 1)/count) sin(angle)/(count sin(angle/count)), angle = pi bins; the Hann window's is this one
/// less half of its two neighbours, a bin away, in which sin(angle) and the phase return but for their signs.
static double complex hann_lobe(double bins, double count) {
    // At the bins 0, 1 and -1 both sides of a quotient are 0; nobody asks closer by, but at half the sampling frequency.
    const double least = 1e-12;
    const double angle = 0.5 * two_pi * bins, small = angle / count, unit = 0.5 * two_pi / count;
    const double s = sin(small), c = cos(small), unit_s = sin(unit), unit_c = cos(unit);
    const double before = s * unit_c - c * unit_s, after = s * unit_c + c * unit_s;
    if (fabs(s) < least || fabs(before) < least || fabs(after) < least) return fabs(s) < least ? 1.0 : -0.5;
    const double even = 1.0 / s - 0.5 * unit_c * (1.0 / before + 1.0 / after);
    const double odd = 0.5 * unit_s * (1.0 / before - 1.0 / after);
    const double high = sin(angle) / count, turn = angle - small;
    const double turn_s = -sin(turn), turn_c = cos(turn);
    return high * ((even * turn_c - odd * turn_s) + I * (even * turn_s + odd * turn_c));
}

static void subtract(wave_amplitudes *value, const sinusoid *line, double at, double count, bool main_lobe) {
    const double complex there = main_lobe ? hann_lobe(at - line->bin, count) : 0.0;
    const double complex mirror = hann_lobe(at + line->bin, count);
    value->x -= line->a.x * there + conj(line->a.x) * mirror;
    value->y -= line->a.y * there + conj(line->a.y) * mirror;
}

/// The transform at `at` less what all lines but `own` leak there. Lines whose main lobes overlap that of `own` stay.
static wave_amplitudes isolated(const wave_transform *wave, const sinusoid *lines, size_t count, size_t own,
                                double at) {
    wave_amplitudes value = wave_transform_at(wave, at);
    for (size_t m = 0; m < count; m++) {
        if (m == own) {
            subtract(&value, &lines[m], at, (double)wave_transform_count(wave), false);
        } else if (fabs(lines[m].bin - lines[own].bin) >= 2.5) {
            subtract(&value, &lines[m], at, (double)wave_transform_count(wave), true);
        }
    }
    return value;
}

static double pair_power(wave_amplitudes value) {
    return creal(value.x * conj(value.x)) + creal(value.y * conj(value.y));
}

/// One round for one line: its frequency from the two sides of the lobe, then its amplitudes.
static void refine(const wave_transform *wave, sinusoid *lines, size_t count, size_t own) {
    sinusoid *line = &lines[own];
    const double above = pair_power(isolated(wave, lines, count, own, line->bin + 0.5));
    const double below = pair_power(isolated(wave, lines, count, own, line->bin - 0.5));
    if (above > 0.0 && below > 0.0) {
        const double moved = line->bin + 0.375 * log(above / below);
        line->bin = fmin(fmax(moved, (double)line->peak - 0.75), (double)line->peak + 0.75);
    }
    line->a = isolated(wave, lines, count, own, line->bin);
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

whirl_line spectrum_line(double order, wave_amplitudes at) {
    return (whirl_line){.order = order,
                        .x = 2.0 * cabs(at.x),
                        .y = 2.0 * cabs(at.y),
                        .forward = cabs(at.x + I * at.y),
                        .backward = cabs(at.x - I * at.y)};
}

static double line_size(const whirl_line *line) {
    return fmax(line->x, line->y);
}

static int larger_first(const void *a, const void *b) {
    const double first = line_size(a), second = line_size(b);
    return (first < second) - (first > second);
}

size_t spectrum_lines(const wave_transform *wave, const double *power, size_t bins, whirl_line *lines) {
    enum { ROUNDS = 5 };
    sinusoid found[WHIRL_MAX_LINES];
    const size_t count = pick_peaks(power, bins, found);
    for (int round = 0; round < ROUNDS; round++) {
        for (size_t l = 0; l < count; l++) refine(wave, found, count, l);
    }
    for (size_t l = 0; l < count; l++) lines[l] = spectrum_line(found[l].bin, found[l].a);
    qsort(lines, count, sizeof *lines, larger_first);
    size_t kept = count;
    while (kept > 0 && line_size(&lines[kept - 1]) < smallest_share * line_size(&lines[0])) kept--;
    return kept;
}
