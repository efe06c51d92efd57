/// A machine carried by steps that end where its laws switch.
///
/// Every step runs on fixed sides of the switching functions, where the right-hand side is smooth
/// (whirl_system.rhs_on_sides). The first zero of a switching function within the step is found on the interpolant, and
/// the step is taken again so that it ends there. Then the motion continues beyond the switch or, if both sides push it
/// onto the switch, slides along it (Filippov 1988) until one side no longer does. For systems without laws on given
/// sides the state decides, and steps end at the switches all the same.
#ifndef INTEGRATE_STEPPER_H
#define INTEGRATE_STEPPER_H

#include "crossing.h"
#include "dop853_tableau.h"
#include "method.h"
#include "rk4_lanes.h"

#include <stdbool.h>
#include <stddef.h>

enum { MAX_SLIDING = 8, MAX_SWITCHINGS = 10000, DENSE = 3 + DOP853_DENSE, CUBIC = 3 };

struct adaptive_lanes;
struct lanes_method;

/// Perturbations carried with a motion, and their workspace.
typedef struct stepper_variation {
    whirl_perturbations *set;                 ///< NULL: none
    double *k[DOP853_STAGES], *stage, *upper; ///< [count][dimension]; adjacent rows of [1 + most] vectors
    double *end;                              ///< [count][dimension] at the end of the step that was tried
    double volume;                            ///< increase of the set's volume in this step
    double *spare;                            ///< [SPARE_ROWS][dimension]
} stepper_variation;

/// Rows of the workspace of perturbations, each of (1 + most) vectors. SPARE_ROWS single vectors follow.
enum { PERTURBATION_ROWS = DOP853_STAGES + 3 };

/// Rows of a stepper's workspace of values and sides. Functions that call one another use different rows.
enum { ROW_VALUE, ROW_FOUND, ROW_FROM, ROW_TO, ROW_SIDES, ROW_SIDES_OF_MEAN, ROW_SEARCH };
enum { SWITCH_ROWS = ROW_SEARCH + CROSSING_ROWS };

typedef struct stepper {
    const struct lanes_method
        *method;                 ///< method whose kernel takes the steps, by the tolerance; NULL: rk4, of given lengths
    struct adaptive_lanes *slot; ///< workspace of that kernel
    rk4_one fixed;               ///< workspace of rk4
    double times[4];             ///< forcing of rk4's step (t at its beginning, middle and end), and the present
                                 ///< forcing
    const whirl_system *system;
    size_t dimension;
    double rtol, atol, limit;
    double t;            ///< time of the motion
    double *x;           ///< [dimension]
    double *sides;       ///< [switch_count] -1 or +1
    int *held;           ///< [switch_count] as in crossing_search, for the step that begins at x
    bool *sliding;       ///< [switch_count]
    double *at_switches; ///< [SWITCH_ROWS][switch_count] workspace
    size_t *mates;       ///< [dimension] as in adaptive_lanes
    size_t sliding_count;
    int switchings;    ///< number of switches met since the beginning of the revolution
    bool crossed;      ///< the last step ended at a switch
    bool halts;        ///< steps by the tolerance end at instants of the revolution
    bool observed;     ///< the caller may use stepper_between after a step
    bool eager;        ///< every observed step is interpolated at once; otherwise when stepper_interpolate is called
    bool interpolated; ///< the interpolant is that of the last step
    // The last step.
    double begin, length;
    double *start, *end;  ///< [dimension] the states at its beginning and end
    double *first, *last; ///< [dimension] the slopes at its beginning and end
    double *dense[DENSE]; ///< [dimension] polynomials of the interpolant
    int dense_count;
    size_t tried;  ///< number of steps tried since the stepper was made
    double *stage; ///< [dimension] workspace
    double *rows;  ///< [RK4_ROWS][dimension] workspace of rk4
    double *work;  ///< [MAX_SLIDING + 3][dimension] workspace of sides.c
    stepper_variation variation;
} stepper;

/// Returns a row of the workspace.
static inline double *stepper_row(const stepper *c, int row) {
    return c->at_switches + (size_t)row * c->system->switch_count;
}

/// Makes a stepper, without a motion, for systems with the dimension and the switches of `system`. Returns NULL without
/// memory.
stepper *stepper_new(const struct lanes_method *own, const whirl_system *system,
                     const whirl_integrate_options *options);
void stepper_free(stepper *c);

/// Begins a revolution at x: t = 0, sides by x, and a first step whose length depends on x alone.
whirl_motion stepper_begin(stepper *c, const whirl_system *system, const double *x);

/// Prepares the stepper to continue another motion at time t. The caller sets x, sides and held, and slot->h, the
/// length of the step to try next.
void stepper_place(stepper *c, const whirl_system *system, double t);

/// Attaches the workspace of up to `most` perturbations: [PERTURBATION_ROWS][1 + most] and [SPARE_ROWS] vectors
/// [dimension].
void stepper_follow(stepper *c, size_t most, double *work);

/// Takes one step, which ends at the first switch and at most at `until`.
whirl_motion stepper_step(stepper *c, double until);

/// Computes the interpolant of the step tried, unless that is done; for rk4 the cubic by states and slopes at both
/// ends.
void stepper_interpolate(stepper *c);

/// Computes the state within the last step by its interpolant (stepper_interpolate), at theta from 0 to 1.
void stepper_between(const stepper *c, double theta, double *x);

#endif
