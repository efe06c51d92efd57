/// Sensitivities: derivatives of a machine's equations, and of its motion, by a number that it is built from.
///
/// A number of a case (a clearance, the speed, what stands in an expression) passes through units, expressions, scales
/// and tables into the machine's equations. They are smooth functions of it: the derivative is taken by central
/// differences of machines built at p +- h, h = reach, reach/2, ... reach/64, extrapolated to h = 0 (Richardson 1911;
/// each component from where the extrapolation is known best, Ridders 1982), with an estimate of the error. The laws
/// are held on the sides of the switches at p, so that no difference crosses a contact.
#ifndef WHIRL_SENSITIVITY_H
#define WHIRL_SENSITIVITY_H

#include "whirl/engine/study.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Derivatives by parameters of a case.
typedef struct whirl_sensitivity whirl_sensitivity;

/// Builds machines of the study at `value` of the batch's parameter (whose name may be changed in a copy of the batch
/// to that of any other parameter of the case) and beside it. reach > 0 in the parameter's SI unit, the largest h: an
/// eighth of the distance to where the equations stop being smooth is right; 0 for an eighth of |value|. It is halved
/// where a machine cannot be built beside the value. WHIRL_BAD_INPUT where value and reach are 0, where machines have
/// another dimension there, or as `machine` of the study says; WHIRL_NO_MEMORY. Freed by whirl_sensitivity_free; used
/// by one thread at a time.
whirl_status whirl_sensitivity_new(const whirl_study *study, const whirl_batch *batch, double value, double reach,
                                   whirl_sensitivity **out);

/// Frees them; NULL is none.
void whirl_sensitivity_free(whirl_sensitivity *sensitivity);

/// The machine at the value itself; borrowed.
const whirl_system *whirl_sensitivity_machine(const whirl_sensitivity *sensitivity);

/// Writes df/dp [dimension] of the right-hand side at (t, x), and unless NULL how far each may be off, from the
/// extrapolation and from rounding: error [dimension]. sides [switch_count] as whirl_system.rhs_on_sides has them;
/// NULL: those of x. Of a scaled state: x, t and the derivative are in the machine's units, of length and of time,
/// which may themselves depend on the parameter; where its period does, t and f are those of the same part of a period.
void whirl_sensitivity_slope(const whirl_sensitivity *sensitivity, double t, const double *x, const double *sides,
                             double *slope, double *error);

/// The machine beside its sensitivity: the state is x, then s = dx/dp [dimension] with s' = J s + df/dp. Carried by any
/// integrator from (x, s) it gives the derivative of the motion, over a revolution that of the Poincare map: with s
/// = dx/dp at the start, 0 for a start that does not depend on the parameter. Steps end at switches; s is continuous
/// there, so that WHIRL_BAD_INPUT for machines whose forces jump at a switch (damped contacts, sharp friction) or which
/// give no Jacobian. Borrowed.
whirl_status whirl_sensitivity_system(whirl_sensitivity *sensitivity, const whirl_system **system);

#ifdef __cplusplus
}
#endif
#endif
