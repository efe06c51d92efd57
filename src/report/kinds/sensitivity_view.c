#include <math.h>
#include <stdio.h>

#include "sensitivity_view.h"

size_t sensitivity_parameters(const whirl_table *table) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_SENSITIVITY_PARAMETERS);
    return field ? field->rows : 0;
}

const char *sensitivity_parameter(const whirl_result *result, size_t index) {
    char fact[WHIRL_NAME_SIZE];
    snprintf(fact, sizeof fact, "sensitivity %zu", index + 1);
    return whirl_result_fact(result, fact);
}

sensitivity_at sensitivity_of(const whirl_table *table, size_t point, size_t number, size_t parameter) {
    const size_t count = sensitivity_parameters(table);
    const double *parameters = whirl_table_field(table, point, WHIRL_FIELD_SENSITIVITY_PARAMETERS, 0);
    const double *numbers = whirl_table_field(table, point, WHIRL_FIELD_SENSITIVITY_NUMBERS, 0);
    const double *slopes = whirl_table_field(table, point, WHIRL_FIELD_SENSITIVITY_SLOPES, 0);
    sensitivity_at at = {NAN, NAN, NAN, NAN, NAN};
    if (!parameters || !numbers || !slopes) return at;
    const double *row = slopes + 2 * (number * count + parameter);
    at = (sensitivity_at){numbers[number], parameters[parameter], row[0], row[1], NAN};
    if (at.number != 0.0) at.change = at.slope * at.parameter / at.number;
    return at;
}

size_t sensitivity_largest(const whirl_table *table, size_t number) {
    size_t at = table->count;
    double most = -INFINITY;
    for (size_t p = 0; p < table->count; p++) {
        const double size = whirl_table_done(table, p) ? fabs(sensitivity_of(table, p, number, 0).number) : NAN;
        if (!(size > most)) continue;
        most = size;
        at = p;
    }
    return at;
}

size_t sensitivity_order(const whirl_table *table, size_t point, size_t number, size_t order[WHIRL_MAX_SENSITIVITIES]) {
    const size_t count = sensitivity_parameters(table);
    double changes[WHIRL_MAX_SENSITIVITIES];
    size_t known = 0;
    for (size_t i = 0; i < count && i < WHIRL_MAX_SENSITIVITIES; i++) {
        const sensitivity_at at = sensitivity_of(table, point, number, i);
        changes[i] = fabs(at.change);
        if (!isfinite(at.change) || fabs(at.slope) <= at.error) continue;
        size_t k = known++;
        for (; k > 0 && changes[order[k - 1]] < changes[i]; k--) order[k] = order[k - 1];
        order[k] = i;
    }
    return known;
}
