/// The film of a pad as a table, for motions: its force by splines over where the journal is and where it goes.
///
/// The force is homogeneous in (A, B) = V (cos alpha, sin alpha) (reynolds.h). With the film's thickness at the middle
/// of the pad Hm = 1 - x, t = sqrt(Hm), and v = y over the largest y at which nothing of the pad touches, v = 2 w/(1 +
/// w^2), it is
///
///     f = V/((1 - v^2) Hm^2) S(t, w, alpha),
///
/// S a cubic spline with equal distances of nodes, periodic in alpha. Beyond the table t and w count as at its edge:
/// the factor goes on growing where the film closes. Lengths are in the pad's clearance.
#ifndef ROTOR_PAD_TABLE_H
#define ROTOR_PAD_TABLE_H

#include <stddef.h>

#include "reynolds.h"

/// What a table is of.
typedef struct pad_table_key {
    double arc, ratio;
    cavitation law;
    whirl_turbulence turbulence;
    double reynolds; ///< as in pad_film; 0 of laminar ones
} pad_table_key;

/// An axis of nodes.
typedef struct pad_axis {
    double first, step;
    int count;
} pad_axis;

typedef struct pad_table {
    double cosine, sine; ///< of half the arc
    pad_axis t, w, alpha;
    double *coefficients; ///< [t.count + 2][w.count + 2][alpha.count + 3][2] of B-splines
} pad_table;

/// Solves the films of all nodes, some seconds' work, of pads of less than half a turn. To be freed by pad_table_free.
/// Errors as pad_solve.
whirl_status pad_table_new(const pad_table_key *key, pad_table **out);
void pad_table_free(pad_table *table);

/// One whose coefficients are 0; NULL without memory.
pad_table *pad_table_empty(double arc);

/// Numbers of its coefficients.
size_t pad_table_size(const pad_table *table);

#endif
