/// Functions that the files of the stepper share.
#ifndef INTEGRATE_STEPPER_PARTS_H
#define INTEGRATE_STEPPER_PARTS_H

#include "stepper.h"

#include <stdbool.h>
#include <stddef.h>

/// Computes dx/dt at (t, x) on the present sides, sliding included.
void stepper_slope(const stepper *c, double t, const double *x, double *dxdt);

/// Returns the derivative of switch `which` by time along `slope`, by the system's gradient, otherwise by central
/// differences.
double stepper_rate(const stepper *c, size_t which, double t, const double *x, const double *slope);

/// Sets the sides at the beginning of a revolution, where x may lie on a switch.
void stepper_find_sides(stepper *c);

/// Writes the functions [switch_count] that must stay positive during a step: the switching functions times their
/// sides; and for a switch along which the motion slides a function of the share that is positive between 0 and 1.
void stepper_guarded(const stepper *c, double t, const double *x, double *values);

/// Continues after a step that ended at switch `which`: on its other side, or along it.
void stepper_cross(stepper *c, size_t which);

/// Projects perturbations, at the beginning of a revolution, onto the switches along which the motion slides. They move
/// along the difference of the slopes on both sides.
void stepper_vary_begin(stepper *c);

/// Applies the Jacobian at (t, x) on the present sides, sliding included, to `vectors`. vectors and out are
/// [count][dimension]; with sliding, count is at most the number of perturbations.
void stepper_apply_jacobian(const stepper *c, double t, const double *x, size_t count, const double *vectors,
                            double *out);

/// Take a step of rk4 from `start`, of the state and of its perturbations.
void rk4_try_step(stepper *c, double h);
double rk4_try_varied(stepper *c);

/// Returns the tolerance of perturbation `which` in the step tried. The equations of perturbations are linear, so that
/// there is no absolute tolerance.
double stepper_varied_tolerance(const stepper *c, size_t which);

/// Returns the divergence at (t, x) on the present sides, or NaN along switches.
double stepper_divergence(const stepper *c, double t, const double *x);

/// Moves the perturbations to the end of the step tried. To be called before the motion moves.
void stepper_vary(stepper *c);

/// Crosses a switch like stepper_cross, with the saltation of the perturbations.
void stepper_cross_varied(stepper *c, size_t which);

/// Notes the state x at c->t as the beginning of a step of rk4 that does not locate switches.
void unlocated_begin(stepper *c, const double *x);

/// Applies the saltation of all switches within such a step to perturbations, at its end (t, x). `slope` is the slope
/// at its beginning.
void unlocated_saltate(stepper *c, double t, const double *slope, const double *x, whirl_perturbations *perturbations);

/// Lists the switches along which the motion slides. Returns their number.
size_t stepper_list_sliding(const stepper *c, size_t list[MAX_SLIDING]);

/// Computes the slope along these switches, and the shares of their upper sides. The differences between the sides
/// remain in `work`, in rows from the second on.
void stepper_slope_along(const stepper *c, double t, const double *x, double *dxdt, double *share);

/// Solves the n by n equations matrix x = right by elimination with the largest pivot; `right` becomes x. Returns false
/// if they are singular.
bool stepper_solve(size_t n, double matrix[MAX_SLIDING][MAX_SLIDING], double *right);

/// Moves x back onto the switches along which it slides.
void stepper_project(const stepper *c, double *x);

/// Returns the bound within which the value of switch `which` at x counts as zero: a thousandth of the tolerance of x.
double stepper_reach(const stepper *c, size_t which, double t, const double *x);

#endif
