// Vold-Kalman filter of the second generation: complex amplitudes of several orders at every sample, solved together
// (Vold and Leuridan 1993, SAE 931288; Tuma 2005, "Setting the passband width in the Vold-Kalman order tracking
// filter", 12th International Congress on Sound and Vibration, Lisbon).
//
// With half amplitudes x_k it minimizes |y - sum_k x_k e^{i phase_k}|^2 + sum_k r_k^2 |D^p x_k|^2, D the difference of
// neighbouring samples. The condition number of the normal equations is about r^4, which leaves no correct digit for a
// narrow band. Givens rotations work on the banded rows themselves, whose condition number is about r^2.
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "signal_check.h"

static const double pi = 3.141592653589793238463;

enum {
    MAX_WIDTH = 3 * WHIRL_SIGNALS_MAX_TRACKED, ///< most columns of a row: p + 1 samples of all phases
    MAX_NUMBERS = 100000000                    ///< most complex numbers of the triangle, 1.6 GB
};

static const double max_weight = 1e9;    // relative errors are some 1e-16 times the weight
static const double min_diagonal = 1e-6; // noise at the end of the record is amplified by 1 over the diagonal

// ---------------------------------------------------------------- bandwidth

whirl_status whirl_signals_vold_kalman_weight(double bandwidth, double rate, int poles, double *weight) {
    if (poles != 1 && poles != 2) return whirl_fail(WHIRL_BAD_INPUT, "there are %d poles, expected 1 or 2", poles);
    if (!(rate > 0.0) || !isfinite(rate))
        return whirl_fail(WHIRL_BAD_INPUT, "the rate is %g, expected samples per unit of time, above 0", rate);
    if (!(bandwidth > 0.0) || !(bandwidth < rate))
        return whirl_fail(WHIRL_BAD_INPUT, "the bandwidth is %g, expected above 0 and below the rate of samples, %g",
                          bandwidth, rate);
    const double gain = 2.0 * sin(pi * bandwidth / (2.0 * rate));
    *weight = sqrt(sqrt(2.0) - 1.0) / (poles == 1 ? gain : gain * gain);
    if (*weight <= max_weight) return whirl_ok();
    return whirl_fail(
        WHIRL_BAD_INPUT,
        "the bandwidth is %g of the rate of samples, too narrow for %d poles: expected at least %.3g; take "
        "fewer samples per unit of time",
        bandwidth / rate, poles, 2.0 / pi * asin(0.5 * pow(sqrt(sqrt(2.0) - 1.0) / max_weight, 1.0 / poles)));
}

// ---------------------------------------------------------------- the triangle

/// Upper triangle of the rotated rows. Row i has the columns i to i + width - 1; unknowns are sample by sample, all
/// phases of a sample together.
typedef struct triangle {
    size_t width;
    double complex *rows, *side; ///< [unknowns][width], [unknowns]
} triangle;

/// Rotates a row into the triangle: `row` [width] begins at column `first`, its right side is `side`.
static void vold_kalman_insert(const triangle *of, size_t first, size_t width, double complex *row,
                               double complex side) {
    for (size_t j = 0; j < width; j++) {
        if (row[j] == 0.0) continue;
        double complex *own = of->rows + (first + j) * of->width, *own_side = of->side + first + j;
        const double a = creal(own[0]), b = hypot(creal(row[j]), cimag(row[j])); // diagonals are real, 0 or more
        const double length = hypot(a, b), c = a / length;
        const double complex s = conj(row[j]) / length;
        own[0] = length;
        for (size_t k = 1; j + k < width; k++) {
            const double complex mine = own[k], given = row[j + k];
            own[k] = c * mine + s * given;
            row[j + k] = c * given - conj(s) * mine;
        }
        const double complex mine = *own_side;
        *own_side = c * mine + s * side;
        side = c * side - conj(s) * mine;
    }
}

/// Inserts all rows, sample by sample: first the differences that keep amplitudes smooth, then the measured sample.
static void vold_kalman_rotate(const triangle *of, const double *values, size_t count, const double *phases,
                               size_t tracked, const double *weights, size_t poles) {
    static const double differences[2][3] = {{-1.0, 1.0, 0.0}, {1.0, -2.0, 1.0}};
    double complex row[MAX_WIDTH];
    for (size_t n = 0; n < count; n++) {
        const size_t first = n * tracked, left = (count - n) * tracked, width = left < of->width ? left : of->width;
        for (size_t k = 0; k < tracked && n + poles < count; k++) {
            memset(row, 0, width * sizeof *row);
            for (size_t d = 0; d <= poles; d++) row[d * tracked + k] = weights[k] * differences[poles - 1][d];
            vold_kalman_insert(of, first, width, row, 0.0);
        }
        memset(row, 0, width * sizeof *row);
        for (size_t k = 0; k < tracked; k++) {
            const double phase = phases[k * count + n];
            row[k] = cos(phase) + sin(phase) * I;
        }
        vold_kalman_insert(of, first, width, row, values[n]);
    }
}

/// Solves for the unknowns, backwards; amplitudes [tracked][count][2] are twice the unknowns.
static void vold_kalman_solve(const triangle *of, size_t count, size_t tracked, double *amplitudes) {
    const size_t unknowns = count * tracked;
    for (size_t i = unknowns; i-- > 0;) {
        const double complex *row = of->rows + i * of->width;
        double complex rest = of->side[i];
        for (size_t k = 1; k < of->width && i + k < unknowns; k++) rest -= row[k] * of->side[i + k];
        of->side[i] = rest / creal(row[0]);
        double *amplitude = amplitudes + 2 * (i % tracked * count + i / tracked);
        amplitude[0] = 2.0 * creal(of->side[i]);
        amplitude[1] = 2.0 * cimag(of->side[i]);
    }
}

// ---------------------------------------------------------------- checks

static whirl_status vold_kalman_check(const double *values, size_t count, const double *phases, size_t tracked,
                                      int poles) {
    // Check sizes.
    if (tracked < 1 || tracked > WHIRL_SIGNALS_MAX_TRACKED)
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu orders, expected 1 to %d", tracked,
                          WHIRL_SIGNALS_MAX_TRACKED);
    if (poles != 1 && poles != 2) return whirl_fail(WHIRL_BAD_INPUT, "there are %d poles, expected 1 or 2", poles);
    const size_t fewest = (size_t)(poles + 1) * 2, width = (size_t)(poles + 1) * tracked;
    if (count > MAX_NUMBERS / (width * tracked))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "there are %zu samples and %zu orders, expected at most %zu samples for so many orders: take "
                          "fewer samples per unit of time, or parts of the record",
                          count, tracked, MAX_NUMBERS / (width * tracked));
    whirl_status status = signal_check_channels(values, count, 1, fewest);
    if (status.code != WHIRL_OK) return status;
    // Phases turn by less than half a turn from sample to sample.
    for (size_t k = 0; k < tracked; k++) {
        const double *phase = phases + k * count;
        for (size_t n = 0; n < count; n++) {
            if (!(fabs(phase[n]) <= 1e100))
                return whirl_fail(WHIRL_BAD_INPUT, "phase %zu (from 0) is %g at sample %zu, expected a number", k,
                                  phase[n], n);
            if (n > 0 && !(fabs(phase[n] - phase[n - 1]) < pi))
                return whirl_fail(
                    WHIRL_BAD_INPUT,
                    "phase %zu (from 0) turns by %.4g rad from sample %zu to %zu, expected less than pi: half the "
                    "rate of samples is the highest frequency",
                    k, phase[n] - phase[n - 1], n - 1, n);
        }
    }
    return whirl_ok();
}

/// Checks that the phase somewhere turns faster than its band is wide. In a slower part the filter cannot separate the
/// line from its mirror image at the negative frequency, and the amplitude is up to twice too large.
static whirl_status vold_kalman_check_speed(const double *phase, size_t count, size_t k, double rate,
                                            double bandwidth) {
    double fastest = 0.0;
    for (size_t n = 1; n < count; n++) fastest = fmax(fastest, fabs(phase[n] - phase[n - 1]));
    fastest *= rate / (2.0 * pi);
    if (fastest > bandwidth) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT,
                      "phase %zu (from 0) has a frequency of at most %.4g, expected one above its bandwidth, %.4g", k,
                      fastest, bandwidth);
}

whirl_status whirl_signals_vold_kalman(const double *values, size_t count, double rate, const double *phases,
                                       size_t tracked, const double *bandwidths, int poles, double *amplitudes) {
    whirl_status status = vold_kalman_check(values, count, phases, tracked, poles);
    if (status.code != WHIRL_OK) return status;
    double weights[WHIRL_SIGNALS_MAX_TRACKED];
    for (size_t k = 0; k < tracked && status.code == WHIRL_OK; k++) {
        status = whirl_signals_vold_kalman_weight(bandwidths[k], rate, poles, weights + k);
        if (status.code == WHIRL_OK)
            status = vold_kalman_check_speed(phases + k * count, count, k, rate, bandwidths[k]);
    }
    if (status.code != WHIRL_OK) return status;

    const size_t unknowns = count * tracked, width = (size_t)(poles + 1) * tracked;
    double complex *numbers = calloc(unknowns * (width + 1) + 1, sizeof *numbers);
    if (!numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu orders of %zu samples", tracked, count);
    const triangle made = {width, numbers, numbers + unknowns * width};
    vold_kalman_rotate(&made, values, count, phases, tracked, weights, (size_t)poles);

    // The diagonal is at least about 1 where orders are apart, because each sample measures a sum of them.
    double least = INFINITY;
    for (size_t i = 0; i < unknowns; i++) least = fmin(least, creal(made.rows[i * width]));
    if (least > min_diagonal)
        vold_kalman_solve(&made, count, tracked, amplitudes);
    else
        status = whirl_fail(WHIRL_BAD_INPUT,
                            "the orders cannot be separated in this record: two of them have nearly the same angle in "
                            "all of it");
    free(numbers);
    return status;
}
