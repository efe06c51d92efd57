// Figures of any field over one parameter, or over two as a map. They are made on request by a name
// FIELD[:OF][:COLUMN], where OF is a station or contact: "orbit/max_radius:disc", "orbit/mean:disc:y",
// "lyapunov/largest".
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "regimes.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/engine/system.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

// ---------------------------------------------------------------- the name

/// Finds the index of a word among names. WHIRL_BAD_INPUT for another word, with the nearest name.
static whirl_status choose(const char *word, const char *const *names, size_t count, const char *what, size_t *chosen) {
    for (*chosen = 0; *chosen < count; ++*chosen)
        if (strcmp(names[*chosen], word) == 0) return whirl_ok();
    const char *near = whirl_nearest_name(word, names, count);
    if (near) return whirl_fail(WHIRL_BAD_INPUT, "there is no %s '%.60s', did you mean %.60s?", what, word, near);
    return whirl_fail(WHIRL_BAD_INPUT, "there is no %s '%.60s', expected one of %zu, such as %.60s", what, word, count,
                      count > 0 ? names[0] : "none");
}

static whirl_status choose_column(const figure_place *place, const char *word, size_t *column) {
    char own[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE];
    const char *names[WHIRL_MAX_COLUMNS];
    const size_t count = whirl_field_column_names(place->field, own) ? place->field->columns : 0;
    for (size_t i = 0; i < count; i++) names[i] = own[i];
    return choose(word, names, count, "column", column);
}

static whirl_status choose_owner(const drawing *of, const figure_place *place, const char *word, size_t *owner) {
    const char *names[WHIRL_MAX_CONTACTS];
    const bool station = place->field->extent == WHIRL_PER_STATION;
    const size_t all = station ? of->result->station_count : of->result->contact_count;
    const size_t count = all < WHIRL_MAX_CONTACTS ? all : WHIRL_MAX_CONTACTS;
    for (size_t i = 0; i < count; i++) names[i] = station ? of->result->stations[i].name : of->result->contacts[i];
    return choose(word, names, count, station ? "station" : "contact", owner);
}

/// Finds the first table over one or two parameters that has the field.
static bool find_field(const whirl_result *result, const char *name, figure_place *place) {
    for (size_t t = 0; t < result->table_count; t++) {
        place->table = &result->tables[t];
        place->field = *place->table->parameter ? whirl_layout_field(&place->table->layout, name) : NULL;
        if (place->field && place->table->count > 0) return true;
    }
    return false;
}

static whirl_status no_field(const whirl_result *result, const char *name) {
    const char *names[WHIRL_MAX_FIELDS];
    const whirl_layout *layout = &result->tables[0].layout;
    for (size_t i = 0; i < layout->field_count; i++) names[i] = layout->fields[i].name;
    size_t ignored;
    return choose(name, names, layout->field_count, "field along a parameter", &ignored);
}

static whirl_status field_find(figure_list *list, const drawing *of, const char *name) {
    char text[200], title[280], label[WHIRL_NAME_SIZE];
    figure_place place = {.kind = &field_figure, .point = NO_POINT};
    // Names with a slash are fields: FIELD[:OWNER][:COLUMN].
    if (*name == '@' || !strchr(name, '/') || of->result->table_count == 0) return whirl_ok();
    // Split the name into field, owner and column.
    snprintf(text, sizeof text, "%s", name);
    char *owner = strchr(text, ':');
    if (owner) *owner++ = '\0';
    if (!find_field(of->result, text, &place)) return no_field(of->result, text);
    char *column = place.field->extent == WHIRL_PER_POINT ? owner : owner ? strchr(owner, ':') : NULL;
    // Find owner and column among those of the field.
    whirl_status status = whirl_ok();
    if (place.field->extent != WHIRL_PER_POINT) {
        if (column) *column++ = '\0';
        if (owner) status = choose_owner(of, &place, owner, &place.which);
    }
    if (status.code == WHIRL_OK && column) status = choose_column(&place, column, &place.column);
    // A map needs a field with one number for each point.
    if (status.code == WHIRL_OK && place.table->row > 0 && place.field->rows != 1)
        status = whirl_fail(WHIRL_BAD_INPUT, "%.60s has %zu rows at every point, expected a field with one for a map",
                            place.field->name, place.field->rows);
    if (status.code != WHIRL_OK) return status;
    // Title the figure by the quantity, its owner and the parameters.
    shown_quantity(&place, label, sizeof label);
    const char *whose = shown_owner(of, &place);
    snprintf(title, sizeof title, "%s%s%s over %.60s%s%.60s", label, *whose ? " of " : "", whose,
             place.table->parameter, place.table->row > 0 ? " and " : "", place.table->second);
    list_figure(list, &place, name, "%s", title);
    return whirl_ok();
}

// ---------------------------------------------------------------- the diagram

/// Adds the points of one regime, or all points of a table without verdicts. Points of the branch from the last value
/// on are crosses.
static void add_points(const drawing *of, const figure_place *place, whirl_figure *figure, whirl_panel *panel, int kind,
                       int branch) {
    const whirl_table *table = place->table;
    const bool judged = whirl_layout_has_verdict(&table->layout);
    const double size = whirl_shown_parameter(of->units, table->parameter).size;
    whirl_series *dots = NULL;
    for (size_t i = 0; i < table->count; i++) {
        const whirl_verdict verdict = judged ? whirl_table_verdict(table, i) : (whirl_verdict){0};
        if (!whirl_table_done(table, i) || (table->branch[i] < 0 ? -1 : 1) != branch) continue;
        if (judged && (int)regime_class_of(&verdict) != kind) continue;
        const char *name = judged && branch > 0 ? regime_class_name((regime_class)kind) : "";
        const char *colour = judged ? regime_class_colour((regime_class)kind) : line_colour(0);
        if (!dots) dots = panel_named(figure, panel, WHIRL_DOTS, name, colour, branch < 0 ? 3.0 : 2.0);
        if (dots && branch < 0) dots->mark = WHIRL_CROSS;
        for (size_t row = 0; row < place->field->rows; row++)
            series_add(figure, dots, table->values[i] / size, shown_number(of, place, i, row));
    }
}

static void field_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    if (place->table->row > 0) {
        map_describe(of, place, figure);
        return;
    }
    whirl_panel *panel = figure_panel(figure, "value", 1.0, 6.0);
    if (!panel) return;
    symbol_parameter(of->units, place->table->parameter, panel->x.label, sizeof panel->x.label);
    shown_label(of, place, panel->y.label, sizeof panel->y.label);
    const int kinds = whirl_layout_has_verdict(&place->table->layout) ? CLASS_COUNT : 1;
    for (int kind = 0; kind < kinds; kind++)
        for (int branch = 1; branch >= -1; branch -= 2) add_points(of, place, figure, panel, kind, branch);
    bool down = false;
    for (size_t i = 0; i < place->table->count; i++) down = down || place->table->branch[i] < 0;
    snprintf(figure->caption, sizeof figure->caption, "%.250s%s%s.", figure->title,
             kinds > 1 ? ", coloured by regime" : "", down ? "; crosses: followed from the last value on" : "");
}

const figure_kind field_figure = {.describe = field_describe, .find = field_find};
