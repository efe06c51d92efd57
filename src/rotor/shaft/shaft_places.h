/// Shapes of shafts between their nodes (whirl/internal/line.h).
#ifndef ROTOR_SHAFT_PLACES_H
#define ROTOR_SHAFT_PLACES_H

#include "design.h"
#include "whirl/internal/line.h"

/// A place on a piece: the node to its left; and the contributions to its displacement by displacement and slope of
/// that node and of the next one.
typedef struct line_place {
    size_t node;
    double moved[4];
} line_place;

/// Adds the sag to a line with these places. Errors as whirl_design_statics.
whirl_status statics_line(const whirl_design *design, const char *couplings, const line_place *places,
                          whirl_shaft_line *out);

#endif
