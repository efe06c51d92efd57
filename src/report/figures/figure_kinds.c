// Registry of the kinds of figures, and the functions that list and make figures of all kinds.
#include "figure_kinds.h"

#include <stdlib.h>
#include <string.h>

#include "figure_build.h"
#include "machine_at.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

#define KIND_AT(name) &name##_figure,
static const figure_kind *const kinds[] = {FIGURE_KINDS(KIND_AT)};
enum { KINDS = sizeof kinds / sizeof *kinds };

// ---------------------------------------------------------------- the list

whirl_status figures_list(const drawing *of, figure_list *list) {
    *list = (figure_list){.count = 0};
    for (size_t k = 0; k < KINDS; k++) {
        if (kinds[k]->whole) kinds[k]->list(list, of, of->result->table_count > 0 ? of->result->tables : NULL);
        for (size_t t = 0; t < of->result->table_count && !kinds[k]->whole; t++) {
            const whirl_table *table = &of->result->tables[t];
            const bool fits = (table->tolerances.samples > 0) == kinds[k]->samples;
            if (table->count > 0 && fits && kinds[k]->list) kinds[k]->list(list, of, table);
        }
    }
    if (!list->failed) return whirl_ok();
    free(list->items);
    *list = (figure_list){.count = 0};
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
}

/// Makes a figure of the list with its panels and series, still without ranges and places.
static whirl_status figure_described(const drawing *of, const figure_place *place, whirl_figure **out) {
    whirl_figure *figure = calloc(1, sizeof *figure);
    *out = figure;
    if (!figure) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the figure %.100s", place->name.name);
    figure->width = 12.0;
    figure->font = 7.0;
    memcpy(figure->name, place->name.name, sizeof figure->name);
    memcpy(figure->title, place->name.title, sizeof figure->title);
    place->kind->describe(of, place, figure);
    if (!figure->failed) return whirl_ok();
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for the figure %.100s", place->name.name);
}

/// Keeps the requested panels and places them; frees the figure after a failure.
static whirl_status figure_completed(whirl_status status, const whirl_figure_options *options, whirl_figure **figure) {
    if (status.code == WHIRL_OK && options && options->panels) status = figure_choose(*figure, options->panels);
    if (status.code == WHIRL_OK) {
        figure_finish(*figure, options ? options->log : NULL);
        return status;
    }
    whirl_figure_free(*figure);
    *figure = NULL;
    return status;
}

whirl_status figure_make(const drawing *of, const figure_place *place, const whirl_figure_options *options,
                         whirl_figure **out) {
    return figure_completed(figure_described(of, place, out), options, out);
}

// ---------------------------------------------------------------- figures by name

/// A result for figures, with each attractor as a table of its own, and the list of its figures.
typedef struct shown_result {
    whirl_result *view;
    whirl_shown_units units;
    whirl_case *machine;
    drawing of;
    figure_list list;
} shown_result;

static void shown_free(shown_result *shown) {
    free(shown->list.items);
    whirl_case_free(shown->machine);
    whirl_result_view_free(shown->view);
}

static whirl_status shown_new(const whirl_result *result, const char *units, shown_result *shown) {
    *shown = (shown_result){.view = NULL};
    whirl_status status = whirl_result_by_attractor(result, &shown->view);
    if (status.code == WHIRL_OK) status = whirl_result_shown_units(shown->view, units, &shown->units);
    if (status.code != WHIRL_OK) return status;
    status = machine_of(shown->view, &shown->machine);
    if (status.code != WHIRL_OK) return status;
    shown->of = (drawing){shown->view, &shown->units, shown->machine};
    return figures_list(&shown->of, &shown->list);
}

whirl_status whirl_figure_names(const whirl_result *result, const char *units, whirl_figure_name **names,
                                size_t *count) {
    shown_result shown;
    *names = NULL;
    *count = 0;
    whirl_status status = shown_new(result, units, &shown);
    whirl_figure_name *all = status.code == WHIRL_OK ? calloc(shown.list.count + 1, sizeof *all) : NULL;
    if (status.code == WHIRL_OK && !all) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the names of figures");
    for (size_t i = 0; all && i < shown.list.count; i++) all[i] = shown.list.items[i].name;
    if (all) *count = shown.list.count;
    *names = all;
    shown_free(&shown);
    return status;
}

/// Returns the kind to which a name belongs by its stem, if the result has no figure of that kind; else NULL.
static const figure_kind *kind_lacking(const figure_list *list, const char *name) {
    const figure_kind *lacking = NULL;
    for (size_t k = 0; k < KINDS; k++)
        if (kinds[k]->stem && strncmp(name, kinds[k]->stem, strlen(kinds[k]->stem)) == 0) lacking = kinds[k];
    for (size_t i = 0; i < list->count; i++)
        if (list->items[i].kind == lacking) return NULL;
    return lacking;
}

/// Reports that there is no figure of a name, in a table or in the result.
static whirl_status no_figure(const shown_result *shown, const whirl_table *within, const char *name) {
    const figure_list *list = &shown->list;
    const figure_kind *lacking = kind_lacking(list, name);
    if (list->count == 0 && shown->view->partial)
        return whirl_fail(WHIRL_BAD_INPUT, "the result has no figures: its points are not done");
    if (lacking)
        return whirl_fail(WHIRL_BAD_INPUT, "there is no figure '%.80s': 'study: %s' in a case has one", name,
                          lacking->study);
    if (list->count == 0) return whirl_fail(WHIRL_BAD_INPUT, "the result has no figures");
    if (within) return whirl_fail(WHIRL_BAD_INPUT, "the table %.60s has no figure '%.80s'", within->name, name);
    const char **names = calloc(list->count, sizeof *names);
    for (size_t i = 0; names && i < list->count; i++) names[i] = list->items[i].name.name;
    const char *near = names ? whirl_nearest_name(name, names, list->count) : NULL;
    const whirl_status status =
        near ? whirl_fail(WHIRL_BAD_INPUT, "there is no figure '%.80s', did you mean %.80s?", name, near)
             : whirl_fail(WHIRL_BAD_INPUT, "there is no figure '%.80s', expected one of %zu, such as %.80s", name,
                          list->count, list->items[0].name.name);
    free((void *)names);
    return status;
}

/// Finds the index of a figure in the list by its name, or adds a figure that is made on request; index list->count if
/// there is none. within: only figures of this table count; NULL: of all tables.
static whirl_status find_named(shown_result *shown, const whirl_table *within, const char *name, size_t *at) {
    figure_list *list = &shown->list;
    whirl_result alone = *shown->of.result;
    drawing of = shown->of;
    whirl_status status = whirl_ok();
    for (*at = 0; *at < list->count; ++*at) {
        const figure_place *place = &list->items[*at];
        const bool named = strcmp(place->name.name, name) == 0;
        if (!within ? named : place->table == within && (named || strcmp(place->within, name) == 0)) return status;
    }
    if (within) {
        alone.tables += within - alone.tables;
        alone.table_count = 1;
        of.result = &alone;
    }
    for (size_t k = 0; k < KINDS && *at == list->count && status.code == WHIRL_OK; k++)
        if (kinds[k]->find) status = kinds[k]->find(list, &of, name);
    return list->failed ? whirl_fail(WHIRL_NO_MEMORY, "no memory for the figure %.100s", name) : status;
}

/// Returns true if the part of `name` before `rest` is the group of a field, like "modes" of "modes/frequency".
static bool is_group(const whirl_result *result, const char *name, const char *rest) {
    for (size_t t = 0; t < result->table_count; t++)
        for (size_t f = 0; f < result->tables[t].layout.field_count; f++)
            if (strncmp(result->tables[t].layout.fields[f].name, name, (size_t)(rest - name) + 1) == 0) return true;
    return false;
}

/// Finds a figure by its name, which may begin with a table: "detail/@#3:disc" is the figure "@#3:disc" of the table
/// "detail". Names of fields and units ("@2.5 rad/s") have a slash, too.
static whirl_status find_figure(shown_result *shown, const char *name, size_t *at) {
    const char *slash = *name == '@' ? NULL : strchr(name, '/');
    whirl_status status = whirl_ok();
    if (slash) {
        char word[WHIRL_NAME_SIZE];
        snprintf(word, sizeof word, "%.*s", (int)(slash - name), name);
        const whirl_table *table = whirl_result_table(shown->of.result, word);
        const bool group = is_group(shown->of.result, name, slash);
        if (table) status = find_named(shown, table, slash + 1, at);
        if (table && (status.code != WHIRL_OK || *at < shown->list.count)) return status;
        if (table && !group) return no_figure(shown, table, slash + 1);
        if (!group && shown->list.count > 0)
            return whirl_fail(WHIRL_BAD_INPUT, "the result has no table and no fields '%.60s'", word);
    }
    status = find_named(shown, NULL, name, at);
    return status.code == WHIRL_OK && *at == shown->list.count ? no_figure(shown, NULL, name) : status;
}

/// Makes the figure of a result with this name (NULL: the first figure of a table).
static whirl_status figure_of_result(shown_result *shown, const char *name, whirl_figure **figure) {
    size_t at = 0;
    whirl_status status = name ? find_figure(shown, name, &at) : whirl_ok();
    *figure = NULL;
    while (!name && at < shown->list.count && shown->list.items[at].kind->whole) at++;
    if (status.code == WHIRL_OK && !name && at == shown->list.count) status = no_figure(shown, NULL, "");
    return status.code == WHIRL_OK ? figure_described(&shown->of, &shown->list.items[at], figure) : status;
}

/// Shows a result in the units of the first one. Lengths that the first result shows over its length scale are shown
/// over the same scale.
static void shown_like(shown_result *shown, const shown_result *first) {
    const double length = first->units.length * shown->view->length_scale / first->view->length_scale;
    shown->units = first->units;
    shown->units.result = shown->view;
    shown->units.length = length;
}

/// Returns the word for the origin of a result in a legend.
static const char *figure_origin(const whirl_result *result) {
    return *whirl_result_fact(result, "measured") ? "measured" : "computed";
}

whirl_status whirl_figure_new(const whirl_result *result, const char *name, const whirl_figure_options *options,
                              whirl_figure **figure) {
    const char *units = options ? options->units : NULL;
    const whirl_result *with = options ? options->with : NULL;
    shown_result shown, second = {.view = NULL};
    whirl_figure *other = NULL;
    *figure = NULL;
    whirl_status status = shown_new(result, units, &shown);
    if (status.code == WHIRL_OK) status = figure_of_result(&shown, name, figure);
    if (status.code == WHIRL_OK && with) status = shown_new(with, units, &second);
    if (status.code == WHIRL_OK && with) {
        shown_like(&second, &shown);
        status = figure_of_result(&second, name ? name : (*figure)->name, &other);
    }
    if (status.code == WHIRL_OK && with)
        status = figure_overlay(*figure, other, figure_origin(result), figure_origin(with));
    whirl_figure_free(other);
    shown_free(&second);
    shown_free(&shown);
    return figure_completed(status, options, figure);
}
