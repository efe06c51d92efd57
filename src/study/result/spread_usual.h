/// The numbers of a point that spreads and derivatives use if a case names none.
#ifndef STUDY_SPREAD_USUAL_H
#define STUDY_SPREAD_USUAL_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/spread.h"

/// Writes usual number `index`, from 0, of a layout for tolerances, or (`derived`) for derivatives: field, column and
/// row to *of, and the station or contact, from 0, to *which. Returns false past the last.
bool spread_usual(const whirl_layout *layout, bool derived, size_t index, whirl_spread_of *of, size_t *which);

#endif
