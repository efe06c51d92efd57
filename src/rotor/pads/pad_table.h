/// The film of a pad as a table, for motions: its force by splines over the position and the velocity of the journal.
///
/// The force is homogeneous in (A, B) = V (cos alpha, sin alpha) (reynolds.h). Hm = 1 - x is the film's thickness at
/// the middle of the pad, t = sqrt(Hm), and v = 2 w/(1 + w^2) is y divided by the largest y at which no part of the pad
/// touches. The force is
///
///     f = V/((1 - v^2) Hm^2) S(t, w, alpha),
///
/// where S is a cubic spline with equal distances of nodes, periodic in alpha. Beyond the table t and w count as at its
/// edge, while the factor continues to grow as the film closes. Lengths are in units of the pad's clearance.
#ifndef ROTOR_PAD_TABLE_H
#define ROTOR_PAD_TABLE_H

#include "reynolds.h"
#include "whirl/internal/bearing.h"

#include <stdbool.h>

/// Key of a table: the pad, and the law of its film.
typedef struct pad_table_key {
    double arc, ratio;
    cavitation law;
    whirl_turbulence turbulence;
    double reynolds; ///< as in pad_film; 0 for laminar films
    double lead;     ///< angle from pivot to middle of a pad that tilts without inertia; otherwise 0
} pad_table_key;

/// Nodes along t, w and alpha, the same for all tables; numbers for one t and w, for one t, and of a whole table.
enum {
    PAD_T_NODES = 28,
    PAD_W_NODES = 27,
    PAD_ALPHA_NODES = 48,
    PAD_ROW = 2 * (PAD_ALPHA_NODES + 3),
    PAD_SHEET = PAD_ROW * (PAD_W_NODES + 2),
    PAD_COEFFICIENTS = PAD_SHEET * (PAD_T_NODES + 2)
};
#define PAD_MIN_T 0.14
#define PAD_STEP_T (1.46 / (PAD_T_NODES - 1))
#define PAD_MAX_W 0.92
#define PAD_STEP_W (2.0 * PAD_MAX_W / (PAD_W_NODES - 1))
#define PAD_HALF_TURN 3.14159265358979323846
#define PAD_STEP_ALPHA (2.0 * PAD_HALF_TURN / PAD_ALPHA_NODES)

/// Distances of rows for kernels along alpha, w and t. For every w there is one row more than there are cells along
/// alpha, since otherwise rows around a place would share few sets of a cache.
enum {
    PAD_ALPHA_APART = 8,
    PAD_W_APART = PAD_ALPHA_APART * (PAD_ALPHA_NODES + 1),
    PAD_T_APART = PAD_W_APART * (PAD_W_NODES + 2),
    PAD_ROWS = PAD_T_APART * (PAD_T_NODES + 2)
};

/// A table. coefficients: of B-splines [t][w][alpha][2], from one before the first node on. lean: for a pad that tilts
/// freely, r/p at the nodes of t and w where its film has approximately no moment about the pivot
/// (elements/films/pads_balance.h). rows: for kernels, the four coefficients on which every t, w and cell along alpha
/// depends, as one line of a cache.
typedef struct pad_table {
    double coefficients[PAD_COEFFICIENTS];
    double lean[PAD_T_NODES][PAD_W_NODES];
    _Alignas(64) double rows[PAD_ROWS];
} pad_table;

/// Makes a table of zeros, to be freed. Returns NULL without memory.
pad_table *pad_table_empty(void);

/// Returns the film at a table's nodes, with its grid.
pad_film pad_table_film(const pad_table_key *key);

/// Fills in the values at the nodes of one t, 0 to PAD_T_NODES - 1, in place of coefficients, for pads of less than
/// half a turn. Takes some hundredths of a second. Errors as pad_solve.
whirl_status pad_table_fill(pad_table *table, const pad_film *film, pad_workspace *work, int t);

/// Converts the values at all nodes to coefficients.
void pad_table_splines(pad_table *table);

/// Solves films at some places all over the table, and compares their forces with the table's, since a table from a
/// file may be from another program. Errors as pad_solve.
whirl_status pad_table_confirm(const pad_table *table, const pad_table_key *key, bool *confirmed);

/// Fills in `rows` from the coefficients.
void pad_table_rows(pad_table *table);

/// Fills in `lean` for a pad whose pivot is `lead` before its middle.
void pad_table_lean(pad_table *table, double lead);

#endif
