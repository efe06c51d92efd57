#include "bounds.h"

#include <math.h>
#include <string.h>

bool bounds_read(const whirl_table *table, size_t point, size_t stations, double *bounds) {
    static const char *const fields[] = {WHIRL_FIELD_ORBIT_MEAN, WHIRL_FIELD_ORBIT_LOW, WHIRL_FIELD_ORBIT_HIGH};
    for (size_t s = 0; s < stations; s++)
        for (size_t f = 0; f < 3; f++) {
            const double *at = whirl_table_field(table, point, fields[f], s);
            if (!at || !isfinite(at[0]) || !isfinite(at[1])) return false;
            memcpy(&bounds[BOUNDS * s + 2 * f], at, 2 * sizeof *at);
        }
    return true;
}

// ---------------------------------------------------------------- axes

size_t map_axes_of(const whirl_table *table, map_axis axes[MAP_AXES]) {
    const size_t row = table->row, rows = whirl_table_rows(table), planes = whirl_table_planes(table);
    axes[0] = (map_axis){.count = row > 0 ? row : whirl_table_places(table), .step = 1};
    if (row == 0) return 1;
    axes[1] = (map_axis){.count = rows, .step = row};
    axes[2] = (map_axis){.count = planes, .step = row * rows};
    return planes > 1 ? 3 : 2;
}
