/// The journal of a run, for any thread.
#ifndef STUDY_RUN_JOURNAL_H
#define STUDY_RUN_JOURNAL_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/study.h"

/// Journal entry of a finished point (whirl_point_store).
typedef struct journal_entry {
    size_t batch, slot;
    double *block; ///< [size]
    size_t size;
    double *end; ///< [dimension] state that is stored with the block
    size_t dimension;
} journal_entry;

/// Access to the journal of a run, for any thread. Without a journal (NULL) nothing is read or written.
/// Reads the entry of a point; false if there is none.
bool run_journal_read(const whirl_point_store *journal, const journal_entry *entry);

/// Writes an entry. WHIRL_NO_MEMORY if memory has run out in the calling thread since errno was 0.
whirl_status run_journal_write(const whirl_point_store *journal, const journal_entry *entry);

/// Syncs entries to disk.
whirl_status run_journal_sync(const whirl_point_store *journal);

/// Returns true if the journal stores states of motions under way.
static inline bool run_journal_saves(const whirl_point_store *journal) {
    return journal && journal->save;
}

/// Seconds after which a point under way is saved, and saved again: shorter ones are cheaper to repeat.
static const double save_interval = 5.0;

/// Returns when points are to be saved next, if saving took from `begun` to `now`: large states on a slow disk are
/// saved less often, so that saving takes at most a twentieth of the time. All in seconds of clock_seconds.
double save_next(double begun, double now);

/// Stores the states of a worker's motions under way.
void run_journal_save(const whirl_point_store *journal, size_t worker, const whirl_point_state *states, size_t count);

/// Returns the stored state of a point that begins [*size], to be freed; NULL without one.
void *run_journal_state(const whirl_point_store *journal, size_t batch, size_t slot, double *revolutions, size_t *size);

#endif
