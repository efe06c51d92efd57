/// Reduction of shafts by component modes (Craig, Bampton 1968): what elements act on stays as it is, the nodes between
/// follow by the way they give way statically and by their lowest modes while these stand still.
///
/// With q_B what is kept and q_I what is not,
///
///     q_I = Psi q_B + Phi (z - Phi' (M_II Psi + M_IB) q_B),    Psi = -K_II^-1 K_IB,   K_II Phi = M_II Phi w^2,
///
/// where the usual modal coordinates are shifted so that z is coupled with q_B by stiffness alone, not by mass: then
/// only the few q_B have a mass matrix to be inverted. A column of Phi is scaled to a largest displacement of 1 (of
/// a tilt: what that is at the radius of gyration), so that z is a displacement in m, and its inertia the modal mass.
#ifndef ROTOR_REDUCTION_H
#define ROTOR_REDUCTION_H

#include "element.h"
#include "mesh.h"

/// What became of a shaft.
typedef struct reduction {
    size_t kept, all; ///< modes in a plane, and how many there are
    double highest;   ///< rad/s of the highest that is kept; 0 where none is
    size_t first;     ///< coordinate of its first mode along x; that along y follows, then the next mode
} reduction;

/// Reduces the shafts of the assembly that are to be, before assembly_finish: renumbers coordinates, transforms all
/// that is linear, and renames the ports and states of the elements. out [mesh->shaft_count], or NULL. WHIRL_BAD_INPUT
/// where a shaft's stiffness is not positive; WHIRL_NO_MEMORY.
whirl_status reduction_make(const mesh *from, assembly *of, element *elements, size_t element_count, reduction *out);

/// The coordinates of one plane (x, tilt_x) of a shaft's nodes that the assembly has, at most 2 a node; how many.
size_t reduction_nodes(const mesh *from, const assembly *of, size_t shaft, size_t *coordinate);

/// Stiffness and mass [count][count] of shafts between these coordinates, mass with what stations bring.
void reduction_matrices(const assembly *of, size_t count, const size_t *coordinate, double *stiffness, double *mass);

#endif
