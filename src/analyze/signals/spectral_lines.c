// Lines between the bins of a spectrum.
// A peak of the transform gives a first guess. The transform is then evaluated half a bin to either side of the guess:
// there the main lobe W of the window falls with slope 2/3 of ln W per 1/2 bin, so the ratio of the two values gives
// the error of the guess. The leakage of the other lines (and of a line's own mirror image at the negative frequency)
// is known in closed form and subtracted; a few rounds converge. Side lobes do not disturb the picking of peaks: at
// whole bins the transform of one sinusoid falls monotonically.
#include "spectral_lines.h"
#include "transform.h"
#include "two_pi.h"

#include <complex.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/// Lines below this share of the largest are taken for noise or leakage.
static const double smallest_share = 1e-4;

/// Sine and cosine of an angle.
typedef struct turn {
    double sine, cosine;
} turn;

static turn turn_of(double angle) {
    return (turn){sin(angle), cos(angle)};
}

static turn turn_on(turn a, turn b) {
    return (turn){a.sine * b.cosine + a.cosine * b.sine, a.cosine * b.cosine - a.sine * b.sine};
}

static turn turn_back(turn a, turn b) {
    return (turn){a.sine * b.cosine - a.cosine * b.sine, a.cosine * b.cosine + a.sine * b.sine};
}

/// A frequency with the angles that the window's transform needs: a lobe lies at the sum or the difference of two.
typedef struct frequency {
    double bin;
    turn whole, part; ///< pi bin, pi bin/count
} frequency;

static frequency frequency_of(double bin, double count) {
    return (frequency){bin, turn_of(0.5 * two_pi * bin), turn_of(0.5 * two_pi * bin / count)};
}

/// A sinusoid a e^(i theta) + conj(a) e^(-i theta) in each coordinate, theta = 2 pi bin j/count.
typedef struct sinusoid {
    size_t peak; ///< whole bin where it was found
    frequency at;
    wave_amplitudes a;
} sinusoid;

/// A signal and the lines found in it so far.
typedef struct line_search {
    const wave_transform *wave;
    double samples;
    turn unit; ///< pi/samples
    size_t count;
    sinusoid lines[WHIRL_MAX_LINES];
} line_search;

/// Returns the transform of the Hann window at a distance from its centre, where it is 1 (Harris 1978). The rectangular
/// window has D(bins) = e^(-i angle (count - 1)/count) sin(angle)/(count sin(angle/count)), angle = pi bins. The Hann
/// window has D(bins) - (D(bins - 1) + D(bins + 1))/2. All three terms share sin(angle), up to the sign, and their
/// phases differ by pi/count.
static double complex hann_lobe(const line_search *search, turn whole, turn part) {
    // At the bins 0, 1 and -1 both sides of a quotient are 0. Only frequencies at half the sampling rate come so close.
    const double least = 1e-12;
    const double before = turn_back(part, search->unit).sine, after = turn_on(part, search->unit).sine;
    if (fabs(part.sine) < least || fabs(before) < least || fabs(after) < least)
        return fabs(part.sine) < least ? 1.0 : -0.5;
    const double even = 1.0 / part.sine - 0.5 * search->unit.cosine * (1.0 / before + 1.0 / after);
    const double odd = 0.5 * search->unit.sine * (1.0 / before - 1.0 / after);
    const double high = whole.sine / search->samples;
    const turn phase = turn_back(part, whole);
    return high * ((even * phase.cosine - odd * phase.sine) + I * (even * phase.sine + odd * phase.cosine));
}

/// Returns the product of a and b. The product of the language C also handles infinities, and is slower.
static double complex lines_times(double complex a, double complex b) {
    return (creal(a) * creal(b) - cimag(a) * cimag(b)) + I * (creal(a) * cimag(b) + cimag(a) * creal(b));
}

static void lines_subtract(const line_search *search, wave_amplitudes *value, const sinusoid *line, const frequency *at,
                           bool main_lobe) {
    const turn whole = turn_on(at->whole, line->at.whole), part = turn_on(at->part, line->at.part);
    const double complex mirror = hann_lobe(search, whole, part);
    value->x -= lines_times(conj(line->a.x), mirror);
    value->y -= lines_times(conj(line->a.y), mirror);
    if (!main_lobe) return;
    const double complex there =
        hann_lobe(search, turn_back(at->whole, line->at.whole), turn_back(at->part, line->at.part));
    value->x -= lines_times(line->a.x, there);
    value->y -= lines_times(line->a.y, there);
}

/// Returns the transform at `bin` without the leakage of the lines other than `own`. Lines whose main lobes overlap
/// that of `own` are not removed.
static wave_amplitudes lines_isolated(const line_search *search, size_t own, double bin) {
    const frequency at = frequency_of(bin, search->samples);
    wave_amplitudes value = wave_transform_at(search->wave, bin);
    for (size_t m = 0; m < search->count; m++) {
        const sinusoid *line = &search->lines[m];
        if (m == own)
            lines_subtract(search, &value, line, &at, false);
        else if (fabs(line->at.bin - search->lines[own].at.bin) >= 2.5)
            lines_subtract(search, &value, line, &at, true);
    }
    return value;
}

static double pair_power(wave_amplitudes value) {
    return creal(value.x * conj(value.x)) + creal(value.y * conj(value.y));
}

/// Refines one line: its frequency from the two sides of the lobe, then its amplitudes.
static void lines_refine(line_search *search, size_t own) {
    sinusoid *line = &search->lines[own];
    const double above = pair_power(lines_isolated(search, own, line->at.bin + 0.5));
    const double below = pair_power(lines_isolated(search, own, line->at.bin - 0.5));
    if (above > 0.0 && below > 0.0) {
        const double moved = line->at.bin + 0.375 * log(above / below);
        const double bin = fmin(fmax(moved, (double)line->peak - 0.75), (double)line->peak + 0.75);
        line->at = frequency_of(bin, search->samples);
    }
    line->a = lines_isolated(search, own, line->at.bin);
}

/// Finds the largest local maxima of `power`, largest first.
static void pick_peaks(line_search *search, const double *power, size_t bins) {
    sinusoid *lines = search->lines;
    double largest = 0.0;
    for (size_t k = 2; k < bins; k++) largest = fmax(largest, power[k]);
    size_t count = 0;
    for (size_t k = 2; k + 1 < bins; k++) {
        if (power[k] < power[k - 1] || power[k] <= power[k + 1]) continue;
        if (power[k] < smallest_share * smallest_share * largest) continue;
        size_t place = count < WHIRL_MAX_LINES ? count++ : count;
        if (place == WHIRL_MAX_LINES && power[k] <= power[lines[--place].peak]) continue;
        for (; place > 0 && power[lines[place - 1].peak] < power[k]; place--) lines[place] = lines[place - 1];
        lines[place] = (sinusoid){.peak = k, .at = frequency_of((double)k, search->samples)};
    }
    search->count = count;
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
    const double samples = (double)wave_transform_count(wave);
    line_search search = {.wave = wave, .samples = samples, .unit = turn_of(0.5 * two_pi / samples)};
    pick_peaks(&search, power, bins);
    for (int round = 0; round < ROUNDS; round++) {
        for (size_t l = 0; l < search.count; l++) lines_refine(&search, l);
    }
    const size_t count = search.count;
    for (size_t l = 0; l < count; l++) lines[l] = spectrum_line(search.lines[l].at.bin, search.lines[l].a);
    qsort(lines, count, sizeof *lines, larger_first);
    size_t kept = count;
    while (kept > 0 && line_size(&lines[kept - 1]) < smallest_share * line_size(&lines[0])) kept--;
    return kept;
}
