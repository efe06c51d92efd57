/// Recording many motions side by side, a revolution at a time.
#ifndef ANALYZE_RECORD_LANES_H
#define ANALYZE_RECORD_LANES_H

#include "whirl/analyze.h"

typedef struct lanes_recorder lanes_recorder;

/// A recorder of systems that whirl_ensemble_takes, in an ensemble of at least `lanes` lanes (0: as many as are fast).
/// The options are sound; all that is given must outlive it. Freed by lanes_recorder_free, which abandons what is under
/// way.
whirl_status lanes_recorder_new(const whirl_system *system, const whirl_integrate_options *integrate,
                                const whirl_record_options *options, const whirl_task_source *source, size_t lanes,
                                lanes_recorder **recorder);
void lanes_recorder_free(lanes_recorder *recorder);

/// One revolution of the motions in lanes, new ones included. *turned is how many that were: 0 when there are none
/// left.
whirl_status lanes_recorder_revolve(lanes_recorder *recorder, size_t *turned);

#endif
