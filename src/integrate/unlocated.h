/// What disturbances feel where a fixed step has gone over a switch.
///
/// The step itself knows of no switch; its derivative misses what happens where the right-hand side jumps. That is made
/// good at the step's end by the saltation matrix of the place where the step's cubic meets the switch: right to the
/// first order of the step, and nothing at all where the right-hand side is continuous, as in an elastic contact.
#ifndef INTEGRATE_UNLOCATED_H
#define INTEGRATE_UNLOCATED_H

#include <stdbool.h>

#include "method.h"

typedef struct unlocated_step {
    const whirl_system *system; ///< without gradients of its switches nothing is done
    double length;
    const double *slope; ///< [dimension] at the step's beginning, once it is taken
    double *rows;        ///< [SPARE_ROWS][dimension] workspace
    double *before;      ///< [UNLOCATED_ROWS][switch_count] the switches at the beginning, and workspace
    double t;
    bool known; ///< the sides at the beginning are those at the end of the step before
} unlocated_step;

/// Notes the state x at t, where a step begins.
void unlocated_begin(unlocated_step *step, double t, const double *x);

/// Changes disturbances at the end x of the step for all switches between.
void unlocated_saltate(unlocated_step *step, const double *x, whirl_disturbances *disturbances);

#endif
