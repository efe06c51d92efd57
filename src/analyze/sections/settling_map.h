/// The linear map from each step of a section to the next, while a motion settles.
#ifndef ANALYZE_SETTLING_MAP_H
#define ANALYZE_SETTLING_MAP_H

#include <stdbool.h>

#include "section.h"

/// The linear map from each step of the section to the next.
typedef struct settling_map {
    whirl_estimate rate; ///< rate of its largest multiplier, natural logarithm per revolution; NaN without such a map
    double bend;         ///< change of the rate from half to half, over the rate's square and the time between them
    double bend_error;
} settling_map;

/// Finds the map. `size` and `rounding` are those of the motion.
settling_map settling_map_find(const section *all, double size, double rounding);

/// Returns true if the map leads to an orbit of one revolution: it certainly shrinks all steps, and its rate stays
/// constant, as that of a linear map. The rate changes on the approach to a small torus, and on the passage near the
/// ghost of a vanished orbit.
bool settling_map_leads_to_rest(const settling_map *map);

#endif
