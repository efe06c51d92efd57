/// States of unfinished points, in files JOURNAL-N next to the journal. Each thread replaces its own file as a whole
/// every few seconds.
///
/// A state stays valid for its point, so that files remain until the end of the run. If a point has several states, the
/// one with the most revolutions is used. Files consist of frames as in the journal, whose payload begins with the
/// number of revolutions done.
#ifndef STORE_UNDERWAY_H
#define STORE_UNDERWAY_H

#include "whirl/engine/study.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct underway underway;

/// Opens the states next to the journal at `path` for the study with that hash. States of an earlier run are read if
/// `resume`, else removed. NULL without memory.
underway *underway_open(const char *path, uint64_t identity, bool resume);

/// Reads the states next to another journal of the same study, too.
void underway_take(underway *states, const char *path);

/// Returns true if there are states next to the journal at `path`, of any study.
bool underway_any(const char *path);

/// Close the states and keep their files, or remove them.
void underway_close(underway *states);
void underway_remove(underway *states);

/// Save the states of a worker's points, and return that of a point, as whirl_point_store describes.
void underway_save(underway *states, size_t worker, const whirl_point_state *kept, size_t count);
void *underway_saved(const underway *states, size_t batch, size_t slot, double *revolutions, size_t *size);

#endif
