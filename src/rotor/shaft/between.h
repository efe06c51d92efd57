/// Static shapes of shafts between their stations.
#ifndef ROTOR_BETWEEN_H
#define ROTOR_BETWEEN_H

#include "mesh.h"
#include "reduction.h"

/// Share of a station's displacement, along x or along y, in a coordinate; the same for velocities.
typedef struct between_term {
    size_t row, column; ///< coordinates along x, each followed by that along y; the column is the station's
    double share;       ///< share in their units
} between_term;

/// Finds the static shape of shafts as functions of their stations' displacements (a shaft with a single one stays
/// straight): tilts, nodes of meshes and coordinates of modes. The assembly is finished except for its body's scales;
/// made [mesh->shaft_count]. The caller frees *terms, NULL if there are none. WHIRL_BAD_INPUT if a shaft has no such
/// shape; WHIRL_NO_MEMORY.
whirl_status between_stations(const mesh *from, const assembly *of, const reduction *made, between_term **terms,
                              size_t *count);

#endif
