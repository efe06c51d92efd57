/// A table that grows: the points of branches, or of branches of tori, in the order in which they are found.
#ifndef STUDY_ROWS_H
#define STUDY_ROWS_H

#include "passes.h"

typedef struct rows {
    study_run *run;
    const pass *pass;
    const whirl_batch *batch;
    const char *analysis; ///< "trace" or "torus", whose fields the rows have
    whirl_table *table;
    whirl_machine machine; ///< of the first value: its probes are those of all
    size_t room;           ///< rows that there may be
    size_t count;          ///< that there are
    bool left_out;         ///< points are gathered, and none of these is there
    size_t recalled;       ///< rows in the table that the keeper knew, of branches that have an end
    size_t next;           ///< number of the branch that is looked for next, from 1
    size_t at;             ///< row along whose branch others are looked for
} rows;

/// Opens those of a pass, and recalls what the keeper knows. Errors as those of the machine. Closed by rows_close,
/// after a failure too, which lets the table have as many points as there are rows.
whirl_status rows_open(rows *r, study_run *run, const pass *p);
void rows_close(rows *r);

/// The machines of the batch.
whirl_family rows_family(const rows *r);

/// Whether the next `count` branches are known: their rows are there then, if they have any.
bool rows_recall(rows *r, size_t count);

/// Adds the points of a branch and keeps them, if it has come to its end.
whirl_status rows_add(rows *r, const whirl_branch *branch, size_t number, size_t parent);

/// The same piece by piece: the block of a row, that of row `count` is filled first; takes that row; keeps those from
/// `first` on if their branch has come to its end, and tells the tracker.
double *rows_block(const rows *r, size_t row);
void rows_take(rows *r, double value);
whirl_status rows_keep(rows *r, size_t first, bool ended);

/// A number, or the first one, of a row's field; its first node [dimension]; all of it, whose orbit is to be freed.
const double *rows_field(const rows *r, size_t row, const char *field);
const double *rows_nodes(const rows *r, size_t row);
whirl_status rows_trace(const rows *r, size_t row, whirl_trace *trace);

/// Whether two rows are of one branch.
bool rows_are_one(const rows *r, size_t row, size_t other);

/// Times that branches were left for another one up to that of a row.
size_t rows_depth(const rows *r, size_t row);

/// Tells the tracker, and brings kept rows to safety; false when the run shall end. The same as
/// whirl_branch_options.found, whose `context` are the rows.
bool rows_go_on(const rows *r);
bool rows_found(void *context, const whirl_branch_point *point);

#endif
