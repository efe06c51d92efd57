#include "rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double *block_of(const rows *r, size_t row) {
    return r->table->blocks + row * r->table->layout.size;
}

const double *rows_field(const rows *r, size_t row, const char *field) {
    return block_of(r, row) + whirl_layout_field(&r->table->layout, field)->offset;
}

const double *rows_nodes(const rows *r, size_t row) {
    return rows_field(r, row, "trace/nodes");
}

whirl_status rows_trace(const rows *r, size_t row, whirl_trace *trace) {
    return whirl_block_trace(&r->table->layout, block_of(r, row), r->table->values[row], &r->pass->record, trace);
}

static size_t number_of(const rows *r, size_t row) {
    return (size_t)*rows_field(r, row, "trace/number");
}

bool rows_are_one(const rows *r, size_t row, size_t other) {
    return number_of(r, row) == number_of(r, other);
}

size_t rows_depth(const rows *r, size_t row) {
    size_t depth = 0, parent = (size_t)*rows_field(r, row, "trace/parent");
    // Parents stand before their children.
    for (size_t i = row; i-- > 0 && parent > 0;)
        if (number_of(r, i) == parent) {
            depth++;
            parent = (size_t)*rows_field(r, i, "trace/parent");
        }
    return depth;
}

// ---------------------------------------------------------------- what a keeper knows

/// What is kept of a row: its block, and the value of its parameter in place of a state.
static bool recall_row(const rows *r, size_t row) {
    const whirl_keeper *keeper = r->run->keeper;
    bool known = false;
#pragma omp critical(whirl_keeper)
    known = keeper && keeper->recall(keeper->context, r->pass->batch, row, block_of(r, row), r->table->layout.size,
                                     &r->table->values[row], 1);
    return known;
}

static whirl_status keep_row(const rows *r, size_t row) {
    const whirl_keeper *keeper = r->run->keeper;
    whirl_status status = whirl_ok();
    if (!keeper) return status;
#pragma omp critical(whirl_keeper)
    status = keeper->keep(keeper->context, r->pass->batch, row, block_of(r, row), r->table->layout.size,
                          &r->table->values[row], 1);
    return status;
}

whirl_status rows_open(rows *r, study_run *run, const pass *p) {
    *r = (rows){.run = run,
                .pass = p,
                .batch = &run->study->batches[p->batch],
                .table = &run->result->tables[p->batch],
                .next = 1};
    r->room = r->table->count;
    for (size_t row = 0; row < r->room && recall_row(r, row); row++)
        if (!isnan(*rows_field(r, row, "trace/end"))) r->recalled = row + 1;
    return run->study->machine(run->study->family, r->batch, r->batch->values[0], &r->machine);
}

bool rows_recall(rows *r, size_t count) {
    // What is after all that is known was not looked for, or not to its end.
    if (r->count >= r->recalled || number_of(r, r->recalled - 1) < r->next + count - 1) {
        r->recalled = r->count;
        return false;
    }
    const size_t before = r->count;
    while (r->count < r->recalled && number_of(r, r->count) < r->next + count) r->table->done[r->count++] = 1;
    tracker_recall(&r->run->tracker, (double)(r->count - before) * pass_revolutions(r->run, r->pass),
                   r->count - before);
    return true;
}

void rows_close(rows *r) {
    const size_t left = r->room - r->count;
    const bool ended = r->run->tracker.status.code == WHIRL_OK && !atomic_load(&r->run->tracker.halt);
    if (r->machine.release) r->machine.release(r->machine.owner);
    r->table->planned = ended ? 0 : r->table->count;
    r->table->count = r->count;
    if (ended) tracker_lack(&r->run->tracker, (double)left * pass_revolutions(r->run, r->pass), left);
}

// ---------------------------------------------------------------- new rows

static whirl_status add_row(rows *r, const whirl_trace *trace) {
    const size_t row = r->count;
    const whirl_status status = whirl_analyze_trace(trace, &r->pass->record, &r->table->layout, block_of(r, row));
    if (status.code != WHIRL_OK) return status;
    r->table->values[row] = trace->point.value;
    r->table->done[row] = 1;
    r->count++;
    return status;
}

whirl_status rows_add(rows *r, const whirl_branch *branch, size_t number, size_t parent) {
    const size_t first = r->count;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < branch->count && r->count < r->room && status.code == WHIRL_OK; i++) {
        const bool last = i + 1 == branch->count, full = r->count + 1 == r->room;
        const whirl_trace trace = {.system = r->machine.system,
                                   .point = branch->points[i],
                                   .branch = number,
                                   .parent = parent,
                                   .end = last   ? (double)branch->end
                                          : full ? (double)WHIRL_END_OF_POINTS
                                                 : (double)NAN};
        status = add_row(r, &trace);
    }
    // One that was stopped is looked for anew by a later run.
    for (size_t row = first; row < r->count && branch->end != WHIRL_END_STOPPED && status.code == WHIRL_OK; row++)
        status = keep_row(r, row);
    tracker_advance(&r->run->tracker, (double)(r->count - first) * pass_revolutions(r->run, r->pass), r->count - first);
    return status;
}

bool rows_found(void *context, const whirl_branch_point *point) {
    const rows *r = context;
    const whirl_keeper *keeper = r->run->keeper;
    whirl_status status = whirl_ok();
    (void)point;
#pragma omp critical(whirl_keeper)
    if (keeper && keeper->tend) status = keeper->tend(keeper->context);
    if (status.code != WHIRL_OK) tracker_fail(&r->run->tracker, &status);
    return tracker_advance(&r->run->tracker, 0.0, 0);
}
