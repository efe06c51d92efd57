#include "units.h"
#include "two_pi.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

double units_order(const whirl_shown_units *units, double speed) {
    return units->frequency > 0.0 && speed > 0.0 ? speed / two_pi / units->frequency : (double)NAN;
}

void units_order_label(const whirl_shown_units *units, bool orders, bool full, char *label, size_t size) {
    const char *keyphasor = whirl_result_keyphasor(units->result), *below = "negative: backward whirl";
    if (orders)
        snprintf(label, size, full ? "order of the %.63s (%s)" : "order of the %.63s",
                 *keyphasor ? keyphasor : "running speed", below);
    else
        snprintf(label, size, full ? "frequency (%s, %s)" : "frequency (%s)", units->frequency_name, below);
}

int units_way(double direction) {
    const double flat = 0.05;
    return direction > flat ? 1 : direction < -flat ? -1 : 0;
}

bool units_of_speed(const whirl_table *table, const char *speeds) {
    for (size_t point = 0; point < table->count; point++) {
        const double speed = whirl_table_number(table, point, speeds, 0);
        if (whirl_table_done(table, point) && fabs(speed - table->values[point]) > 1e-9 * fabs(speed)) return false;
    }
    return true;
}

double units_length(const whirl_shown_units *units, const whirl_table *table, size_t point, whirl_counting counting) {
    return whirl_shown_length(units, table, point) * (counting == WHIRL_AMPLITUDE ? units->amplitude : 1.0);
}

void units_length_label(const whirl_shown_units *units, whirl_counting counting, const char *quantity, char *label,
                        size_t size) {
    const char *counted = whirl_shown_counted(units, counting);
    if (!*counted)
        snprintf(label, size, units->ratio ? "%s / %s" : "%s (%s)", quantity, units->length_name);
    else
        snprintf(label, size, units->ratio ? "%s / %s (%s)" : "%s (%s %s)", quantity, units->length_name, counted);
}

void units_parameter_label(const whirl_shown_units *units, const char *name, char *label, size_t size) {
    const whirl_unit unit = whirl_shown_parameter(units, name);
    snprintf(label, size, *unit.name ? "%s (%s)" : "%s", name, unit.name);
}

/// Writes "omega = 6000 rpm".
static void put_value(const whirl_shown_units *units, const char *parameter, double value, char *text, size_t size) {
    const whirl_unit unit = whirl_shown_parameter(units, parameter);
    snprintf(text, size, "%s = %.6g%s%s", parameter, value / unit.size, *unit.name ? " " : "", unit.name);
}

void units_point_label(const whirl_shown_units *units, const whirl_table *table, size_t point, char *label,
                       size_t size) {
    if (!*table->parameter) {
        if (table->attractors)
            snprintf(label, size, "%s, attractor %zu", table->name, table->attractors[point].number);
        else
            snprintf(label, size, "%s", table->name);
        return;
    }
    char second[UNIT_LABEL_SIZE];
    put_value(units, table->parameter, table->values[point], label, size);
    const size_t used = strlen(label);
    if (table->row > 0 && whirl_layout_field(&table->layout, WHIRL_FIELD_MAP_SECOND)) {
        put_value(units, table->second, whirl_table_number(table, point, WHIRL_FIELD_MAP_SECOND, 0), second,
                  sizeof second);
        snprintf(label + used, size - used, ", %s", second);
    } else if (table->row == 0 && table->branch && table->branch[point] < 0) {
        snprintf(label + used, size - used, " from the last value");
    }
}
