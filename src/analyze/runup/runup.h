/// A run of a machine whose speed changes. It is carried turn by turn and stops at the instants of events; each turn's
/// amplitudes, means and contacts go to rows over the time.
#ifndef ANALYZE_RUNUP_H
#define ANALYZE_RUNUP_H

#include <complex.h>

#include "archive.h"
#include "turn_history.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/record.h"
#include "whirl/engine/running.h"

/// Orders of the speed whose amplitudes are tracked, from 1 on.
enum { RUNUP_ORDERS = 4 };

/// End of a run.
typedef enum runup_end {
    RUNUP_DONE,     ///< reached its time or its last speed
    RUNUP_STALLED,  ///< the shaft came to rest, or never turned
    RUNUP_DIVERGED, ///< the motion left all bounds
    RUNUP_STUCK,    ///< the solver could not go on
    RUNUP_STOPPED   ///< the caller stopped it: the results are meaningless
} runup_end;

/// A station's motion over a turn of the shaft, in the machine's unit of length.
typedef struct runup_station {
    double radius;                                   ///< largest distance from the centre
    double least, largest;                           ///< x of a probe besides those of stations; 0 for these
    double mean[2];                                  ///< means of x and y over the turn
    double complex x[RUNUP_ORDERS], y[RUNUP_ORDERS]; ///< 2/turn times the integrals of x and y times exp(-i k theta)
} runup_station;

/// Torques on the shaft in results: motor, load, friction, rotor, drag.
enum { RUNUP_SHAFT_TORQUES = 5 };

/// Writes the torques on the shaft in the order of results.
static inline void runup_list_torques(const whirl_torques *of, double out[RUNUP_SHAFT_TORQUES]) {
    out[0] = of->motor, out[1] = of->load, out[2] = of->friction, out[3] = of->rotor, out[4] = of->drag;
}

/// Writes the numbers of a shaft of a machine with several, in the order of results.
static inline void runup_list_shaft(const whirl_shaft_torques *of, double out[RUNUP_SHAFT_NUMBERS]) {
    out[0] = of->motor, out[1] = of->load, out[2] = of->friction, out[3] = of->rotor, out[4] = of->drag;
    out[5] = of->gears, out[6] = of->inertia, out[7] = of->speed;
}

/// A turn of the shaft.
typedef struct runup_turn {
    double time, speed;            ///< s, rad/s, at the turn's middle
    double end;                    ///< s, at the turn's end
    double turns;                  ///< turns of the shaft since the beginning
    bool whole;                    ///< the run does not end within the turn: means and orders count
    bool parted;                   ///< an event happened in the turn, such as a trip or the end of a rate
    whirl_torques torques;         ///< torques at the turn's end
    const runup_station *stations; ///< [probe_count + extra_count] those of whirl_system.extras, as x, come last
    const double *force;           ///< [contact_count] N, largest normal force
    const double *share;           ///< [contact_count] share of the turn in contact
    const double *samples; ///< samples as in turn_samples; NULL if the run ends within the turn, or the plan has none
} runup_turn;

/// A turn of a shaft with a speed of its own.
typedef struct runup_spool_turn {
    size_t spool;                  ///< from 0
    double time, speed;            ///< s and rad/s along its rotation, at its middle
    double end;                    ///< s, at its end
    double turns;                  ///< turns of this shaft since the beginning
    const runup_station *stations; ///< [probe_count] means and orders of this shaft's angle; no radii
    whirl_torques torques;         ///< at its end
} runup_spool_turn;

/// A contact over the run. Times in s; NaN if it never closed.
typedef struct runup_contact {
    double first, last; ///< when it closed first, and opened last
    double count, time; ///< number of closings, and time in contact
} runup_contact;

/// The largest distance of a station from the centre, or the largest axial displacement, or the largest one in the
/// opposite direction (as a number above 0).
typedef struct runup_peak {
    double radius, time, speed;
} runup_peak;

/// The largest or least value of a torque, N m, and when that was, s.
typedef struct runup_extreme {
    double value, time;
} runup_extreme;

/// The extremes of a torque that was watched.
typedef struct runup_torque {
    runup_extreme largest, least;
} runup_torque;

/// An event, and when it happened.
typedef struct runup_happening {
    whirl_run_event is;
    double time, at; ///< s and rad/s of the shaft; NaN: never
} runup_happening;

/// Maximum number of events: a trip and a loss of the options, and the events of a course.
enum { RUNUP_EVENTS = WHIRL_MAX_EVENTS + 2 };

/// Writes the events of the options themselves, a trip and a loss, to out [RUNUP_EVENTS]; returns their number. A
/// system without stations (probe_count 0) gets station 0 for the loss.
size_t runup_events_of(const whirl_runup_options *options, const whirl_system *system, runup_happening *out);

/// The results of a run.
typedef struct runup_run {
    runup_end end;
    double time, speed, turns;                                           ///< at its end: s, rad/s, turns of the shaft
    double spool_speed[WHIRL_MAX_SPOOLS], spool_turns[WHIRL_MAX_SPOOLS]; ///< the same, for shafts with own speeds
    double error;            ///< largest interpolation error of the numbers of its machines
    double sensitivity[4];   ///< as in the field runup/sensitivity
    size_t event_count;      ///< number of events that may happen
    runup_happening *events; ///< [event_count] those of the options, then those of the course
    runup_peak *peaks; ///< [probe_count + 2 extra_count] located: the radius of each station; then for each station
                       ///< that moves along its shaft the displacements against and in the direction of growing
                       ///< positions. -INFINITY: never seen
    runup_contact *contacts; ///< [contact_count] located
    runup_torque *torques;   ///< [watched_count] located
    double *last;            ///< [dimension by the angle] the last state
} runup_run;

/// Receives a turn.
typedef void runup_see(void *context, const runup_turn *turn);

/// A run between two of its turns.
typedef struct runup_state runup_state;

/// Writes everything that the rest of a run depends on to an archive, or reads it from there, to the bit. For reading,
/// the run must have the same machine and plan; a state that does not fit leaves the run unusable, and the archive
/// reports that.
void runup_archive(runup_state *state, archive *a);

/// Returns the number of turns so far, of settling and of the run.
double runup_turns_of(const runup_state *state);

/// Receives torques [watched_count], N m, and speeds of stations [probe_count], rad/s, at instants dense enough to show
/// their course.
typedef void runup_watch_at(void *context, double time, const double *torque, const double *speed);

/// Plan of a run.
typedef struct runup_plan {
    const whirl_runup_options *options;
    const whirl_run_course *course; ///< laws and events, or NULL
    /// Makes the machine after events [count] of the course, in this order; see whirl_running.adopt.
    whirl_status (*change)(const void *context, size_t count, const unsigned char *happened, whirl_running **running);
    const void *change_context;
    whirl_integrate_options integrate;
    const double *start; ///< [start_count] the rotor's displacements, then velocities by time over the unit of speed
    size_t start_count;
    double angle; ///< rad of the first state
    runup_see *see;
    void (*see_spool)(void *context,
                      const runup_spool_turn *turn); ///< receives turns of shafts with a speed of their own
    runup_watch_at *watch;                           ///< watcher of machines that are run by time; NULL: none
    void *context;
    turn_samples *samples;    ///< filled in before a turn is shown; NULL: none are wanted
    whirl_run_motion *motion; ///< filled in as the run proceeds, with time as the variable; NULL: not wanted
    /// Called after every whole turn, also of settling: the state may be saved. NULL: not called.
    void (*turned)(void *context, runup_state *state);
    /// Reads a saved state, with which the run continues. Returns false if the state does not fit. NULL: the run begins
    /// at its start.
    bool (*resume)(void *context, runup_state *state);
} runup_plan;

/// Returns true if a run is followed by a copy that began nearby, which shows how fast small changes grow.
bool runup_wants_copy(const whirl_runup_options *options, size_t contacts);

/// A run to be carried out, and its status: WHIRL_BAD_INPUT if a saved state does not fit; WHIRL_NO_MEMORY, and errors
/// of integrators and machines.
typedef struct runup_task {
    whirl_running *running;
    const runup_plan *plan;
    runup_run *run; ///< the caller owns peaks, contacts, torques, events [RUNUP_EVENTS] and last
    whirl_status status;
} runup_task;

/// Carries out runs with the same options, in vector lanes where these take them, otherwise one after the other. No bit
/// of a run depends on the others (runup_together.c).
void runup_carry_together(size_t count, runup_task *tasks);

#endif
