// States of points under way: files JOURNAL-N beside the journal, one a thread, each replaced as a whole every few
// seconds.
//
// A state is good for its point whenever it was saved, so nothing need be removed before the end: of several the one
// furthest on counts. Frames are those of the journal; their payload begins with the revolutions that were done.
#ifndef STORE_UNDERWAY_H
#define STORE_UNDERWAY_H

#include "whirl/engine/study.h"

#include <stdint.h>

typedef struct underway underway;

/// States beside the journal at `path` of the study with that hash. Those of an earlier run are found where it is
/// resumed, else removed. NULL without memory.
underway *underway_open(const char *path, uint64_t identity, bool resume);

/// Finds the states beside another journal of the same study, too.
void underway_take(underway *states, const char *path);

/// Closes; the files stay, or are removed.
void underway_close(underway *states);
void underway_remove(underway *states);

/// See whirl_keeper.
void underway_save(underway *states, size_t worker, const whirl_kept_state *kept, size_t count);
void *underway_saved(const underway *states, size_t batch, size_t slot, double *revolutions, size_t *size);

#endif
