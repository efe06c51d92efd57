/// The equations of an orbit: every segment ends at the next node.
#ifndef ORBIT_EQUATIONS_H
#define ORBIT_EQUATIONS_H

#include "shooting.h"
#include "whirl/engine/branch.h"

/// Unknowns: the coordinates that do not turn of every node, [segments][kept]; the period, if it is free; the
/// parameter, if machines form a family. Equations: as many as nodes have coordinates; and for a free period the phase
/// condition, which selects the first node. An equilibrium is one node, at which accelerations vanish.
typedef struct orbit_equations {
    const whirl_orbit_options *options;
    const whirl_family *family; ///< NULL: one machine, no parameter
    whirl_machine machine;      ///< machine of the family at `value`
    whirl_machine first;        ///< machine for which s was made, unless it is the present one
    double value;
    double reach; ///< step of derivatives by the parameter, in its unit
    shooting *s;
    double largest;  ///< largest size of nodes in equations_scale
    double steepest; ///< largest rest_rate of an equilibrium's Jacobian in equations_scale
    double *nodes;   ///< [segments][dimension] nodes of the last evaluation
    /// [dimension] Phase condition: the first node is the point of the orbit nearest to `at`, where its slope is
    /// `flow`.
    double *at, *flow;
    double *work; ///< [dimension + 2 segments dimension] workspace
} orbit_equations;

/// Makes the equations of a machine, or of a family at a value (system NULL). Errors as whirl_orbit_find, and the
/// errors of making machines. Freed by equations_free, after a failure too.
whirl_status equations_make(orbit_equations *e, const whirl_system *system, const whirl_family *family, double value,
                            const whirl_orbit_options *options, size_t revolutions, double period);
void equations_free(orbit_equations *e);

/// Sets the step of derivatives by the parameter, which varies over `span`. The step makes both errors of the
/// differences about equal.
void equations_reach(orbit_equations *e, double span);

/// Return the number of equations, and of unknowns including the parameter.
size_t equations_count(const orbit_equations *e);
size_t equations_unknowns(const orbit_equations *e);

/// Returns the period that the unknowns contain.
double equations_period(const orbit_equations *e, const double *u);

/// Convert nodes to unknowns, and unknowns to nodes.
void equations_take(const orbit_equations *e, const double *nodes, double *u);
void equations_put(orbit_equations *e, const double *u);

/// Sets unit lengths along a branch, scale [unknowns]. The unit of nodes is on average the orbit's own size, but at
/// least a part of the largest so far, since a branch may pass through zero. The unit of the period is the period; that
/// of the parameter, its span.
void equations_scale(orbit_equations *e, double span, double *scale);

/// Sets the phase condition: the first node is the point of the orbit nearest to x.
void equations_begin_at(orbit_equations *e, const double *x);

/// Writes the equations' values [count] at u and, unless NULL, their derivative [count][unknowns]. False if a motion is
/// not bounded, or without a machine.
bool equations_evaluate(void *e, const double *u, double *value, double *derivative);

/// Returns the largest gap between segments of the last evaluation, divided by the largest coordinate of its nodes, but
/// at least by a part of the largest so far.
double equations_size(void *e, const double *u, const double *value);

#endif
