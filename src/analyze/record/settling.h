/// Detection of motions that have settled on a periodic orbit, whose transient can then be cut short.
#ifndef ANALYZE_SETTLING_H
#define ANALYZE_SETTLING_H

#include <stddef.h>

#include "archive.h"
#include "section.h"

/// The last states of a section. For every k it counts the consecutive revolutions at whose end the motion was where it
/// had been k revolutions before.
typedef struct settling settling;

/// Makes the kept states and counts for motions of the system, which is borrowed. Coordinates that turn do not count
/// for returns. Returns NULL without memory. Freed by settling_free.
settling *settling_new(const whirl_system *system);
void settling_free(settling *settling);

/// Archives (saves or restores) the kept states.
void settling_archive(settling *settling, archive *a);

/// Adds the state x [dimension] at the end of a revolution. Returns the least k <= 128 for which the motion has
/// returned after k revolutions, to 1e-11 of its size, 3 k + 32 times in a row; 0 if there is none.
size_t settling_note(settling *settling, const double *x);

/// Returns the state [dimension] that lies `back` revolutions before the last one, or NULL if it is not kept. The last
/// 129 states are kept.
const double *settling_state(const settling *settling, size_t back);

#endif
