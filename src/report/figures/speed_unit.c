#include "speed_unit.h"

#include <math.h>
#include <stdio.h>

speed_unit speed_unit_of(const drawing *of, const whirl_table *table, const char *speeds) {
    const whirl_unit unit = whirl_shown_parameter(of->units, table->parameter);
    speed_unit found = {.size = 6.283185307179586476925, .name = "Hz", .of_speed = true};
    for (size_t point = 0; point < table->count; point++) {
        const double *speed = whirl_table_field(table, point, speeds, 0);
        if (speed && whirl_table_done(table, point) && fabs(*speed - table->values[point]) > 1e-9 * fabs(*speed))
            found.of_speed = false;
    }
    if (!found.of_speed) return found;
    found.size = unit.size;
    snprintf(found.name, sizeof found.name, "%s", *unit.name ? unit.name : "rad/s");
    return found;
}
