// The largest Lyapunov exponent: the mean logarithmic growth of a small disturbance.
#include "lyapunov.h"

#include <math.h>

#include "analysis.h"

/// A disturbance that vanished altogether has shrunk at least to the smallest double.
static const double strongest_decay = -745.0;

static double block_mean(const double *values, size_t length) {
    double sum = 0.0;
    for (size_t i = 0; i < length; i++) sum += fmax(values[i], strongest_decay);
    return sum / (double)length;
}

/// Standard error of the mean of all blocks from their scatter. What does not fill a block is left out at the start.
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
    enum { FEWEST_BLOCKS = 16 };
    if (count == 0) return (whirl_estimate){NAN, NAN};
    const double mean = block_mean(values, count);
    if (count == 1) return (whirl_estimate){mean, NAN};
    double error = block_error(values, count, 1);
    for (size_t length = 2; count / length >= FEWEST_BLOCKS; length *= 2) {
        error = fmax(error, block_error(values, count, length));
    }
    return (whirl_estimate){mean, error};
}

whirl_estimate whirl_lyapunov_largest(const whirl_record *record) {
    if (record->motion != WHIRL_BOUNDED) return (whirl_estimate){NAN, NAN};
    if (record->growth_count == 0) return (whirl_estimate){NAN, NAN};
    // While the disturbance turns towards the direction of fastest growth it does not count.
    const size_t aligning = record->growth_count / 10;
    return estimate_mean(record->growth + aligning, record->growth_count - aligning);
}

enum { LARGEST, ERROR, FIELD_COUNT };

static const field_plan fields[FIELD_COUNT] = {
    [LARGEST] = {"largest", "1/revolution", "largest Lyapunov exponent, natural logarithm", WHIRL_PER_POINT, 1, NULL},
    [ERROR] = {"error", "1/revolution", "its standard error", WHIRL_PER_POINT, 1, NULL},
};

static whirl_status compute(const whirl_record *record, const whirl_record_options *options, const block_view *view) {
    (void)options;
    const whirl_estimate exponent = whirl_lyapunov_largest(record);
    *view_numbers(view, LARGEST, 0) = exponent.value;
    *view_numbers(view, ERROR, 0) = exponent.error;
    return whirl_ok();
}

const analysis_plan lyapunov_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .needs_growth = true, .compute = compute};
