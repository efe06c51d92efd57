// The numbers of any field as figures show them, and what they are called.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "figure_kinds.h"
#include "symbols.h"

const char *shown_owner(const drawing *of, const figure_place *place) {
    if (place->field->extent == WHIRL_PER_STATION) return of->result->stations[place->which].name;
    return place->field->extent == WHIRL_PER_CONTACT ? of->result->contacts[place->which] : "";
}

void shown_quantity(const figure_place *place, char *text, size_t size) {
    char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE];
    const whirl_field *field = place->field;
    if (whirl_field_column_names(field, names))
        snprintf(text, size, "%s", names[place->column]);
    else
        snprintf(text, size, "%.*s", (int)strcspn(field->meaning, ",;("), field->meaning);
    for (size_t end = strlen(text); end > 0 && text[end - 1] == ' '; end--) text[end - 1] = '\0';
}

/// The unit in which it is shown; of lengths "", for the units of the figure say it.
static whirl_unit unit_of(const drawing *of, const figure_place *place) {
    static const char *const kept[] = {"length", "revolution", "1/revolution", "order"};
    const whirl_field *field = place->field;
    whirl_unit unit = {.size = 1.0};
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++)
        if (strcmp(field->unit, kept[i]) == 0) {
            if (i > 0) snprintf(unit.name, sizeof unit.name, "%s", kept[i]);
            return unit;
        }
    const whirl_unit si = whirl_field_si(of->result, place->table, field);
    if (strcmp(si.name, "rad/s") == 0 && of->units->speed.size > 0.0) return of->units->speed;
    if (strcmp(si.name, "1") != 0 && isfinite(si.size))
        snprintf(unit.name, sizeof unit.name, "%s", si.name), unit.size = 1.0 / si.size;
    return unit;
}

static bool is_length(const figure_place *place) {
    char quantity[WHIRL_NAME_SIZE];
    shown_quantity(place, quantity, sizeof quantity);
    return strcmp(place->field->unit, "length") == 0 && strcmp(quantity, "order") != 0;
}

double shown_number(const drawing *of, const figure_place *place, size_t point, size_t row) {
    const double *numbers = whirl_table_field(place->table, point, place->field->name, place->which);
    if (!numbers || row >= place->field->rows || !whirl_table_done(place->table, point)) return NAN;
    const double number = numbers[row * place->field->columns + place->column];
    if (is_length(place)) return number * whirl_shown_length(of->units, place->table, point);
    return number / unit_of(of, place).size;
}

void shown_label(const drawing *of, const figure_place *place, char *label, size_t size) {
    char quantity[WHIRL_NAME_SIZE], symbol[WHIRL_NAME_SIZE + 2];
    shown_quantity(place, quantity, sizeof quantity);
    const whirl_unit unit = unit_of(of, place);
    snprintf(symbol, sizeof symbol, strlen(quantity) == 1 ? "$%s$" : "%s", quantity);
    if (is_length(place))
        symbol_length(of->units, symbol, label, size);
    else
        snprintf(label, size, *unit.name ? "%s (%s)" : "%s", symbol, unit.name);
}
