// All Lyapunov exponents: mean logarithmic growths of orthonormal disturbances (Benettin et al. 1980), with the sum that they must
// have and the dimension that they give the attractor (Kaplan, Yorke 1979).
#include <math.h>
#include <stdlib.h>

#include "analysis.h"
#include "lyapunov.h"

/// While the disturbances turn towards their directions they do not count.
static size_t first_counted(const whirl_record *record) {
    return record->growth_count / 10;
}

/// Mean of column `which` of rows [growth_count][columns]; `values` [growth_count] is workspace.
static whirl_estimate column_mean(const whirl_record *record, const double *rows, size_t columns, size_t which,
                                  double *values) {
    const size_t first = first_counted(record);
    for (size_t i = first; i < record->growth_count; i++) values[i - first] = rows[i * columns + which];
    return estimate_mean(values, record->growth_count - first);
}

bool whirl_lyapunov_spectrum(const whirl_record *record, whirl_estimate *exponents) {
    const size_t n = record->dimension;
    double *values = record->growths && record->growth_count > 0 ? malloc(record->growth_count * sizeof *values) : NULL;
    const bool known = values && record->motion == WHIRL_BOUNDED;
    for (size_t k = 0; k < n; k++)
        exponents[k] =
            known ? column_mean(record, record->growths, n, k, values) : (whirl_estimate){.value = NAN, .error = NAN};
    free(values);
    return known;
}

double whirl_kaplan_yorke(const whirl_estimate *exponents, size_t count) {
    enum { SIGMAS = 3 };
    const double least = 0.002; // as chaos needs it
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

enum { VALUES, ERRORS, SUM, SUM_EXACT, DIMENSION, FIELD_COUNT };

static size_t rows_of_exponents(const block_shape *shape) {
    return shape->dimension;
}

static const field_plan fields[FIELD_COUNT] = {
    [VALUES] = {"values", "1/revolution", "all Lyapunov exponents, natural logarithms, largest first", WHIRL_PER_POINT,
                1, rows_of_exponents},
    [ERRORS] = {"errors", "1/revolution", "their standard errors", WHIRL_PER_POINT, 1, rows_of_exponents},
    [SUM] = {"sum", "1/revolution", "the sum of all exponents", WHIRL_PER_POINT, 1, NULL},
    [SUM_EXACT] = {"sum_exact", "1/revolution",
                   "what it is by the divergence of the equations: the difference is an error of the integration",
                   WHIRL_PER_POINT, 1, NULL},
    [DIMENSION] = {"dimension", "1", "Kaplan-Yorke dimension of the attractor in the section", WHIRL_PER_POINT, 1,
                   NULL},
};

static whirl_status compute(const whirl_record *record, const whirl_record_options *options, const block_view *view) {
    const size_t n = record->dimension, count = record->growth_count;
    (void)options;
    whirl_estimate *exponents = malloc(n * sizeof *exponents + count * sizeof(double));
    if (!exponents) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu exponents", n);
    if (whirl_lyapunov_spectrum(record, exponents)) {
        double sum = 0.0;
        for (size_t k = 0; k < n; k++) {
            view_numbers(view, VALUES, 0)[k] = exponents[k].value;
            view_numbers(view, ERRORS, 0)[k] = exponents[k].error;
            sum += exponents[k].value;
        }
        *view_numbers(view, SUM, 0) = sum;
        *view_numbers(view, SUM_EXACT, 0) = column_mean(record, record->volume, 1, 0, (double *)(exponents + n)).value;
        *view_numbers(view, DIMENSION, 0) = whirl_kaplan_yorke(exponents, n);
    }
    free(exponents);
    return whirl_ok();
}

const analysis_plan exponents_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .needs_growth = WHIRL_GROWTH_ALL, .compute = compute};
