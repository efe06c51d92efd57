/// The mean of a system over time. Forcing that varies is set to zero. The right-hand side is averaged over the phases
/// of turning parts, or over the period if the system lists no forcing.
#ifndef LINEAR_MEAN_H
#define LINEAR_MEAN_H

#include "whirl/engine/system.h"

/// A system, its kept coordinates, and workspace.
typedef struct mean_system {
    const whirl_system *system;
    size_t count;           ///< coordinates other than angles of turning parts (whirl_system.turns)
    whirl_settled *settled; ///< [dimension] kinds of coordinates, as mean_settle wrote them
    size_t *kept;           ///< [count] coordinates of the state
    int samples;            ///< phases over which the mean is taken
    double *state;          ///< [dimension] workspace, like slope
    double *slope;          ///< [dimension]
    double *unit;           ///< [count][dimension] unit perturbations of the kept coordinates
    double *rows;           ///< [count][dimension] workspace: derivatives of the slope
    /// Values of the forcing that do not change with time; 0 for those that do.
    double steady[WHIRL_MAX_FORCING];
} mean_system;

/// Makes a mean system. Its arrays are in one block, *block, which the caller frees with free. WHIRL_BAD_INPUT for a
/// system without a Jacobian.
whirl_status mean_begin(mean_system *m, const whirl_system *system, void **block);

/// Moves coordinates such as tilts of pads to where the forces on them balance (whirl_system.settle), if the system has
/// such coordinates. Returns false if there is no balance.
bool mean_settle(mean_system *m, double *x);

/// Removes from the kept coordinates those that nothing holds at the equilibrium x (WHIRL_IDLE): their motions are not
/// modes of the machine.
void mean_leave_idle(mean_system *m, const double *x);

/// Writes the mean system's right-hand side [count] at x [dimension].
void mean_slope(mean_system *m, const double *x, double *slope);

/// Writes the normal forces of all contacts [contact_count]; `work` [contact_count] is workspace.
void mean_contacts(mean_system *m, const double *x, double *force, double *work);

/// Writes the mean system's Jacobian [count][count] at x [dimension].
void mean_jacobian(mean_system *m, const double *x, double *jacobian);

/// Returns true if the system's Jacobian at x depends on time through the forcing: coefficients turn with the shaft.
/// jacobian [count][count] is workspace.
bool mean_is_modulated(mean_system *m, const double *x, double *jacobian);

/// Returns the coordinate that is the rate of coordinate `row`, from a Jacobian [n][n]; n if `row` is not a
/// displacement.
size_t mean_rate_of(const double *jacobian, size_t n, size_t row);

#endif
