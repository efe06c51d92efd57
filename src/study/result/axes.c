#include "axes.h"

size_t map_axes_of(const whirl_table *table, map_axis axes[MAP_AXES]) {
    const size_t row = table->row, rows = whirl_table_rows(table), planes = whirl_table_planes(table);
    axes[0] = (map_axis){.count = row > 0 ? row : whirl_table_places(table), .step = 1};
    if (row == 0) return 1;
    axes[1] = (map_axis){.count = rows, .step = row};
    axes[2] = (map_axis){.count = planes, .step = row * rows};
    return planes > 1 ? 3 : 2;
}
