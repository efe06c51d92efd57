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

enum { MAX_SLIDING = 8, MAX_SWITCHINGS = 10000, DENSE = 3 + DOP853_DENSE };

/// Disturbances that go with a motion, and their workspace.
typedef struct stepper_variation {
    whirl_disturbances *set;                  ///< NULL: none
    double *k[DOP853_STAGES], *stage, *upper; ///< [count][dimension]
    double *end;                              ///< [count][dimension] at the end of the step that was tried
    double volume;                            ///< its part of the set's
    double *spare;                            ///< [SPARE_ROWS][dimension]
} stepper_variation;

/// An explicit Runge-Kutta formula: row `stages` of a gives the result, at whose end one more slope is taken.
typedef struct formula {
    int stages;
    const double *c, (*a)[DOP853_SLOPES - 1];
    bool adaptive; ///< estimates its error, chooses its steps, and has an interpolant of its own
} formula;

extern const formula dop853_formula, rk4_formula;

typedef struct stepper {
    const formula *formula;
    const whirl_system *system;
    size_t dimension;
    double rtol, atol, limit;
    double t;                     ///< where the motion is
    double h;                     ///< length of step to try next
    double *x;                    ///< [dimension]
    double *sides;                ///< [switch_count] -1 or +1
    int held[WHIRL_MAX_SWITCHES]; ///< as crossing_search has it, for the step that begins at x
    bool sliding[WHIRL_MAX_SWITCHES];
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
    double *stage, *scale;                   ///< [dimension] workspace
    double *work;                            ///< [MAX_SLIDING + 3][dimension] workspace of the sides
    stepper_variation variation;
} stepper;

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
/// where there are none or the formula estimates no error.
double stepper_try_varied(stepper *c);

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
