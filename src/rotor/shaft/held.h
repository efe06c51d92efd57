/// A shaft in one plane that is held at some of its nodes, its supports, which may be raised.
#ifndef ROTOR_HELD_H
#define ROTOR_HELD_H

#include "mesh.h"
#include "shafts.h"

/// A shaft and its supports. Unknowns are displacement and slope of each node along the shaft, node by node, then the
/// load of every support.
typedef struct held_shaft {
    const mesh *from;
    size_t shaft, first, nodes; ///< first: index of its first node in the mesh
    size_t supports;
    const size_t *support; ///< [supports] nodes, counted along the shaft
} held_shaft;

/// Returns a shaft of the mesh, without supports.
held_shaft held_find(const mesh *from, size_t shaft);

/// Returns the number of unknowns: 2 for each node, and 1 for each support.
size_t held_unknowns(const held_shaft *of);

/// Computes the stiffness of a piece (with flats, its mean over both planes), and the stiffness by its axial force.
void held_piece(const mesh_piece *own, matrix4 *stiffness, matrix4 *axial);

/// Fills in stiffness and constraints of the supports, [K -C'; C 0], to a matrix [unknowns][unknowns] of zeros.
void held_fill(const held_shaft *of, bool axial, double *matrix);

/// Computes influence [supports][supports], N/m: the load on a support (row) if another support (column) is raised by 1
/// m, from the stiffness of the shaft alone. WHIRL_BAD_INPUT if the supports do not hold the shaft; WHIRL_NO_MEMORY.
whirl_status held_influence(const held_shaft *of, double *influence);

#endif
