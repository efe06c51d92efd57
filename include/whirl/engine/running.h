/// Machines whose speed changes: a rotor with the angle and the speed of its shaft among its states.
///
/// The shaft turns by a law of time, or a drive turns it: then
///
///     J theta'' = T - sum U_i g cos(theta + a_i) + sum u_i . q'',   u_i = U_i (sin(theta + a_i), -cos(theta + a_i)),
///
/// with T the torque of the drive less its load, the friction of contacts and the drag of films and seals, and
/// unbalances U_i at angles a_i. An unbalance that turns at n times the speed has n theta in place of theta, and n u_i
/// in both sums. The force of an unbalance is U_i theta'^2 (cos, sin)(theta + a_i) + u_i theta''. Shafts with a speed
/// of their own (whirl_spool) have such an equation each, with the unbalances, contacts and films on them; all theta''
/// together solve a small system, since every unbalance accelerates what others act on. Where a torque turns
/// a disc through its shaft it follows the disc's axis, and polar inertia adds no moment with theta'' (docs/theory.md).
/// Coefficients of films, bearings and seals are those of the speed of the moment.
///
/// The independent variable of the equations is the angle, d/dtheta in place of d/dt, 2 pi for one revolution. For a
/// machine that begins at rest, or hardly turns, it is the time.
#ifndef WHIRL_RUNNING_H
#define WHIRL_RUNNING_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Maximum number of events in the course of a run; maximum number of rows of a speed table; index that stands for no
/// event.
enum { WHIRL_MAX_EVENTS = 16, WHIRL_MAX_SPEEDS = 256, WHIRL_NO_EVENT = WHIRL_MAX_EVENTS };

/// An event of a run: it happens once, as soon as one of its conditions holds.
typedef struct whirl_run_event {
    double time;       ///< s, since the event `after`, or since the beginning of the run; NaN: the time is no condition
    double speed;      ///< rad/s, that the shaft passes; NaN: the speed is no condition
    size_t spool;      ///< shaft of that speed, and of the motor that trips: 0: the rotor's, from 1: whirl_spool
    int passing;       ///< 1: passed by a rising speed, -1: by a falling speed, 0: by either
    bool when;         ///< true if it happens when its formula is not below 0
    size_t after;      ///< the event that must have happened before; WHIRL_NO_EVENT: none
    bool trip;         ///< the motor trips
    bool end;          ///< the run ends
    bool changes;      ///< parameters of the machine have other values from then on
    whirl_placed lost; ///< the unbalance that appears; moment 0: none
} whirl_run_event;

/// Formulas of a run.
typedef enum whirl_run_formula {
    WHIRL_FORMULA_RATE,     ///< rate of the speed, rad/s2
    WHIRL_FORMULA_MOTOR,    ///< N m, torque of the motor
    WHIRL_FORMULA_LOAD,     ///< N m, torque of the load against the rotation
    WHIRL_FORMULA_GROUND_X, ///< m/s2, acceleration of the ground
    WHIRL_FORMULA_GROUND_Y,
    WHIRL_FORMULA_EVENT,                                          ///< formula of event 0; those of other events follow
    WHIRL_FORMULA_SPOOL = WHIRL_FORMULA_EVENT + WHIRL_MAX_EVENTS, ///< of the first whirl_spool, WHIRL_SPOOL_FORMULAS
    WHIRL_FORMULAS = WHIRL_FORMULA_SPOOL + 3 * WHIRL_MAX_SPOOLS
} whirl_run_formula;

/// Formulas of a shaft with a speed of its own (whirl_spool), behind WHIRL_FORMULA_SPOOL.
enum {
    WHIRL_SPOOL_SPEED, ///< rad/s, its speed by the time and the rotor's speed
    WHIRL_SPOOL_MOTOR, ///< N m, torque of its motor, by the time and its own speed
    WHIRL_SPOOL_LOAD,  ///< N m, torque of its load
    WHIRL_SPOOL_FORMULAS
};

/// Variables of formulas. All formulas may use the time and the speed; only those of events may use the variables of
/// stations.
enum {
    WHIRL_VARIABLE_TIME,  ///< s
    WHIRL_VARIABLE_SPEED, ///< rad/s: speed of the shaft; in a formula of a motor or load, of its station
    WHIRL_LAW_VARIABLES,
    WHIRL_VARIABLE_STATIONS = WHIRL_LAW_VARIABLES, ///< variables of every station, in the order of the constants below
    WHIRL_OF_STATION_X = 0,                        ///< m, from the centre
    WHIRL_OF_STATION_Y,
    WHIRL_OF_STATION_RADIUS,
    WHIRL_OF_STATION_VX, ///< m/s
    WHIRL_OF_STATION_VY,
    WHIRL_OF_STATION_SPEED,          ///< rad/s
    WHIRL_OF_STATION_AXIAL,          ///< m, displacement along the shaft; 0 where the station has none
    WHIRL_OF_STATION_AXIAL_VELOCITY, ///< m/s
    WHIRL_OF_STATION_TWIST,          ///< rad, relative to the mean turn; 0 where the station has none
    WHIRL_OF_STATION
};

/// Laws that give the speed of a shaft with a speed of its own.
typedef enum whirl_spool_law {
    WHIRL_SPOOL_RATE,       ///< a rate, 0 for a constant speed
    WHIRL_SPOOL_BY_TIME,    ///< a table over the time, straight between its rows
    WHIRL_SPOOL_BY_ROTOR,   ///< a table over the rotor's speed, monotone cubics between its rows
    WHIRL_SPOOL_BY_FORMULA, ///< WHIRL_SPOOL_SPEED
    WHIRL_SPOOL_DRIVEN      ///< its drive
} whirl_spool_law;

/// The course of a shaft with a speed of its own. Speeds are along its rotation.
typedef struct whirl_spool_course {
    whirl_spool_law law; ///< what gives its speed
    double from, to;     ///< rad/s: speed at the beginning, and at the end of the rate (0: none)
    double rate;         ///< rad/s2, the size of the rate
    double highest;      ///< rad/s, no higher speed occurs
    size_t count;        ///< rows of its table
    double at[WHIRL_MAX_SPEEDS], speeds[WHIRL_MAX_SPEEDS]; ///< [count] s or rad/s of the rotor, rising; and rad/s
} whirl_spool_course;

/// Events of a run, and its laws of time and speed, which supplement its options. Not to be shared between threads.
typedef struct whirl_run_course {
    size_t event_count;                                             ///< number of events
    whirl_run_event events[WHIRL_MAX_EVENTS];                       ///< [event_count]
    size_t speed_count;                                             ///< rows of the speed table; 0: none
    double speed_times[WHIRL_MAX_SPEEDS], speeds[WHIRL_MAX_SPEEDS]; ///< s, rising from 0, and rad/s; linear between
                                                                    ///< rows
    size_t spool_count;                                             ///< as in whirl_system
    whirl_spool_course spools[WHIRL_MAX_SPOOLS];                    ///< [spool_count]
    bool has[WHIRL_FORMULAS];                                       ///< formulas that are given
    double length;                                                  ///< m of one unit of displacement
    double *variables; ///< [WHIRL_VARIABLE_STATIONS + WHIRL_OF_STATION * stations] that formulas read
    void *owner;       ///< passed to `value`
    /// Returns the value of a formula with the present variables; NaN if it has none.
    double (*value)(void *owner, whirl_run_formula formula);
} whirl_run_course;

/// Returns the index of the first row after a time, s, in a table of a course with times [count] that rise, or `count`
/// if there is none.
size_t whirl_run_row_after(size_t count, const double *times, double time);

/// The motion of a shaft with a speed of its own: what gives its speed now.
typedef struct whirl_spool_turning {
    whirl_spool_law law; ///< what gives its speed
    double rate;         ///< rad/s2, with a rate or a table over the time
    bool tripped;        ///< the motor of its drive is lost, its load is not
} whirl_spool_turning;

/// The motion of the shaft: its rate or drive, and the events that have happened.
typedef struct whirl_turning {
    bool driven;                    ///< the torques of the machine's drive turn the shaft; else it has the given rate
    double rate;                    ///< rad/s2; the formula of the course is added
    bool tripped;                   ///< the motor of the drive is lost, its load is not
    bool lost;                      ///< unbalances that were set by `lose` have appeared
    bool dragless;                  ///< films and seals do not brake the shaft: the load of the drive includes their
                                    ///< drag
    const whirl_run_course *course; ///< laws of time and speed, or NULL
    whirl_spool_turning spools[WHIRL_MAX_SPOOLS]; ///< shafts with a speed of their own
} whirl_turning;

/// Torques on the shaft, N m, in the sense of the rotation.
typedef struct whirl_torques {
    double motor;          ///< torque of all motors; NaN at a given rate, like the next three
    double load, friction; ///< load and all other torques; friction in contacts; below 0 where they brake
    double drag;           ///< drag of films and seals
    double rotor;          ///< torque of unbalances, by the rotor's motion and by their weight
    double acceleration;   ///< rad/s2
} whirl_torques;

/// Torques on one of the shafts of a machine with several, N m, in the sense of its rotation. Their sum is `inertia`.
/// All but the speed are NaN where a law gives its speed.
typedef struct whirl_shaft_torques {
    double motor, load, friction, rotor, drag; ///< as in whirl_torques, of this shaft alone. Where stations twist, what
                                               ///< acts on the machine as a whole is dealt out by inertia
    double gears;   ///< of gears, and of all else that acts; NaN where the polar inertia of a shaft with a ratio is 0
    double inertia; ///< polar inertia about axes through centres of mass, times the acceleration
    double speed;   ///< rad/s, where stations twist the mean by inertia
} whirl_shaft_torques;

/// The motion of a run at equal times, as sensors of a data set take it, or at given times. Instants before the
/// beginning of the run have its first state.
typedef struct whirl_run_motion {
    size_t probes, count; ///< stations, instants
    double from, step;    ///< s: time of the first instant, and between instants
    const double *times;  ///< [count] s, that rise, in place of `from` and `step`; NULL: equal times; borrowed
    size_t filled;        ///< number of instants that the run has reached so far
    double *x;            ///< [probes][2][count] displacements x and y, in the machine's unit of length
    double *angle;        ///< [count] rad, angle of the shaft
} whirl_run_motion;

/// A machine whose speed changes; not to be shared between threads.
typedef struct whirl_running whirl_running;

/// Equations and functions of a machine whose speed changes.
struct whirl_running {
    /// The equations by the angle, [dimension]: the rotor's state, with derivatives by the angle, states of motors,
    /// then the speed and the time. Their period is the part that was last set, their time the angle from its
    /// beginning.
    const whirl_system *by_angle;
    /// By time, [dimension + 1]: the same with derivatives by time, and the angle as the last number.
    const whirl_system *by_time;
    bool in_time;           ///< only by_time is valid for this machine: torques depend on time, or stations twist
    double unit;            ///< speeds in states are multiples of it, rad/s; its inverse, s, is the unit of time
    double error;           ///< relative interpolation error of numbers between the speeds of the tables; 0: exact
    bool geared;            ///< unbalances turn at fixed ratios of the shaft's speed
    size_t driver;          ///< station of the first motor, whose speed triggers events; the number of stations if no
                            ///< station twists
    size_t spool_count;     ///< shafts with a speed of their own (whirl_system.spools)
    size_t spool_state;     ///< index of the angle of the first of them, rad along its rotation, in states; its speed
                            ///< follows, over `unit`, then angle and speed of the next
    size_t shaft_count;     ///< as whirl_system.shaft_count
    const size_t *shaft_of; ///< [probe_count] shaft of each station, from 0; that of the motor, or the rotor's, is 0;
                            ///< those with a speed of their own follow
    size_t contact_count;   ///< number of contacts
    size_t watched_count;   ///< number of watched torques: those at stations (motors and others), then those between
                            ///< twists

    /// Sets how the shaft turns from now on.
    void (*turn)(whirl_running *running, const whirl_turning *how);

    /// Sets unbalances [count] that appear once whirl_turning.lost is true.
    void (*lose)(whirl_running *running, size_t count, const whirl_placed *placed);

    /// Lets the next revolution of both systems begin at the angle (or time) `from` and have this length, in radians
    /// (or units of time).
    void (*part)(whirl_running *running, double from, double length);

    /// Takes over a state of the machine `from` before its change (whirl_running_check_change), by the angle or by
    /// time: displacements, speeds and angles of all stations in x stay. Returns the change of the shaft's angle, the
    /// mean over its stations, rad.
    double (*adopt)(const whirl_running *running, const whirl_running *from, bool by_time, double *x);

    /// Turns the derivatives of a state by time into those by the angle; its last number stays.
    void (*to_angle)(const whirl_running *running, double *x);

    /// Finds the torques on the shaft in a state by the angle, at that angle.
    void (*torques)(const whirl_running *running, const double *x, double angle, whirl_torques *out);

    /// Finds the torques on the shafts with a speed of their own, out [spool_count], along their rotations, likewise.
    void (*spool_torques)(const whirl_running *running, const double *x, double angle, whirl_torques *out);

    /// Finds the torques on all shafts of a machine with several, out [shaft_count], likewise.
    void (*shaft_torques)(const whirl_running *running, const double *x, double angle, whirl_shaft_torques *out);

    /// Sets the speeds of the shafts that follow a formula or the rotor's speed in a state. It changes by the errors of
    /// the integration.
    void (*follow)(const whirl_running *running, double *x);

    /// Writes the torques that are watched, N m, in a state by the angle, at that angle: of a motor in the sense of its
    /// station's rotation, between twists positive where the first station drives the second.
    void (*watch)(const whirl_running *running, const double *x, double angle, double *torque);

    /// Writes the stations of a watched torque, and the name of its element. The second station is the number of
    /// stations for a torque that acts on one station only.
    void (*watched)(const whirl_running *running, size_t index, size_t station[2], const char **name);

    /// Writes the speed of every station, rad/s in the sense of the rotation of its shaft, in a state by the angle; the
    /// speed of the shaft where a station does not twist.
    void (*speeds)(const whirl_running *running, const double *x, double *speed);

    /// Returns the next instant after `time`, s, at which a torque begins; infinite if there is none.
    double (*begins)(const whirl_running *running, double time);

    /// Writes normal forces of contacts, N, in a state by the angle.
    void (*contacts)(const whirl_running *running, const double *x, double *normal_force);

    /// Returns the index of the switching function that is 0 where a contact closes.
    size_t (*contact_switch)(const whirl_running *running, size_t contact);

    /// Returns the equations by the angle for ensembles, whose time is the angle itself, or NULL if the machine, as it
    /// turns now, does not run in lanes. An ensemble knows the machine as it was when it was loaded. derived: with the
    /// derivatives that implicit methods need.
    const whirl_system *(*in_lanes)(const whirl_running *running, bool derived);

    /// Frees the machine.
    void (*release)(whirl_running *running);
};

/// Makes the machine at a speed in rad/s, above 0; spools: speeds of the shafts with a speed of their own
/// [WHIRL_MAX_SPOOLS], of which the first count, along their rotations, or NULL for those of their keys. All have one
/// structure and length scale.
typedef whirl_status whirl_machine_at(const void *context, double speed, const double *spools, whirl_machine *machine);

/// The range of a shaft with a speed of its own in a run.
typedef struct whirl_spool_range {
    double highest; ///< rad/s, above 0: no higher speed occurs
    bool driven;    ///< its drive turns it at some time
} whirl_spool_range;

/// Checks that the speed of a system's shaft can change. driven: by the torques of the machine. WHIRL_BAD_INPUT with a
/// sentence for systems that are not rotors, have a phase of their own, have no inertia, or have stations that twist
/// without a drive.
whirl_status whirl_running_check(const whirl_system *system, bool driven);

/// Checks that a machine may change into another one in a run. WHIRL_BAD_INPUT with a sentence for other parts or
/// another length scale.
whirl_status whirl_running_check_change(const whirl_system *system, const whirl_system *changed);

/// Makes a machine whose speed changes from `lowest` (>= 0) to `highest` rad/s, by its torques if `driven`. It
/// determines how the numbers of the rotor depend on the speed: as powers from -2 to 2 if these fit to rounding, else
/// as cubic splines (whirl_running.error). spools: ranges of the shafts with a speed of their own
/// [whirl_system.spool_count]; NULL if there are none, or all keep the speeds of their keys. A number that depends on
/// the speeds of two shafts is a product, a sum, or a function of the sum or difference of both speeds, times a power
/// of the rotor's. WHIRL_BAD_INPUT with a sentence if machines are not rotors, change their structure with the speed,
/// have a phase of their own, or have a number that depends on two speeds in another way; WHIRL_NO_MEMORY; errors of
/// `machine`. Freed by its `release`.
whirl_status whirl_running_new(whirl_machine_at *machine, const void *context, double lowest, double highest,
                               bool driven, const whirl_spool_range *spools, whirl_running **out);

#ifdef __cplusplus
}
#endif
#endif
