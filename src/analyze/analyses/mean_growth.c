#include "mean_growth.h"

#include <math.h>
#include <stdlib.h>

#include "birkhoff_weight.h"
#include "turns.h"

/// Lower limit of a recorded growth, a natural logarithm: a perturbation that underflows to 0 is recorded as -infinity.
static const double strongest_decay = -745.0;

static double block_mean(const double *values, size_t length) {
    double sum = 0.0;
    for (size_t i = 0; i < length; i++) sum += fmax(values[i], strongest_decay);
    return sum / (double)length;
}

/// Returns the standard error of the mean of all blocks, from their scatter. The first values are left out where the
/// number of values is not a multiple of the block's length.
static double block_error(const double *values, size_t count, size_t length) {
    const size_t blocks = count / length;
    const double *first = values + count % length;
    const double mean = block_mean(first, blocks * length);
    double sum = 0.0;
    for (size_t b = 0; b < blocks; b++) {
        const double deviation = block_mean(first + b * length, length) - mean;
        sum += deviation * deviation;
    }
    return sqrt(sum / ((double)blocks * (double)(blocks - 1)));
}

whirl_estimate estimate_mean(const double *values, size_t count) {
    enum { FEWER = 16, MORE = 32 };
    if (count == 0) return (whirl_estimate){NAN, NAN};
    const double mean = block_mean(values, count);
    if (count == 1) return (whirl_estimate){mean, NAN};
    if (count < MORE) return (whirl_estimate){mean, block_error(values, count, 1)};
    return (whirl_estimate){mean,
                            fmax(block_error(values, count, count / FEWER), block_error(values, count, count / MORE))};
}

static double smooth_mean(const double *values, size_t count) {
    double weights = 0.0, sum = 0.0;
    for (size_t i = 0; i < count; i++) {
        const double w = birkhoff_weight(i, count);
        weights += w;
        sum += w * fmax(values[i], strongest_decay);
    }
    return sum / weights;
}

/// Returns the mean of all values. Its error is the larger one of its two differences from the means of the halves.
static whirl_estimate compare_halves(double (*mean)(const double *, size_t), const double *values, size_t half) {
    const double all = mean(values, 2 * half);
    return (whirl_estimate){all, fmax(fabs(mean(values, half) - all), fabs(mean(values + half, half) - all))};
}

whirl_estimate estimate_regular_mean(const double *values, size_t count, size_t period) {
    enum { MIN_SMOOTH = 16 };
    const size_t half = count / 2, whole = half - half % period;
    whirl_estimate best = {NAN, NAN};
    if (whole > 0) best = compare_halves(block_mean, values + count - 2 * whole, whole);
    if (half >= MIN_SMOOTH) {
        const whirl_estimate smooth = compare_halves(smooth_mean, values + count - 2 * half, half);
        if (!(best.error <= smooth.error)) best = smooth;
    }
    return best;
}

// ---------------------------------------------------------------- all exponents

/// Returns the index of the first growth that counts: the first tenth lets the perturbations align.
static size_t growth_first(const whirl_record *record) {
    return record->growth_count / 10;
}

/// Returns the mean growth of perturbation `which`; `values` [growth_count] is workspace.
static whirl_estimate growth_mean(const whirl_record *record, size_t which, double *values) {
    const size_t first = growth_first(record), n = record->dimension;
    for (size_t i = first; i < record->growth_count; i++) values[i - first] = record->growths[i * n + which];
    return estimate_mean(values, record->growth_count - first);
}

/// Returns the mean growth of volume, or NaN if it is unknown in some revolution.
static double growth_mean_volume(const whirl_record *record) {
    const size_t first = growth_first(record);
    double sum = 0.0;
    for (size_t i = first; i < record->growth_count; i++) sum += record->volume[i];
    return sum / (double)(record->growth_count - first);
}

bool follows_all(const whirl_record *record) {
    return record->growths && record->growth_count > 0 && record->motion == WHIRL_BOUNDED;
}

/// Sorts exponents, largest first. Exponents of coordinates that turn stay at the end: they are zeros that say nothing
/// about the motion.
static void growth_sort(const whirl_record *record, whirl_estimate *exponents) {
    const size_t steady = record->dimension - turns_count(record->turns, record->dimension);
    for (size_t k = 1; k < steady; k++)
        for (size_t j = k; j > 0 && exponents[j].value > exponents[j - 1].value; j--) {
            const whirl_estimate larger = exponents[j];
            exponents[j] = exponents[j - 1];
            exponents[j - 1] = larger;
        }
}

growth_balance gather_exponents(const whirl_record *record, whirl_estimate *exponents, double *values) {
    const double least_share = 1e-3;
    growth_balance b = {.exact = growth_mean_volume(record)};
    double errors = 0.0, sizes = 0.0;
    for (size_t k = 0; k < record->dimension; k++) {
        exponents[k] = growth_mean(record, k, values);
        b.sum += exponents[k].value;
        sizes += fabs(exponents[k].value);
        errors += isnan(exponents[k].error) ? 0.0 : exponents[k].error; // a single revolution
    }
    growth_sort(record, exponents);
    if (isfinite(b.exact)) b.miss = fabs(b.sum - b.exact);
    b.failed = !(b.miss <= fmax(errors, least_share * sizes));
    return b;
}

growth_balance balance_growth(const whirl_record *record) {
    growth_balance balance = {0};
    if (!follows_all(record)) return balance;
    whirl_estimate *exponents = malloc(record->dimension * sizeof *exponents + record->growth_count * sizeof(double));
    if (exponents) balance = gather_exponents(record, exponents, (double *)(exponents + record->dimension));
    free(exponents);
    return balance;
}

whirl_estimate second_exponent(const whirl_record *record) {
    const size_t first = growth_first(record), n = record->dimension;
    whirl_estimate second = {NAN, NAN};
    double *values = follows_all(record) && n > 1 ? malloc(record->growth_count * sizeof *values) : NULL;
    if (!values) return second;
    for (size_t i = first; i < record->growth_count; i++) values[i - first] = record->growths[i * n + 1];
    second = estimate_regular_mean(values, record->growth_count - first, 1);
    free(values);
    return second;
}
