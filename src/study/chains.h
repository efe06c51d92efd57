/// The points of a study as the recorders ask for them.
///
/// A chain is a sequence of points that start from one another's ends; points that do not carry are chains of one. A
/// chain is a pure function of the study and writes to its own slots, so threads cannot change a result.
#ifndef STUDY_CHAINS_H
#define STUDY_CHAINS_H

#include "tracker.h"
#include "whirl/study.h"

/// One or two tables' worth of points: carried in both directions they are there twice.
static inline size_t batch_copies(const whirl_batch *batch) {
    return batch->carry == WHIRL_CARRY_BOTH ? 2 : 1;
}

/// Revolutions of a point that runs to its end.
static inline double point_revolutions(const whirl_batch *batch) {
    return (double)batch->record.transient + batch->record.record;
}

/// A result with tables without blocks, one a batch. What was made is in *result also where it fails.
whirl_status tables_new(const whirl_study *study, whirl_result **result);

/// Makes the blocks.
whirl_status tables_fill(whirl_result *result);

/// Sets the blocks of points that are not done to NaN.
void tables_blank(whirl_result *result);

/// Points that are computed one after the other.
typedef struct chain {
    size_t first_slot, length; ///< slots of the batch's table
    bool reverse;              ///< from the last slot to the first
    size_t done;               ///< points
    whirl_machine machine;     ///< of the point under way
    double *carried;           ///< [dimension] where the last point ended; NULL: start as the machine says
} chain;

/// The chains of one batch, shared by all threads.
typedef struct chains {
    const whirl_study *study;
    const whirl_batch *batch;
    size_t batch_index;
    whirl_table *table;
    tracker *tracker;
    const whirl_keeper *keeper; ///< or NULL
    size_t count;
    chain *items;
    size_t ready_count;
    chain **ready; ///< [count] those that no thread is at, the next one last
} chains;

/// The chains of a batch. Freed by chains_free, also where it fails.
whirl_status chains_new(chains *chains, const whirl_study *study, size_t batch, whirl_table *table, tracker *progress,
                        const whirl_keeper *keeper);
void chains_free(chains *chains);

/// Computes points until there are none left for this thread, at most `quota` at a time.
whirl_status chains_work(chains *chains, size_t quota);

#endif
