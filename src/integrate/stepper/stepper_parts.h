/// Parts of a step, between the files of the stepper.
#ifndef INTEGRATE_STEPPER_PARTS_H
#define INTEGRATE_STEPPER_PARTS_H

#include "stepper.h"

#include <stdbool.h>
#include <stddef.h>

/// Computes dx/dt at (t, x) on the present sides, sliding included.
void stepper_slope(const stepper *c, double t, const double *x, double *dxdt);

/// Returns the derivative by time of switch `which` along `slope`: by the system's gradient, else by central
/// differences.
double stepper_rate(const stepper *c, size_t which, double t, const double *x, const double *slope);

/// Sets the sides at the beginning of a revolution, where x may lie on a switch.
void stepper_find_sides(stepper *c);

/// Writes the functions [switch_count] that must stay positive during a step: the switching functions times their
/// sides, and for switches with sliding a function of the share that is positive between 0 and 1.
void stepper_guarded(const stepper *c, double t, const double *x, double *values);

/// Continues after a step that ended on switch `which`: on its other side, or along it.
void stepper_cross(stepper *c, size_t which);

/// Projects perturbations onto switches with sliding at the beginning of a revolution, along the difference of the
/// slopes on both sides.
void stepper_vary_begin(stepper *c);

/// The Jacobian at (t, x) on the present sides, sliding included, applied to `vectors`; vectors and out are
/// [count][dimension], with sliding at most as many as perturbations.
void stepper_apply_jacobian(const stepper *c, double t, const double *x, size_t count, const double *vectors,
                            double *out);

/// Takes a step of rk4 from `start`, of the state and its perturbations.
void rk4_try_step(stepper *c, double h);
double rk4_try_varied(stepper *c);

/// Returns the tolerance of perturbation `which` in the step tried. Equations of perturbations are linear, so that
/// there is no absolute tolerance.
double stepper_varied_tolerance(const stepper *c, size_t which);

/// Returns the divergence at (t, x) on the present sides; NaN along switches.
double stepper_divergence(const stepper *c, double t, const double *x);

/// Moves the perturbations to the end of the step tried; called before the motion moves.
void stepper_vary(stepper *c);

/// Crosses a switch like stepper_cross, with the saltation of the perturbations.
void stepper_cross_varied(stepper *c, size_t which);

/// Notes the state x at c->t, where a step of rk4 begins that does not locate switches.
void unlocated_begin(stepper *c, const double *x);

/// Applies the saltation of all switches within that step to perturbations, at its end (t, x); `slope` is the slope at
/// its beginning.
void unlocated_saltate(stepper *c, double t, const double *slope, const double *x, whirl_perturbations *perturbations);

/// Lists the switches along which the motion slides; returns their number.
size_t stepper_list_sliding(const stepper *c, size_t list[MAX_SLIDING]);

/// Computes the slope along these switches and the shares of their upper sides; the differences of the sides stay in
/// the rows of `work` from the second on.
void stepper_slope_along(const stepper *c, double t, const double *x, double *dxdt, double *share);

/// Solves n by n equations in place of `right`; returns false if they are singular.
bool stepper_solve(size_t n, double matrix[MAX_SLIDING][MAX_SLIDING], double *right);

/// Moves x back onto the switches along which it slides.
void stepper_project(const stepper *c, double *x);

/// Returns the bound within which the value of switch `which` at x counts as zero: a thousandth of the tolerance of x.
double stepper_reach(const stepper *c, size_t which, double t, const double *x);

#endif
