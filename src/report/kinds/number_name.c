#include <stdio.h>
#include <string.h>

#include "number_name.h"

/// Names of usual numbers. The number of the row is appended to a name that ends with a blank.
static const struct {
    const char *field, *column, *name;
} number_names[] = {
    {WHIRL_FIELD_MODES_FREQUENCY, "", "frequency of mode "},
    {WHIRL_FIELD_MODES_DAMPING_RATIO, "", "damping ratio of mode "},
    {WHIRL_FIELD_MODES_DECREMENT, "", "decrement of mode "},
    {WHIRL_FIELD_MODES_CRITICAL, "value", "critical speed or threshold "},
    {WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, "", "critical speed "},
    {WHIRL_FIELD_UNBALANCE_AXES, "major", "largest response"},
    {WHIRL_FIELD_ORBIT_MAX_RADIUS, "", "largest radius"},
    {WHIRL_FIELD_ORBIT_MIN_RADIUS, "", "smallest radius"},
    {WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, "forward", "forward 1X"},
    {WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, "backward", "backward 1X"},
    {WHIRL_FIELD_FLOQUET_MODULUS, "", "largest multiplier"},
    {WHIRL_FIELD_TRACE_SPECIAL, "", "value of the special point"},
    {WHIRL_FIELD_ORBIT_AXIAL, "least", "least axial displacement"},
    {WHIRL_FIELD_ORBIT_AXIAL, "largest", "largest axial displacement"},
    {WHIRL_FIELD_ORBIT_TWIST, "least", "least twist"},
    {WHIRL_FIELD_ORBIT_TWIST, "largest", "largest twist"},
    {WHIRL_FIELD_SPECTRUM_AXIAL_SYNCHRONOUS, "", "axial 1X"},
    {WHIRL_FIELD_SPECTRUM_TWIST_SYNCHRONOUS, "", "twist at 1X"},
    {WHIRL_FIELD_RUNUP_AXIAL_EXTREME, "least", "least axial displacement of the run"},
    {WHIRL_FIELD_RUNUP_AXIAL_EXTREME, "largest", "largest axial displacement of the run"},
    {WHIRL_FIELD_RUNUP_TWIST_EXTREME, "least", "least twist of the run"},
    {WHIRL_FIELD_RUNUP_TWIST_EXTREME, "largest", "largest twist of the run"},
    {WHIRL_FIELD_RUNUP_PEAK, "", "largest motion of the run"},
    {WHIRL_FIELD_RUNUP_PEAK_TIME, "", "time of the largest motion"},
    {WHIRL_FIELD_RUNUP_PEAK_SPEED, "", "speed of the largest motion"},
};

void number_name(const whirl_table *table, const whirl_spread_of *of, char text[NUMBER_NAME_SIZE]) {
    size_t i = 0, used;
    while (i < sizeof number_names / sizeof *number_names &&
           (strcmp(number_names[i].field, of->field) != 0 || strcmp(number_names[i].column, of->column) != 0))
        i++;
    if (i < sizeof number_names / sizeof *number_names) {
        used = (size_t)snprintf(text, NUMBER_NAME_SIZE, "%s", number_names[i].name);
        if (text[used - 1] == ' ') snprintf(text + used, NUMBER_NAME_SIZE - used, "%zu", of->row + 1);
    } else {
        // Keep the group of the field, which shows of what a "speed" or "angle" is, and append the number of the row.
        const whirl_field *field = whirl_layout_field(&table->layout, of->field);
        const char *last = strrchr(of->field, '/'), *own = last ? last + 1 : of->field;
        const size_t group = strcspn(of->field, "/");
        snprintf(text, NUMBER_NAME_SIZE, "%s%s%.*s %s", of->column, *of->column ? " of " : "", (int)group, of->field,
                 own);
        for (char *c = text; *c; c++)
            if (*c == '_') *c = ' ';
        used = strlen(text);
        if (field && field->rows > 1) snprintf(text + used, NUMBER_NAME_SIZE - used, " %zu", of->row + 1);
    }
    used = strlen(text);
    if (*of->at) snprintf(text + used, NUMBER_NAME_SIZE - used, " at %s", of->at);
}

/// Returns the index of a column by its name, or 0 if it is unknown.
static size_t number_column(const whirl_field *field, const char *column) {
    char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE];
    size_t i = 0;
    if (!whirl_field_column_names(field, names)) return 0;
    while (i < field->columns && strcmp(names[i], column) != 0) i++;
    return i < field->columns ? i : 0;
}

whirl_unit number_unit(const whirl_shown_units *units, const whirl_table *table, const whirl_spread_of *of) {
    const whirl_field *field = whirl_layout_field(&table->layout, of->field);
    whirl_unit plain = {.size = 1.0};
    if (!field) return plain;
    const char *unit = whirl_column_unit(field, number_column(field, of->column));
    if (strcmp(unit, "length") == 0)
        return units->of[whirl_field_counting(field) == WHIRL_AMPLITUDE ? WHIRL_QUANTITY_SIZE : WHIRL_QUANTITY_LENGTH];
    if (strcmp(unit, "force") == 0) return units->of[WHIRL_QUANTITY_FORCE];
    if (strcmp(unit, "rad/s") == 0)
        return units->of[strstr(of->field, "speed") ? WHIRL_QUANTITY_SPEED : WHIRL_QUANTITY_FREQUENCY];
    const whirl_unit chosen = whirl_shown_chosen(units, unit);
    if (chosen.size > 0.0) return chosen;
    if (strcmp(unit, "1") != 0) snprintf(plain.name, sizeof plain.name, "%s", unit);
    return plain;
}
