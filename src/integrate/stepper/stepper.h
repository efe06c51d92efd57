/// A machine carried by steps that end where its laws switch.
///
/// Every step runs on fixed sides of the switching functions, where the right-hand side is smooth
/// (whirl_system.rhs_on_sides); the first zero of a switching function within the step is found on the interpolant and
/// the step taken anew to end there. Then the motion continues beyond the switch or, if both sides push onto it, slides
/// along it (Filippov 1988) until one side no longer pushes. For systems without laws on given sides the state decides,
/// and steps end at the switches all the same.
#ifndef INTEGRATE_STEPPER_H
#define INTEGRATE_STEPPER_H

#include "dop853_tableau.h"
#include "method.h"
#include "rk4_lanes.h"
#include "vector.h"

#include <stdbool.h>
#include <stddef.h>

// ---------------------------------------------------------------- crossing
// First zero of a function within a step.

/// Writes the `count` values of functions that are positive until they are crossed, at `theta` of the step, 0 to 1.
typedef void crossing_values(void *context, double theta, double *values);

typedef struct crossing_search {
    crossing_values *values;
    void *context;
    size_t count;
    /// [count] 0; 1 for a function that begins at zero, 2 if its derivative begins at zero too: the zero at theta = 0
    /// is ignored. CROSSING_ALONG: all zeros of this function are ignored.
    const int *held;
    double *work; ///< [CROSSING_ROWS][count]
} crossing_search;

enum { CROSSING_ROWS = 12, CROSSING_DEGREE = 8, CROSSING_ALONG = CROSSING_DEGREE + 1 };

/// Finds the first zero: returns true with its theta and the function's index. Two zeros in one step, where a function
/// only dips below zero, are found too: every function is replaced by a polynomial, which its Bernstein coefficients
/// bound.
bool crossing_first(const crossing_search *search, double *theta, size_t *which);

enum { MAX_SLIDING = 8, MAX_SWITCHINGS = 10000, DENSE = 3 + DOP853_DENSE, CUBIC = 3 };

struct adaptive_lanes;
struct lanes_method;

/// Perturbations carried with a motion, and their workspace.
typedef struct stepper_variation {
    whirl_perturbations *set;                 ///< NULL: none
    double *k[DOP853_STAGES], *stage, *upper; ///< [count][dimension], rows of [1 + most] in a line
    double *end;                              ///< [count][dimension] at the end of the step that was tried
    double volume;                            ///< part of the set's volume in this step
    double *spare;                            ///< [SPARE_ROWS][dimension]
} stepper_variation;

/// Rows of the workspace of perturbations, each of (1 + most) vectors; the last SPARE_ROWS are single vectors.
enum { PERTURBATION_ROWS = DOP853_STAGES + 3 };

/// Rows of a stepper's workspace of values and sides; functions that call one another use different rows.
enum { ROW_VALUE, ROW_FOUND, ROW_FROM, ROW_TO, ROW_SIDES, ROW_SIDES_OF_MEAN, ROW_SEARCH };
enum { SWITCH_ROWS = ROW_SEARCH + CROSSING_ROWS };

typedef struct stepper {
    const struct lanes_method
        *method;                 ///< method whose kernel takes the steps, by the tolerance; NULL: rk4, of given lengths
    struct adaptive_lanes *slot; ///< workspace of that kernel
    rk4_one fixed;               ///< workspace of rk4
    double times[4];             ///< values of time of its step, and the present ones
    const whirl_system *system;
    size_t dimension;
    double rtol, atol, limit;
    double t;            ///< time of the motion
    double *x;           ///< [dimension]
    double *sides;       ///< [switch_count] -1 or +1
    int *held;           ///< [switch_count] as in crossing_search, for the step that begins at x
    bool *sliding;       ///< [switch_count]
    double *at_switches; ///< [SWITCH_ROWS][switch_count] workspace
    size_t *mates;       ///< [dimension] as adaptive_lanes has them
    size_t sliding_count;
    int switchings; ///< since the beginning of the revolution
    bool crossed;   ///< the last step ended at a switch
    bool observed;  ///< the caller uses stepper_between after every step
    // The last step.
    double begin, length;
    double *start, *end;  ///< [dimension] the states at its beginning and end
    double *first, *last; ///< [dimension] the slopes there
    double *dense[DENSE]; ///< [dimension] polynomials of the interpolant
    int dense_count;
    size_t tried;  ///< steps, since the stepper was made
    double *stage; ///< [dimension] workspace
    double *rows;  ///< [RK4_ROWS][dimension] of rk4
    double *work;  ///< [MAX_SLIDING + 3][dimension] workspace of functions of sides
    stepper_variation variation;
} stepper;

/// Returns a row of the workspace.
static inline double *stepper_row(const stepper *c, int row) {
    return c->at_switches + (size_t)row * c->system->switch_count;
}

/// Makes a stepper for systems with this one's dimension and switches, without a motion; NULL without memory.
stepper *stepper_new(const struct lanes_method *own, const whirl_system *system,
                     const whirl_integrate_options *options);
void stepper_free(stepper *c);

/// Begins a revolution at x, with t = 0, sides from x, and a first step whose length depends on x alone.
whirl_motion stepper_begin(stepper *c, const whirl_system *system, const double *x);

/// Places the motion of another stepper at time t: x, sides and held are the caller's to set, and the length of the
/// step to try next, slot->h.
void stepper_place(stepper *c, const whirl_system *system, double t);

/// Attaches the workspace of up to `most` perturbations: [PERTURBATION_ROWS][1 + most] and [SPARE_ROWS] vectors
/// [dimension].
void stepper_follow(stepper *c, size_t most, double *room);

/// Takes one step, at most to `until` and at most to the first switch.
whirl_motion stepper_step(stepper *c, double until);

/// Writes the interpolant of the step tried; for rk4 the cubic by states and slopes at both ends.
void stepper_interpolate(stepper *c);

/// Computes the state within the last step by its interpolant, at theta from 0 to 1.
void stepper_between(const stepper *c, double theta, double *x);

// ---------------------------------------------------------------- between the stepper's own files

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

// ---------------------------------------------------------------- bernstein
// The course of a switching function over a step, by the Bernstein coefficients of the cubic through its values and
// derivatives at both ends.

/// Returns 1 if the function clearly stays positive, else 0: all coefficients exceed a bound for the difference of
/// function and polynomial, taken from the bend of their polygon.
static inline vec bernstein_clear(vec b0, vec b1, vec b2, vec b3) {
    const vec bend0 = v_add(v_sub(b0, v_add(b1, b1)), b2), bend1 = v_add(v_sub(b1, v_add(b2, b2)), b3);
    const vec margin = v_fma(v_set(0.5), v_max(v_abs(bend0), v_abs(bend1)), v_abs(v_sub(bend1, bend0)));
    return v_select(v_less(margin, v_min(v_min(b0, b1), v_min(b2, b3))), v_set(1.0), v_set(0.0));
}

#endif
