/// Reduction of shafts by component modes (Craig, Bampton 1968). Coordinates on which elements act are kept. The other
/// nodes follow them statically, and move by their lowest modes with the kept coordinates fixed.
///
/// With the kept coordinates q_B and the others q_I this is
///
///     q_I = Psi q_B + Phi (z - Phi' (M_II Psi + M_IB) q_B),    Psi = -K_II^-1 K_IB,   K_II Phi = M_II Phi w^2,
///
/// where the usual modal coordinates are shifted, so that z is coupled with q_B by stiffness alone, not by mass. Then
/// only the few q_B have a mass matrix to be inverted. A column of Phi is scaled to a largest displacement of 1 (a tilt
/// counts as its displacement at the radius of gyration), so that z is a displacement in m, and its inertia is the
/// modal mass.
#ifndef ROTOR_REDUCTION_H
#define ROTOR_REDUCTION_H

#include "element.h"
#include "mesh.h"

/// Result of the reduction of a shaft.
typedef struct reduction {
    size_t kept, all; ///< number of kept modes in a plane, and of all modes
    double highest;   ///< frequency of the highest kept mode, rad/s; 0 if none is kept
    size_t first;     ///< coordinate of the shaft's first mode along x; that along y follows, then those of the next
                      ///< mode
} reduction;

/// Reduces the shafts for which the design requests it. To be called before assembly_finish: renumbers coordinates,
/// transforms linear terms, and renumbers the ports and states of the elements. out [mesh->shaft_count], or NULL.
/// *follow (unless follow is NULL) becomes a matrix [coordinates before][coordinates after]: m or rad of the old
/// coordinates for one m or rad of the new ones, freed by the caller; NULL if nothing is reduced. WHIRL_BAD_INPUT if a
/// shaft's stiffness is not positive; WHIRL_NO_MEMORY.
whirl_status reduction_make(const mesh *from, assembly *of, element *elements, size_t element_count, reduction *out,
                            double **follow);

/// Lists the coordinates of one plane (x, tilt_x) of a shaft's nodes in the assembly, at most 2 for each node. Returns
/// their number.
size_t reduction_nodes(const mesh *from, const assembly *of, size_t shaft, size_t *coordinate);

/// Computes stiffness and mass [count][count] of shafts for these coordinates. The mass includes that of stations.
void reduction_matrices(const assembly *of, size_t count, const size_t *coordinate, double *stiffness, double *mass);

#endif
