/// A table that grows: points of branches, or of branches of tori, in the order in which they are found.
#ifndef STUDY_ROWS_H
#define STUDY_ROWS_H

#include "pass.h"
#include "study_run.h"
#include "whirl/engine/study.h"

typedef struct rows {
    study_run *run;
    const pass *pass;
    const whirl_batch *batch;
    const char *analysis; ///< "trace" or "torus": the analysis with the rows' fields
    whirl_table *table;
    whirl_machine machine; ///< machine of the first value; all machines have its probes
    size_t capacity;       ///< most rows of the table
    size_t count;          ///< rows in the table
    bool left_out;         ///< true if the run only gathers points and the journal has none of these rows
    size_t recalled;       ///< rows in the table that come from the journal, of finished branches
    size_t next;           ///< number of the branch to be searched next, from 1
    size_t at;             ///< row along whose branch others are searched
} rows;

/// Opens the rows of a pass and recalls those in the journal. Errors as those of the machine. Closed by rows_close,
/// after a failure too; rows_close shrinks the table to its rows.
whirl_status rows_open(rows *r, study_run *run, const pass *p);
void rows_close(rows *r);

/// Returns the machines of the batch.
whirl_family rows_family(const rows *r);

/// Returns true if the next `count` branches are in the journal; their rows, if any, are then in the table.
bool rows_recall(rows *r, size_t count);

/// Adds the points of a branch, and keeps them in the journal if the branch is finished.
whirl_status rows_add(rows *r, const whirl_branch *branch, size_t number, size_t parent);

/// Add rows piece by piece. rows_block returns the block of a row; fill that of row `count`. rows_take then adds this
/// row to the table. rows_keep writes the rows from `first` on to the journal if their branch has ended, and informs
/// the tracker.
double *rows_block(const rows *r, size_t row);
void rows_take(rows *r, double value);
whirl_status rows_keep(rows *r, size_t first, bool ended);

/// rows_field returns the first number of a row's field, rows_nodes its first node [dimension]. rows_trace reads its
/// whole orbit, which the caller frees.
const double *rows_field(const rows *r, size_t row, const char *field);
const double *rows_nodes(const rows *r, size_t row);
whirl_status rows_trace(const rows *r, size_t row, whirl_trace *trace);

/// Returns true if two rows are on one branch.
bool rows_are_one(const rows *r, size_t row, size_t other);

/// Returns the number of branch switches that lead to a row's branch.
size_t rows_depth(const rows *r, size_t row);

/// Informs the tracker and flushes kept rows; false if the run must end. rows_found is the whirl_branch_options.found
/// whose `context` are the rows.
bool rows_go_on(const rows *r);
bool rows_found(void *context, const whirl_branch_point *point);

#endif
