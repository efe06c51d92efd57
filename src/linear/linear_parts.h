/// What linear analyses have of one another.
#ifndef LINEAR_LINEAR_PARTS_H
#define LINEAR_LINEAR_PARTS_H

#include "whirl/engine/linear.h"
#include "whirl/engine/system.h"

// ---------------------------------------------------------------- direction
// The direction of a whirl.

/// Twice the signed area that two shapes share, out [2], a Hermitian form: that of a shape with itself is its
/// direction, but for its size. Above 0 forward.
void direction_area(const whirl_system *system, const double *a, const double *b, double out[2]);

/// Takes displacements of the probes for 0 that are rounding, of a mode v [dimension][2] that moves none of them: one
/// of tilts alone, or of a node between stations.
void direction_drop_rounding(const whirl_system *system, double *v);

/// Of a motion Re(v exp(i w t)), v [dimension][2]: whirl_mode.direction.
double whirl_direction(const whirl_system *system, const double *v);

// ---------------------------------------------------------------- mean
// A system without what drives it in time: the forcing at zero amplitude, turning phases at their mean.

/// A system with workspace.
typedef struct mean_system {
    const whirl_system *system;
    size_t count;           ///< coordinates that do not turn on and on
    whirl_settled *settled; ///< [dimension] which of them have a balance of their own, since mean_settle
    size_t *kept;           ///< [count] which these are
    int samples;            ///< phases over which the mean is taken
    double *state;          ///< [dimension] workspace, as the next two
    double *slope;          ///< [dimension]
    double *unit;           ///< [count][dimension]
    double *rows;           ///< [count][dimension]
    /// Values of time that do not change; 0 for those that do.
    double steady[WHIRL_MAX_FORCING];
} mean_system;

/// Makes one in one block, *block, to be freed by free. WHIRL_BAD_INPUT for a system without a Jacobian.
whirl_status mean_begin(mean_system *m, const whirl_system *system, void **block);

/// Sets coordinates that have a balance of their own to it (whirl_system.settle). False where there is none.
bool mean_settle(mean_system *m, double *x);

/// Leaves out what is idle where the machine rests: motions of it are none of the machine's.
void mean_leave_idle(mean_system *m, const double *x);

/// Its right-hand side [count] at x [dimension].
void mean_slope(mean_system *m, const double *x, double *slope);

/// The normal forces of all contacts [contact_count]; `room` has as many numbers.
void mean_contacts(mean_system *m, const double *x, double *force, double *room);

/// Its Jacobian [count][count] there.
void mean_jacobian(mean_system *m, const double *x, double *jacobian);

/// Whether the system's Jacobian at x depends on time by the forcing: coefficients turn with the shaft. jacobian
/// [count][count] is workspace.
bool mean_is_modulated(mean_system *m, const double *x, double *jacobian);

/// The coordinate that is the rate of coordinate `row` by a Jacobian [n][n]; n where `row` is no place.
size_t mean_rate_of(const double *jacobian, size_t n, size_t row);

// ---------------------------------------------------------------- memory

/// WHIRL_NO_MEMORY where memory ran out since exhausted_watch gave `before`, else `status`: matrices that have no
/// memory to be decomposed look like singular ones.
whirl_status linear_status(int before, whirl_status status, size_t coordinates);

// ---------------------------------------------------------------- free motions
// Zeros of a Jacobian: what nothing holds, and what nothing brings to a stop.

/// How coordinates were replaced by what they move beside free shapes.
typedef struct free_step free_step;

/// Takes all zero eigenvalues out of a matrix [n][n], which becomes one [left][left] of the other eigenvalues, to
/// rounding. A zero is known by its null vector, not by its size: an elimination leaves nothing but the rounding of
/// what was subtracted. `displaced`: independent null vectors in which a coordinate moves that is a place, place [n].
/// *first, NULL where there is no zero, is to be freed by free_motions_end. False without memory.
bool free_motions_take_out(size_t n, double *matrix, const bool *place, size_t *left, size_t *displaced,
                           free_step **first);

/// The eigenvector [left][2] at the front of vector [n][2], whose eigenvalue is not 0, becomes that of the matrix
/// [n][n], of Euclidean length 1. room [n][2].
void free_motions_put_back(const free_step *first, double real, double imaginary, double *vector, double *room);

/// Frees them; NULL is none.
void free_motions_end(free_step *first);

// ---------------------------------------------------------------- modes
// Room for modes, and those about a state that is known.

/// For `count` modes and as many real eigenvalues, none of which are there yet; NULL without memory.
whirl_modes *modes_allocate(size_t dimension, size_t count);

/// Puts overdamped modes behind the others, without a change of the order among either.
whirl_status modes_put_overdamped_last(whirl_modes *modes);

/// The modes by rising imaginary part, or (held) about a state that is taken for the equilibrium as it is.
whirl_status modes_about(const whirl_system *system, const double *start, bool held, whirl_modes **out);

// ---------------------------------------------------------------- periodic
// Periodic motions of systems whose coefficients turn with the shaft, and their monodromy matrix.

/// Finds the periodic motion near x [dimension], which becomes where it is at t = 0; monodromy [count][count] of the
/// coordinates that do not turn on and on, over *period. Unless it shall be `closed`, it is enough that the matrix no
/// longer changes: that of a linear machine is the same of all motions, and its periodic one may be beyond all bounds.
/// WHIRL_BAD_INPUT where none is found, or the coefficients fit no number of revolutions.
whirl_status periodic_find(const mean_system *m, double *x, bool closed, double *monodromy, double *period);

/// Its mean [dimension], and its first harmonic [dimension][2], from where periodic_find left x.
whirl_status periodic_harmonic(const mean_system *m, const double *x, double *mean, double *harmonic);

// ---------------------------------------------------------------- rest
// Where a mean system rests.

/// whirl_equilibrium of a system that is prepared.
whirl_status rest_find(mean_system *m, double *x);

#endif
