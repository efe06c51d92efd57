// Views of results with one point for each attractor of a place.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/engine/result.h"

double whirl_missed_share(size_t starts) {
    return starts > 0 ? 1.0 - pow(0.05, 1.0 / (double)starts) : 1.0;
}

static int attractor_by_number(const void *left, const void *right) {
    const whirl_coexisting *a = left, *b = right;
    if (a->number != b->number) return a->number < b->number ? -1 : 1;
    return (a->place > b->place) - (a->place < b->place);
}

/// Keeps, of every place, the attractor that most starts lead to. Items are sorted by place.
static size_t keep_largest(whirl_coexisting *items, size_t count) {
    size_t kept = 0;
    for (size_t k = 0; k < count; k++) {
        if (kept > 0 && items[kept - 1].place == items[k].place) {
            if (items[k].starts > items[kept - 1].starts) items[kept - 1] = items[k];
        } else {
            items[kept++] = items[k];
        }
    }
    return kept;
}

/// Copies the source's columns for the chosen points.
static bool take_columns(whirl_table *view) {
    const whirl_table *source = view->source;
    view->chosen = calloc(view->count + 1, sizeof *view->chosen);
    view->slots = calloc(view->count + 1, sizeof *view->slots);
    view->values = calloc(view->count + 1, sizeof *view->values);
    view->branch = calloc(view->count + 1, sizeof *view->branch);
    view->length_scales = source->length_scales ? calloc(view->count + 1, sizeof *view->length_scales) : NULL;
    if (!view->chosen || !view->slots || !view->values || !view->branch) return false;
    if (source->length_scales && !view->length_scales) return false;
    for (size_t i = 0; i < view->count; i++) {
        const whirl_coexisting *one = &view->attractors[i];
        view->chosen[i] = one->first;
        view->slots[i] = one->place;
        view->values[i] = source->values[one->first];
        view->branch[i] = view->row > 0 ? 0 : (int)one->number;
        if (view->length_scales) view->length_scales[i] = source->length_scales[one->first];
    }
    return true;
}

/// Begins a view of a table: copies everything but the arrays.
static void begin_view(const whirl_table *table, whirl_table *view) {
    *view = *table;
    view->starts = view->neighbours = view->places = 0;
    view->slots = view->chosen = NULL;
    view->values = view->length_scales = view->blocks = NULL;
    view->branch = NULL;
    view->done = NULL;
    view->journal_blocks = NULL;
    view->mapped = NULL;
    view->attractors = NULL;
}

static whirl_status finish_view(whirl_table *view) {
    return take_columns(view) ? whirl_ok()
                              : whirl_fail(WHIRL_NO_MEMORY, "no memory for a view of %zu points", view->count);
}

static whirl_status view_table(const whirl_table *source, whirl_table *view) {
    whirl_coexistence found;
    begin_view(source, view);
    view->source = source;
    const whirl_status status = whirl_table_coexistence(source, &found);
    if (status.code != WHIRL_OK) return status;
    view->attractors = found.items;
    view->count = view->row > 0 ? keep_largest(found.items, found.count) : found.count;
    view->planned = found.places;
    found.items = NULL;
    whirl_coexistence_free(&found);
    if (view->row == 0 && view->count > 0)
        qsort(view->attractors, view->count, sizeof *view->attractors, attractor_by_number);
    return finish_view(view);
}

/// Makes a view of a view: the same points of the same source, in arrays of its own.
static whirl_status view_again(const whirl_table *before, whirl_table *view) {
    begin_view(before, view);
    view->attractors = malloc((view->count + 1) * sizeof *view->attractors);
    if (!view->attractors) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a view of %zu points", view->count);
    if (view->count > 0) memcpy(view->attractors, before->attractors, view->count * sizeof *view->attractors);
    return finish_view(view);
}

whirl_status whirl_result_by_attractor(const whirl_result *result, whirl_result **out) {
    // The view shares all but its tables with the result.
    whirl_result *view = *out = malloc(sizeof *view);
    whirl_table *tables = calloc(result->table_count + 1, sizeof *tables);
    if (!view || !tables) {
        free(view);
        free(tables);
        *out = NULL;
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a view of a result");
    }
    *view = *result;
    view->tables = tables;
    whirl_status status = whirl_ok();
    // Make a view of each table with several starts.
    for (size_t i = 0; i < result->table_count; i++) {
        const whirl_table *table = &result->tables[i];
        const bool seen = table->source != NULL;
        if (status.code == WHIRL_OK && (seen || table->starts > 1))
            status = seen ? view_again(table, &tables[i]) : view_table(table, &tables[i]);
        else if (seen)
            begin_view(table, &tables[i]);
        else
            tables[i] = *table;
    }
    if (status.code == WHIRL_OK) return status;
    whirl_result_view_free(view);
    *out = NULL;
    return status;
}

void whirl_result_view_free(whirl_result *view) {
    if (!view) return;
    for (size_t i = 0; i < view->table_count; i++) {
        whirl_table *table = &view->tables[i];
        if (!table->source) continue;
        free(table->chosen);
        free(table->slots);
        free(table->values);
        free(table->branch);
        free(table->length_scales);
        free(table->attractors);
    }
    free(view->tables);
    free(view);
}
