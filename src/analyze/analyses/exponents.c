// All Lyapunov exponents: mean logarithmic growths of orthonormal perturbations (Benettin et al. 1980), with their
// exact sum and the Kaplan-Yorke dimension of the attractor (Kaplan, Yorke 1979).
#include <math.h>
#include <stdlib.h>

#include "analysis.h"
#include "mean_growth.h"

/// Discards exponents whose balance failed, and adds the error of the balance to the errors of the others.
static void settle_balance(const growth_balance *balance, whirl_estimate *exponents, size_t count) {
    for (size_t k = 0; k < count; k++) {
        if (balance->failed)
            exponents[k] = (whirl_estimate){NAN, NAN};
        else
            exponents[k].error = hypot(exponents[k].error, balance->miss);
    }
}

bool whirl_lyapunov_spectrum(const whirl_record *record, whirl_estimate *exponents) {
    const size_t n = record->dimension;
    double *values = follows_all(record) ? malloc(record->growth_count * sizeof *values) : NULL;
    growth_balance balance = {.failed = true};
    if (values) balance = gather_exponents(record, exponents, values);
    settle_balance(&balance, exponents, n);
    free(values);
    return !balance.failed;
}

double whirl_kaplan_yorke(const whirl_estimate *exponents, size_t count) {
    enum { SIGMAS = 3 };
    const double least = 0.002; // the least exponent of chaos
    double sum = 0.0;
    for (size_t k = 0; k < count; k++) {
        const whirl_estimate *e = &exponents[k];
        const double value = fabs(e->value) <= fmin(SIGMAS * e->error, least) ? 0.0 : e->value;
        if (!isfinite(value)) return NAN;
        if (sum + value < 0.0) return (double)k + sum / fabs(value);
        sum += value;
    }
    return (double)count;
}

enum { VALUES, ERRORS, SUM, SUM_EXACT, DIMENSION, FAILED, FIELD_COUNT };

static const field_plan fields[FIELD_COUNT] = {
    [VALUES] = {WHIRL_FIELD_EXPONENTS_VALUES, "1/revolution",
                "all Lyapunov exponents, natural logarithms, largest first", WHIRL_PER_POINT, 1, rows_per_coordinate},
    [ERRORS] = {WHIRL_FIELD_EXPONENTS_ERRORS, "1/revolution",
                "their standard errors, with the error of the sum and the difference at a second tolerance",
                WHIRL_PER_POINT, 1, rows_per_coordinate},
    [SUM] = {WHIRL_FIELD_EXPONENTS_SUM, "1/revolution", "the sum of all exponents", WHIRL_PER_POINT, 1, NULL},
    [SUM_EXACT] = {WHIRL_FIELD_EXPONENTS_SUM_EXACT, "1/revolution",
                   "sum by the divergence of the equations: the difference is an error of the integration",
                   WHIRL_PER_POINT, 1, NULL},
    [DIMENSION] = {WHIRL_FIELD_EXPONENTS_DIMENSION, "1", "Kaplan-Yorke dimension of the attractor in the section",
                   WHIRL_PER_POINT, 1, NULL},
    [FAILED] = {WHIRL_FIELD_EXPONENTS_FAILED, "1",
                "1: the error of the sum is larger than the errors, and there are no exponents", WHIRL_PER_POINT, 1,
                NULL},
};

static whirl_status exponents_compute(const whirl_record *record, const whirl_record_options *options,
                                      const block_view *view) {
    const size_t n = record->dimension, count = record->growth_count;
    (void)options;
    whirl_estimate *exponents = malloc(n * sizeof *exponents + count * sizeof(double));
    if (!exponents) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu exponents", n);
    if (follows_all(record)) {
        const growth_balance balance = gather_exponents(record, exponents, (double *)(exponents + n));
        settle_balance(&balance, exponents, n);
        for (size_t k = 0; k < n; k++) {
            view_numbers(view, VALUES, 0)[k] = exponents[k].value;
            view_numbers(view, ERRORS, 0)[k] = exponents[k].error;
        }
        *view_numbers(view, SUM, 0) = balance.sum;
        *view_numbers(view, SUM_EXACT, 0) = balance.exact;
        *view_numbers(view, DIMENSION, 0) = whirl_kaplan_yorke(exponents, n);
        *view_numbers(view, FAILED, 0) = balance.failed ? 1.0 : 0.0;
    }
    free(exponents);
    return whirl_ok();
}

const analysis_plan exponents_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .needs_growth = WHIRL_GROWTH_ALL, .compute = exponents_compute};

void whirl_block_compare_exponents(const whirl_layout *layout, double *block, const whirl_layout *other_layout,
                                   const double *other) {
    static const char *const pairs[][2] = {{WHIRL_FIELD_REGIME_EXPONENT, WHIRL_FIELD_REGIME_EXPONENT_ERROR},
                                           {WHIRL_FIELD_LYAPUNOV_LARGEST, WHIRL_FIELD_LYAPUNOV_ERROR},
                                           {WHIRL_FIELD_EXPONENTS_VALUES, WHIRL_FIELD_EXPONENTS_ERRORS}};
    for (size_t p = 0; p < sizeof pairs / sizeof *pairs; p++) {
        const whirl_field *values = whirl_layout_field(layout, pairs[p][0]);
        const whirl_field *errors = whirl_layout_field(layout, pairs[p][1]);
        const whirl_field *others = whirl_layout_field(other_layout, pairs[p][0]);
        if (!values || !errors || !others || others->rows != values->rows || errors->rows != values->rows) continue;
        for (size_t i = 0; i < values->rows; i++) {
            const double difference = block[values->offset + i] - other[others->offset + i];
            double *error = &block[errors->offset + i];
            if (isfinite(difference)) *error = hypot(*error, difference);
        }
    }
}
