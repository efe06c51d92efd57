/// Recording a motion: states once per revolution, waveforms, extremes, contact statistics and the growth of a small
/// perturbation, gathered while the integrator runs. Analyses (whirl/engine/analyze.h) turn a record into numbers.
#ifndef WHIRL_RECORD_H
#define WHIRL_RECORD_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/fit.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/orbit.h"
#include "whirl/engine/system.h"
#include "whirl/engine/watched.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Perturbations that are followed while a motion is watched.
typedef enum whirl_growth {
    WHIRL_GROWTH_NONE = 0, ///< none
    WHIRL_GROWTH_LARGEST,  ///< one, by a second trajectory; possible for any system
    WHIRL_GROWTH_ALL       ///< as many as the state has coordinates, by the system's Jacobian
} whirl_growth;

/// Largest numbers of revolutions in cases and result files.
enum { WHIRL_MAX_TRANSIENT = 1000000000, WHIRL_MAX_RECORD = 100000000 };

/// Options of the search for branches of orbits.
typedef struct whirl_trace_options {
    /// Start of the search for the first orbit: "settled", where a motion has settled after the transient; "start",
    /// the initial state; "linear", the forced response of the machine linearized about its equilibrium. The last two
    /// also find unstable orbits.
    char begin[WHIRL_NAME_SIZE];
    bool rest;             ///< follow branches of equilibria instead of orbits
    int revolutions;       ///< revolutions of the first orbit; 0: the period of the settled motion
    int longest;           ///< most revolutions of an orbit
    int switches;          ///< most switches from one branch to those that begin along it
    int segments;          ///< as in whirl_orbit_options
    int points;            ///< most points of all branches
    double step;           ///< whirl_branch_options.most_step
    double rtol;           ///< relative tolerance of the integrator
    bool tori;             ///< also follow the tori that begin at Neimark-Sacker points
    int torus_nodes;       ///< most nodes of a torus' curve; see whirl_trace_torus_nodes
    int torus_points;      ///< most points of one branch of tori
    double torus_step;     ///< whirl_torus_branch_options.most_step
    double torus_accuracy; ///< whirl_torus_options.accuracy
} whirl_trace_options;

/// Returns the most nodes of a torus' curve: the option torus_nodes, raised to the next odd number if it is even.
size_t whirl_trace_torus_nodes(const whirl_trace_options *options);

/// Returns the members of the options for cases (part "branch") and results of branches; static, ended by a member
/// without a part.
const whirl_member *whirl_trace_members(void);

/// The 1X of a station at a speed is slow roll if it changes by at most this share of its largest in the run, within
/// WHIRL_SLOW_ROLL_RANGE of the speed.
#define WHIRL_MAX_SLOW_ROLL_CHANGE 0.05
/// Half-width of the range of speeds in which the change of slow roll is measured, as a share of the speed.
#define WHIRL_SLOW_ROLL_RANGE 0.1

/// Number of waveforms that a run stores: one around the largest motion (for a contact, the largest force), and one
/// around each of its first four events.
enum { WHIRL_RUNUP_WAVEFORMS = 5 };

/// Options of a run-up or coast-down.
typedef struct whirl_runup_options {
    double from, to;               ///< rad/s, speed at the beginning (0: at rest) and at the end of the rate (0: none)
    double rate;                   ///< rad/s2, size of the rate; 0: the machine's drive turns the shaft
    double duration;               ///< s; 0: until the speed `to` is reached
    double angle;                  ///< rad, angle of the shaft at the beginning
    char begin[WHIRL_NAME_SIZE];   ///< state at the beginning: "rest", "centre" or "steady"
    double settle;                 ///< turns at the first speed before a "steady" beginning
    double trip_time, trip_speed;  ///< s and rad/s at which the motor trips; 0: never
    char loss_at[WHIRL_NAME_SIZE]; ///< station where an unbalance appears, or ""
    double loss_moment, loss_angle, loss_time, loss_speed; ///< kg m, rad, s, rad/s
    char change[WHIRL_NAME_SIZE];                          ///< names of parameters that change in the run, or ""
    double change_time, change_speed;                      ///< time (s) and speed (rad/s) of the change; 0: does not
                                                           ///< depend on it
    char events[WHIRL_NAME_SIZE];                          ///< number of further events as text, or ""
    int event_count; ///< number of events of the course (whirl_run_course), including the change of parameters
    char shafts[WHIRL_NAME_SIZE];     ///< names of the shafts with a speed of their own, separated by blanks, or ""
    int shaft_count;                  ///< number of these shafts
    char speeds[WHIRL_NAME_SIZE];     ///< text of the speed over the time, or ""
    char rate_law[WHIRL_NAME_SIZE];   ///< formula of the rate, or ""
    char torque_law[WHIRL_NAME_SIZE]; ///< formula of the motor's torque, or ""
    char load_law[WHIRL_NAME_SIZE];   ///< formula of the load, or ""
    char ground_x[WHIRL_NAME_SIZE], ground_y[WHIRL_NAME_SIZE]; ///< formulas of the ground's acceleration, or ""
    char sensitivity[WHIRL_NAME_SIZE]; ///< "yes", "no", or "contacts" (only in machines with contacts): a perturbed
                                       ///< copy of the run is followed
    bool drag;                         ///< true if films and seals brake a shaft that a drive turns
    int stationary;                    ///< speeds at which the torques of a drive are balanced; 0: none
    int rows;                          ///< number of rows of the result over the time
    int samples;                       ///< samples of a turn
    double rtol;                       ///< relative tolerance
    double atol;                       ///< absolute tolerance, in length scales; 0: 1e-3 rtol
    char method[WHIRL_NAME_SIZE];      ///< name of whirl_method_at
    int spectra;                       ///< number of spectra over the time; 0: none
    int spectrum_turns;                ///< turns of the shaft in a spectrum
    double highest_order;              ///< spectra reach up to this order of the speed
    double slow_roll;                  ///< rad/s, speed of the slow roll; 0: none
    int orbits;                        ///< number of orbits over the time; 0: none
    int waveform;                      ///< turns of a waveform; 0: none
} whirl_runup_options;

/// Returns the members of these options for cases (part "runup") and results; static, ended by a member without a part.
const whirl_member *whirl_runup_members(void);

/// Returns true if the torques of the machine turn the shaft: the run has no rate, table of speeds or formula of the
/// rate.
bool whirl_runup_driven(const whirl_runup_options *options);

/// Writes the name of a shaft with a speed of its own, by its index from 0 to before shaft_count.
void whirl_runup_shaft_name(const whirl_runup_options *options, size_t index, char name[WHIRL_NAME_SIZE]);

/// Returns the length of the run in s, as planned.
double whirl_runup_duration(const whirl_runup_options *options);

/// Checks these options. WHIRL_BAD_INPUT with a sentence for options that mean nothing or contradict each other.
/// driven: the machine has a drive, whose motor has the speed `no_load` without load, rad/s; 0: no such speed.
whirl_status whirl_runup_check(const whirl_runup_options *options, bool driven, double no_load);

/// Options of a data set.
typedef struct whirl_dataset_options {
    int machines;          ///< number of machines; 0: there is no data set
    int records;           ///< records of each machine with each label
    int seed;              ///< seed of all random numbers
    int only;              ///< number of the only record that is made, from 1; 0: all
    double turns;          ///< revolutions of a record; 0: as many as its samples take
    double per_revolution; ///< samples of a revolution; 0: samples are taken at `rate`
    double rate;           ///< Hz
    int samples;           ///< samples of a channel
    double train;          ///< share of machines for training
    double validation;     ///< share of machines for validation; the rest is for testing
    double lead;           ///< revolutions computed before and after the samples
    int labels;            ///< number of labels
    int channels;          ///< number of channels
    int parameters;        ///< number of parameters that differ between records
} whirl_dataset_options;

/// Returns the members of these options for cases (part "dataset") and results; static, ended by a member without a
/// part.
const whirl_member *whirl_dataset_members(void);

/// Length and contents of the record of a motion.
typedef struct whirl_record_options {
    int transient; ///< revolutions before the record, >= 0
    int record;    ///< revolutions recorded, >= 1
    /// Last revolutions in which the Poincare section and the growth of a perturbation are followed, record <= watch <=
    /// transient + record; 0: the record and the second half of the transient, but of that at most the larger of 1000
    /// and record.
    int watch;
    int waveform_revolutions; ///< last revolutions whose waveform is stored in results, 0 <= ... <= record
    /// Least samples of the waveform per revolution (the next divisor of steps_per_revolution is used).
    int samples_per_revolution;
    double highest_order; ///< spectra are kept up to this order of the running speed
    bool bearings; ///< for critical speed maps: the parameter is the stiffness of springs that replace bearings, N/m
    /// When the motion has settled on a periodic orbit to 1e-11, skip the rest of the transient except its last 64
    /// revolutions.
    bool settle;
    int modes;             ///< number of modes in results, >= 1
    int orders;            ///< highest order of the speed that excites torsion; all orders from 1 on do; 0: none
    double line_frequency; ///< mains frequency, Hz; it and twice this frequency excite torsion; 0: none
    double running_low, running_high; ///< range of running speed, rad/s; 0: not given
    double trip;                      ///< speed, rad/s, up to which clearances are checked; 0: all speeds
    double probe_angle;               ///< angle of the first probe of every station, rad from the x axis towards y
    int antinodes_of;                 ///< forward mode whose antinodes have unbalances by rule; 0: none
    char placed_at[WHIRL_NAME_SIZE];  ///< station that has an unbalance by rule, or ""
    char probes_at[WHIRL_NAME_SIZE];  ///< stations whose probes scale responses, or ""
    double placed_weight;             ///< mass for the rule of this unbalance, kg; 0: the overhanging mass there
    double placed_factor;             ///< factor of unbalances by rule
    char coupling[WHIRL_NAME_SIZE];   ///< statics: stations at which bearings are raised until moment and shear vanish,
                                      ///< or ""
    double gas_density;               ///< stability, kg/m3: mean density of the gas; 0: not given
    bool spectra;                     ///< store whole spectra, not only their peaks
    bool waveform;                    ///< record waveforms (for spectra, or to be stored)
    /// Search for the orbits of settled motions by Newton's method. With `settle`, also search before they have
    /// settled, and end the transient when the motion is certain to settle on one.
    bool orbits;
    whirl_growth growth;           ///< perturbations that are followed; each costs one more trajectory while the motion
                                   ///< is watched
    whirl_trace_options trace;     ///< for branches only
    whirl_runup_options runup;     ///< options of run-ups
    whirl_fit_options fit;         ///< options of fits
    whirl_dataset_options dataset; ///< options of data sets
} whirl_record_options;

/// Returns the members of the options for cases (parts "integrate" and "keep", and "detail" for options that a detail
/// replaces) and results; static, ended by a member without a part.
const whirl_member *whirl_record_members(void);

/// Returns the defaults of whirl_record_members and whirl_trace_members, but with settle false.
whirl_record_options whirl_record_default(void);

/// Returns the number of watched revolutions, with the default resolved.
int whirl_record_watch(const whirl_record_options *options);

/// Returns the samples of a waveform per revolution: the smallest divisor of `steps_per_revolution` that is at least
/// options->samples_per_revolution.
int whirl_record_samples(const whirl_record_options *options, int steps_per_revolution);

/// Returns WHIRL_BAD_INPUT with a sentence if an option is out of range or options contradict each other.
whirl_status whirl_record_options_check(const whirl_record_options *options);

/// Checks the same, and that all perturbations can be followed if they are requested: the system needs a Jacobian, and
/// a method that carries them.
whirl_status whirl_record_check(const whirl_system *system, const whirl_integrate_options *integrate,
                                const whirl_record_options *options);

/// Accuracy of the steps for a motion. For fixed steps it is computed from the equations. For methods with a tolerance
/// it is estimated from the motion's size over the absolute tolerance: growth is NaN, and error is NaN if the tolerance
/// is fine enough.
typedef struct whirl_step_quality {
    double growth; ///< whirl_step_check.growth of the checked revolutions: above 1 the step is unstable
    double error;  ///< error of a revolution by the steps, over the size of the motion
    double factor; ///< factor by which the number of steps should grow, 1 if it is sufficient
} whirl_step_quality;

/// Outcomes of the search for the orbit of a settled motion.
typedef enum whirl_orbit_search {
    /// No search: the motion does not return, it would cost too much, or there is no Jacobian.
    WHIRL_ORBIT_UNSOUGHT = 0,
    WHIRL_ORBIT_STABLE,    ///< the motion is on the orbit, and all multipliers are inside the unit circle
    WHIRL_ORBIT_UNSTABLE,  ///< a multiplier is on the unit circle or beyond it
    WHIRL_ORBIT_ELSEWHERE, ///< an orbit was found, but the motion is too far from it
    WHIRL_ORBIT_NONE       ///< Newton's method found none
} whirl_orbit_search;

/// The periodic orbit of a settled motion.
typedef struct whirl_record_orbit {
    whirl_orbit_search search; ///< outcome of the search
    int period;                ///< revolutions of the orbit
    double residual;           ///< closing error of the orbit, over its largest coordinate
    double distance;           ///< distance of the motion's last state from the orbit, over the size of the motion
    double modulus;            ///< modulus of the largest multiplier
    size_t multiplier_count;   ///< number of coordinates that are not turning phases; 0: no orbit was found
    double *multipliers;       ///< [dimension][2] real and imaginary parts, by falling modulus
    double volume;             ///< sum of ln|multiplier| from the divergence along the orbit; NaN if unknown
    double revolutions;        ///< cost of Newton's method in revolutions, with all perturbations
    /// Revolution after which the motion was replaced by the orbit: the record then repeats the orbit's revolutions,
    /// and growths follow from its multipliers. 0: the whole motion was integrated.
    double set_at;
} whirl_record_orbit;

/// The equilibrium at which a motion rests.
typedef struct whirl_record_rest {
    /// True if the motion stays at the equilibrium to within 1e-5 of the state's size; else the other members are
    /// meaningless.
    bool found;
    /// Largest distance of the record from it, over the state's size: its largest coordinate, or the resolution of the
    /// steps over 1e-5.
    double distance;
    double growth; ///< exponent, per revolution, of the mode about it that decays most slowly or grows
    double order;  ///< order of that mode's frequency, 0 if it does not oscillate
} whirl_record_rest;

/// The record of one motion. Lengths are in the system's unit. One block, freed by whirl_record_free. After a
/// divergence only `diverged_at`, `limit`, `limit_coordinate`, `motion`, `steps` and `end` are meaningful.
typedef struct whirl_record {
    size_t dimension, probe_count, contact_count; ///< as in the system
    const whirl_probe *probes;                    ///< as in the system; borrowed
    size_t extra_count;                           ///< as in the system
    const whirl_extra *extras;                    ///< as in the system; borrowed
    const double *turns;                          ///< as in the system; borrowed. Sections hold 0 for turning phases
    const double *angles;                         ///< as in the system; borrowed
    size_t repeats;                               ///< as in the system
    double period;                                ///< as in the system
    whirl_motion motion;                          ///< bounded, diverged or stuck
    double revolutions;      ///< revolutions integrated: fewer than requested if the motion settled or diverged
    double diverged_at;      ///< revolution (counted from 1) in which the motion left its bounds, else 0
    double limit;            ///< whirl_integrate_options.limit if a finite coordinate exceeded it, else 0
    size_t limit_coordinate; ///< the coordinate that exceeded it most

    size_t section_count; ///< revolutions watched
    double *section;      ///< [section_count][dimension] states at the ends of the watched revolutions, oldest first
    double *points;       ///< workspace for the sections with angles as points on circles; NULL if there are no angles
    size_t record_count;  ///< number of the last sections that belong to the record

    size_t growth_count; ///< 0 if no perturbation was followed
    double *growth;      ///< [growth_count] ln of the perturbation's growth in each watched revolution
    double *growths; ///< [growth_count][dimension] growths of all orthonormal perturbations; NULL if one was followed
    double *volume;  ///< [growth_count] exact sum of the growths (whirl_perturbations.volume); NULL likewise

    size_t sample_count;           ///< samples of the waveform over the record, 0 if not requested
    size_t samples_per_revolution; ///< samples at t = period/samples_per_revolution, ..., period
    double *waveform;              ///< [probe_count + extra_count][2][sample_count] x, then y, of every probe

    /// [dimension] Bounds of every coordinate over the record; in lanes as in whirl_ensemble_seen.
    double *low, *high;
    /// Quantities observed over the record, of all probes, those of `extras` last: radii sqrt(x^2 + y^2);
    /// `backward`, the share of the time with x vy - y vx < 0 (whirl against the rotation, about (0, 0)); normal forces
    /// in the model's unit.
    WHIRL_WATCHED_ARRAYS

    double *end; ///< [dimension] the last state; after a divergence that before the revolution in which it happened

    whirl_step_quality steps; ///< accuracy of a fixed-step method
    whirl_record_orbit orbit; ///< WHIRL_ORBIT_UNSOUGHT unless the options request it
    whirl_record_rest rest;   ///< not found if the motion moves, or the system has turning phases or no Jacobian

    const whirl_system *system; ///< system of the motion; borrowed. NULL for a measured machine
} whirl_record;

/// A callback after every revolution of a motion.
typedef struct whirl_monitor {
    bool (*revolution_done)(void *context); ///< returns false to request a stop
    void *context;                          ///< passed to the function; borrowed
} whirl_monitor;

/// Integrates from `start` [dimension] and records the motion. The caller frees the record. WHIRL_BAD_INPUT for options
/// that contradict each other, WHIRL_NO_MEMORY; WHIRL_STOPPED if `monitor` (which may be NULL) requested it.
whirl_status whirl_record_motion(const whirl_system *system, const whirl_integrate_options *integrate,
                                 const whirl_record_options *options, const double *start, const whirl_monitor *monitor,
                                 whirl_record **record);

/// Frees a record; accepts NULL.
void whirl_record_free(whirl_record *record);

/// Records a motion along an orbit, stable or not, from its first node on; each segment is followed from its own node.
/// The record has the revolutions of the options and no transient; perturbations are not followed and orbits not
/// searched. If the orbit has a period of its own, states at the ends of revolutions are interpolated by cubics between
/// its instants. Bounds and observed quantities are those of one period of the orbit. Uses the orbit's dimension,
/// revolutions, period and nodes. Errors as whirl_orbit_observe and whirl_record_motion.
whirl_status whirl_record_along(const whirl_system *system, const whirl_orbit *orbit,
                                const whirl_orbit_options *options, const whirl_record_options *wanted,
                                whirl_record **record);

/// One of many motions to be recorded. `system` and `start` [dimension] are borrowed until whirl_recorder_take or
/// whirl_recorder_drop returns the motion.
typedef struct whirl_task {
    const whirl_system *system; ///< the machine
    const double *start;        ///< [dimension]
    void *tag;                  ///< for the use of the caller
} whirl_task;

/// The state of an unfinished motion between two revolutions, as bytes.
typedef struct whirl_motion_state {
    whirl_task task;    ///< the motion
    double revolutions; ///< revolutions computed
    void *bytes;        ///< [size]
    size_t size;        ///< number of bytes
} whirl_motion_state;

/// Records many motions, one revolution at a time, in the lanes of an ensemble if possible (whirl_ensemble_takes), else
/// one after the other. Each record equals that of whirl_record_motion to the bit. The caller repeats four steps until
/// no motion turns:
///
///     whirl_recorder_begin(recorder);
///     while (whirl_recorder_has_room(recorder) && another motion waits) whirl_recorder_add(recorder, &task, NULL, 0);
///     whirl_recorder_revolve(recorder, &turned);
///     while (whirl_recorder_take(recorder, &task, &record)) ...
///
/// After an error the recorder can only be freed.
typedef struct whirl_recorder whirl_recorder;

/// Creates a recorder for machines with the structure of `system`; all arguments must outlive it. `lanes`: least number
/// of motions side by side, if lanes are possible (0: the fastest number). Errors as whirl_record_motion. Freed by
/// whirl_recorder_free.
whirl_status whirl_recorder_new(const whirl_system *system, const whirl_integrate_options *integrate,
                                const whirl_record_options *options, size_t lanes, whirl_recorder **recorder);

/// Begins a revolution: resumes motions that waited for a free lane, or for the search for the orbit near them.
whirl_status whirl_recorder_begin(whirl_recorder *recorder);

/// Returns true if the recorder takes a further motion into this revolution.
bool whirl_recorder_has_room(const whirl_recorder *recorder);

/// Adds a motion. It continues from the saved state `bytes` [size] (whirl_recorder_save), or begins at its start if
/// bytes is NULL or does not fit the motion, its system or the options. Frees bytes. After an error the motion was not
/// added.
whirl_status whirl_recorder_add(whirl_recorder *recorder, const whirl_task *task, void *bytes, size_t size);

/// Carries all motions over one revolution; *turned is their number, 0 if there are none.
whirl_status whirl_recorder_revolve(whirl_recorder *recorder, size_t *turned);

/// Removes a finished motion; false if none is left. The caller frees the record (whirl_record_free).
bool whirl_recorder_take(whirl_recorder *recorder, whirl_task *task, whirl_record **record);

/// Removes a motion that is unfinished, when work ends early; false if none is left.
bool whirl_recorder_drop(whirl_recorder *recorder, whirl_task *task);

/// Returns the states of all unfinished motions [*count], so that a later run can continue them: no bit of a record
/// depends on it. NULL without motions, or without memory. Freed by whirl_motion_states_free.
whirl_motion_state *whirl_recorder_save(whirl_recorder *recorder, size_t *count);

/// Frees the states [count] of whirl_recorder_save; accepts NULL.
void whirl_motion_states_free(whirl_motion_state *states, size_t count);

/// Frees a recorder; accepts NULL.
void whirl_recorder_free(whirl_recorder *recorder);

#ifdef __cplusplus
}
#endif

#endif
