/// What lies between the stations of shafts: how it follows them where nothing else is said of it.
#ifndef ROTOR_BETWEEN_H
#define ROTOR_BETWEEN_H

#include "mesh.h"
#include "reduction.h"

/// So much of a station's displacement, along x or along y, is in a coordinate; of velocities as much.
typedef struct between_term {
    size_t row, column; ///< coordinates along x, those along y stand behind them; the station's is the column
    double share;       ///< of their units
} between_term;

/// The state of shafts that give way statically between displacements of their stations (a shaft with a single one
/// stays straight): tilts, nodes of meshes and coordinates of modes. Of an assembly that is finished but for its body's
/// scales; made [mesh->shaft_count]. *terms is the caller's to free, NULL where there are none. WHIRL_BAD_INPUT where a
/// shaft has no such state; WHIRL_NO_MEMORY.
whirl_status between_stations(const mesh *from, const assembly *of, const reduction *made, between_term **terms,
                              size_t *count);

#endif
