/// The points of a pass as the recorders ask for them.
///
/// A chain is a sequence of points that start from one another's ends; points that do not carry are chains of one. A
/// chain is a pure function of the study and writes to its own slots, so threads cannot change a result.
#ifndef STUDY_CHAINS_H
#define STUDY_CHAINS_H

#include "passes.h"

/// Points that are computed one after the other.
typedef struct chain {
    size_t first_slot, length; ///< slots of the batch's table
    bool reverse;              ///< from the last slot to the first
    size_t done;               ///< points
    double begun;              ///< when the point under way was (clock_seconds)
    whirl_machine machine;     ///< of the point under way
    double *start;             ///< of a copy under way
    const double *from;        ///< [dimension] where the motion under way began
} chain;

/// The chains of one pass, shared by all threads.
typedef struct chains {
    study_run *run;
    const pass *pass;
    const whirl_batch *batch;
    whirl_table *table;
    double *ends;               ///< of the batch, or NULL
    double weight, revolutions; ///< of a revolution, of a point
    whirl_layout other;         ///< of a verdict at the second tolerance
    deal deal;                  ///< of chains
    size_t ready_count;
    chain **ready;    ///< those of more than one point that were begun and that no thread is at
    size_t under_way; ///< those that threads are at
} chains;

/// The chains of a pass. Freed by chains_free, also where it fails.
whirl_status chains_new(chains *chains, study_run *run, const pass *pass);
void chains_free(chains *chains);

/// Computes points until there are none left for this thread; `worker` is its number.
whirl_status chains_work(chains *chains, size_t worker);

#endif
