// Converts numbers of any field to shown units, and names them, for figures.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "units.h"

const char *shown_owner(const drawing *of, const figure_place *place) {
    if (place->field->extent == WHIRL_PER_STATION) return of->result->stations[place->which].name;
    return place->field->extent == WHIRL_PER_CONTACT ? of->result->contacts[place->which] : "";
}

/// Writes the name of the column; "" if the field has one number.
static void shown_field_column(const figure_place *place, char name[WHIRL_NAME_SIZE]) {
    char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE];
    *name = '\0';
    if (whirl_field_column_names(place->field, names)) snprintf(name, WHIRL_NAME_SIZE, "%s", names[place->column]);
}

void shown_quantity(const figure_place *place, char *text, size_t size) {
    const char *meaning = place->field->meaning, *last = strrchr(place->field->name, '/');
    char column[WHIRL_NAME_SIZE];
    shown_field_column(place, column);
    // A meaning that lists codes ("0: ...") cannot serve as a name.
    const bool named = !*column && *meaning && !strchr("0123456789", *meaning);
    if (named)
        snprintf(text, size, "%.*s", (int)strcspn(meaning, ",;(:"), meaning);
    else
        snprintf(text, size, "%s%s%s", last ? last + 1 : place->field->name, *column ? " " : "", column);
    for (char *at = text; *at && !named; at++)
        if (*at == '_') *at = ' ';
    for (size_t end = strlen(text); end > 0 && text[end - 1] == ' '; end--) text[end - 1] = '\0';
}

/// Kind of unit of a field's numbers.
typedef enum measure { PLAIN, OF_LENGTH, OF_VELOCITY, OF_PARAMETER, OF_SPEED } measure;

static measure measure_of(const figure_place *place) {
    static const char *const units[] = {
        [OF_LENGTH] = "length", [OF_VELOCITY] = "length/radian", [OF_PARAMETER] = "parameter", [OF_SPEED] = "rad/s"};
    const char *unit = whirl_column_unit(place->field, place->column);
    const char *meaning = place->field->meaning;
    if (strncmp(meaning, "value of the ", 13) == 0 && strstr(meaning, "in SI")) return OF_PARAMETER;
    for (measure how = OF_LENGTH; how <= OF_SPEED; how++)
        if (strcmp(unit, units[how]) == 0) return how;
    return PLAIN;
}

/// Returns the unit of frequencies and speeds: the requested one, or else that of the parameter if it is a speed.
static whirl_unit speed_unit_of(const drawing *of, const whirl_table *table) {
    whirl_unit unit = {.name = "rad/s", .size = 1.0};
    if (of->units->frequency > 0.0) {
        unit.size = 2.0 * acos(-1.0) * of->units->frequency;
        snprintf(unit.name, sizeof unit.name, "%s", of->units->frequency_name);
    } else if (of->units->speed.size > 0.0) {
        unit = of->units->speed;
    } else if (strcmp(whirl_result_parameter_unit(of->result, table->parameter), "rad/s") == 0) {
        unit = whirl_shown_parameter(of->units, table->parameter);
    }
    return unit;
}

/// Returns the unit of a number that is not a length.
static whirl_unit unit_of(const drawing *of, const figure_place *place) {
    static const char *const kept[] = {"revolution", "1/revolution", "order"};
    const whirl_field *field = place->field;
    const measure how = measure_of(place);
    whirl_unit unit = {.size = 1.0};
    if (how == OF_SPEED) return speed_unit_of(of, place->table);
    if (how == OF_PARAMETER)
        return whirl_shown_parameter(of->units, strstr(field->meaning, "second parameter")  ? place->table->second
                                                : strstr(field->meaning, "third parameter") ? place->table->third
                                                                                            : place->table->parameter);
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++)
        if (strcmp(field->unit, kept[i]) == 0) {
            snprintf(unit.name, sizeof unit.name, "%s", kept[i]);
            return unit;
        }
    const whirl_unit si = whirl_field_si(of->result, place->table, field);
    if (strcmp(field->unit, "length") != 0 && strcmp(si.name, "1") != 0 && isfinite(si.size))
        snprintf(unit.name, sizeof unit.name, "%s", si.name), unit.size = 1.0 / si.size;
    const whirl_unit chosen = whirl_shown_chosen(of->units, si.name);
    if (chosen.size > 0.0) unit = chosen, unit.size /= si.size;
    return unit;
}

double shown_number(const drawing *of, const figure_place *place, size_t point, size_t row) {
    const double *numbers = whirl_table_field(place->table, point, place->field->name, place->which);
    if (!numbers || row >= place->field->rows || !whirl_table_done(place->table, point)) return NAN;
    const double number = numbers[row * place->field->columns + place->column];
    const measure how = measure_of(place);
    if (how == OF_LENGTH || how == OF_VELOCITY)
        return number * units_length(of->units, place->table, point, whirl_field_counting(place->field));
    return number / unit_of(of, place).size;
}

void shown_label(const drawing *of, const figure_place *place, char *label, size_t size) {
    char quantity[WHIRL_NAME_SIZE], symbol[WHIRL_NAME_SIZE + 2], column[WHIRL_NAME_SIZE];
    const measure how = measure_of(place);
    shown_quantity(place, quantity, sizeof quantity);
    shown_field_column(place, column);
    // Write a column named by a single letter as a symbol.
    const size_t before = strlen(quantity) - strlen(column);
    snprintf(symbol, sizeof symbol, strlen(column) == 1 ? "%.*s$%s$" : "%.*s%s", (int)before, quantity,
             quantity + before);
    if (how == OF_LENGTH || how == OF_VELOCITY) {
        symbol_length(of->units, whirl_field_counting(place->field), symbol, label, size);
        if (how == OF_VELOCITY) snprintf(label + strlen(label), size - strlen(label), " per radian");
        return;
    }
    const whirl_unit unit = unit_of(of, place);
    snprintf(label, size, *unit.name ? "%s (%s)" : "%s", symbol, unit.name);
}
