/// Static shapes of shafts between their stations.
#ifndef ROTOR_BETWEEN_H
#define ROTOR_BETWEEN_H

#include "mesh.h"
#include "reduction.h"

/// Contribution of a station's displacement, along x or along y, to a coordinate; the same for velocities.
typedef struct between_term {
    size_t row, column; ///< coordinates along x, each of which is followed by that along y; column: that of the station
    double share;       ///< share in their units
} between_term;

/// Finds the static shape of shafts as functions of their stations' displacements: tilts, nodes of meshes, and
/// coordinates of modes. A shaft with a single station stays straight. The assembly must be finished, except that its
/// body is not scaled yet; made [mesh->shaft_count]. The caller frees *terms, which is NULL if there are none.
/// WHIRL_BAD_INPUT if a shaft has no such shape; WHIRL_NO_MEMORY.
whirl_status between_stations(const mesh *from, const assembly *of, const reduction *made, between_term **terms,
                              size_t *count);

#endif
