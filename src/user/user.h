/// What a user's system consists of.
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
    USER_AXES = 3 ///< of a study
};

typedef struct user_axis {
    size_t parameter, count;
    double *values; ///< [count]
} user_axis;

/// Branches that are followed in the place of motions, and curves of their special points.
typedef struct user_branches {
    bool wanted, curves; ///< whether there are any
    size_t parameter;    ///< over which branches go
    double bounds[2];    ///< between which
    size_t count;        ///< of `at`
    double *at;          ///< [count] values at which they begin; none: at the first bound
    size_t second;       ///< parameter of curves
    double second_bounds[2];
} user_branches;

/// A slope that jumps where its derivative was asked for, in place of what a function gave.
enum { USER_JUMP = INT_MIN };

/// What failed first: no motion is computed after that.
typedef struct user_failure {
    atomic_int code; ///< that a function gave, or USER_JUMP; 0: none failed
    atomic_int told; ///< one thread writes what follows
    double time;
    size_t slope; ///< of a jump: which
    double jump;  ///< by how much
} user_failure;

struct whirl_user_system {
    char title[256];
    char *identity; ///< of its functions; NULL: not known
    size_t dimension, displacements;
    double *start;    ///< [dimension]
    double *angles;   ///< [dimension] periods of angles, 0 of what is none; NULL: there are none
    double *scales;   ///< [dimension] of coordinates: what was given, 0 of the others; NULL: none was given
    double *units;    ///< [dimension] by which the library counts coordinates while a study runs (scales.c); NULL: 1
    long *calls_left; ///< NULL, or how often slopes may still be taken: the rest are not numbers; by one thread
    size_t parameter_count, station_count, axis_count;
    whirl_parameter *parameters; ///< [parameter_count]
    whirl_probe *stations;       ///< [station_count]
    whirl_user_rates_fn rates;
    whirl_user_lanes_fn lanes;
    whirl_user_tangent_fn tangent;
    void *context, *tangent_context;
    double period;
    size_t speed; ///< index of the parameter that is the angular frequency; parameter_count or beyond: `period` counts
    bool kinked, smooth; ///< of slopes; `smooth`: a derivative is followed that knows of no jump
    user_axis axes[USER_AXES];
    user_branches branches;
    whirl_carry carry;
    whirl_analysis_set analyses;
    whirl_integrate_options integrate;
    whirl_record_options record;
    whirl_batch options; ///< of which whirl_batch_members alone count
    user_failure *failure;
};

/// Calls the functions once, at the start. WHIRL_BAD_INPUT where they change what they are given or leave slopes
/// unwritten, as functions of another form do; WHIRL_NO_MEMORY.
whirl_status user_check_form(const whirl_user_system *system);

/// Facts of a result that tell the equations from others.
whirl_status user_add_equations(const whirl_user_system *system, whirl_result *result);

/// The index of a parameter. WHIRL_BAD_INPUT with the nearest name.
whirl_status user_require_parameter(const whirl_user_system *system, const char *name, size_t *index);

/// Makes a copy of a system, which borrows all of the user's, and its study those of its branches: both last as long as
/// the system. WHIRL_BAD_INPUT where something else is asked for besides.
whirl_status user_prepare_branches(whirl_user_system *copy, whirl_study *study);

/// Refuses equilibria of a system that something drives in time. Errors as those of machines.
whirl_status user_check_rest(const whirl_study *study);

/// Writes which branches and curves are followed.
void user_tell_branches(const whirl_user_system *system, FILE *out);

/// Puts the numbers of a table, which are by the common time, in the user's own: velocities. Frequencies and periods of
/// branches become those by the angle of a revolution, 2 pi. Errors as user_period.
whirl_status user_restore(const whirl_user_system *system, whirl_table *table);

/// Chooses the units of a copy's coordinates: scales that were given, and for the others powers of two about the size
/// that motions of the study's points have, where one is far from 1. Adapts the limit of its batches to them. units and
/// what they are of stay NULL where all are 1; else they are freed with free. Motions that take too many slopes count
/// as not seen. WHIRL_NO_MEMORY; WHIRL_BAD_INPUT for scales that do not fit.
whirl_status user_choose_units(whirl_user_system *copy, whirl_study *study);

/// Warns in a result of coordinates of very different sizes whose scales were not given. WHIRL_NO_MEMORY.
whirl_status user_warn_of_units(const whirl_user_system *system, whirl_result *result);

/// Writes the units of a system that has some.
void user_tell_units(const whirl_user_system *system, FILE *out);

/// The period of the system with these parameters [parameter_count]. WHIRL_BAD_INPUT where it is no number above 0.
whirl_status user_period(const whirl_user_system *system, const double *parameters, double *period);

/// A machine of the system with these parameters, for whirl_study.machine.
whirl_status user_machine(const whirl_user_system *system, const double *parameters, whirl_machine *machine);

#endif
