/// A system without what drives it in time: the forcing at zero amplitude, turning phases at their mean.
#ifndef LINEAR_MEAN_H
#define LINEAR_MEAN_H

#include "whirl/engine/linear.h"

/// A system with workspace.
typedef struct mean_system {
    const whirl_system *system;
    size_t count;  ///< coordinates that do not turn on and on
    size_t *kept;  ///< [count] which these are
    int samples;   ///< phases over which the mean is taken
    double *state; ///< [dimension] workspace, as the next two
    double *slope; ///< [dimension]
    double *unit;  ///< [count][dimension]
    double *rows;  ///< [count][dimension]
} mean_system;

/// Makes one in one block, *block, to be freed by free. WHIRL_BAD_INPUT for a system without a Jacobian.
whirl_status mean_begin(mean_system *m, const whirl_system *system, void **block);

/// Its right-hand side [count] at x [dimension].
void mean_slope(mean_system *m, const double *x, double *slope);

/// Its Jacobian [count][count] there.
void mean_jacobian(mean_system *m, const double *x, double *jacobian);

/// Whether the system's Jacobian at x depends on time by the forcing: coefficients turn with the shaft. jacobian
/// [count][count] is workspace.
bool mean_is_modulated(mean_system *m, const double *x, double *jacobian);

#endif
