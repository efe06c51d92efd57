/// The mesh of shafts: nodes and finite elements between them, from segments and stations.
#ifndef ROTOR_MESH_H
#define ROTOR_MESH_H

#include "design.h"
#include "element.h"
#include "shafts.h"
#include "whirl/engine/line.h"

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

// ---------------------------------------------------------------- reduction
// Reduction of shafts by component modes (Craig, Bampton 1968). Coordinates on which elements act are kept. The nodes
// between follow statically, and by their lowest modes with the kept coordinates fixed.
//
// With q_B the kept coordinates and q_I the others,
//
//     q_I = Psi q_B + Phi (z - Phi' (M_II Psi + M_IB) q_B),    Psi = -K_II^-1 K_IB,   K_II Phi = M_II Phi w^2,
//
// where the usual modal coordinates are shifted so that z is coupled with q_B by stiffness alone, not by mass: then
// only the few q_B have a mass matrix to be inverted. A column of Phi is scaled to a largest displacement of 1 (tilts
// count at the radius of gyration), so that z is a displacement in m, and its inertia the modal mass.

/// Result of a shaft's reduction.
typedef struct reduction {
    size_t kept, all; ///< modes in a plane, and how many there are
    double highest;   ///< rad/s of the highest kept mode; 0 if none is kept
    size_t first;     ///< coordinate of its first mode along x; that along y follows, then the next mode
} reduction;

/// Reduces the shafts for which the design asks it, before assembly_finish: renumbers coordinates, transforms linear
/// terms, and renumbers the ports and states of the elements. out [mesh->shaft_count], or NULL. *follow (unless follow
/// is NULL): [coordinates before][coordinates after] m or rad of the old coordinates for one m or rad of the new ones,
/// freed by the caller; NULL if nothing is reduced. WHIRL_BAD_INPUT if a shaft's stiffness is not positive;
/// WHIRL_NO_MEMORY.
whirl_status reduction_make(const mesh *from, assembly *of, element *elements, size_t element_count, reduction *out,
                            double **follow);

/// Lists the coordinates of one plane (x, tilt_x) of a shaft's nodes in the assembly, at most 2 a node; returns how
/// many.
size_t reduction_nodes(const mesh *from, const assembly *of, size_t shaft, size_t *coordinate);

/// Computes stiffness and mass [count][count] of shafts for these coordinates; the mass includes that of stations.
void reduction_matrices(const assembly *of, size_t count, const size_t *coordinate, double *stiffness, double *mass);

// ---------------------------------------------------------------- inner modes
// Modes of shafts between their stations, which a process remembers of its latest shafts. Only problems whose numbers
// are equal to the bit are the same, so that nothing changes but the time. For all threads.

/// The problem K_II Phi = M_II Phi w^2, and Psi. Its parts are the caller's.
typedef struct inner_modes {
    size_t inner, kept;
    const double *k, *m; ///< [inner][inner]
    double *follow;      ///< [kept][inner] -K_IB, a column a row; once it is solved Psi
    double *squares;     ///< [inner] w^2
    double *shapes;      ///< [inner][inner] a mode a row
} inner_modes;

/// Writes the solution of a problem that is remembered; returns false, and writes nothing, if it is not.
bool inner_modes_recall(const inner_modes *of);

/// Notes a problem that is to be solved, for inner_modes_keep. NULL if it is too small or too large to be remembered,
/// or without memory.
double *inner_modes_begin(const inner_modes *of);

/// Remembers a problem and its solution; takes over `begun`.
void inner_modes_keep(const inner_modes *of, double *begun);

// ---------------------------------------------------------------- line
// Shapes of shafts between their nodes (whirl/engine/line.h).

/// A place on a piece: the node to its left, and its displacement by displacement and slope of that and of the next.
typedef struct line_place {
    size_t node;
    double moved[4];
} line_place;

/// Adds the sag to a line with these places. Errors as whirl_design_statics.
whirl_status statics_line(const whirl_design *design, const char *couplings, const line_place *places,
                          whirl_shaft_line *out);

// ---------------------------------------------------------------- between
// Static shapes of shafts between their stations.

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

// ---------------------------------------------------------------- bow
// Bent shafts.

/// Adds the rotating forces that bend a straight shaft to the bow at its stations. WHIRL_BAD_INPUT if a station with a
/// bow is on no shaft of finite elements, or if its shaft has too few of them, another speed, flats or hysteresis.
whirl_status bow_build(const mesh *from, const whirl_design *design, assembly *to);

// ---------------------------------------------------------------- held
// A shaft in one plane that is held at some of its nodes, which may be raised.

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
