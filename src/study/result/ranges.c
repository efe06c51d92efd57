// Points of a table that left the range of a law.
#include <math.h>
#include <stdio.h>

#include "whirl/engine/result.h"

const char *whirl_result_law_range(const whirl_result *result, size_t index) {
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, "range %zu", index + 1);
    return whirl_result_fact(result, name);
}

size_t whirl_table_left(const whirl_table *table, size_t index, whirl_left *out) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_RANGES_REACHED);
    *out = (whirl_left){.points = 0, .reached = NAN, .most = NAN};
    for (size_t point = 0; field && index < field->rows && point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const double *at = whirl_table_field(table, point, WHIRL_FIELD_RANGES_REACHED, 0) + 2 * index;
        if (!(at[0] > at[1] * (1.0 + 1e-9))) continue;
        if (out->points == 0) out->first = point;
        if (out->points == 0 || at[0] / at[1] > out->reached / out->most) {
            out->reached = at[0];
            out->most = at[1];
        }
        out->points++;
    }
    return out->points;
}
