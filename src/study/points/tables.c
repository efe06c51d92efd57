// Tables of a study's result before the run: values, branches, and a slot for each point.
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "batch_points.h"
#include "batch_slots.h"
#include "derived_fields.h"
#include "journal_blocks.h"
#include "mapped.h"
#include "record_fields.h"
#include "refine_fields.h"
#include "starts.h"
#include "study_run.h"
#include "tables.h"
#include "whirl/engine/study.h"

static void fill_values(whirl_table *table, const whirl_batch *batch) {
    const bool found = batch_is_found(batch);
    for (size_t slot = 0; found && slot < table->count; slot++) table->values[slot] = NAN;
    if (found) return;
    for (size_t copy = 0; copy < batch_all_slots(batch) / batch->count; copy++)
        for (size_t k = 0; k < batch->count; k++) {
            const size_t slot = copy * batch->count + k;
            mapped_evict_often(batch->mapped, k);
            mapped_evict_often(table->mapped, k);
            table->values[slot] = batch->values ? batch->values[k] : NAN;
            if (batch->carry != WHIRL_CARRY_NONE)
                table->branch[slot] = copy == 1 || batch->carry == WHIRL_CARRY_REVERSE ? -1 : 1;
        }
}

/// Makes an empty table, whose layout follows from the first machine of the batch.
static whirl_status make_table(const whirl_study *study, const whirl_batch *batch, whirl_table *table) {
    // Take the layout from an outline of the first machine.
    whirl_batch first = *batch;
    whirl_machine machine;
    first.outline = true;
    whirl_status status = whirl_study_machine(study, &first, 0, &machine);
    if (status.code != WHIRL_OK) return status;
    status = whirl_layout_new(machine.system, &batch->integrate, &batch->record, batch->analyses, &table->layout);
    const size_t stations = machine.system->probe_count;
    if (status.code == WHIRL_OK) status = derived_add_fields(batch, machine.system, &table->layout);
    if (machine.release) machine.release(machine.owner);
    if (status.code == WHIRL_OK) status = starts_add_fields(batch, stations, &table->layout);
    if (status.code == WHIRL_OK) status = map_add_field(batch, &table->layout);
    if (status.code == WHIRL_OK) status = sample_add_fields(batch, &table->layout);
    if (status.code == WHIRL_OK) status = records_add_fields(batch, &table->layout);
    if (status.code == WHIRL_OK && study_is_refined(study) && !batch_is_found(batch))
        status = refine_add_fields(&table->layout);
    if (status.code != WHIRL_OK) return status;
    // Copy the names and the shape of the batch.
    memcpy(table->name, batch->name, sizeof table->name);
    table->role = batch->role;
    memcpy(table->parameter, batch->parameter, sizeof table->parameter);
    memcpy(table->second, batch->second, sizeof table->second);
    if (batch->third_values) memcpy(table->third, batch->third, sizeof table->third);
    table->clock_factor = 1.0;
    table->tolerances = batch->tolerances;
    table->row = batch->tolerances.samples > 0 ? 0 : batch->row;
    table->plane = batch->plane;
    table->starts = batch->starts > 1 ? batch->starts : 0;
    table->neighbours = batch->neighbours;
    table->places = batch->neighbours > 0 ? batch->count : 0;
    table->refine = batch->refine;
    table->grid = batch->refine > 0 ? batch->count : 0;
    table->count = batch_all_slots(batch);
    table->analyses = batch->analyses;
    table->integrate = batch->integrate;
    table->record = batch->record;
    // Allocate the values; large arrays are files on disk.
    table->values = mapped_take(&table->mapped, table->count, sizeof *table->values, MAPPED_MIN);
    table->branch = mapped_take(&table->mapped, table->count, sizeof *table->branch, MAPPED_MIN);
    if (!table->values || !table->branch)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the values of %zu points", table->count);
    fill_values(table, batch);
    mapped_evict(table->mapped);
    return whirl_ok();
}

/// Allocates the blocks. Arrays of `large` bytes or more are files on disk. Tables that are closed up at the end
/// (table_close_up) stay in memory; only the blocks of their points are ever written, and take up memory.
static whirl_status make_blocks(whirl_table *table, size_t large) {
    const bool closed_up = table->refine > 0 || table->neighbours > 0;
    const size_t least = closed_up ? PTRDIFF_MAX : large > MAPPED_MIN ? large : MAPPED_MIN;
    table->blocks = mapped_take(&table->mapped, table->count * table->layout.size + 1, sizeof *table->blocks, least);
    return table->blocks ? whirl_ok()
                         : whirl_fail(WHIRL_NO_MEMORY, "no memory for the results of %zu points", table->count);
}

/// Returns true if a batch's blocks may stay in the journal: blocks that change later stay in memory.
static bool may_leave(const study_run *run, size_t batch) {
    const whirl_batch *own = &run->study->batches[batch];
    return run->journal && !own->confirm && !study_is_refined(run->study) && !batch_is_found(own);
}

whirl_status tables_fill(const study_run *run, size_t memory) {
    const size_t bytes = memory > 0 ? memory : (size_t)256 << 20, most = bytes / sizeof(double);
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < run->result->table_count && status.code == WHIRL_OK; i++) {
        whirl_table *table = &run->result->tables[i];
        table->done = mapped_take(&table->mapped, table->count, sizeof *table->done, MAPPED_MIN);
        if (!table->done) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", table->count);
        const bool large = table->count >= most / (table->layout.size + 1);
        // No state is kept for points at rest.
        const size_t dimension = whirl_analysis_kind(table->analyses)->moves ? run->dimension : 0;
        status = large && may_leave(run, i) ? journal_blocks_new(table, run->journal, i, dimension)
                                            : make_blocks(table, bytes);
    }
    return status;
}

/// Moves a point to the front.
static void move_point(whirl_table *table, size_t to, size_t from) {
    const size_t size = table->layout.size;
    table->slots[to] = from;
    table->values[to] = table->values[from];
    table->branch[to] = table->branch[from];
    table->done[to] = table->done[from];
    if (table->blocks) memmove(table->blocks + to * size, table->blocks + from * size, size * sizeof *table->blocks);
}

whirl_status table_close_up(whirl_table *table, const unsigned char *wanted) {
    size_t count = 0, point = 0;
    for (size_t slot = 0; slot < table->count; slot++) count += wanted[slot];
    table->slots = calloc(count + 1, sizeof *table->slots);
    if (!table->slots) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", count);
    for (size_t slot = 0; slot < table->count; slot++)
        if (wanted[slot]) move_point(table, point++, slot);
    table->count = count;
    if (table->journal_blocks) journal_blocks_forget(table->journal_blocks);
    double *blocks = table->blocks ? realloc(table->blocks, (count * table->layout.size + 1) * sizeof *blocks) : NULL;
    if (blocks) table->blocks = blocks;
    return whirl_ok();
}

void tables_blank(whirl_result *result) {
    for (size_t i = 0; i < result->table_count; i++) {
        const whirl_table *table = &result->tables[i];
        const size_t size = table->layout.size;
        for (size_t k = 0; table->blocks && k < table->count * size; k++)
            if (!table->done[k / size]) table->blocks[k] = NAN;
    }
}

/// Adds the budget of refinement as a fact: a run with another budget is another study.
static whirl_status tables_note_budget(const whirl_study *study, whirl_result *result) {
    char text[80];
    if (!study_is_refined(study)) return whirl_ok();
    if (study->refine.seconds > 0.0)
        snprintf(text, sizeof text, "%.10g s", study->refine.seconds);
    else
        snprintf(text, sizeof text, "%.10g revolutions", study->refine.revolutions);
    return whirl_result_add_fact(result, "refine", text);
}

/// Adds the second parameter of curves as a fact.
static whirl_status tables_note_second(const whirl_study *study, whirl_result *result) {
    for (size_t i = 0; i < study->batch_count; i++)
        if (*study->batches[i].second)
            return whirl_result_add_fact(result, "second parameter", study->batches[i].second);
    return whirl_ok();
}

whirl_status tables_new(const whirl_study *study, whirl_result **out) {
    whirl_result *result = *out = calloc(1, sizeof *result);
    if (result) {
        result->case_text = calloc(1, 1);
        result->tables = calloc(study->batch_count, sizeof *result->tables);
    }
    if (!result || !result->tables || !result->case_text) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a result");
    result->table_count = study->batch_count;
    for (size_t i = 0; i < study->batch_count; i++) {
        const whirl_status status = make_table(study, &study->batches[i], &result->tables[i]);
        if (status.code != WHIRL_OK) return status;
    }
    const whirl_status status = tables_note_second(study, result);
    return status.code == WHIRL_OK ? tables_note_budget(study, result) : status;
}
