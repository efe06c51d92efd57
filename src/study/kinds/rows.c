#include "rows.h"
#include "derived.h"
#include "pass.h"
#include "run_journal.h"
#include "study_run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/engine/result.h"

double *rows_block(const rows *r, size_t row) {
    return r->table->blocks + row * r->table->layout.size;
}

const double *rows_field(const rows *r, size_t row, const char *field) {
    return rows_block(r, row) + whirl_layout_field(&r->table->layout, field)->offset;
}

const double *rows_nodes(const rows *r, size_t row) {
    return rows_field(r, row, WHIRL_FIELD_TRACE_NODES);
}

whirl_status rows_trace(const rows *r, size_t row, whirl_trace *trace) {
    return whirl_block_trace(&r->table->layout, rows_block(r, row), r->table->values[row], &r->pass->record, trace);
}

/// Returns a field that rows of branches and of tori have in common.
static double common_field(const rows *r, size_t row, const char *quantity) {
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, "%s/%s", r->analysis, quantity);
    return *rows_field(r, row, name);
}

static size_t rows_number_of(const rows *r, size_t row) {
    return (size_t)common_field(r, row, "number");
}

bool rows_are_one(const rows *r, size_t row, size_t other) {
    return rows_number_of(r, row) == rows_number_of(r, other);
}

size_t rows_depth(const rows *r, size_t row) {
    size_t depth = 0, parent = (size_t)*rows_field(r, row, WHIRL_FIELD_TRACE_PARENT);
    // Parents come before their children.
    for (size_t i = row; i-- > 0 && parent > 0;)
        if (rows_number_of(r, i) == parent) {
            depth++;
            parent = (size_t)*rows_field(r, i, WHIRL_FIELD_TRACE_PARENT);
        }
    return depth;
}

static whirl_status rows_machine_of(const void *context, double value, whirl_machine *machine) {
    const rows *r = context;
    return r->run->study->machine(r->run->study->family, r->batch, value, machine);
}

whirl_family rows_family(const rows *r) {
    return (whirl_family){rows_machine_of, r};
}

// ---------------------------------------------------------------- what the journal has

/// Returns the journal entry of a row: its block, and the value of its parameter in place of a state.
static journal_entry rows_entry(const rows *r, size_t row) {
    return (journal_entry){.batch = r->pass->batch,
                           .slot = row,
                           .block = rows_block(r, row),
                           .size = r->table->layout.size,
                           .end = &r->table->values[row],
                           .dimension = 1};
}

static bool recall_row(const rows *r, size_t row) {
    const journal_entry entry = rows_entry(r, row);
    return run_journal_read(r->run->journal, &entry) &&
           whirl_block_check(&r->table->layout, entry.block, &r->pass->record).code == WHIRL_OK;
}

static whirl_status keep_row(const rows *r, size_t row) {
    const journal_entry entry = rows_entry(r, row);
    return run_journal_write(r->run->journal, &entry);
}

/// Returns true if the search for these rows has not begun. Curves and tori depend on branches, and there may be none.
static bool are_missing(const rows *r) {
    const whirl_table *branches = whirl_result_role(r->run->result, WHIRL_ROLE_BRANCHES);
    return branches && branches != r->table ? branches->planned > 0 : r->recalled == 0;
}

whirl_status rows_open(rows *r, study_run *run, const pass *p) {
    *r = (rows){.run = run,
                .pass = p,
                .batch = &run->study->batches[p->batch],
                .table = &run->result->tables[p->batch],
                .next = 1};
    r->analysis = whirl_layout_field(&r->table->layout, WHIRL_FIELD_TORUS_NUMBER) ? "torus" : "trace";
    r->capacity = r->table->count;
    for (size_t row = 0; row < r->capacity && recall_row(r, row); row++)
        if (!isnan(common_field(r, row, "end"))) r->recalled = row + 1;
    r->left_out = run->gathering && are_missing(r);
    return run->study->machine(run->study->family, r->batch, r->batch->values[0], &r->machine);
}

bool rows_recall(rows *r, size_t count) {
    // Branches after the known ones were not searched, or not to their end.
    if (r->count >= r->recalled || rows_number_of(r, r->recalled - 1) < r->next + count - 1) {
        r->recalled = r->count;
        return false;
    }
    const size_t before = r->count;
    while (r->count < r->recalled && rows_number_of(r, r->count) < r->next + count) r->table->done[r->count++] = 1;
    tracker_recall(&r->run->tracker, (double)(r->count - before) * pass_revolutions(r->run, r->pass),
                   r->count - before);
    return true;
}

void rows_close(rows *r) {
    const size_t left = r->capacity - r->count;
    const bool ended = !r->left_out && r->run->tracker.error.code == WHIRL_OK && !atomic_load(&r->run->tracker.halt);
    if (r->machine.release) r->machine.release(r->machine.owner);
    r->table->planned = ended ? 0 : r->table->count;
    r->table->count = r->count;
    if (ended) tracker_lack(&r->run->tracker, (double)left * pass_revolutions(r->run, r->pass), left);
}

// ---------------------------------------------------------------- new rows

void rows_take(rows *r, double value) {
    r->table->values[r->count] = value;
    r->table->done[r->count] = 1;
    r->count++;
}

whirl_status rows_keep(rows *r, size_t first, bool ended) {
    whirl_status status = whirl_ok();
    for (size_t row = first; row < r->count && ended && status.code == WHIRL_OK; row++) status = keep_row(r, row);
    tracker_advance(&r->run->tracker, (double)(r->count - first) * pass_revolutions(r->run, r->pass), r->count - first);
    return status;
}

static whirl_status add_row(rows *r, const whirl_trace *trace) {
    whirl_status status = whirl_analyze_trace(trace, &r->pass->record, &r->table->layout, rows_block(r, r->count));
    if (status.code == WHIRL_OK)
        status = derived_of_special(r->run->study, r->batch, r->machine.system, &trace->point, &r->table->layout,
                                    rows_block(r, r->count));
    if (status.code == WHIRL_OK) rows_take(r, trace->point.value);
    return status;
}

whirl_status rows_add(rows *r, const whirl_branch *branch, size_t number, size_t parent) {
    const size_t first = r->count;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < branch->count && r->count < r->capacity && status.code == WHIRL_OK; i++) {
        const bool last = i + 1 == branch->count, full = r->count + 1 == r->capacity;
        const whirl_trace trace = {.system = r->machine.system,
                                   .point = branch->points[i],
                                   .branch = number,
                                   .parent = parent,
                                   .end = last   ? (double)branch->end
                                          : full ? (double)WHIRL_END_OF_POINTS
                                                 : (double)NAN};
        status = add_row(r, &trace);
    }
    return status.code == WHIRL_OK ? rows_keep(r, first, branch->end != WHIRL_END_STOPPED) : status;
}

bool rows_go_on(const rows *r) {
    const whirl_status status = run_journal_sync(r->run->journal);
    if (status.code != WHIRL_OK) tracker_fail(&r->run->tracker, &status);
    return tracker_advance(&r->run->tracker, 0.0, 0);
}

bool rows_found(void *context, const whirl_branch_point *point) {
    (void)point;
    return rows_go_on(context);
}

// ---------------------------------------------------------------- torus_rows
// Branches of tori as rows of a table.

static void find_largest_line(const whirl_table *table, whirl_tori *own) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_TORUS_AMPLITUDE);
    double largest = -1.0;
    for (size_t station = 0; field && station < field->repeat; station++)
        for (size_t axis = 0; axis < field->columns; axis++) {
            const double amplitude = whirl_table_field(table, own->last, field->name, station)[axis];
            if (amplitude > largest) own->station = station, own->axis = axis;
            largest = fmax(largest, amplitude);
        }
}

whirl_tori whirl_table_tori(const whirl_table *table, size_t first) {
    whirl_tori own = {.first = first, .last = first};
    while (own.last + 1 < table->count && whirl_table_number(table, own.last + 1, WHIRL_FIELD_TORUS_NUMBER, 0) ==
                                              whirl_table_number(table, first, WHIRL_FIELD_TORUS_NUMBER, 0))
        own.last++;
    for (size_t point = first; point <= own.last; point++) {
        own.found += isfinite(whirl_table_number(table, point, WHIRL_FIELD_TORUS_ROTATION, 0));
        own.stable += whirl_table_number(table, point, WHIRL_FIELD_TORUS_UNSTABLE, 0) == 0.0;
    }
    if (own.found > 0) find_largest_line(table, &own);
    return own;
}
