/// A shaft in one plane that is held at some of its nodes, which may be raised.
#ifndef ROTOR_HELD_H
#define ROTOR_HELD_H

#include "mesh.h"
#include "shafts.h"

/// Displacement and slope of each node along the shaft, node by node, then the load of every support.
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

/// Computes the stiffness of a piece, of a shaft with flats its mean; and that of its axial force.
void held_piece(const mesh_piece *own, matrix4 *stiffness, matrix4 *axial);

/// Fills in stiffness, and constraints of the supports: [K -C'; C 0], [unknowns][unknowns], zeros at first.
void held_fill(const held_shaft *of, bool axial, double *matrix);

/// Computes influence [supports][supports] in N/m: the load on a support (row) if another (column) is raised by 1 m,
/// from the stiffness of the shaft alone.
whirl_status held_influence(const held_shaft *of, double *influence);

#endif
