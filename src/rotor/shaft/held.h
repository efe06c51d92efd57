/// A shaft in one plane that is held at some of its nodes, which may be raised.
#ifndef ROTOR_HELD_H
#define ROTOR_HELD_H

#include "mesh.h"

/// Displacement and slope of each node along the shaft, node by node, then the load of every support.
typedef struct held_shaft {
    const mesh *from;
    size_t shaft, first, nodes; ///< first: of its nodes in the mesh
    size_t supports;
    const size_t *support; ///< [supports] nodes, counted along the shaft
} held_shaft;

/// A shaft of the mesh, without supports.
held_shaft held_find(const mesh *from, size_t shaft);

/// 2 nodes + supports.
size_t held_unknowns(const held_shaft *of);

/// The stiffness of a piece, of a shaft with flats its mean; without that of its axial force.
void held_piece(const mesh_piece *own, matrix4 *stiffness, matrix4 *axial);

/// Stiffness, and supports that displacements keep to: [K -C'; C 0], [unknowns][unknowns], zeros at first.
void held_fill(const held_shaft *of, bool axial, double *matrix);

/// N/m [supports][supports]: the load of the first by raising the second by 1 m, by the stiffness of the shaft alone.
whirl_status held_influence(const held_shaft *of, double *influence);

#endif
