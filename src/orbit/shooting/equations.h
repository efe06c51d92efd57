/// The equations of an orbit: its segments meet.
#ifndef ORBIT_EQUATIONS_H
#define ORBIT_EQUATIONS_H

#include "shooting.h"

/// Unknowns: what does not turn of every node, [segments][kept]; the period, where the orbit has a time of its own; the
/// parameter, where machines are one of a family. Equations: as many as nodes have, and where the period is unknown the
/// one that says which point of the orbit is the first. An equilibrium is one node, at which forces vanish.
typedef struct orbit_equations {
    const whirl_orbit_options *options;
    const whirl_family *family; ///< NULL: one machine, no parameter
    whirl_machine machine;      ///< of the family, at `value`
    whirl_machine first;        ///< for which s was made, unless that is the present one
    double value;
    double reach; ///< from which derivatives by the parameter are taken, in its unit
    shooting *s;
    double largest;  ///< size of nodes that equations_scale has seen
    double steepest; ///< rate of an equilibrium's Jacobian, likewise
    double *nodes;   ///< [segments][dimension] of the last evaluation
    /// [dimension] The first node is where the orbit is nearest to `at`, where its slope is `flow`.
    double *at, *flow;
    double *work; ///< [dimension + 2 segments dimension] workspace
} orbit_equations;

/// Makes those of a machine, or of a family at a value (system NULL). Errors as whirl_orbit_find and those of machines.
/// Freed by equations_free, whether it was made or not.
whirl_status equations_make(orbit_equations *e, const whirl_system *system, const whirl_family *family, double value,
                            const whirl_orbit_options *options, size_t revolutions, double period);
void equations_free(orbit_equations *e);

/// Sets from how far derivatives by the parameter are taken, of a parameter that goes over `span`: where what both
/// errors of the differences are is about the same.
void equations_reach(orbit_equations *e, double span);

/// Numbers of equations and, with the parameter, of unknowns.
size_t equations_count(const orbit_equations *e);
size_t equations_unknowns(const orbit_equations *e);

/// The period that unknowns say.
double equations_period(const orbit_equations *e, const double *u);

/// Unknowns of nodes, and nodes of unknowns.
void equations_take(const orbit_equations *e, const double *nodes, double *u);
void equations_put(orbit_equations *e, const double *u);

/// What counts as 1 in lengths along a branch: of nodes, on average, the orbit's own size, but no less than a part of
/// the largest so far, for a branch may pass through zero; its period; the span of the parameter. scale [unknowns]
void equations_scale(orbit_equations *e, double span, double *scale);

/// Lets the first node be where the orbit is nearest to x.
void equations_begin_at(orbit_equations *e, const double *x);

/// Writes the equations' values [count] at u and, unless NULL, their derivative [count][unknowns]. False where a motion
/// is not bounded, or there is no machine.
bool equations_evaluate(void *e, const double *u, double *value, double *derivative);

/// By how much the segments of the last evaluation fail to meet, over the largest coordinate of its nodes, or the same
/// part of the largest so far.
double equations_size(void *e, const double *u, const double *value);

#endif
