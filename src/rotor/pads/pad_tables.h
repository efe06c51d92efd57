/// Pads of films: where they are, their tables, turbulence.
#ifndef ROTOR_PAD_TABLES_H
#define ROTOR_PAD_TABLES_H

#include "reynolds.h"
#include "whirl/engine/bearing.h"
#include "whirl/engine/stop.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// ---------------------------------------------------------------- centred
// Tilt of a pad before a centred journal.

/// Returns the tilt, R delta/c, at which the film's moment on a pad vanishes, by a coarse grid; 0 if there is none, or
/// without memory.
double pad_centred_tilt(const whirl_pad *pad, double ratio, bool gumbel);

// ---------------------------------------------------------------- table
// The film of a pad as a table, for motions: its force by splines over where the journal is and where it goes.
//
// The force is homogeneous in (A, B) = V (cos alpha, sin alpha) (reynolds.h). With the film's thickness at the middle
// of the pad Hm = 1 - x, t = sqrt(Hm), and v = y over the largest y at which nothing of the pad touches, v = 2 w/(1 +
// w^2), it is
//
//     f = V/((1 - v^2) Hm^2) S(t, w, alpha),
//
// S a cubic spline with equal distances of nodes, periodic in alpha. Beyond the table t and w count as at its edge:
// the factor goes on growing where the film closes. Lengths are in the pad's clearance.

/// Key of a table: the pad and its film.
typedef struct pad_table_key {
    double arc, ratio;
    cavitation law;
    whirl_turbulence turbulence;
    double reynolds; ///< as in pad_film; 0 of laminar ones
    double lead;     ///< angle from pivot to middle of a pad that tilts without inertia; else 0
} pad_table_key;

/// Nodes along t, w and alpha, the same of all tables; numbers of one t and w, of one t, and of a whole table.
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

/// Row distances for kernels along alpha, w and t: one row more for every w than there are cells along alpha, since
/// rows around a place would otherwise share few sets of a cache.
enum {
    PAD_ALPHA_APART = 8,
    PAD_W_APART = PAD_ALPHA_APART * (PAD_ALPHA_NODES + 1),
    PAD_T_APART = PAD_W_APART * (PAD_W_NODES + 2),
    PAD_ROWS = PAD_T_APART * (PAD_T_NODES + 2)
};

/// Coefficients of B-splines [t][w][alpha][2], from one before the first node on. Of a pad that tilts freely, about
/// where its film has no moment about the pivot: r/p at the nodes of t and w (elements/films/pads_balance.h). For
/// kernels, of every t, w and cell along alpha the four coefficients on which it depends, as one line of a cache.
typedef struct pad_table {
    double coefficients[PAD_COEFFICIENTS];
    double lean[PAD_T_NODES][PAD_W_NODES];
    _Alignas(64) double rows[PAD_ROWS];
} pad_table;

/// A table of zeros, to be freed; NULL without memory.
pad_table *pad_table_empty(void);

/// Returns the film at a table's nodes, with its grid.
pad_film pad_table_film(const pad_table_key *key);

/// Fills in the values at the nodes of one t, from 0 to PAD_T_NODES - 1, in place of coefficients: some hundredths of a
/// second's work, for pads of less than half a turn. Errors as pad_solve.
whirl_status pad_table_fill(pad_table *table, const pad_film *film, pad_workspace *work, int t);

/// Turns the values at all nodes into coefficients.
void pad_table_splines(pad_table *table);

/// Solves films at some places all over the table, and compares their forces: a table from a file may be another
/// program's. Errors as pad_solve.
whirl_status pad_table_confirm(const pad_table *table, const pad_table_key *key, bool *confirmed);

/// Fills in `rows` from the coefficients.
void pad_table_rows(pad_table *table);

/// Fills in `lean` for a pad whose pivot is `lead` before its middle.
void pad_table_lean(pad_table *table, double lead);

// ---------------------------------------------------------------- table files
// Tables in the user's cache folder, $XDG_CACHE_HOME/whirl or ~/.cache/whirl, for other runs.

/// Returns the checksum (Fowler, Noll, Vo 1991) of the coefficients, as words of 64 bits.
uint64_t pad_table_checksum(const pad_table *table);

/// Returns true if there is a file for such a table, which is not read.
bool pad_table_file_is_there(const pad_table_key *key);

/// Reads the coefficients. *found is false if there is no plain file, or if it is damaged, of other sources or not
/// confirmed. Errors as pad_table_confirm.
whirl_status pad_table_file_read(const pad_table_key *key, pad_table *table, bool *found);

/// Saves a table for other runs, atomically; a failure is ignored. Removes the least recently used files beyond
/// PAD_TABLE_FILES.
void pad_table_file_write(const pad_table_key *key, const pad_table *table);

enum { PAD_TABLE_FILES = 512 }; ///< files of 2 MB each

// ---------------------------------------------------------------- tables
// Tables of all pads of the process, by number. Machines hold the tables of their pads; a table is read from its file
// or made when it is first held, and freed some time after its last holder.

/// Largest number of unused tables in memory, of 4 MB each.
enum { MAX_IDLE_PAD_TABLES = 64 };

/// Returns the number of a pad's table, which need not exist yet. WHIRL_BAD_INPUT for more tables than
/// WHIRL_MAX_FILM_TABLES.
whirl_status pad_table_number(const pad_table_key *key, double *number);

/// Returns the key of a number.
pad_table_key pad_table_key_of(double number);

/// Provides the table until pad_table_release. Making it takes a second; all threads that want the table make it
/// together, and give up when *stop becomes true (NULL: never). An unsolvable film gives a table of NaN, with which
/// motions diverge. WHIRL_NO_MEMORY, WHIRL_STOPPED: then the table is not provided.
whirl_status pad_table_hold(double number, const whirl_stop *stop);
void pad_table_release(double number);

/// Returns the table of a number if it is provided; else a table of zeros.
const pad_table *pad_table_of(double number);

// ---------------------------------------------------------------- turbulence
// Turbulence of a film: factors by its local Reynolds number, rho U h/mu with the speed U of the journal's surface and
// the thickness h. All are 1 if that is 0.

/// Divisors of the flow that a pressure gradient drives, around the bearing and along its axis: 12 G of the literature
/// inverted, (1 + .0136/12 Re^.90, 1 + .0043/12 Re^.96) of Ng and Pan 1965.
typedef struct turbulent_factors {
    double around, along;
} turbulent_factors;

turbulent_factors turbulent_resistance(whirl_turbulence law, double reynolds);

/// Shear of Couette flow over the laminar one, 1 + .0012 Re^.94 (Constantinescu, Galetuse 1965).
double turbulent_shear(whirl_turbulence law, double reynolds);

#endif
