/// A machine carried by steps that end where its laws switch.
///
/// Every step runs on fixed sides of the switching functions, where the right-hand side is smooth
/// (whirl_system.rhs_on_sides); the first zero of a switching function within the step is found on the interpolant and
/// the step taken anew to end there. Then the motion goes on beyond the switch or, where both sides push onto it,
/// slides along it (Filippov 1988) until one side lets go. Of systems that do not know sides the state decides, and
/// steps end at the switches all the same.
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
    /// [count] 0; 1 for a function that begins at zero, 2 where its derivative begins at zero, too: the zero at theta =
    /// 0 is not one that is looked for. CROSSING_ALONG: no zero of this function is.
    const int *held;
    double *work; ///< [CROSSING_ROWS][count]
} crossing_search;

enum { CROSSING_ROWS = 12, CROSSING_DEGREE = 8, CROSSING_ALONG = CROSSING_DEGREE + 1 };

/// The first zero: true with its place and the function's index. Two zeros in one step, where a function only dips
/// below zero, are seen: every function is replaced by a polynomial, whose Bernstein coefficients bound it.
bool crossing_first(const crossing_search *search, double *theta, size_t *which);

enum { MAX_SLIDING = 8, MAX_SWITCHINGS = 10000, DENSE = 3 + DOP853_DENSE, CUBIC = 3 };

struct adaptive_lanes;
struct lanes_method;

/// Perturbations that go with a motion, and their workspace.
typedef struct stepper_variation {
    whirl_perturbations *set;                 ///< NULL: none
    double *k[DOP853_STAGES], *stage, *upper; ///< [count][dimension], rows of [1 + most] in a line
    double *end;                              ///< [count][dimension] at the end of the step that was tried
    double volume;                            ///< its part of the set's
    double *spare;                            ///< [SPARE_ROWS][dimension]
} stepper_variation;

/// Rows of its workspace, each of (1 + most) vectors, except the last SPARE_ROWS, which are vectors.
enum { PERTURBATION_ROWS = DOP853_STAGES + 3 };

/// Rows of a stepper's workspace, so that what calls one another does not share one: values, sides.
enum { ROW_VALUE, ROW_FOUND, ROW_FROM, ROW_TO, ROW_SIDES, ROW_SIDES_OF_MEAN, ROW_SEARCH };
enum { SWITCH_ROWS = ROW_SEARCH + CROSSING_ROWS };

typedef struct stepper {
    const struct lanes_method
        *method;                 ///< method whose kernel takes the steps, by the tolerance; NULL: rk4, of given lengths
    struct adaptive_lanes *slot; ///< workspace of that kernel
    rk4_one fixed;               ///< workspace of rk4
    double times[4];             ///< values of time of its step, and of now
    const whirl_system *system;
    size_t dimension;
    double rtol, atol, limit;
    double t;            ///< time of the motion
    double *x;           ///< [dimension]
    double *sides;       ///< [switch_count] -1 or +1
    int *held;           ///< [switch_count] as crossing_search has it, for the step that begins at x
    bool *sliding;       ///< [switch_count]
    double *at_switches; ///< [SWITCH_ROWS][switch_count] workspace
    size_t *mates;       ///< [dimension] as adaptive_lanes has them
    size_t sliding_count;
    int switchings; ///< since the beginning of the revolution
    bool crossed;   ///< the last step ended at a switch
    bool observed;  ///< stepper_between is wanted after every step
    // The last step.
    double begin, length;
    double *start, *end;  ///< [dimension] the states at its beginning and end
    double *first, *last; ///< [dimension] the slopes there
    double *dense[DENSE]; ///< [dimension] polynomials of the interpolant
    int dense_count;
    size_t tried;  ///< steps, since the stepper was made
    double *stage; ///< [dimension] workspace
    double *rows;  ///< [RK4_ROWS][dimension] of rk4
    double *work;  ///< [MAX_SLIDING + 3][dimension] workspace of the sides
    stepper_variation variation;
} stepper;

/// A row of its workspace.
static inline double *stepper_row(const stepper *c, int row) {
    return c->at_switches + (size_t)row * c->system->switch_count;
}

/// A stepper for systems of that one's dimension and switches, with no motion yet; NULL where there is no memory.
stepper *stepper_new(const struct lanes_method *own, const whirl_system *system,
                     const whirl_integrate_options *options);
void stepper_free(stepper *c);

/// Begins a revolution at x: t = 0, sides as x says, a length of step that depends on x alone.
whirl_motion stepper_begin(stepper *c, const whirl_system *system, const double *x);

/// Places the motion of another stepper at time t: x, sides and held are the caller's to set, and the length of the
/// step to try next, slot->h.
void stepper_place(stepper *c, const whirl_system *system, double t);

/// Gives it the workspace of up to so many perturbations: [PERTURBATION_ROWS][1 + most] and [SPARE_ROWS] vectors
/// [dimension].
void stepper_follow(stepper *c, size_t most, double *room);

/// Carries the motion one step further, at most to `until` and at most to the first switch.
whirl_motion stepper_step(stepper *c, double until);

/// Writes the interpolant of the step tried; of rk4 the cubic by the states and slopes at both ends.
void stepper_interpolate(stepper *c);

/// The state within the last step, by the formula's interpolant; theta from 0 to 1.
void stepper_between(const stepper *c, double theta, double *x);

// ---------------------------------------------------------------- between the stepper's own files

/// dx/dt at (t, x) on the present sides, sliding included.
void stepper_slope(const stepper *c, double t, const double *x, double *dxdt);

/// The derivative by time of switch `which` along `slope`: by the system's gradient, else by central differences.
double stepper_rate(const stepper *c, size_t which, double t, const double *x, const double *slope);

/// The sides at the beginning of a revolution, where x may lie on a switch.
void stepper_find_sides(stepper *c);

/// Writes what must stay positive during a step, [switch_count]: the switching functions times their sides, and for
/// those that are slid along the room that the two sides leave.
void stepper_guarded(const stepper *c, double t, const double *x, double *values);

/// At the end of a step on switch `which`: beyond it, or along it.
void stepper_cross(stepper *c, size_t which);

/// At the beginning of a revolution: perturbations off a switch that is slid along are there at once, drawn along what
/// its two sides differ by.
void stepper_vary_begin(stepper *c);

/// The Jacobian at (t, x) on the present sides, sliding included (of at most as many vectors as there is room for
/// perturbations), applied to `vectors`: these and out are [count][dimension].
void stepper_apply_jacobian(const stepper *c, double t, const double *x, size_t count, const double *vectors,
                            double *out);

/// Takes a step of rk4 of the state from `start`, and that of the perturbations that go along.
void rk4_try_step(stepper *c, double h);
double rk4_try_varied(stepper *c);

/// The error that perturbation `which` may have over the step that was tried. Equations of perturbations are linear:
/// they know no absolute tolerance.
double stepper_varied_tolerance(const stepper *c, size_t which);

/// The divergence at (t, x) on the present sides; not a number along switches.
double stepper_divergence(const stepper *c, double t, const double *x);

/// Lets the perturbations go on at the end of the step that was tried, before the motion does.
void stepper_vary(stepper *c);

/// stepper_cross, with the saltation of the perturbations.
void stepper_cross_varied(stepper *c, size_t which);

/// Notes the state x where a step of rk4 begins that goes over switches, at c->t.
void unlocated_begin(stepper *c, const double *x);

/// Changes perturbations at the end (t, x) of that step, which began with that slope, for all switches between.
void unlocated_saltate(stepper *c, double t, const double *slope, const double *x, whirl_perturbations *perturbations);

/// The switches that are slid along; gives how many.
size_t stepper_list_sliding(const stepper *c, size_t list[MAX_SLIDING]);

/// The slope along them with the shares of their upper sides; leaves what these add in the rows of `work` from the
/// second on.
void stepper_slope_along(const stepper *c, double t, const double *x, double *dxdt, double *share);

/// Solves n by n equations in place of `right`; false where they are singular.
bool stepper_solve(size_t n, double matrix[MAX_SLIDING][MAX_SLIDING], double *right);

/// Puts x back onto the switches that are slid along.
void stepper_project(const stepper *c, double *x);

/// Returns the bound within which the value of switch `which` at x counts as zero: a thousandth of the tolerance of x.
double stepper_reach(const stepper *c, size_t which, double t, const double *x);

// ---------------------------------------------------------------- bernstein
// The course of a switching function over a step, by the Bernstein coefficients of the cubic through its values and
// derivatives at both ends.

/// 1 where the function stays positive by far, else 0: all coefficients exceed what the bend of their polygon says of
/// the function between the ends.
static inline vec bernstein_clear(vec b0, vec b1, vec b2, vec b3) {
    const vec bend0 = v_add(v_sub(b0, v_add(b1, b1)), b2), bend1 = v_add(v_sub(b1, v_add(b2, b2)), b3);
    const vec margin = v_fma(v_set(0.5), v_max(v_abs(bend0), v_abs(bend1)), v_abs(v_sub(bend1, bend0)));
    return v_select(v_less(margin, v_min(v_min(b0, b1), v_min(b2, b3))), v_set(1.0), v_set(0.0));
}

#endif
