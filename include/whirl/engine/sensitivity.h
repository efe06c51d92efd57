/// Sensitivities: derivatives of a machine's equations, and of its motion, by an input of its case.
///
/// An input (a clearance, the speed, a term of an expression) passes through units, expressions, scales and tables into
/// the machine's equations, which are smooth functions of it. The derivative is taken by central differences of
/// machines built at p +- h, h = reach, reach/2, ... reach/64, extrapolated to h = 0 (Richardson 1911; each component
/// at the level with the smallest error, Ridders 1982), with an estimate of the error. Every switching law (a
/// contact, say) is evaluated on the side that it has at p, in the neighbouring machines, too. So no difference crosses
/// a switch.
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

/// Builds machines of the study at and around `value` of batch->parameter. To differentiate by another parameter of the
/// case, pass a copy of the batch that names it. `reach`, in the parameter's SI unit, is the largest h. A good choice
/// is an eighth of the distance to the nearest value at which the equations are not smooth; 0 stands for an eighth of
/// |value|. The reach is halved while a machine cannot be built. Machines for small h are built when they are needed:
/// the study, and what the batch borrows, must live as long. WHIRL_BAD_INPUT if value and reach are both 0 or machines
/// differ in their numbers of states or switches; otherwise the errors of study->machine. WHIRL_NO_MEMORY. Freed by
/// whirl_sensitivity_free; used by one thread at a time.
whirl_status whirl_sensitivity_new(const whirl_study *study, const whirl_batch *batch, double value, double reach,
                                   whirl_sensitivity **out);

/// Frees sensitivities; accepts NULL.
void whirl_sensitivity_free(whirl_sensitivity *sensitivity);

/// Returns the machine at the value itself; borrowed.
const whirl_system *whirl_sensitivity_machine(const whirl_sensitivity *sensitivity);

/// Computes df/dp [dimension] of the right-hand side at (t, x), and unless NULL its error from extrapolation and
/// rounding, error [dimension]. sides [switch_count] as in whirl_system.rhs_on_sides; NULL: those of x. x, t and the
/// derivative are in the units of the machine at the value. If the period depends on the parameter, all machines are
/// evaluated at the same fraction of their periods.
void whirl_sensitivity_slope(whirl_sensitivity *sensitivity, double t, const double *x, const double *sides,
                             double *slope, double *error);

/// Writes the machine's length scale L in metres to `length` and returns dL/dp. A displacement L x in metres has the
/// derivative L dx/dp + x dL/dp.
double whirl_sensitivity_length(whirl_sensitivity *sensitivity, double *length);

/// Maximum number of parameters of one extended machine.
enum { WHIRL_MAX_SENSITIVITIES = 16 };

/// A machine with additional, constant states: one for each parameter.
typedef struct whirl_extended whirl_extended;

/// Makes the machine whose state is x, then q [count] with q' = 0. q is the change of each parameter divided by
/// whirl_extended_unit; motions have q = 0. A perturbation that begins with x = 0 and q = 1 for one parameter is s, the
/// derivative of the motion by that parameter, times the unit: s' = J s + df/dp. Every integrator with perturbations
/// carries s. Where forces jump at a switch, a zero of h(t, x, p), s changes by (f+ - f-) (h_x s + h_p)/(h_x f- + h_t)
/// (Galan, Feehery, Barton 1999). Motions that slide along a switch are covered, too. All sensitivities are of one
/// machine at the same values; they are borrowed. WHIRL_BAD_INPUT for more than WHIRL_MAX_SENSITIVITIES, for different
/// machines, and for machines without a Jacobian; WHIRL_NO_MEMORY. Freed by whirl_extended_free; used by one thread at
/// a time.
whirl_status whirl_extended_new(size_t count, whirl_sensitivity *const *by, whirl_extended **out);

/// Frees an extended machine; accepts NULL.
void whirl_extended_free(whirl_extended *extended);

/// Returns the system of an extended machine; borrowed.
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

/// Computes the derivatives s of a forced orbit by parameters. They have the period T of the orbit: s(0) = M s(0) + S,
/// with the monodromy matrix M, and S the derivative at T of the motion that begins with s = 0. The orbit is integrated
/// from its nodes at the beginnings of revolutions by options->integrate, whose method must carry several perturbations
/// ("cvode" does not). For a method of fixed steps `instants` must divide steps_per_revolution. WHIRL_BAD_INPUT also
/// for autonomous orbits and equilibria; if a multiplier is 1, where the derivatives do not exist; and if a parameter
/// changes the rate of a turning coordinate, since neighbouring machines then have no such orbit. WHIRL_NO_MEMORY.
/// Freed by whirl_orbit_sensitivity_free.
whirl_status whirl_orbit_sensitivity_new(const whirl_extended *extended, const whirl_orbit *orbit,
                                         const whirl_orbit_options *options, size_t instants,
                                         whirl_orbit_sensitivity **out);

/// Frees derivatives of an orbit; accepts NULL.
void whirl_orbit_sensitivity_free(whirl_orbit_sensitivity *sensitivity);

/// Maximum number of numbers of a point that are differentiated.
enum { WHIRL_MAX_DERIVED = 64 };

/// Numbers of every point of a batch that are differentiated by parameters of the case. At each point the blocks hold
/// the parameters' values ("sensitivity/parameters"), the numbers ("sensitivity/numbers"), and for each number the
/// derivative by each parameter with its error ("sensitivity/slopes"), all in SI.
///
/// For machines at rest derivatives are extrapolated differences as above. A mode is followed by its shape; a critical
/// speed or threshold v, where g(v, p) = 0, has the derivative -g_p/g_v. For motions they are the exact derivatives of
/// the periodic orbit on which the motion settles; the largest multiplier is differenced. Errors are estimates from
/// extrapolation and rounding, 0 for exact derivatives.
///
/// Motions that are not periodic have derivatives only if `difference` is given, of numbers that are no angles: the
/// slope of the line that fits best to the differences of four pairs of records, at distances from a quarter of
/// `difference` to all of it on both sides of the parameter's value. The error is half of the 95 % interval of that
/// slope, from the scatter of the pairs about the line.
typedef struct whirl_derivatives {
    size_t parameter_count;                ///< number of parameters, at most WHIRL_MAX_SENSITIVITIES
    const whirl_given *parameters;         ///< [parameter_count] with their values in the case; borrowed
    size_t number_count;                   ///< number of chosen numbers; 0: the usual ones of each table
    const struct whirl_spread_of *numbers; ///< [number_count], `above` and `below` infinite; borrowed
    double difference; ///< largest change of a parameter for motions that are not periodic, as a part of its value; 0:
                       ///< these have no derivatives
} whirl_derivatives;

#ifdef __cplusplus
}
#endif
#endif
