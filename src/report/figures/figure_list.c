// Functions that the kinds of figures share: their list, colours of lines, fields of tables.
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "figure_kinds.h"
#include "report_file.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"

const char *line_colour(size_t number) {
    static const char *const colours[] = {"#0072B2", "#D55E00", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
    return colours[number % (sizeof colours / sizeof *colours)];
}

bool table_has(const whirl_table *table, const char *field) {
    return whirl_layout_field(&table->layout, field) != NULL;
}

bool table_is_sweep(const drawing *of, const whirl_table *table) {
    return *table->parameter && table->row == 0 && whirl_analysis_kind(table->analyses)->moves &&
           table == whirl_result_role(of->result, WHIRL_ROLE_SURVEY);
}

static bool is_taken(const figure_list *list, const char *name) {
    for (size_t i = 0; i < list->count; i++)
        if (strcmp(list->items[i].name.name, name) == 0) return true;
    return false;
}

/// Returns the part of a table's name that distinguishes it from other tables of its study at rest: "first_minimum" for
/// "unbalance_first_minimum"; "" without one.
static const char *table_own_part(const whirl_table *table) {
    if (whirl_analysis_kind(table->analyses)->moves || whirl_analysis_kind(table->analyses)->found) return "";
    for (const whirl_analysis *one = whirl_analyses(); one->name; one++) {
        const size_t length = strlen(one->name);
        if (strncmp(table->name, one->name, length) == 0 && table->name[length] == '_') return table->name + length + 1;
    }
    return "";
}

void list_figure(figure_list *list, const figure_place *place, const char *name, const char *title, ...) {
    // Double the capacity when it is used up.
    if (list->count == list->capacity) {
        const size_t capacity = list->capacity ? 2 * list->capacity : 32;
        figure_place *items = realloc(list->items, capacity * sizeof *items);
        list->failed = list->failed || !items;
        if (!items) return;
        list->items = items;
        list->capacity = capacity;
    }
    // Copy the place.
    figure_place *const added = &list->items[list->count];
    whirl_figure_name *const own = &added->name;
    *added = *place;
    *own = (whirl_figure_name){.point = place->point, .station = place->station};
    // Make a name for files from the given one and the table's own part.
    char safe[sizeof added->within], whole[sizeof safe];
    const char *const own_part = place->kind->whole ? "" : table_own_part(place->table);
    safe_name(name, added->within, sizeof added->within);
    snprintf(whole, sizeof whole, "%.80s%s%.60s", name, *own_part ? "-" : "", own_part);
    safe_name(whole, safe, sizeof safe);
    snprintf(own->name, sizeof own->name, "%s", safe);
    // Number figures of equal names.
    for (unsigned again = 2; is_taken(list, own->name); again++)
        snprintf(own->name, sizeof own->name, "%s-%u", safe, again);
    // Write the title, with the table's name.
    va_list arguments;
    va_start(arguments, title);
    vsnprintf(own->title, sizeof own->title, title, arguments);
    va_end(arguments);
    const size_t used = strlen(own->title);
    if (*own_part) snprintf(own->title + used, sizeof own->title - used, " (%.60s)", own_part);
    list->count++;
}
