#include <stdio.h>

#include "figure_kinds.h"
#include "speed_unit.h"
#include "units.h"
#include "whirl/internal/shown.h"

speed_unit speed_unit_of(const drawing *of, const whirl_table *table, const char *speeds) {
    const whirl_unit unit = whirl_shown_parameter(of->units, table->parameter);
    speed_unit found = {.size = 6.283185307179586476925, .name = "Hz", .of_speed = units_of_speed(table, speeds)};
    if (!found.of_speed) return found;
    found.size = unit.size;
    snprintf(found.name, sizeof found.name, "%s", *unit.name ? unit.name : "rad/s");
    return found;
}
