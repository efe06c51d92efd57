/// The numbers of a point that are looked at where a case asks for none.
#ifndef STUDY_SPREAD_USUAL_H
#define STUDY_SPREAD_USUAL_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/spread.h"

/// Gives the usual numbers of a layout for tolerances, or for derivatives, by index from 0: field, column and row to
/// *of, and the station or contact, from 0, to *which. Returns false past the last.
bool spread_usual(const whirl_layout *layout, bool derived, size_t index, whirl_spread_of *of, size_t *which);

#endif
