// The largest Lyapunov exponent: the mean logarithmic growth of a small perturbation.
#include "analysis.h"
#include "mean_growth.h"

#include <math.h>

whirl_estimate whirl_lyapunov_largest(const whirl_record *record) {
    if (record->motion != WHIRL_BOUNDED) return (whirl_estimate){NAN, NAN};
    if (record->growth_count == 0) return (whirl_estimate){NAN, NAN};
    // Growth does not count while the perturbation aligns with the direction of fastest growth.
    const size_t aligning = record->growth_count / 10;
    const growth_balance balance = balance_growth(record);
    if (balance.failed) return (whirl_estimate){NAN, NAN};
    const whirl_estimate mean = estimate_mean(record->growth + aligning, record->growth_count - aligning);
    return (whirl_estimate){mean.value, balance.miss > 0.0 ? hypot(mean.error, balance.miss) : mean.error};
}

enum { LARGEST, ERROR, FIELD_COUNT };

static const field_plan fields[FIELD_COUNT] = {
    [LARGEST] = {WHIRL_FIELD_LYAPUNOV_LARGEST, "1/revolution", "largest Lyapunov exponent, natural logarithm",
                 WHIRL_PER_POINT, 1, NULL},
    [ERROR] =
        {WHIRL_FIELD_LYAPUNOV_ERROR, "1/revolution",
         "its standard error, with the difference at a second tolerance; exponents less than 1 / revolutions apart "
         "count as equal",
         WHIRL_PER_POINT, 1, NULL},
};

static whirl_status lyapunov_compute(const whirl_record *record, const whirl_record_options *options,
                                     const block_view *view) {
    (void)options;
    const whirl_estimate exponent = whirl_lyapunov_largest(record);
    *view_numbers(view, LARGEST, 0) = exponent.value;
    *view_numbers(view, ERROR, 0) = exponent.error;
    return whirl_ok();
}

const analysis_plan lyapunov_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .needs_growth = WHIRL_GROWTH_LARGEST, .compute = lyapunov_compute};
