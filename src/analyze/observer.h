/// Gathers extremes, means, contacts and waveforms of a motion, instant by instant.
#ifndef ANALYZE_OBSERVER_H
#define ANALYZE_OBSERVER_H

#include "whirl/analyze.h"

typedef struct observer {
    const whirl_system *system;
    whirl_record *record;
    size_t instants;        ///< observed so far
    size_t stride;          ///< instants between two samples of the waveform
    size_t sample_capacity; ///< samples the waveform has room for
    bool touching[WHIRL_MAX_CONTACTS];
} observer;

/// Begins a record whose arrays are allocated and zero.
void observer_open(observer *o, const whirl_system *system, const whirl_integrate_options *integrate,
                   whirl_record *record);

/// Notes which contacts are closed before the record begins, so that only new ones count.
void observer_note_contacts(observer *o, const double *x);

/// A whirl_observe_fn; `context` is the observer.
void observer_instant(void *context, double t, const double *x);

/// Turns sums into means and shares.
void observer_close(const observer *o);

#endif
