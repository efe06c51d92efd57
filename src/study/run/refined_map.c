#include <stdlib.h>
#include <string.h>

#include "attractors.h"
#include "journal_blocks.h"
#include "pass.h"
#include "passes.h"
#include "refined_map.h"
#include "squares.h"
#include "study_run.h"
#include "tables.h"
#include "whirl/engine/study.h"

struct refined_map {
    const whirl_table *table;
    squares plane;
    unsigned char *asked; ///< [slots] points of the run's share, computed or to be
    unsigned char *late;  ///< [slots] points of `asked` that no share requested; NULL before all shares are gathered
    double *widths;       ///< [slots] widths of undivided squares, at their first corners; 1 for other points
    unsigned char *known; ///< [slots] points of `asked` that were done when squares were last divided
    alike *labels;
    unsigned char *own; ///< [first squares] 1 for squares of the run's share, or dealt to it
};

static squares plane_of(const whirl_batch *batch) {
    return (squares){.columns = batch->row, .rows = batch->count / batch->row, .width = batch->refine};
}

size_t refined_first_points(const whirl_batch *batch) {
    const squares plane = plane_of(batch);
    size_t count = 0;
    for (size_t slot = 0; slot < batch->count; slot++) count += squares_is_corner(&plane, slot);
    return count;
}

bool refined_share_has(const whirl_batch *batch, const whirl_share *share, size_t slot) {
    const squares plane = plane_of(batch);
    const size_t count = squares_count(&plane);
    if (share->count == 0) return true;
    for (size_t i = share->number - 1; i < count; i += share->count)
        if (squares_has(&plane, i, slot)) return true;
    return false;
}

// ---------------------------------------------------------------- making

static bool refined_map_differ(const void *context, size_t a, size_t b) {
    const refined_map *map = context;
    return !alike_are(map->labels, a, b);
}

/// Collects the points that all own first squares need.
static whirl_status ask_all(const refined_map *map, unsigned char *asked) {
    const size_t count = squares_count(&map->plane);
    for (size_t i = 0; i < count; i++)
        if (map->own[i] && !squares_ask(&map->plane, i, asked))
            return whirl_fail(WHIRL_NO_MEMORY, "no memory to refine a map");
    return whirl_ok();
}

/// Marks the first squares of the run's share; none yet if they are dealt out.
static void share_squares(const study_run *run, refined_map *map) {
    const whirl_share *share = &run->share;
    const size_t count = squares_count(&map->plane);
    for (size_t i = 0; i < count && !run->dealer; i++)
        map->own[i] = share->count == 0 || i % share->count + 1 == share->number;
}

static whirl_status make_map(const study_run *run, size_t batch, refined_map **out) {
    const whirl_table *table = &run->result->tables[batch];
    refined_map *map = *out = calloc(1, sizeof *map);
    if (!map) return whirl_fail(WHIRL_NO_MEMORY, "no memory to refine a map");
    map->table = table;
    map->plane = plane_of(&run->study->batches[batch]);
    map->plane.alone = run->share.count > 0 || run->dealer || run->gathering;
    map->plane.differ = refined_map_differ;
    map->plane.context = map;
    map->asked = calloc(table->count, 1);
    map->plane.known = map->known = calloc(table->count, 1);
    map->widths = calloc(table->count, sizeof *map->widths);
    map->labels = alike_new(table);
    map->own = calloc(squares_count(&map->plane), 1);
    if (!map->asked || !map->known || !map->widths || !map->labels || !map->own)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory to refine a map of %zu points", table->count);
    share_squares(run, map);
    return ask_all(map, map->asked);
}

void refined_maps_free(study_run *run) {
    for (size_t i = 0; i < WHIRL_MAX_BATCHES; i++) {
        refined_map *map = run->refined[i];
        if (!map) continue;
        free(map->asked);
        free(map->known);
        free(map->late);
        free(map->own);
        free(map->widths);
        alike_free(map->labels);
        free(map);
        run->refined[i] = NULL;
    }
}

whirl_status refined_maps_new(study_run *run) {
    whirl_status status = whirl_ok();
    refined_maps_free(run);
    for (size_t i = 0; i < run->study->batch_count && status.code == WHIRL_OK; i++)
        if (run->study->batches[i].refine > 0) status = make_map(run, i, &run->refined[i]);
    return status;
}

// ---------------------------------------------------------------- rounds

/// Makes a pass of the points in one list that are not in another (NULL: empty).
static whirl_status take_points(const refined_map *map, const unsigned char *points, const unsigned char *without,
                                pass *p) {
    p->count = 0;
    p->slots = calloc(map->table->count + 1, sizeof *p->slots);
    if (!p->slots) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", map->table->count);
    for (size_t slot = 0; slot < map->table->count; slot++)
        if (points[slot] && !(without && without[slot])) p->slots[p->count++] = slot;
    return whirl_ok();
}

whirl_status refined_pass(const study_run *run, pass *p) {
    const refined_map *map = run->refined[p->batch];
    if (map) return take_points(map, map->asked, map->late, p);
    p->count = refined_first_points(&run->study->batches[p->batch]); // a count for progress, before the map is made
    return whirl_ok();
}

whirl_status refined_late_pass(const study_run *run, pass *p) {
    const refined_map *map = run->refined[p->batch];
    p->anew = true;
    p->count = 0;
    return map->late ? take_points(map, map->late, NULL, p) : whirl_ok();
}

/// Plans the points that squares request because of newly known ones.
static whirl_status plan_round(refined_map *map, pass *p) {
    unsigned char *asked = calloc(map->table->count, 1);
    if (!asked) return whirl_fail(WHIRL_NO_MEMORY, "no memory to refine a map");
    for (size_t slot = 0; slot < map->table->count; slot++)
        map->known[slot] = map->asked[slot] && map->table->done[slot];
    whirl_status status = ask_all(map, asked);
    if (status.code == WHIRL_OK) status = take_points(map, asked, map->asked, p);
    for (size_t slot = 0; status.code == WHIRL_OK && slot < map->table->count; slot++) {
        if (map->late && asked[slot] && !map->asked[slot]) map->late[slot] = 1;
        map->asked[slot] |= asked[slot];
    }
    free(asked);
    return status;
}

static whirl_status refined_map_refine(study_run *run, size_t batch) {
    const whirl_batch *own = &run->study->batches[batch];
    whirl_status status = whirl_ok();
    bool more = true;
    while (status.code == WHIRL_OK && more) {
        pass p = {.batch = batch, .integrate = own->integrate, .record = own->record};
        p.anew = run->refined[batch]->late != NULL;
        status = plan_round(run->refined[batch], &p);
        // Count the points also when the run must end: the study would otherwise seem complete.
        if (status.code == WHIRL_OK) tracker_add(&run->tracker, (double)p.count * pass_revolutions(run, &p), p.count);
        more = p.count > 0 && !atomic_load(&run->tracker.halt);
        if (status.code == WHIRL_OK && more) status = passes_work(run, &p, 1);
        free(p.slots);
    }
    return status;
}

/// Lets first squares request points together, after each has requested alone in its share, and computes these points.
static whirl_status refine_together(study_run *run, size_t batch) {
    refined_map *map = run->refined[batch];
    map->plane.alone = false;
    map->late = calloc(map->table->count, 1);
    return map->late ? refined_map_refine(run, batch) : whirl_fail(WHIRL_NO_MEMORY, "no memory to refine a map");
}

/// Works on first squares as they are dealt out, until none is left or the run must end.
static whirl_status refine_dealt(study_run *run, size_t batch) {
    refined_map *map = run->refined[batch];
    const whirl_dealer *dealer = run->dealer;
    whirl_status status = whirl_ok();
    size_t first = 0, taken = 1;
    while (status.code == WHIRL_OK && taken > 0 && !atomic_load(&run->tracker.halt)) {
        taken = dealer->claim(dealer->context, batch, squares_count(&map->plane), &first);
        for (size_t i = first; i < first + taken; i++) map->own[i] = 1;
        if (taken > 0) status = refined_map_refine(run, batch);
    }
    return status;
}

/// Returns true if all gathered points are known.
static bool has_gathered(const study_run *run) {
    const whirl_progress *progress = &run->tracker.progress;
    return run->gathering && progress->points_done == progress->points_total;
}

/// Notes the widths of the squares, which follow from the labels of the present points. Squares stay as they are when
/// points are recomputed later.
static whirl_status note_widths(refined_map *map) {
    const size_t count = squares_count(&map->plane);
    for (size_t slot = 0; slot < map->table->count; slot++) map->widths[slot] = 1.0;
    for (size_t i = 0; i < count; i++)
        if (map->own[i] && !squares_widths(&map->plane, i, map->widths))
            return whirl_fail(WHIRL_NO_MEMORY, "no memory to refine a map");
    return whirl_ok();
}

whirl_status refined_maps_work(study_run *run) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < run->study->batch_count && status.code == WHIRL_OK; i++) {
        if (!run->refined[i]) continue;
        status = run->dealer ? refine_dealt(run, i) : refined_map_refine(run, i);
        if (status.code == WHIRL_OK && has_gathered(run)) status = refine_together(run, i);
        if (status.code == WHIRL_OK) status = note_widths(run->refined[i]);
    }
    return status;
}

// ---------------------------------------------------------------- the final table

static void note_width(const whirl_table *table, size_t point, double width) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MAP_WIDTH);
    if (table->blocks)
        table->blocks[point * table->layout.size + field->offset] = width;
    else
        journal_blocks_note_width(table, point, width);
}

static whirl_status refined_map_compact(const refined_map *map, whirl_table *table) {
    whirl_status status = table_close_up(table, map->asked);
    if (status.code == WHIRL_OK && table->journal_blocks) status = journal_blocks_make_widths(table);
    for (size_t point = 0; status.code == WHIRL_OK && point < table->count; point++)
        note_width(table, point, map->widths[table->slots[point]]);
    return status;
}

whirl_status refined_maps_end(study_run *run) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < run->study->batch_count && status.code == WHIRL_OK; i++)
        if (run->refined[i]) status = refined_map_compact(run->refined[i], &run->result->tables[i]);
    return status;
}
