/// The mesh of shafts: nodes, and finite elements between them, from segments and stations.
#ifndef ROTOR_MESH_H
#define ROTOR_MESH_H

#include "design.h"
#include "shafts.h"

typedef struct mesh_node {
    size_t shaft;
    double z;       ///< along the shaft, m
    size_t station; ///< index in the assembly: a station of the design, or a hidden station of the mesh after these
} mesh_node;

typedef struct mesh_piece {
    size_t shaft, node[2];
    double angle;            ///< direction of the flats' normal, rad
    shaft_settings settings; ///< settings of the shaft, overridden by its segment
    shaft_piece piece;
} mesh_piece;

/// The mesh; empty if the design has no segments.
typedef struct mesh {
    size_t shaft_count, node_count, piece_count;
    shaft_settings *shafts;
    mesh_node *nodes; ///< shaft by shaft, in order along each shaft
    mesh_piece *pieces;
    size_t hidden; ///< number of nodes that are no stations of the design
    /// [stations of the design] shaft without segments on which a station is; NO_SHAFT: none.
    size_t *lumped;
    size_t spool_count;
    whirl_spool spools[WHIRL_MAX_SPOOLS]; ///< [spool_count] shafts whose speed is their own, without drives
} mesh;

/// Makes the mesh. Returns WHIRL_BAD_INPUT with a sentence; then *culprit is the design's element at fault, or
/// WHIRL_NO_ELEMENT. Freed by mesh_clear, also after a failure.
whirl_status mesh_make(const whirl_design *design, mesh *out, size_t *culprit);
void mesh_clear(mesh *of);

/// Sets the speeds of the stations and nodes of shafts.
void mesh_turn(const mesh *from, assembly *to);

/// Adds the nodes' inertia to an assembly, and where they move. The assembly's stations are those of the design and
/// `hidden` more.
void mesh_inertia(const mesh *from, assembly *to);

/// Adds stiffness, coupling mass, gyroscopic moments and damping. To be called when coordinates are numbered.
void mesh_build(const mesh *from, assembly *to);

#endif
