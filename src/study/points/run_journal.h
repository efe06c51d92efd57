/// The journal of a run. All functions may be called from any thread; a lock lets one thread at a time use the journal.
/// For a journal NULL they read and write nothing.
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

/// Reads the entry of a point. Returns false if there is none.
bool run_journal_read(const whirl_point_store *journal, const journal_entry *entry);

/// Writes an entry. Returns WHIRL_NO_MEMORY if errno is ENOMEM: memory ran out in this thread while it computed the
/// point, so the block may be wrong. The caller sets errno to 0 before the computation.
whirl_status run_journal_write(const whirl_point_store *journal, const journal_entry *entry);

/// Syncs entries to disk.
whirl_status run_journal_sync(const whirl_point_store *journal);

/// Returns true if the journal stores states of motions under way.
static inline bool run_journal_saves(const whirl_point_store *journal) {
    return journal && journal->save;
}

/// Seconds between two saves of a point under way, and from its beginning to the first save. Shorter points are cheaper
/// to repeat.
static const double save_interval = 5.0;

/// Returns the time of the next save after one that took from `begun` to `now`. Large states on a slow disk are saved
/// less often, so that saving takes at most a twentieth of the time. All times are seconds of clock_seconds.
double save_next(double begun, double now);

/// Stores the states of a worker's motions under way.
void run_journal_save(const whirl_point_store *journal, size_t worker, const whirl_point_state *states, size_t count);

/// Returns the stored state [*size] of a point that begins, to be freed by the caller; NULL without one.
void *run_journal_state(const whirl_point_store *journal, size_t batch, size_t slot, double *revolutions, size_t *size);

#endif
