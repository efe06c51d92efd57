/// Whether a motion has settled on a periodic orbit: then the rest of its transient teaches nothing.
#ifndef ANALYZE_SETTLING_H
#define ANALYZE_SETTLING_H

#include <stdbool.h>
#include <stddef.h>

#include "archive.h"
#include "whirl/engine/system.h"

/// The last states of a section, and for every k how many revolutions in a row have returned after k.
typedef struct settling settling;

/// Of motions of the system, which is borrowed: what turns has no part in returns. NULL without memory. Freed by
/// settling_free.
settling *settling_new(const whirl_system *system);
void settling_free(settling *settling);

/// Goes over its state.
void settling_archive(settling *settling, archive *a);

/// Takes the state x [dimension] at the end of a revolution. The least k <= 128 after which the motion has returned to
/// 1e-11 of its size for three periods and 32 revolutions; 0: none.
size_t settling_note(settling *settling, const double *x);

/// The state [dimension] so many revolutions before the last one; NULL where it is no longer, or was never, there. 129
/// are kept.
const double *settling_state(const settling *settling, size_t back);

#endif
