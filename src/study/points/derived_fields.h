/// Fields of the numbers that are differentiated by parameters (whirl_derivatives), in blocks of points.
#ifndef STUDY_DERIVED_FIELDS_H
#define STUDY_DERIVED_FIELDS_H

#include <stddef.h>

#include "whirl/engine/sensitivity.h"
#include "whirl/engine/spread.h"
#include "whirl/engine/study.h"

/// Lists the numbers of a layout that are differentiated: their places in its blocks, at most WHIRL_MAX_DERIVED.
/// Returns how many.
size_t derived_list(const whirl_derivatives *derivatives, const whirl_system *system, const whirl_layout *layout,
                    whirl_spread_at numbers[WHIRL_MAX_DERIVED]);

/// Adds the fields "sensitivity/..." to the layout of a batch, if any of its numbers are differentiated.
/// WHIRL_BAD_INPUT if it has too many fields.
whirl_status derived_add_fields(const whirl_batch *batch, const whirl_system *system, whirl_layout *layout);

#endif
