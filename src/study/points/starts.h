/// Fields of the starts of motions, in blocks of points.
#ifndef STUDY_STARTS_H
#define STUDY_STARTS_H

#include <stddef.h>

#include "whirl/engine/study.h"

/// Adds the fields "starts/number" and "starts/state" of a batch with several starts, and "starts/neighbour" if it may
/// have starts from neighbours. WHIRL_BAD_INPUT if it has too many.
whirl_status starts_add_fields(const whirl_batch *batch, size_t stations, whirl_layout *layout);

/// Start of a motion: a state [dimension]. It is the end of the motion of slot `origin`, unless `origin` is the slot
/// itself.
typedef struct beginning {
    size_t slot, origin;
    const double *state;
} beginning;

/// Notes the start of a point in its block.
void starts_note(const whirl_batch *batch, const beginning *start, const whirl_system *system,
                 const whirl_layout *layout, double *block);

#endif
