/// A machine carried by steps that end where its laws switch.
///
/// Every step runs on fixed sides of the switching functions, where the right-hand side is smooth
/// (whirl_system.rhs_on_sides); the first zero of a switching function within the step is found on the interpolant and
/// the step taken anew to end there. Then the motion goes on beyond the switch or, where both sides push onto it,
/// slides along it (Filippov 1988) until one side lets go. Of systems that do not know sides the state decides, and
/// steps end at the switches all the same.
#ifndef INTEGRATE_STEPPER_H
#define INTEGRATE_STEPPER_H

#include "crossing.h"
#include "dop853_tableau.h"
#include "method.h"
#include "rodas5p_tableau.h"

enum { MAX_SLIDING = 8, MAX_SWITCHINGS = 10000, DENSE = 3 + DOP853_DENSE };

/// Disturbances that go with a motion, and their workspace.
typedef struct stepper_variation {
    whirl_disturbances *set;                  ///< NULL: none
    double *k[DOP853_STAGES], *stage, *upper; ///< [count][dimension]
    double *end;                              ///< [count][dimension] at the end of the step that was tried
    double volume;                            ///< its part of the set's
    double *spare;                            ///< [SPARE_ROWS][dimension]
} stepper_variation;

/// Rows of a stepper's workspace, so that what calls one another does not share one: values, sides.
enum { ROW_VALUE, ROW_FOUND, ROW_FROM, ROW_TO, ROW_SIDES, ROW_SIDES_OF_MEAN, ROW_SEARCH };
enum { SWITCH_ROWS = ROW_SEARCH + CROSSING_ROWS };

struct stepper;

/// A formula of a step: explicit Runge-Kutta, whose row `stages` of a gives the result, or another with functions of
/// its own.
typedef struct formula {
    int stages; ///< number of the slope at the step's end among the stepper's k
    const double *c, (*a)[DOP853_SLOPES - 1];
    bool adaptive; ///< estimates its error, chooses its steps, and has an interpolant of its own
    /// Tries a step of that length from `start`, whose slope is k[0]: writes end and the slope there; gives the norm of
    /// the estimated error over the tolerance, not a number where the step leaves the equations' domain.
    double (*try_step)(struct stepper *c, double h);
    void (*interpolate)(struct stepper *c);  ///< writes the polynomials of the step tried
    double (*try_varied)(struct stepper *c); ///< stepper_try_varied
    /// By what the length changes after a step of that error and the one before, and after one that was rejected.
    double (*longer)(double error, double before), (*shorter)(double error);
    size_t (*room)(size_t dimension); ///< numbers of the workspace `own`, or NULL
} formula;

extern const formula dop853_formula, rodas5p_formula, rk4_formula;

typedef struct stepper {
    const formula *formula;
    const whirl_system *system;
    size_t dimension;
    double rtol, atol, limit;
    double t;            ///< where the motion is
    double h;            ///< length of step to try next
    double *x;           ///< [dimension]
    double *sides;       ///< [switch_count] -1 or +1
    int *held;           ///< [switch_count] as crossing_search has it, for the step that begins at x
    bool *sliding;       ///< [switch_count]
    double *at_switches; ///< [SWITCH_ROWS][switch_count] workspace
    size_t sliding_count;
    int switchings; ///< since the beginning of the revolution
    bool crossed;   ///< the last step ended at a switch
    bool observed;  ///< stepper_between is wanted after every step
    // The last step.
    double begin, length;
    double *start;                           ///< [dimension] the state at its beginning
    double *end;                             ///< [dimension] workspace: the state at its end
    double *k[DOP853_SLOPES], *dense[DENSE]; ///< [dimension] slopes and polynomials
    double error;                            ///< of the last accepted step, in tolerances
    size_t tried;                            ///< steps, since the stepper was made
    double *stage, *scale;                   ///< [dimension] workspace
    double *work;                            ///< [MAX_SLIDING + 3][dimension] workspace of the sides
    double *own;                             ///< workspace of the formula
    stepper_variation variation;
} stepper;

/// A row of its workspace.
static inline double *stepper_row(const stepper *c, int row) {
    return c->at_switches + (size_t)row * c->system->switch_count;
}

/// A stepper for systems of that dimension and number of switches, with no motion yet; NULL where there is no memory.
/// Freed by free().
stepper *stepper_new(const formula *formula, size_t dimension, size_t switch_count,
                     const whirl_integrate_options *options);

/// Begins a revolution at x: t = 0, sides as x says, a length of step that depends on x alone.
whirl_motion stepper_begin(stepper *c, const whirl_system *system, const double *x);

/// Places the motion of another stepper at time t: x, sides, held and h are the caller's to set.
void stepper_place(stepper *c, const whirl_system *system, double t);

/// Carries the motion one step further, at most to `until` and at most to the first switch.
whirl_motion stepper_step(stepper *c, double until);

/// The state within the last step, by the formula's interpolant; theta from 0 to 1.
void stepper_between(const stepper *c, double theta, double *x);

// ---------------------------------------------------------------- between the stepper's own files

/// dx/dt at (t, x) on the present sides, sliding included.
void stepper_slope(const stepper *c, double t, const double *x, double *dxdt);

/// The derivative by time of switch `which` along `slope`: by the system's gradient, else by central differences.
double stepper_rate(const stepper *c, size_t which, double t, const double *x, const double *slope);

/// The sides at the beginning of a revolution, where x may lie on a switch.
void stepper_find_sides(stepper *c);

/// What must stay positive during a step, [switch_count]: the switching functions times their sides, and for those that
/// are slid along the room that the two sides leave.
void stepper_guarded(const stepper *c, double t, const double *x, double *values);

/// At the end of a step on switch `which`: beyond it, or along it.
void stepper_cross(stepper *c, size_t which);

/// At the beginning of a revolution: disturbances off a switch that is slid along are there at once, drawn along what
/// its two sides differ by.
void stepper_vary_begin(stepper *c);

/// The Jacobian at (t, x) on the present sides, sliding included, applied to as many vectors as there are disturbances:
/// `vectors` and out are [count][dimension].
void stepper_apply_jacobian(const stepper *c, double t, const double *x, const double *vectors, double *out);

/// Tries the step of the state for the disturbances; gives the norm of their estimated error over the tolerance, 0
/// where there are none or the formula estimates no error. This is the explicit formulas' one.
double stepper_try_varied(stepper *c);

/// The norm of the error of disturbance `which` over the step that was tried, [dimension], over the tolerance of its
/// length. Equations of disturbances are linear: they know no absolute tolerance.
double stepper_varied_error(const stepper *c, size_t which, const double *error);

/// The divergence at (t, x) on the present sides; not a number along switches.
double stepper_divergence(const stepper *c, double t, const double *x);

/// What an error of every coordinate is compared with, between the states a and b, in c->scale.
void stepper_set_scales(stepper *c, const double *a, const double *b);

/// Lets the disturbances go on at the end of the step that was tried, before the motion does.
void stepper_vary(stepper *c);

/// stepper_cross, with the saltation of the disturbances.
void stepper_cross_varied(stepper *c, size_t which);

/// The switches that are slid along; gives how many.
size_t stepper_list_sliding(const stepper *c, size_t list[MAX_SLIDING]);

/// The slope along them with the shares of their upper sides; leaves what these add in the rows of `work` from the
/// second on.
void stepper_slope_along(const stepper *c, double t, const double *x, double *dxdt, double *share);

/// Solves n by n equations in place of `right`; false where they are singular.
bool stepper_solve(size_t n, double matrix[MAX_SLIDING][MAX_SLIDING], double *right);

/// Puts x back onto the switches that are slid along.
void stepper_project(const stepper *c, double *x);

/// Within which the value of switch `which` at x counts as zero: a thousandth of the tolerance of x.
double stepper_reach(const stepper *c, size_t which, double t, const double *x);

#endif
