/// State of a run, the passes that it makes over the points of a study, and what all kinds of points need: their
/// fields, tables, journal and deal.
#ifndef STUDY_PASS_H
#define STUDY_PASS_H

#include "tracker.h"
#include "whirl/engine/study.h"

/// State of a refined map (run.h).
typedef struct refined_map refined_map;

/// Data that all passes share.
typedef struct study_run {
    const whirl_study *study;
    whirl_result *result;
    const whirl_keeper *journal; ///< or NULL
    int threads;
    size_t dimension;
    whirl_room *room;                ///< memory of large arrays below
    double *ends[WHIRL_MAX_BATCHES]; ///< [count][dimension] end of every point, NaN if it diverged; for batches that
                                     ///< are carried or may be followed, else NULL
    refined_map *refined[WHIRL_MAX_BATCHES]; ///< refined maps of batches that have one, else NULL
    /// [slots] for batches with starts from neighbours: 1 + the slot whose end a motion begins at, 0 for others; or
    /// NULL.
    size_t *origins[WHIRL_MAX_BATCHES];
    whirl_share share;          ///< points that are computed and confirmed; all zero: all of them
    const whirl_dealer *dealer; ///< NULL: points are not dealt out
    bool gathering;             ///< points that are not in the journal are left out
    bool traced;                ///< branches and tori are as complete as this run makes them
    double deadline;            ///< time at which points under way are abandoned (clock_seconds); 0: none
    tracker tracker;
} study_run;

/// One walk over points of a batch, all with the same options. Slots are those of the batch's table.
typedef struct pass {
    size_t batch;
    int round;       ///< round of refinement; 0: the study itself
    bool confirming; ///< computes motions of finished points at the second tolerance
    bool anew;       ///< computes points that are not in the journal, even while others are gathered
    int copy;        ///< number from 1 of perturbed copies that continue finished points; 0: no copies
    whirl_integrate_options integrate;
    whirl_record_options record;
    size_t count;  ///< points
    size_t *slots; ///< its points or, if these are carried, the first ones of them; NULL: all of the batch
    bool dealt;    ///< other runs take of it, too
} pass;

/// Number of points that are computed one after the other, each from the end of the one before: 1 if none is carried.
static inline size_t pass_carried(const pass *p, const whirl_batch *batch) {
    const bool first = p->round == 0 && !p->confirming && p->copy == 0;
    return first && batch->carry != WHIRL_CARRY_NONE ? batch->count : 1;
}

/// Ratio of step errors at the first and the second tolerance: twice the steps of RK4.
static const double confirm_factor = 16.0;

// ---------------------------------------------------------------- pass.c

enum {
    FOLLOW_COPIES = 2 ///< copies of a chaotic motion that is followed
};

/// Returns a pass over the same points at the second tolerance.
pass pass_confirming(const pass *points);

/// Returns true if a pass computes only verdicts, which are compared with those of the points.
static inline bool pass_is_beside(const pass *p) {
    return p->confirming || p->copy > 0;
}

/// Cost of a revolution, in revolutions of the study.
double pass_weight(const study_run *run, const pass *pass);

/// Weighted revolutions of a point that runs to its end.
double pass_revolutions(const study_run *run, const pass *pass);

/// Number of a pass in the journal (whirl_keeper).
size_t pass_number(const study_run *run, const pass *p);

/// Initial state of a point's perturbed copy [dimension], to be freed; NULL without memory.
double *pass_copy_start(const study_run *run, const pass *p, size_t slot);

/// Slot whose end is the start of a motion from a neighbour; for other motions the slot itself.
size_t pass_origin(const study_run *run, size_t batch, size_t slot);

/// Returns true after the deadline.
bool pass_time_is_over(const study_run *run);

// ---------------------------------------------------------------- run_journal.c

/// Journal entry of a finished point (whirl_keeper).
typedef struct journal_entry {
    size_t batch, slot;
    double *block; ///< [size]
    size_t size;
    double *end; ///< [dimension] state that is stored with the block
    size_t dimension;
} journal_entry;

/// Access to the journal of a run, for any thread. Without a journal (NULL) nothing is read or written.
/// Reads the entry of a point; false if there is none.
bool run_journal_read(const whirl_keeper *journal, const journal_entry *entry);

/// Writes an entry. WHIRL_NO_MEMORY if memory has run out in the calling thread since errno was 0.
whirl_status run_journal_write(const whirl_keeper *journal, const journal_entry *entry);

/// Syncs entries to disk.
whirl_status run_journal_sync(const whirl_keeper *journal);

/// Returns true if the journal stores states of motions under way.
static inline bool run_journal_saves(const whirl_keeper *journal) {
    return journal && journal->save;
}

/// Stores the states of a worker's motions under way.
void run_journal_save(const whirl_keeper *journal, size_t worker, const whirl_point_state *states, size_t count);

/// Returns the stored state of a point that begins [*size], to be freed; NULL without one.
void *run_journal_state(const whirl_keeper *journal, size_t batch, size_t slot, double *revolutions, size_t *size);

// ---------------------------------------------------------------- batches

/// Copies of each point in the table: one for every start; two if carried in both directions.
static inline size_t batch_copies(const whirl_batch *batch) {
    if (batch->starts > 1) return batch->starts;
    return batch->carry == WHIRL_CARRY_BOTH ? 2 : 1;
}

/// Returns true if the batch's points are found during the run.
static inline bool batch_is_found(const whirl_batch *batch) {
    return whirl_analysis_kind(batch->analyses)->found;
}

/// Points of a batch that are known beforehand, or the most that its branches may have.
static inline size_t batch_slots(const whirl_batch *batch) {
    return batch_is_found(batch) ? (size_t)batch->record.trace.points : batch->count * batch_copies(batch);
}

/// Slots of a batch's table, including those for starts from neighbours.
static inline size_t batch_room(const whirl_batch *batch) {
    return batch_slots(batch) + (batch->neighbours > 0 ? batch->count * WHIRL_MAX_NEIGHBOUR_STARTS : 0);
}

/// Returns true if doubtful points are computed again.
static inline bool study_is_refined(const whirl_study *study) {
    return study->refine.revolutions > 0.0 || study->refine.seconds > 0.0;
}

// ---------------------------------------------------------------- tables.c

/// Makes a result with one table a batch, without blocks. *result holds what was made also after a failure.
whirl_status tables_new(const whirl_study *study, whirl_result **result);

/// Makes the blocks, or leaves those of tables of `memory` bytes or more (0: 256 MB) in the journal.
whirl_status tables_fill(const study_run *run, size_t memory);

/// Reduces a table to the wanted [count] slots; it remembers their old slots. WHIRL_NO_MEMORY.
whirl_status table_close_up(whirl_table *table, const unsigned char *wanted);

/// Sets the blocks of points that are not done to NaN.
void tables_blank(whirl_result *result);

// ---------------------------------------------------------------- batch_points.c

/// Adds the fields of the second and third parameters' values, "map/second" and "map/third", to a batch's layout, and
/// of a refined map the width. WHIRL_BAD_INPUT if it has too many fields.
whirl_status map_add_field(const whirl_batch *batch, whirl_layout *layout);

/// Notes these values in the block of a point, by its index in the batch.
void map_note(const whirl_batch *batch, size_t point, const whirl_layout *layout, double *block);

/// Adds the fields "tolerances/..." of a study of tolerances. WHIRL_BAD_INPUT if it has too many fields.
whirl_status sample_add_fields(const whirl_batch *batch, whirl_layout *layout);

/// Notes sample, machine and parameters of a point, by its index in the batch, in its block.
void sample_note(const whirl_batch *batch, size_t point, const whirl_layout *layout, double *block);

// ---------------------------------------------------------------- record_fields.c

/// Adds the fields "dataset/..." of a data set. WHIRL_BAD_INPUT if it has too many fields.
whirl_status records_add_fields(const whirl_batch *batch, whirl_layout *layout);

/// Notes what a record, by its index in the batch, is of, and its signals, in its block. Errors as
/// whirl_channels_sample.
whirl_status records_note(const whirl_batch *batch, size_t point, const whirl_machine *machine,
                          const whirl_record *record, const whirl_layout *layout, double *block);

// ---------------------------------------------------------------- starts.c

/// Adds the fields "starts/number" and "starts/state" of a batch with several starts, and "starts/neighbour" if it may
/// have starts from neighbours. WHIRL_BAD_INPUT if it has too many.
whirl_status starts_add_fields(const whirl_batch *batch, size_t stations, whirl_layout *layout);

/// Start of a motion: a state [dimension], which is the end of slot `origin`, unless that is the slot itself.
typedef struct beginning {
    size_t slot, origin;
    const double *state;
} beginning;

/// Notes the start of a point in its block.
void starts_note(const whirl_batch *batch, const beginning *start, const whirl_system *system,
                 const whirl_layout *layout, double *block);

// ---------------------------------------------------------------- refine_fields.c

/// The fields "refine/...", in this order; from REFINE_OPTIONS on, one for every option of refine_option.
enum { REFINE_ROUNDS, REFINE_SPENT, REFINE_OPTIONS };

/// An option that an advice may change, the offset of its struct in a pass, and the unit of its field.
typedef struct refined_option {
    const whirl_member *member;
    size_t offset;
    const char *unit;
} refined_option;

/// Gives these options by index from 0; false past the last.
bool refine_option(size_t index, refined_option *option);

/// Returns the refinement's numbers in a block, NULL if the layout has none.
double *refine_noted(const whirl_layout *layout, double *block);

/// Sets a pass's options to the noted ones.
void refine_recall(const double *numbers, pass *pass);

/// Adds a field of one number a point at the end of a layout, which has space. Strings other than the name must be
/// static.
void study_add_field(whirl_layout *layout, const char *name, const char *unit, const char *meaning);

/// Adds the fields "refine/..." to the layout of a table. WHIRL_BAD_INPUT if it has too many.
whirl_status refine_add_fields(whirl_layout *layout);

/// Notes the options of a finished point in its block, if it has such fields; `spent` is its cost so far.
void refine_note(const whirl_layout *layout, double *block, const pass *pass, double spent);

/// Returns the cost of refining a point so far, 0 if nothing was noted; and adds a further cost.
double refine_spent(const whirl_layout *layout, const double *block);
void refine_add_spent(const whirl_layout *layout, double *block, double revolutions);

// ---------------------------------------------------------------- deal
// The pieces of a pass (points with those carried from them, neighbours at rest) as they are dealt to threads and, if
// points are dealt out, to other runs.

typedef struct deal {
    const whirl_dealer *dealer; ///< NULL: all pieces are this run's
    size_t number;              ///< pass_number of the pass
    size_t count;               ///< pieces
    size_t next, end;           ///< pieces that this run has and no thread has begun
    size_t dealt;               ///< pieces before this one were dealt to some run
    int threads;                ///< threads of all runs
} deal;

/// Makes the deal of a pass with so many pieces.
deal deal_begin(const study_run *run, const pass *p, size_t count);

/// Pieces that no thread is known to have begun.
static inline size_t deal_left(const deal *d) {
    return d->end - d->next + d->count - d->dealt;
}

/// Takes the next piece; false if none is left. Called by one thread at a time.
bool deal_take(deal *d, size_t *piece);

#endif
