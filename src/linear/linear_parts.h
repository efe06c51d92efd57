/// Functions that the linear analyses share.
#ifndef LINEAR_LINEAR_PARTS_H
#define LINEAR_LINEAR_PARTS_H

#include "whirl/engine/linear.h"
#include "whirl/engine/system.h"

// ---------------------------------------------------------------- direction
// The direction of a whirl.

/// Writes twice the signed area of two shapes, a Hermitian form, to out [2]. The area of a shape with itself, divided
/// by the shape's size, is its direction: above 0 forward.
void direction_area(const whirl_system *system, const double *a, const double *b, double out[2]);

/// Sets displacements of probes that are rounding to 0, for a mode v [dimension][2] that moves no probe: a mode of
/// tilts alone, or of a node between stations.
void direction_drop_rounding(const whirl_system *system, double *v);

/// Direction (whirl_mode.direction) of a motion Re(v exp(i w t)), v [dimension][2].
double whirl_direction(const whirl_system *system, const double *v);

// ---------------------------------------------------------------- mean
// A system without what drives it in time: the forcing at zero amplitude, turning phases at their mean.

/// A system with workspace.
typedef struct mean_system {
    const whirl_system *system;
    size_t count;           ///< coordinates that do not turn on and on
    whirl_settled *settled; ///< [dimension] coordinates that mean_settle sets to a balance of their own
    size_t *kept;           ///< [count] coordinates of the state
    int samples;            ///< phases over which the mean is taken
    double *state;          ///< [dimension] workspace, as the next two
    double *slope;          ///< [dimension]
    double *unit;           ///< [count][dimension]
    double *rows;           ///< [count][dimension]
    /// Values of time that are constant; 0 for the others.
    double steady[WHIRL_MAX_FORCING];
} mean_system;

/// Makes a mean system in one block, *block, which the caller frees by free. WHIRL_BAD_INPUT for a system without a
/// Jacobian.
whirl_status mean_begin(mean_system *m, const whirl_system *system, void **block);

/// Moves coordinates that have a balance of their own to that balance (whirl_system.settle). Returns false without one.
bool mean_settle(mean_system *m, double *x);

/// Leaves out coordinates that are idle where the machine rests: their motions are not modes of the machine.
void mean_leave_idle(mean_system *m, const double *x);

/// Writes the mean system's right-hand side [count] at x [dimension].
void mean_slope(mean_system *m, const double *x, double *slope);

/// Writes the normal forces of all contacts [contact_count]; `room` [contact_count] is workspace.
void mean_contacts(mean_system *m, const double *x, double *force, double *room);

/// Writes the mean system's Jacobian [count][count] at x [dimension].
void mean_jacobian(mean_system *m, const double *x, double *jacobian);

/// Returns true if the system's Jacobian at x depends on time through the forcing: coefficients turn with the shaft.
/// jacobian [count][count] is workspace.
bool mean_is_modulated(mean_system *m, const double *x, double *jacobian);

/// Returns the coordinate that is the rate of coordinate `row`, from a Jacobian [n][n]; n if `row` is not a
/// displacement.
size_t mean_rate_of(const double *jacobian, size_t n, size_t row);

// ---------------------------------------------------------------- memory

/// Returns WHIRL_NO_MEMORY if memory ran out since exhausted_watch returned `before`, else `status`. A decomposition
/// that fails for lack of memory would otherwise be reported as a singular matrix.
whirl_status linear_status(int before, whirl_status status, size_t coordinates);

// ---------------------------------------------------------------- free motions
// Zero eigenvalues of a Jacobian: displacements without a restoring force, and velocities without damping.

/// Record of one replacement of coordinates by their motion relative to free shapes.
typedef struct free_step free_step;

/// Removes all zero eigenvalues from a matrix [n][n], which becomes a matrix [left][left] of the other eigenvalues, to
/// rounding. A zero is recognised by its null vector, not by its size: an elimination leaves only the rounding of the
/// subtracted numbers. `displaced` is the number of independent null vectors in which a displacement (place [n] true)
/// moves. *first, NULL if there is no zero, is freed by free_motions_end. Returns false without memory.
bool free_motions_take_out(size_t n, double *matrix, const bool *place, size_t *left, size_t *displaced,
                           free_step **first);

/// Converts the eigenvector [left][2] at the front of vector [n][2], whose eigenvalue is not 0, into the eigenvector of
/// the matrix [n][n], of Euclidean length 1. room [n][2] is workspace.
void free_motions_put_back(const free_step *first, double real, double imaginary, double *vector, double *room);

/// Frees the records of free_motions_take_out; accepts NULL.
void free_motions_end(free_step *first);

// ---------------------------------------------------------------- modes
// Memory for modes, and modes about a known state.

/// Allocates room for `count` modes and `count` real eigenvalues, with both counts at 0; NULL without memory.
whirl_modes *modes_allocate(size_t dimension, size_t count);

/// Moves overdamped modes behind the others and keeps the order of both.
whirl_status modes_put_overdamped_last(whirl_modes *modes);

/// Computes the modes by rising imaginary part, about the equilibrium; if `held`, about `start`, which then counts as
/// the equilibrium.
whirl_status modes_about(const whirl_system *system, const double *start, bool held, whirl_modes **out);

// ---------------------------------------------------------------- periodic
// Periodic motions of systems whose coefficients turn with the shaft, and their monodromy matrix.

/// Finds the periodic motion near x [dimension], which becomes its state at t = 0, and its monodromy matrix
/// [count][count] over *period, for the coordinates that do not turn on and on. Without `closed` it is enough that the
/// matrix no longer changes: the matrix of a linear machine is the same for all motions, and its periodic motion may be
/// unbounded. WHIRL_BAD_INPUT if no motion is found, or the coefficients do not repeat after a number of revolutions.
whirl_status periodic_find(const mean_system *m, double *x, bool closed, double *monodromy, double *period);

/// Writes the mean [dimension] and the first harmonic [dimension][2] of the periodic motion that starts at x, as
/// periodic_find left it.
whirl_status periodic_harmonic(const mean_system *m, const double *x, double *mean, double *harmonic);

// ---------------------------------------------------------------- rest
// The equilibrium of a mean system.

/// Finds the equilibrium, as whirl_equilibrium does, of a system that is already prepared.
whirl_status rest_find(mean_system *m, double *x);

#endif
