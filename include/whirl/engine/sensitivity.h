/// Sensitivities: derivatives of a machine's equations, and of its motion, by an input of its case.
///
/// An input (a clearance, the speed, a term of an expression) passes through units, expressions, scales and tables into
/// the machine's equations, which are smooth functions of it. The derivative is taken by central differences of
/// machines built at p +- h, h = reach, reach/2, ... reach/64, extrapolated to h = 0 (Richardson 1911; each component
/// at the level with the smallest error, Ridders 1982), with an estimate of the error. The laws are kept on the sides
/// of the switches at p, so that no difference crosses a contact.
#ifndef WHIRL_SENSITIVITY_H
#define WHIRL_SENSITIVITY_H

#include "whirl/engine/orbit.h"
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
/// machine cannot be built. Machines for small h are built when they are needed: the study, and what the batch borrows,
/// must live as long. WHIRL_BAD_INPUT if value and reach are 0, if machines differ in dimension, or as `machine` of the
/// study; WHIRL_NO_MEMORY. Freed by whirl_sensitivity_free; used by one thread at a time.
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
void whirl_sensitivity_slope(whirl_sensitivity *sensitivity, double t, const double *x, const double *sides,
                             double *slope, double *error);

/// Returns the derivative of the metres of one unit of displacement by the parameter, and writes these metres to
/// length: displacements in metres are length x, and change by length dx/dp + x times this.
double whirl_sensitivity_length(whirl_sensitivity *sensitivity, double *length);

/// Most parameters of one extended machine.
enum { WHIRL_MAX_SENSITIVITIES = 16 };

/// A machine with additional, constant states: one for each parameter.
typedef struct whirl_extended whirl_extended;

/// Makes the machine whose state is x, then q [count] with q' = 0: q is the change of a parameter over
/// whirl_extended_unit. Motions have q = 0. A perturbation that begins as (0, 1 for one parameter) is the derivative of
/// the motion by that parameter, s' = J s + df/dp, times the unit. Every integrator that carries perturbations carries
/// it, also through switches at which forces jump, where s changes by (f+ - f-) (h_x s + h_p)/(h_x f- + h_t) for the
/// switching function h(t, x, p) (Galan, Feehery, Barton 1999), and along switches on which the motion slides. All
/// sensitivities are of one machine at the same values; they are borrowed. WHIRL_BAD_INPUT for more than
/// WHIRL_MAX_SENSITIVITIES, for different machines, and for machines without a Jacobian; WHIRL_NO_MEMORY. Freed by
/// whirl_extended_free; used by one thread at a time.
whirl_status whirl_extended_new(size_t count, whirl_sensitivity *const *by, whirl_extended **out);

/// Frees an extended machine; accepts NULL.
void whirl_extended_free(whirl_extended *extended);

/// Returns its system; borrowed.
const whirl_system *whirl_extended_system(const whirl_extended *extended);

/// Returns the unit of parameter number `parameter`, in SI: |value|, or 8 reach for the value 0.
double whirl_extended_unit(const whirl_extended *extended, size_t parameter);

/// Derivatives of a periodic orbit by parameters.
typedef struct whirl_orbit_sensitivity {
    size_t dimension;   ///< dimension of the machine's state
    size_t count;       ///< number of parameters
    size_t revolutions; ///< revolutions of the orbit
    size_t instants;    ///< equally spaced instants of a revolution, from its beginning on
    double *states;     ///< [revolutions][instants][dimension] states of the orbit, in the machine's units
    double *slopes;     ///< [revolutions][instants][count][dimension] their derivatives by the parameters, in SI
} whirl_orbit_sensitivity;

/// Computes the derivatives of a forced orbit of the machine: ds over a period closes, s(T) = M s(0) + S. The orbit is
/// carried from its nodes at the beginnings of revolutions. Integration is by options->integrate, whose method carries
/// several perturbations ("cvode" does not); for a method of fixed steps instants must divide steps_per_revolution.
/// WHIRL_BAD_INPUT also for orbits with a period of their own and equilibria, where the orbit has a multiplier 1 (it is
/// lost there), and if a parameter changes the rate of a turning coordinate, so that its neighbours have no such orbit;
/// WHIRL_NO_MEMORY. Freed by whirl_orbit_sensitivity_free.
whirl_status whirl_orbit_sensitivity_new(const whirl_extended *extended, const whirl_orbit *orbit,
                                         const whirl_orbit_options *options, size_t instants,
                                         whirl_orbit_sensitivity **out);

/// Frees derivatives of an orbit; accepts NULL.
void whirl_orbit_sensitivity_free(whirl_orbit_sensitivity *sensitivity);

/// Most numbers of a point that are derived.
enum { WHIRL_MAX_DERIVED = 64 };

/// Numbers of every point of a batch that are derived by parameters of the case. At each point the blocks hold the
/// parameters' values ("sensitivity/parameters"), the numbers ("sensitivity/numbers"), and for each number the
/// derivative by each parameter with its error ("sensitivity/slopes"), all in SI.
///
/// Numbers of machines at rest are differenced and extrapolated as above; a mode is followed by its shape, and a
/// critical speed or threshold v, where g(v, p) = 0, changes by -g_p/g_v. Numbers of motions are those of the periodic
/// orbit on which the motion settles, from its exact derivative; its largest multiplier is differenced. Motions that
/// are not periodic have no derivatives. Errors are estimates of extrapolation and rounding; 0 for exact ones.
typedef struct whirl_derivatives {
    size_t parameter_count;                ///< number of parameters, at most WHIRL_MAX_SENSITIVITIES
    const whirl_given *parameters;         ///< [parameter_count] with their values in the case; borrowed
    size_t number_count;                   ///< number of chosen numbers; 0: the usual ones of each table
    const struct whirl_spread_of *numbers; ///< [number_count], without limits; borrowed
} whirl_derivatives;

#ifdef __cplusplus
}
#endif
#endif
