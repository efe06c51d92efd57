/// The mesh of shafts: nodes and finite elements between them, from segments and stations.
#ifndef ROTOR_MESH_H
#define ROTOR_MESH_H

#include "design.h"
#include "shafts.h"

typedef struct mesh_node {
    size_t shaft;
    double z;       ///< along the shaft, m
    size_t station; ///< in the assembly: a station of the design, or one of the mesh's own behind these
} mesh_node;

typedef struct mesh_piece {
    size_t shaft, node[2];
    double angle;            ///< direction of the flats' normal
    shaft_settings settings; ///< the shaft's, or its segment's own
    shaft_piece piece;
} mesh_piece;

/// The mesh; empty if the design has no segments.
typedef struct mesh {
    size_t shaft_count, node_count, piece_count;
    shaft_settings *shafts;
    mesh_node *nodes; ///< shaft by shaft, along them
    mesh_piece *pieces;
    size_t hidden; ///< nodes that are no station of the design
} mesh;

/// Makes the mesh. WHIRL_BAD_INPUT with a sentence: then *culprit is the design's element at fault, or
/// WHIRL_NO_ELEMENT. Freed by mesh_clear in any case.
whirl_status mesh_make(const whirl_design *design, mesh *out, size_t *culprit);
void mesh_clear(mesh *of);

/// Adds the nodes to an assembly, whose stations are those of the design and `hidden` more: where they move, and their
/// inertia.
void mesh_inertia(const mesh *from, assembly *to);

/// Adds stiffness, coupling mass, gyroscopic moments and damping, once coordinates are numbered.
void mesh_build(const mesh *from, assembly *to);

#endif
