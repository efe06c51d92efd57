/// Sensitivities: derivatives of a machine's equations, and of its motion, by an input of its case.
///
/// An input (a clearance, the speed, a term of an expression) passes through units, expressions, scales and tables into
/// the machine's equations, which are smooth functions of it. The derivative is taken by central differences of
/// machines built at p +- h, h = reach, reach/2, ... reach/64, extrapolated to h = 0 (Richardson 1911; each component
/// at the level with the smallest error, Ridders 1982), with an estimate of the error. The laws are kept on the sides
/// of the switches at p, so that no difference crosses a contact.
#ifndef WHIRL_SENSITIVITY_H
#define WHIRL_SENSITIVITY_H

#include "whirl/engine/study.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Derivatives by a parameter of a case.
typedef struct whirl_sensitivity whirl_sensitivity;

/// Builds machines of the study at and around `value` of the batch's parameter (a copy of the batch may name any other
/// parameter of the case). reach > 0, in the parameter's SI unit, is the largest h; a good choice is an eighth of the
/// distance to the next point at which the equations are not smooth; 0 for an eighth of |value|. It is halved while a
/// machine cannot be built. WHIRL_BAD_INPUT if value and reach are 0, if machines differ in dimension, or as `machine`
/// of the study; WHIRL_NO_MEMORY. Freed by whirl_sensitivity_free; used by one thread at a time.
whirl_status whirl_sensitivity_new(const whirl_study *study, const whirl_batch *batch, double value, double reach,
                                   whirl_sensitivity **out);

/// Frees sensitivities; accepts NULL.
void whirl_sensitivity_free(whirl_sensitivity *sensitivity);

/// Returns the machine at the value itself; borrowed.
const whirl_system *whirl_sensitivity_machine(const whirl_sensitivity *sensitivity);

/// Computes df/dp [dimension] of the right-hand side at (t, x), and unless NULL its error from extrapolation and
/// rounding, error [dimension]. sides [switch_count] as in whirl_system.rhs_on_sides; NULL: those of x. x, t and the
/// derivative are in the machine's units of length and time, which may themselves depend on the parameter; if its
/// period does, t and f are at the same fraction of a period.
void whirl_sensitivity_slope(const whirl_sensitivity *sensitivity, double t, const double *x, const double *sides,
                             double *slope, double *error);

/// Returns the machine together with its sensitivity: the state is x, then s = dx/dp [dimension] with s' = J s + df/dp.
/// Any integrator carries (x, s), which gives the derivative of the motion, and over a revolution of the Poincare map;
/// s at the start is dx/dp, 0 for a start that does not depend on the parameter. Steps end at switches. s is continuous
/// there, hence WHIRL_BAD_INPUT for machines whose forces jump at a switch (damped contacts, sharp friction), or that
/// have no Jacobian. Borrowed.
whirl_status whirl_sensitivity_system(whirl_sensitivity *sensitivity, const whirl_system **system);

#ifdef __cplusplus
}
#endif
#endif
