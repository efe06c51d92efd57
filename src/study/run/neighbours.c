// Starts from neighbours. Attractors with small basins, which random starts miss, are found where their basins are
// large and followed from there: each place starts from the ends of its neighbours' motions on attractors that it
// lacks.
#include "neighbours.h"
#include "attractors.h"
#include "pass.h"
#include "passes.h"
#include "study_run.h"
#include "tables.h"
#include "whirl/engine/study.h"

#include <math.h>
#include <stdlib.h>

#include "bounds.h"

/// Attractors known before a round.
typedef struct survey {
    const whirl_table *table;
    size_t *origins;    ///< [count] origins of starts (study_run)
    const double *ends; ///< [count][dimension]
    size_t dimension;
    whirl_coexistence found;
    size_t *first; ///< [places + 1] index in found.items of each place's first attractor
} survey;

// ---------------------------------------------------------------- what a place lacks

/// Lists the neighbours of a place, along a sweep or all axes of a map.
static size_t list_neighbours(const whirl_table *table, size_t place, size_t neighbours[2 * MAP_AXES]) {
    map_axis axes[MAP_AXES];
    const size_t count_axes = map_axes_of(table, axes);
    size_t count = 0;
    for (size_t i = 0; i < count_axes; i++) {
        const size_t step = axes[i].step, at = place / step % axes[i].count;
        if (at > 0) neighbours[count++] = place - step;
        if (at + 1 < axes[i].count) neighbours[count++] = place + step;
    }
    return count;
}

static bool has_number(const survey *s, size_t place, size_t number) {
    for (size_t k = s->first[place]; k < s->first[place + 1]; k++)
        if (s->found.items[k].number == number) return true;
    return false;
}

/// Returns the origin of a place's start number `number` (from 0) from a neighbour.
static size_t *origin_at(const survey *s, size_t place, size_t number) {
    return &s->origins[(s->table->starts + number) * s->table->places + place];
}

/// Counts the starts from neighbours that a place was given.
static size_t count_asked(const survey *s, size_t place) {
    size_t asked = 0;
    for (; asked < WHIRL_MAX_NEIGHBOUR_STARTS; asked++)
        if (*origin_at(s, place, asked) == 0) break;
    return asked;
}

/// Returns true if the place was already started from that point.
static bool was_tried(const survey *s, size_t place, size_t point) {
    for (size_t k = 0; k < count_asked(s, place); k++)
        if (*origin_at(s, place, k) == point + 1) return true;
    return false;
}

/// Returns true if a start of this round (from `before` on) comes from the attractor with that number.
static bool is_asked(const survey *s, size_t place, size_t before, size_t number) {
    for (size_t k = before; k < count_asked(s, place); k++)
        if (s->found.labels[*origin_at(s, place, k) - 1] == number) return true;
    return false;
}

/// Requests starts of a place: one for every attractor of its neighbours that it lacks.
static void ask_place(const survey *s, size_t place) {
    size_t neighbours[2 * MAP_AXES];
    const size_t count = list_neighbours(s->table, place, neighbours), before = count_asked(s, place);
    for (size_t i = 0; i < count; i++)
        for (size_t k = s->first[neighbours[i]]; k < s->first[neighbours[i] + 1]; k++) {
            const whirl_coexisting *one = &s->found.items[k];
            const size_t asked = count_asked(s, place);
            if (asked == WHIRL_MAX_NEIGHBOUR_STARTS) return;
            if (isnan(s->ends[one->first * s->dimension]) || has_number(s, place, one->number)) continue;
            if (was_tried(s, place, one->first) || is_asked(s, place, before, one->number)) continue;
            *origin_at(s, place, asked) = one->first + 1;
        }
}

// ---------------------------------------------------------------- rounds

static whirl_status survey_new(const study_run *run, size_t batch, survey *s) {
    *s = (survey){.table = &run->result->tables[batch],
                  .origins = run->origins[batch],
                  .ends = run->ends[batch],
                  .dimension = run->dimension};
    const whirl_status status = whirl_table_coexistence(s->table, &s->found);
    if (status.code != WHIRL_OK) return status;
    s->first = calloc(s->table->places + 2, sizeof *s->first);
    if (!s->first) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the attractors of %zu places", s->table->places);
    for (size_t k = 0; k < s->found.count; k++) s->first[s->found.items[k].place + 1]++;
    for (size_t place = 0; place < s->table->places; place++) s->first[place + 1] += s->first[place];
    return status;
}

static void survey_free(survey *s) {
    whirl_coexistence_free(&s->found);
    free(s->first);
}

/// Makes a pass of all requested starts. Its slots are to be freed.
static whirl_status plan_round(const study_run *run, size_t batch, pass *p) {
    const whirl_table *table = &run->result->tables[batch];
    const size_t capacity = table->places * WHIRL_MAX_NEIGHBOUR_STARTS;
    survey s;
    p->slots = calloc(capacity + 1, sizeof *p->slots);
    if (!p->slots) return whirl_fail(WHIRL_NO_MEMORY, "no memory for starts of %zu places", table->places);
    const whirl_status status = survey_new(run, batch, &s);
    for (size_t place = 0; status.code == WHIRL_OK && place < table->places; place++) ask_place(&s, place);
    survey_free(&s);
    for (size_t slot = 0; status.code == WHIRL_OK && slot < table->count; slot++)
        if (run->origins[batch][slot] > 0 && !table->done[slot]) p->slots[p->count++] = slot;
    return status;
}

/// Computes a round's motions and, if verdicts are confirmed, those at the second tolerance.
static whirl_status work_round(study_run *run, int round, const pass *p) {
    const bool confirmed = run->study->batches[p->batch].confirm;
    const pass again = pass_confirming(p);
    const double points = (double)p->count;
    tracker_neighbours(&run->tracker, round, p->count,
                       points * (pass_revolutions(run, p) + (confirmed ? pass_revolutions(run, &again) : 0.0)));
    whirl_status status = passes_work(run, p, 1);
    if (status.code == WHIRL_OK) status = passes_outcome(run);
    if (status.code != WHIRL_OK || !confirmed) return status;
    tracker_add(&run->tracker, 0.0, p->count);
    status = passes_work(run, &again, 1);
    return status.code == WHIRL_OK ? passes_outcome(run) : status;
}

/// Runs rounds until no place has an untried attractor, or the limit of rounds is reached.
static whirl_status neighbours_work_batch(study_run *run, size_t batch) {
    const whirl_batch *own = &run->study->batches[batch];
    whirl_status status = whirl_ok();
    bool more = true;
    run->origins[batch] = calloc(run->result->tables[batch].count, sizeof *run->origins[batch]);
    if (!run->origins[batch]) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the starts of neighbours");
    for (size_t round = 1; round <= own->neighbours && more && status.code == WHIRL_OK; round++) {
        pass p = {.batch = batch, .integrate = own->integrate, .record = own->record};
        status = plan_round(run, batch, &p);
        more = p.count > 0;
        if (status.code == WHIRL_OK && more) status = work_round(run, (int)round, &p);
        free(p.slots);
    }
    return status;
}

whirl_status neighbours_work(study_run *run) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < run->study->batch_count && status.code == WHIRL_OK; i++)
        if (run->study->batches[i].neighbours > 0) status = neighbours_work_batch(run, i);
    return status;
}

// ---------------------------------------------------------------- the final table

static whirl_status close_up(const size_t *origins, whirl_table *table) {
    unsigned char *wanted = calloc(table->count + 1, 1);
    if (!wanted) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", table->count);
    for (size_t slot = 0; slot < table->count; slot++)
        wanted[slot] = slot < table->places * table->starts || (origins && origins[slot] > 0);
    const whirl_status status = table_close_up(table, wanted);
    free(wanted);
    return status;
}

whirl_status neighbours_end(study_run *run) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < run->study->batch_count && status.code == WHIRL_OK; i++)
        if (run->study->batches[i].neighbours > 0) status = close_up(run->origins[i], &run->result->tables[i]);
    return status;
}

void neighbours_free(study_run *run) {
    for (size_t i = 0; i < WHIRL_MAX_BATCHES; i++) {
        free(run->origins[i]);
        run->origins[i] = NULL;
    }
}
