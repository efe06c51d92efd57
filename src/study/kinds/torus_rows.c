// Branches of tori as the rows of a table.
#include <math.h>

#include "whirl/engine/result.h"

static void find_largest_line(const whirl_table *table, whirl_tori *own) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_TORUS_AMPLITUDE);
    double largest = -1.0;
    for (size_t station = 0; field && station < field->repeat; station++)
        for (size_t axis = 0; axis < field->columns; axis++) {
            const double amplitude = whirl_table_field(table, own->last, field->name, station)[axis];
            if (amplitude > largest) own->station = station, own->axis = axis;
            largest = fmax(largest, amplitude);
        }
}

whirl_tori whirl_table_tori(const whirl_table *table, size_t first) {
    whirl_tori own = {.first = first, .last = first};
    while (own.last + 1 < table->count && whirl_table_number(table, own.last + 1, WHIRL_FIELD_TORUS_NUMBER, 0) ==
                                              whirl_table_number(table, first, WHIRL_FIELD_TORUS_NUMBER, 0))
        own.last++;
    for (size_t point = first; point <= own.last; point++) {
        own.found += isfinite(whirl_table_number(table, point, WHIRL_FIELD_TORUS_ROTATION, 0));
        own.stable += whirl_table_number(table, point, WHIRL_FIELD_TORUS_UNSTABLE, 0) == 0.0;
    }
    if (own.found > 0) find_largest_line(table, &own);
    return own;
}
