// Points beyond the range of a law, in words.
#include "ranges_told.h"

#include <stdio.h>

bool ranges_told(const whirl_shown_units *units, const whirl_table *table, size_t index, char text[RANGES_TOLD_SIZE]) {
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter);
    whirl_left left;
    if (whirl_table_left(table, index, &left) == 0) return false;
    int used = snprintf(text, RANGES_TOLD_SIZE, "%s; reached %.4g", whirl_result_law_range(units->result, index),
                        left.reached);
    if (used > 0 && used < RANGES_TOLD_SIZE && *table->parameter)
        snprintf(text + used, RANGES_TOLD_SIZE - (size_t)used, " (%zu of %zu points, first at %.6g%s%s)", left.points,
                 table->count, table->values[left.first] / unit.size, *unit.name ? " " : "", unit.name);
    return true;
}
