/// A run's state, and the passes that it makes over the points of a study.
#ifndef STUDY_PASSES_H
#define STUDY_PASSES_H

#include "tracker.h"
#include "whirl/engine/study.h"

/// What is known of a map that is refined (kinds.h).
typedef struct refined_map refined_map;

/// What all passes share.
typedef struct study_run {
    const whirl_study *study;
    whirl_result *result;
    const whirl_keeper *keeper; ///< or NULL
    int threads;
    size_t dimension;
    whirl_room *room;                ///< of large arrays below
    double *ends[WHIRL_MAX_BATCHES]; ///< [count][dimension] where every point ended, NaN where it diverged, of batches
                                     ///< that are carried or may be followed; else NULL
    refined_map *refined[WHIRL_MAX_BATCHES]; ///< of batches that are refined maps, else NULL
    /// [slots] of batches with starts from neighbours: 1 + the slot at whose end a motion begins, 0 for all others; or
    /// NULL.
    size_t *origins[WHIRL_MAX_BATCHES];
    whirl_share share;          ///< of the points that are computed and confirmed; all zero: all of them
    const whirl_dealer *dealer; ///< NULL: points are not dealt out
    bool gathering;             ///< points that the keeper does not know are left out
    bool traced;                ///< branches and tori are as far as this run takes them
    double deadline;            ///< what is under way then is given up (clock_seconds); 0: there is none
    tracker tracker;
} study_run;

/// One walk over points of a batch, all with the same options. Slots are those of the batch's table.
typedef struct pass {
    size_t batch;
    int round;       ///< of refinement; 0: the study itself
    bool confirming; ///< the points are there; their motions are computed at the second tolerance
    bool anew;       ///< its points are computed where the keeper does not know them, though others are gathered
    int copy;        ///< the points are there; copies of their motions go on, from 1; 0: this is none of these
    whirl_integrate_options integrate;
    whirl_record_options record;
    size_t count;  ///< points
    size_t *slots; ///< its points or, where these are carried, the first slots of its chains; NULL: all of the batch
    bool dealt;    ///< other runs take of it, too
} pass;

/// Points that hang together when those of a batch are computed: they start from one another's ends.
static inline size_t pass_chain_length(const pass *p, const whirl_batch *batch) {
    const bool first = p->round == 0 && !p->confirming && p->copy == 0;
    return first && batch->carry != WHIRL_CARRY_NONE ? batch->count : 1;
}

/// Errors of a step at the second tolerance are smaller by this: twice the steps of RK4.
static const double confirm_factor = 16.0;

// ---------------------------------------------------------------- prepare.c

/// Adds the fact "film tables" (whirl_result_film_tables) to a result of the study. WHIRL_NO_MEMORY.
whirl_status study_add_film_tables(const whirl_study *study, whirl_result *result);

// ---------------------------------------------------------------- pass.c

enum {
    FOLLOW_COPIES = 2 ///< of a chaotic motion that is followed
};

/// The same points, at the second tolerance.
pass pass_confirming(const pass *points);

/// Whether only the verdicts of its motions are taken, to be set beside those of the points.
static inline bool pass_is_beside(const pass *p) {
    return p->confirming || p->copy > 0;
}

/// What a revolution costs, in revolutions of the study.
double pass_weight(const study_run *run, const pass *pass);

/// Revolutions of a point that runs to its end, weighted.
double pass_revolutions(const study_run *run, const pass *pass);

/// What a keeper knows it by (whirl_keeper).
size_t pass_number(const study_run *run, const pass *p);

/// Where the copy of a point begins [dimension], to be freed; NULL without memory.
double *pass_copy_start(const study_run *run, const pass *p, size_t slot);

/// The slot at whose end the motion of a start from a neighbour begins; the slot itself for all others.
size_t pass_origin(const study_run *run, size_t batch, size_t slot);

/// Whether the deadline is past.
bool pass_time_is_over(const study_run *run);

// ---------------------------------------------------------------- keeper.c

/// A finished point as a keeper knows it (whirl_keeper).
typedef struct kept_point {
    size_t batch, slot;
    double *block; ///< [size]
    size_t size;
    double *end; ///< [dimension] what is kept beside the block
    size_t dimension;
} kept_point;

/// Any thread may call these; without a keeper (NULL) nothing is known, kept or saved.
/// keeper_keep: WHIRL_NO_MEMORY where memory has run out in the calling thread since errno was 0.
bool keeper_recall(const whirl_keeper *keeper, const kept_point *point);
whirl_status keeper_keep(const whirl_keeper *keeper, const kept_point *point);
whirl_status keeper_tend(const whirl_keeper *keeper);
void keeper_save(const whirl_keeper *keeper, size_t worker, const whirl_kept_state *states, size_t count);
void *keeper_saved(const whirl_keeper *keeper, size_t batch, size_t slot, double *revolutions, size_t *size);

// ---------------------------------------------------------------- passes.c

/// How often all points are in the table: once from every start; carried in both directions twice.
static inline size_t batch_copies(const whirl_batch *batch) {
    if (batch->starts > 1) return batch->starts;
    return batch->carry == WHIRL_CARRY_BOTH ? 2 : 1;
}

/// Whether its points are found as the run goes on.
static inline bool batch_is_found(const whirl_batch *batch) {
    return whirl_analysis_kind(batch->analyses)->found;
}

/// Points of a batch that are known beforehand, or as many as its branches may have.
static inline size_t batch_slots(const whirl_batch *batch) {
    return batch_is_found(batch) ? (size_t)batch->record.trace.points : batch->count * batch_copies(batch);
}

/// Slots of a batch's table: there may be starts from neighbours besides.
static inline size_t batch_room(const whirl_batch *batch) {
    return batch_slots(batch) + (batch->neighbours > 0 ? batch->count * WHIRL_MAX_NEIGHBOUR_STARTS : 0);
}

/// Whether points in doubt are done again.
static inline bool study_is_refined(const whirl_study *study) {
    return study->refine.revolutions > 0.0 || study->refine.seconds > 0.0;
}

/// Makes all passes, on all threads. Errors and stops are the tracker's. WHIRL_NO_MEMORY.
whirl_status passes_work(study_run *run, const pass *passes, size_t count);

/// How a stage ended whose threads have come to rest: WHIRL_STOPPED where it was asked to before its last point.
whirl_status passes_outcome(const study_run *run);

// ---------------------------------------------------------------- share.c

/// Leaves in a pass over all points of a batch those of the run's share, or those that may be dealt to it; its slots
/// are to be freed. WHIRL_NO_MEMORY.
whirl_status share_pass(const study_run *run, pass *p);

/// Leaves in a pass that confirms carried points those that this run has; others do theirs.
void share_confirmed(const study_run *run, pass *p);

// ---------------------------------------------------------------- tables.c

/// A result with tables without blocks, one a batch. What was made is in *result also where it fails.
whirl_status tables_new(const whirl_study *study, whirl_result **result);

/// Makes the blocks, or leaves those of tables of `memory` bytes or more (0: 256 MB) with the keeper.
whirl_status tables_fill(const study_run *run, size_t memory);

/// Leaves the wanted [count] slots of a table alone, which know what slots they were. WHIRL_NO_MEMORY.
whirl_status table_close_up(whirl_table *table, const unsigned char *wanted);

/// Sets the blocks of points that are not done to NaN.
void tables_blank(whirl_result *result);

// ---------------------------------------------------------------- batch_points.c

/// The fields of the second and third parameters' values, "map/second" and "map/third", in the layout of a batch that
/// has such values; and of a refined map the width.
/// WHIRL_BAD_INPUT when it has too many fields.
whirl_status map_add_field(const whirl_batch *batch, whirl_layout *layout);

/// Notes them in the block of a point, by its index in the batch.
void map_note(const whirl_batch *batch, size_t point, const whirl_layout *layout, double *block);

// ---------------------------------------------------------------- starts.c

/// The fields "starts/number" and "starts/state" of a batch with several starts, and "starts/neighbour" where they may
/// be from neighbours. WHIRL_BAD_INPUT when it has too many.
whirl_status starts_add_fields(const whirl_batch *batch, size_t stations, whirl_layout *layout);

/// How a motion began: from a state [dimension], which is where that of the slot `origin` ended, but for the slot
/// itself.
typedef struct beginning {
    size_t slot, origin;
    const double *state;
} beginning;

/// Notes the start of a point in its block.
void starts_note(const whirl_batch *batch, const beginning *start, const whirl_system *system,
                 const whirl_layout *layout, double *block);

// ---------------------------------------------------------------- refine_fields.c

/// The fields "refine/...", in this order; the last of them on there is one for every option of refine_option.
enum { REFINE_ROUNDS, REFINE_SPENT, REFINE_OPTIONS };

/// An option that an advice may change, the offset of its struct in a pass, and the unit of its field.
typedef struct refined_option {
    const whirl_member *member;
    size_t offset;
    const char *unit;
} refined_option;

/// Gives them by index from 0; false past the last.
bool refine_option(size_t index, refined_option *option);

/// The numbers in a block, NULL where the layout has none.
double *refine_noted(const whirl_layout *layout, double *block);

/// Sets a pass's options to those that were noted.
void refine_recall(const double *numbers, pass *pass);

/// Adds a field of one number a point at the end of a layout, which has room. Words are static, but for the name.
void study_add_field(whirl_layout *layout, const char *name, const char *unit, const char *meaning);

/// Adds the fields "refine/..." to the layout of a table. WHIRL_BAD_INPUT when it has too many.
whirl_status refine_add_fields(whirl_layout *layout);

/// Notes the options of a finished point in its block, where there are such fields; `spent` is what it has cost so far.
void refine_note(const whirl_layout *layout, double *block, const pass *pass, double spent);

/// What refining a point has cost so far, 0 where nothing was noted; and a further cost.
double refine_spent(const whirl_layout *layout, const double *block);
void refine_add_spent(const whirl_layout *layout, double *block, double revolutions);

// ---------------------------------------------------------------- follow.c

/// Follows chaotic motions whose chaos may end, where the budget pays for it, which is lessened by what that costs;
/// *done is how many. Stops are the tracker's.
whirl_status follow_points(study_run *run, int round, double *budget, size_t *done);

// ---------------------------------------------------------------- refine.c

/// Does points in doubt again until the budget is used up or nothing is left in doubt. Stops are the tracker's.
whirl_status refine_points(study_run *run);

// ---------------------------------------------------------------- deal
// The pieces of a pass (chains, neighbours at rest) as threads take them, and other runs where points are dealt out.

typedef struct deal {
    const whirl_dealer *dealer; ///< NULL: all pieces are this run's
    size_t number;              ///< of the pass (pass_number)
    size_t count;               ///< pieces
    size_t next, end;           ///< those that this run has and that no thread has begun
    size_t dealt;               ///< all before this one are with some run
    int threads;                ///< that all of them are for
} deal;

/// Of a pass of so many pieces.
deal deal_begin(const study_run *run, const pass *p, size_t count);

/// Pieces that no thread has begun, as far as is known.
static inline size_t deal_left(const deal *d) {
    return d->end - d->next + d->count - d->dealt;
}

/// Takes the next piece; false where none is left. Called by one thread at a time.
bool deal_take(deal *d, size_t *piece);

#endif
