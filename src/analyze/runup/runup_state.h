/// A run under way, between two parts of its turns.
#ifndef ANALYZE_RUNUP_STATE_H
#define ANALYZE_RUNUP_STATE_H

#include "runup.h"

/// The setting in which a state of the run is to be read: the machine, the variable (time or angle), the unbalances
/// that have appeared, and the turning of the shaft.
typedef struct runup_where {
    size_t side;
    bool by_time;
    size_t lost;
    whirl_turning how;
} runup_where;

/// A machine of the run, before or after changes, and its integrators.
typedef struct runup_side {
    whirl_running *machine;
    whirl_integrator *seen[2]; ///< by the angle, by time: with all samples
    whirl_integrator *part[2]; ///< by the angle, by time
} runup_side;

/// Weight of a sample of a part in means, and its factors 2 exp(-i k angle) in orders, before that weight.
typedef struct runup_weights {
    double share;
    double complex turned[RUNUP_ORDERS];
} runup_weights;

/// Numbers of a state that a station's probe reads: x, y, vx and vy, each a coordinate times its unit, or 0.
typedef struct runup_probe {
    size_t at[4];
    double unit[4];
    bool sees[4];
} runup_probe;

/// Phases of a run, by what it does next.
typedef enum runup_phase {
    PHASE_BEGIN,  ///< the run has not begun to settle
    PHASE_SETTLE, ///< the run settles at its first speed
    PHASE_START,  ///< the time of the run begins
    PHASE_TURN,   ///< a turn begins
    PHASE_PART,   ///< a part of a turn is carried
    PHASE_OVER
} runup_phase;

typedef struct runup_state {
    whirl_running *machine;                   ///< machine of sides[side]
    runup_side sides[1 + WHIRL_MAX_EVENTS];   ///< before all changes, after the first, ...
    size_t side, side_count;                  ///< index of the present side, and number of sides
    unsigned char happened[WHIRL_MAX_EVENTS]; ///< [side_count - 1] events of the course that changed the machine
    whirl_placed lost[RUNUP_EVENTS];          ///< [lost_count] unbalances that have appeared
    size_t lost_count;
    whirl_status status; ///< status of changes
    const runup_plan *plan;
    bool by_time;               ///< the variable is the time, not the angle
    const whirl_system *system; ///< system of that variable
    size_t rotor;               ///< length of the state before speed and time (and, by time, the angle)
    size_t dimension, most;     ///< dimension of the state now, and with the time as variable
    size_t probes, contacts, torques;
    size_t watched; ///< probes of stations and, behind them, of axial displacements
    size_t peaks;   ///< located extremes: largest radii of stations; then least, largest axial displacements
    double unit;
    whirl_turning how;
    double leg;                           ///< length of the next part of a turn, in units of time, or rad
    double *x;                            ///< [most] now
    double *begin;                        ///< [most] at the beginning of the turn
    double *samples;                      ///< [samples + 1][dimension] of the part
    double *scratch;                      ///< [3][most]
    double *placed;                       ///< [most] a state by the angle
    double *change;                       ///< [2][most] slopes, and a state next to another one
    double *slopes;                       ///< [samples + 1][most] of the samples, for the motion of a record; else NULL
    double *force;                        ///< [samples + 1][contacts] normal forces of the part
    double *torque;                       ///< [torques] at an instant
    double *speed;                        ///< [probes] at an instant
    double *largest, *share;              ///< [contacts] of the turn
    runup_station *stations;              ///< [watched] of the turn
    runup_probe *probe;                   ///< [watched]
    runup_weights *weights;               ///< [samples + 1] of the samples of a part
    double weights_passed, weights_step;  ///< part whose weights these are: its angle within the turn (NaN: none), and
                                          ///< the distance of its samples
    size_t spools, spool_state;           ///< shafts with a speed of their own, and place of the first one's angle
    runup_station *spool_stations;        ///< [spools][probes] of the present turn of each
    double spool_begin[WHIRL_MAX_SPOOLS]; ///< s, beginning of that turn; NaN: it is not whole
    double spool_turns[WHIRL_MAX_SPOOLS]; ///< whole turns completed
    double spool_before[WHIRL_MAX_SPOOLS]; ///< turns before the time of the run began
    double turns, angle0;                  ///< turns completed, and the angle of the first state
    double *peak_state;                    ///< [peaks][most] the sample before the extreme
    double *peak_from, *peak_length;       ///< [peaks] angle of this sample, and distance to the next sample
    runup_where *peak_where;               ///< [peaks] setting at this sample
    double *torque_state;                  ///< [torques][2][most] the samples before the largest and the least torque
    double *torque_length;                 ///< [torques][2] distances from these samples to the next ones
    runup_where *torque_where;             ///< [torques][2] settings at these samples
    bool parted;                           ///< an event happened in the turn
    double *copy;                          ///< [most] a motion that began nearby; NULL: none, or it was lost
    double size;                           ///< largest radius so far
    double growth, least, least_at; ///< logarithm of the growth of the copy's distance; the least so far, and its
                                    ///< time, s
    size_t settled;                 ///< turns of settling completed
    bool begun;                     ///< settling is over
    runup_phase phase;
    bool first;          ///< the turn is the first from standstill
    double passed;       ///< angle covered so far within the turn
    double from, length; ///< the part to be carried: angle of its beginning (0 with time as variable), and length
    double *end;         ///< [most] state at the beginning of the part; once carried, at its end
    double *copy_end;    ///< [most] end of the copy over that part, if lanes carry it
    bool copy_carried;   ///< lanes have carried the copy over the part
    unsigned settings;   ///< number of changes of the machine, of its turning and of its unbalances so far
    runup_run *run;
} runner;

/// Begins a run: makes its memory and integrators, and reads its saved state if there is one. runup_close frees them,
/// also after an error, which is in r->status.
void runup_open(runner *r, whirl_running *running, const runup_plan *plan, runup_run *run);
void runup_close(runner *r);

/// Goes on to the next part that must be carried: from the angle `from`, over `length`, with the state in `end`.
/// Returns false if the run is over, or r->status is an error.
bool runup_next(runner *r);

/// Carries the part of runup_next by integrators of this run alone.
whirl_motion runup_carry_alone(runner *r);

/// Processes the part of runup_next, which was carried to `end` with that result, with its samples.
void runup_take(runner *r, whirl_motion motion);

/// Completes the results of a run that is over.
void runup_finish(runner *r);

#endif
