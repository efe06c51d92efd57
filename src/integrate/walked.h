/// What disturbances feel where a fixed step has walked over a switch.
///
/// The step itself knows of no switch; its derivative misses what happens where the right-hand side jumps. That is made good at the
/// step's end by the saltation matrix of the place where the step's cubic meets the switch: right to the first order of the step, and
/// nothing at all where the right-hand side is continuous, as in an elastic contact.
#ifndef INTEGRATE_WALKED_H
#define INTEGRATE_WALKED_H

#include <stdbool.h>

#include "method.h"

typedef struct walked_step {
    const whirl_system *system; ///< without gradients of its switches nothing is done
    double length;
    const double *slope; ///< [dimension] at the step's beginning, once it is taken
    double *rows;        ///< [SPARE_ROWS][dimension] workspace
    double t;
    bool known; ///< the sides at the beginning are those at the end of the step before
    double before[WHIRL_MAX_SWITCHES];
} walked_step;

/// Notes the state x at t, where a step begins.
void walked_begin(walked_step *step, double t, const double *x);

/// Changes disturbances at the end x of the step for all switches between.
void walked_saltate(walked_step *step, const double *x, whirl_disturbances *disturbances);

#endif
