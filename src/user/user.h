/// The struct of a user's system, and functions that its files share.
#ifndef USER_USER_H
#define USER_USER_H

#include <limits.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>

#include "lanes.h"
#include "whirl/engine/study.h"
#include "whirl/user_system.h"

enum {
    USER_MAX_STATES = 4096,
    USER_MAX_PARAMETERS = 256,
    USER_AXES = 3,       ///< parameters that a study can vary
    USER_MAX_EVENTS = 64 ///< events that a system can have
};

/// An event of motions over time (follow.c).
typedef struct user_event {
    char name[WHIRL_NAME_SIZE];
    whirl_user_event_fn value;
    whirl_user_reset_fn reset;
    int passing;
    bool ends;
    void *context;
} user_event;

typedef struct user_axis {
    size_t parameter, count;
    double *values; ///< [count]
} user_axis;

/// Branches of orbits or equilibria that a study follows instead of motions, and curves of their special points.
typedef struct user_branches {
    bool wanted, curves; ///< branches are followed; curves are followed, too
    size_t parameter;    ///< parameter of branches
    double bounds[2];    ///< its bounds
    size_t count;        ///< number of `at`
    double *at;          ///< [count] values at which they begin; none: at the first bound
    size_t second;       ///< second parameter of curves
    double second_bounds[2];
} user_branches;

/// Failure code for slopes that jump where their derivative is needed.
enum { USER_JUMP = INT_MIN };

/// The first failure of a run; after it slopes are NaN and motions end.
typedef struct user_failure {
    atomic_int code;     ///< the code that a function returned, or USER_JUMP; 0: no failure
    atomic_int reported; ///< 1 once the members below are written
    double time;
    size_t slope; ///< index of the slope that jumps
    double jump;  ///< size of the jump
} user_failure;

struct whirl_user_system {
    char title[256];
    char *identity; ///< identity of its functions; NULL: unknown
    size_t dimension, displacements;
    double *start;    ///< [dimension]
    double *angles;   ///< [dimension] periods of angles, 0 for other coordinates; NULL: no angles
    double *scales;   ///< [dimension] given scales of coordinates, 0 for others; NULL: none was given
    double *units;    ///< [dimension] units of coordinates in the library while a study runs (scales.c); NULL: 1
    long *calls_left; ///< number of slope evaluations left, after which slopes are NaN; NULL: any number. Used by one
                      ///< thread only
    size_t parameter_count, station_count, axis_count;
    whirl_parameter *parameters; ///< [parameter_count]
    whirl_probe *stations;       ///< [station_count]
    whirl_user_rates_fn rates;
    whirl_user_lanes_fn lanes;
    whirl_user_tangent_fn tangent;
    void *context, *tangent_context;
    double period;
    size_t speed; ///< index of the parameter that is the angular frequency; parameter_count or larger: `period` is used
    bool kinked,
        smooth; ///< kinked: slopes have kinks; smooth: slopes that jump are an error, since derivatives are used
    size_t event_count;
    user_event *events; ///< [event_count]
    user_axis axes[USER_AXES];
    user_branches branches;
    whirl_carry carry;
    whirl_analysis_set analyses;
    whirl_integrate_options integrate;
    whirl_record_options record;
    whirl_batch options; ///< members of whirl_batch_members; the others are not used
    user_failure *failure;
};

/// Calls the functions once, at the start. WHIRL_BAD_INPUT if they change their inputs or leave slopes unwritten, as
/// functions with another signature do; WHIRL_NO_MEMORY.
whirl_status user_check_form(const whirl_user_system *system);

/// Adds facts to a result that identify the equations.
whirl_status user_add_equations(const whirl_user_system *system, whirl_result *result);

/// Finds the index of a parameter. WHIRL_BAD_INPUT with the nearest name.
whirl_status user_require_parameter(const whirl_user_system *system, const char *name, size_t *index);

/// Prepares a copy of a system, which borrows the arrays of the user's system, and the study of its branches. Both are
/// valid as long as the user's system. WHIRL_BAD_INPUT if something incompatible is requested.
whirl_status user_prepare_branches(whirl_user_system *copy, whirl_study *study);

/// Rejects a study of equilibria if the system depends on time. WHIRL_BAD_INPUT, and errors of user_machine.
whirl_status user_check_rest(const whirl_study *study);

/// Writes the branches and curves that are followed.
void user_put_branches(const whirl_user_system *system, FILE *out);

/// Converts velocities of a table from the common time to the user's own, and periods and rates of branches to the
/// angle of a revolution, 2 pi. Errors of user_period.
whirl_status user_restore(const whirl_user_system *system, whirl_table *table);

/// Chooses the units of a copy's coordinates: given scales, and for others powers of two near the size of the motions
/// of the study's points, if one is far from 1. Adapts the limit of its batches. copy->units stays NULL if all are 1;
/// else the caller frees it. Motions that need too many slope evaluations count as unobserved. WHIRL_NO_MEMORY;
/// WHIRL_BAD_INPUT for scales that do not fit.
whirl_status user_choose_units(whirl_user_system *copy, whirl_study *study);

/// Warns in a result about coordinates of very different sizes without given scales. WHIRL_NO_MEMORY.
whirl_status user_warn_of_units(const whirl_user_system *system, whirl_result *result);

/// Writes the units of a system, if it has any.
void user_put_units(const whirl_user_system *system, FILE *out);

/// Computes the period of the system with these parameters [parameter_count]. WHIRL_BAD_INPUT if it is no number above
/// 0.
whirl_status user_period(const whirl_user_system *system, const double *parameters, double *period);

/// Makes a machine of the system with these parameters, for whirl_study.machine. stop: ends its motions early; NULL:
/// none.
whirl_status user_machine(const whirl_user_system *system, const double *parameters, const whirl_stop *stop,
                          whirl_machine *machine);

#endif
