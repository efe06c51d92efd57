/// Gathers extremes, means, contacts and waveforms of a motion, instant by instant.
#ifndef ANALYZE_WATCHER_H
#define ANALYZE_WATCHER_H

#include "whirl/analyze.h"

typedef struct instant_watcher {
    const whirl_system *system;
    whirl_record *record;
    size_t instants;        ///< observed so far
    size_t stride;          ///< instants between two samples of the waveform
    size_t sample_capacity; ///< samples the waveform has room for
    bool touching[WHIRL_MAX_CONTACTS];
} instant_watcher;

/// Begins a record whose arrays are allocated and zero.
void watch_open(instant_watcher *watcher, const whirl_system *system, const whirl_integrate_options *integrate,
                whirl_record *record);

/// Notes which contacts are closed before the record begins, so that only new ones count.
void watch_note_contacts(instant_watcher *watcher, const double *x);

/// A whirl_observe_fn; `observer` is the watcher.
void watch_instant(void *observer, double t, const double *x);

/// Turns sums into means and shares.
void watch_close(const instant_watcher *watcher);

#endif
