/// Number of points and of slots of a batch.
#ifndef STUDY_BATCH_SLOTS_H
#define STUDY_BATCH_SLOTS_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/study.h"

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
static inline size_t batch_all_slots(const whirl_batch *batch) {
    return batch_slots(batch) + (batch->neighbours > 0 ? batch->count * WHIRL_MAX_NEIGHBOUR_STARTS : 0);
}

#endif
