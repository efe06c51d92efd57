/// The points of a pass in the order in which recorders take them.
/// A chain is a sequence of points that start from one another's ends; other points are chains of one. A chain is a
/// pure function of the study and writes to its own slots, so threads cannot change a result.
#ifndef STUDY_CHAINS_H
#define STUDY_CHAINS_H

#include "passes.h"

/// Points that are computed one after the other.
typedef struct chain {
    size_t first_slot, length; ///< slots of the batch's table
    bool reverse;              ///< from the last slot to the first
    size_t done;               ///< points
    double begun;              ///< start of the point under way (clock_seconds)
    whirl_machine machine;     ///< machine of the point under way
    double *start;             ///< initial state of a perturbed copy under way
    const double *from;        ///< [dimension] initial state of the motion under way
} chain;

/// The chains of one pass, shared by all threads.
typedef struct chains {
    study_run *run;
    const pass *pass;
    const whirl_batch *batch;
    whirl_table *table;
    double *ends;               ///< the batch's ends, or NULL
    double weight, revolutions; ///< cost of a revolution; revolutions of a point
    whirl_layout other;         ///< layout of a verdict at the second tolerance
    deal deal;                  ///< chains that are not taken
    size_t ready_count;
    chain **ready;    ///< begun chains of several points that no thread works at
    size_t under_way; ///< chains that threads work at
} chains;

/// Makes the chains of a pass. Freed by chains_free, also after a failure.
whirl_status chains_new(chains *chains, study_run *run, const pass *pass);
void chains_free(chains *chains);

/// Computes points until none is left for this thread; `worker` is its number.
whirl_status chains_work(chains *chains, size_t worker);

#endif
