/// Slopes of machines of one structure at one state, computed side by side in vector lanes.
#ifndef STUDY_SENSITIVITY_LANES_H
#define STUDY_SENSITIVITY_LANES_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/system.h"

typedef struct sensitivity_lanes sensitivity_lanes;

/// Makes the lanes of machines [count]; they are borrowed. *out is NULL if they are not rotors of one structure and
/// period. Returns false without memory. Freed by sensitivity_lanes_free.
bool sensitivity_lanes_new(size_t count, const whirl_system *const *machines, sensitivity_lanes **out);
void sensitivity_lanes_free(sensitivity_lanes *lanes);

/// Computes the slopes of all machines at a state, with the first machine's forcing; sides as in
/// whirl_system.rhs_on_sides.
void sensitivity_lanes_take(sensitivity_lanes *lanes, const double *forcing, const double *x, const double *sides);

/// Writes the slopes of velocities and of further states of machine `index` at that state.
void sensitivity_lanes_rates(const sensitivity_lanes *lanes, size_t index, double *rates);

#endif
