/// Recording a motion: what is gathered of it while the integrator runs.
///
/// States once per revolution, waveforms, extremes, contact statistics and the growth of a small perturbation; what
/// analyses (whirl/engine/analyze.h) turn into numbers.
#ifndef WHIRL_RECORD_H
#define WHIRL_RECORD_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/integrate.h"
#include "whirl/engine/orbit.h"
#include "whirl/engine/system.h"
#include "whirl/engine/watched.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// What is followed of small perturbations while a motion is watched.
typedef enum whirl_growth {
    WHIRL_GROWTH_NONE = 0, ///< none
    WHIRL_GROWTH_LARGEST,  ///< one, by a second trajectory, which any system has
    WHIRL_GROWTH_ALL       ///< as many as the state has coordinates, by the system's Jacobian
} whirl_growth;

/// Most revolutions that cases and result files may say.
enum { WHIRL_MAX_TRANSIENT = 1000000000, WHIRL_MAX_RECORD = 100000000 };

/// How branches of orbits are looked for.
typedef struct whirl_trace_options {
    /// Where the first orbit is looked for: "settled", where a motion has settled after the transient; "start", from
    /// the initial state; "linear", from the forced response of the machine linearized about its rest. The last two
    /// find unstable orbits, too.
    char begin[WHIRL_NAME_SIZE];
    bool rest;             ///< branches of equilibria, in place of orbits
    int revolutions;       ///< of the first orbit; 0: after how many the settled motion comes back
    int longest;           ///< most revolutions of an orbit
    int switches;          ///< times that a branch is left for those that begin along it
    int segments;          ///< as in whirl_orbit_options
    int points;            ///< most points of all branches
    double step;           ///< whirl_branch_options.most_step
    double rtol;           ///< of the integrator
    bool tori;             ///< those that begin at Neimark-Sacker points are followed
    int torus_nodes;       ///< most of a torus' curve; see whirl_trace_torus_nodes
    int torus_points;      ///< most of one branch of tori
    double torus_step;     ///< whirl_torus_branch_options.most_step
    double torus_accuracy; ///< whirl_torus_options.accuracy
} whirl_trace_options;

/// Most nodes of a torus' curve: what the options say, made odd.
size_t whirl_trace_torus_nodes(const whirl_trace_options *options);

/// Its members, as cases say them (part "branch") and results of branches have them; static, ended by one without a
/// part.
const whirl_member *whirl_trace_members(void);

/// What is recorded of a motion, and how long.
typedef struct whirl_record_options {
    int transient; ///< revolutions that pass before anything is recorded, >= 0
    int record;    ///< revolutions recorded, >= 1
    /// Revolutions before the end over which the Poincare section and the growth of a perturbation are followed,
    /// record <= watch <= transient + record; 0: the record and the second half of the transient, of which at most
    /// the larger of 1000 and record.
    int watch;
    int waveform_revolutions; ///< last revolutions whose waveform is kept as a result, 0 <= ... <= record
    /// Samples of the waveform a revolution, at least (the next divisor of steps_per_revolution is taken).
    int samples_per_revolution;
    double highest_order; ///< spectra are kept up to this order of the running speed
    bool bearings; ///< of critical speed maps: the parameter is the stiffness of springs in the place of bearings, N/m
    /// End the transient early, but for 64 revolutions, where the motion has settled on a periodic orbit to 1e-11.
    bool settle;
    int modes;                        ///< modes that are kept, >= 1
    double running_low, running_high; ///< rad/s, between which the machine runs; 0: not said
    double trip;                      ///< rad/s, up to which clearances are looked at; 0: all speeds
    double probe_angle;               ///< of the first probe of every station, rad from the x axis towards y
    int antinodes_of;                 ///< number of the forward mode whose antinodes have unbalances by rule; 0: none
    char placed_at[WHIRL_NAME_SIZE];  ///< station that has an unbalance by rule, or ""
    char probes_at[WHIRL_NAME_SIZE];  ///< stations whose probes scale responses, or ""
    double placed_weight;             ///< kg that it goes by; 0: what hangs over there
    double placed_factor;             ///< times as large are unbalances by rule
    char coupling[WHIRL_NAME_SIZE];   ///< of statics: stations that carry neither moment nor shear, or ""
    double gas_density;               ///< kg/m3, of stability: the average of the gas; 0: not said
    bool spectra;                     ///< keep whole spectra, not only their peaks
    bool waveform;                    ///< waveforms are needed (for spectra or to be kept)
    /// Look for the orbits of motions that have come to rest, by Newton's method; with `settle` also before they have,
    /// and end the transient where the motion cannot but come to rest on one.
    bool orbits;
    whirl_growth growth;       ///< costs one trajectory while watched, or as many as there are coordinates
    whirl_trace_options trace; ///< of branches alone
} whirl_record_options;

/// Its members, as cases say them (parts "integrate" and "keep", and "detail" for what details say anew) and results
/// have them; static, ended by one without a part.
const whirl_member *whirl_record_members(void);

/// The defaults of whirl_record_members and whirl_trace_members, but settle false.
whirl_record_options whirl_record_default(void);

/// Revolutions watched, with the default resolved.
int whirl_record_watch(const whirl_record_options *options);

/// Samples of a waveform a revolution: the smallest divisor of `steps_per_revolution` that is at least
/// options->samples_per_revolution.
int whirl_record_samples(const whirl_record_options *options, int steps_per_revolution);

/// WHIRL_BAD_INPUT with a sentence where options mean nothing or contradict each other.
whirl_status whirl_record_options_check(const whirl_record_options *options);

/// The same, and where all perturbations are to be followed and the system gives no Jacobian or the method takes none
/// along.
whirl_status whirl_record_check(const whirl_system *system, const whirl_integrate_options *integrate,
                                const whirl_record_options *options);

/// How long the steps of a fixed-step method were for the motion; NaN where they were not looked at (methods with a
/// tolerance).
typedef struct whirl_step_quality {
    double growth; ///< whirl_step_check.growth, of the revolutions that were looked at: above 1 the step is unstable
    double error;  ///< of a revolution by the steps, over the size of the motion
    double factor; ///< times as many steps are needed, 1 where these are good
} whirl_step_quality;

/// What became of the search for the orbit that a motion has come to rest on.
typedef enum whirl_orbit_search {
    WHIRL_ORBIT_UNSOUGHT = 0, ///< the motion does not return, the search would cost too much, or there is no Jacobian
    WHIRL_ORBIT_STABLE,       ///< the motion is on it, and all multipliers are within the unit circle
    WHIRL_ORBIT_UNSTABLE,     ///< a multiplier is on the unit circle or beyond it
    WHIRL_ORBIT_ELSEWHERE,    ///< the nearest one is not where the motion is
    WHIRL_ORBIT_NONE          ///< Newton's method found none
} whirl_orbit_search;

/// The periodic orbit of a motion that has come to rest.
typedef struct whirl_record_orbit {
    whirl_orbit_search search; ///< what became of the search
    int period;                ///< revolutions after which it closes
    double residual;           ///< by which it fails to close, over its largest coordinate
    double distance;           ///< of the motion's last state from it, over the size of the motion
    double modulus;            ///< of the largest multiplier
    size_t multiplier_count;   ///< coordinates that do not turn on and on; 0: no orbit was found
    double *multipliers;       ///< [dimension][2] real and imaginary parts, by falling modulus
    double volume;             ///< sum of ln|multiplier| by the divergence along the orbit; NaN where it is not known
    double revolutions;        ///< that Newton's method took, with all perturbations
    /// Revolution after which the motion was set upon the orbit: the record holds its revolutions again and again, and
    /// growths by its multipliers. 0: the motion ran all its way.
    double set_at;
} whirl_record_orbit;

/// The equilibrium at which a motion rests.
typedef struct whirl_record_rest {
    bool found;      ///< the motion stays within 1e-5 of the state's size of it; else the rest means nothing
    double distance; ///< the farthest that the record is from it, over the state's size: its largest coordinate, or
                     ///< what the steps resolve over 1e-5
    double growth;   ///< exponent, per revolution, of the mode about it that decays most slowly, or grows
    double order;    ///< frequency of that mode, 0 where it has none
} whirl_record_rest;

/// What was gathered of one motion. Lengths in the system's own; one block, freed by whirl_record_free.
/// After a divergence only `diverged_at`, `motion`, `steps` and `end` mean anything.
typedef struct whirl_record {
    size_t dimension, probe_count, contact_count; ///< of the system
    const whirl_probe *probes;                    ///< of the system; borrowed
    const double *turns;                          ///< of the system; borrowed. Sections hold 0 for what turns
    const double *angles;                         ///< of the system; borrowed
    size_t repeats;                               ///< of the system
    double period;                                ///< of the system
    whirl_motion motion;                          ///< whether it stayed within its bounds
    double revolutions;      ///< that were integrated: fewer than asked for where the motion settled or diverged
    double diverged_at;      ///< revolution (counted from 1) in which the motion left its bounds, 0 where it did not
    double limit;            ///< whirl_integrate_options.limit where a finite coordinate passed it, else 0
    size_t limit_coordinate; ///< which one was farthest then

    size_t section_count; ///< revolutions watched
    double *section;      ///< [section_count][dimension] states at the ends of the watched revolutions, oldest first
    double *points;       ///< room for them with angles on circles; NULL where there are none
    size_t record_count;  ///< of these the last ones, which are the record

    size_t growth_count; ///< 0 when no perturbation was followed
    double *growth;      ///< [growth_count] ln of the perturbation's growth in each watched revolution
    double *growths; ///< [growth_count][dimension] of all perturbations, orthonormal ones; NULL when one was followed
    double *volume;  ///< [growth_count] what their sum is exactly (whirl_perturbations.volume); NULL likewise

    size_t sample_count;           ///< samples of the waveform over the record, 0 when not wanted
    size_t samples_per_revolution; ///< whose ends are at t = period/samples_per_revolution, ..., period
    double *waveform;              ///< [probe_count][2][sample_count] x, then y, of every probe

    /// [dimension] Bounds of every coordinate over the record; in lanes as whirl_ensemble_seen has them.
    double *low, *high;
    /// What was watched over the record: radii sqrt(x^2 + y^2); `backward`, the share of the time that x vy - y vx < 0
    /// (whirl against the rotation, about (0, 0)); normal forces in the model's unit.
    WHIRL_WATCHED_ARRAYS

    double *end; ///< [dimension] the last state; after a divergence that at the beginning of the revolution in which it
                 ///< left

    whirl_step_quality steps; ///< of a fixed-step method
    whirl_record_orbit orbit; ///< unsought where the options do not ask for it
    whirl_record_rest rest;   ///< not found where the motion moves, the system has phases that turn or no Jacobian

    const whirl_system *system; ///< whose motion it is; borrowed. NULL: that of a machine that was measured
} whirl_record;

/// Called after every revolution of a motion; false asks for a stop.
typedef struct whirl_monitor {
    bool (*revolution_done)(void *context); ///< false asks for a stop
    void *context;                          ///< handed to the function; borrowed
} whirl_monitor;

/// Integrates from `start` [dimension] and records. The record belongs to the caller.
/// WHIRL_BAD_INPUT for options that contradict each other, WHIRL_NO_MEMORY; WHIRL_STOPPED when `monitor`
/// (which may be NULL) asked for it.
whirl_status whirl_record_motion(const whirl_system *system, const whirl_integrate_options *integrate,
                                 const whirl_record_options *options, const double *start, const whirl_monitor *monitor,
                                 whirl_record **record);

/// Frees a record; NULL is none.
void whirl_record_free(whirl_record *record);

/// What recording would gather of a motion that stays on an orbit, stable or not, from its first node on: each segment
/// is followed from its own node. As many revolutions are recorded as the options say; there is no transient, and
/// neither perturbations nor orbits are looked for. Revolutions of an orbit with a time of its own lie between
/// instants: cubics join these. Bounds and all that is watched are those of once round the orbit. Of an orbit its
/// dimension, revolutions, period and nodes count. Errors as whirl_orbit_observe and whirl_record_motion.
whirl_status whirl_record_along(const whirl_system *system, const whirl_orbit *orbit,
                                const whirl_orbit_options *options, const whirl_record_options *wanted,
                                whirl_record **record);

/// A motion to be recorded among many. `system` and `start` [dimension] are borrowed until the motion is done.
typedef struct whirl_task {
    const whirl_system *system; ///< of the machine
    const double *start;        ///< [dimension]
    void *tag;                  ///< the source's own
} whirl_task;

/// The state of a motion under way between two revolutions, as bytes.
typedef struct whirl_motion_state {
    const whirl_task *task; ///< whose motion it is; borrowed
    double revolutions;     ///< that were computed
    void *bytes;            ///< [size]
    size_t size;            ///< of the bytes
} whirl_motion_state;

/// Saves motions under way, so that a later run can take them up where they were. No bit of a record depends on it.
typedef struct whirl_motion_saver {
    /// Asked after every revolution: whether the states are wanted now.
    bool (*wanted)(void *context);
    /// Takes the states of all motions that one recorder has under way; borrowed.
    void (*save)(void *context, const whirl_motion_state *states, size_t count);
    /// Asked when a motion is to begin: a state that was saved of it, to be freed by free, or NULL. One that does not
    /// fit the motion, its system or its options is not used.
    void *(*saved)(void *context, const whirl_task *task, size_t *size);
} whirl_motion_saver;

/// Where motions come from and where their records go.
typedef struct whirl_task_source {
    /// Writes the next motion and returns true; false when there is none now (there may be one after the next `done`).
    bool (*next)(void *context, whirl_task *task);
    /// Takes a finished motion; the record belongs to the source from then on.
    whirl_status (*done)(void *context, const whirl_task *task, whirl_record *record);
    /// Takes back a motion that did not finish because the work ended early.
    void (*abandon)(void *context, const whirl_task *task);
    void *context;                   ///< handed to every function; borrowed
    const whirl_motion_saver *saver; ///< or NULL; called with `context`
} whirl_task_source;

/// Records all motions that the source gives, in the lanes of an ensemble: many side by side where they can
/// (whirl_ensemble_takes), else one after the other. Each record is what whirl_record_motion gives, to the bit. All
/// systems have the structure of `system`. Errors as whirl_record_motion; the first one, or the first of `done`, ends
/// the work.
whirl_status whirl_record_motions(const whirl_system *system, const whirl_integrate_options *integrate,
                                  const whirl_record_options *options, const whirl_task_source *source,
                                  const whirl_monitor *monitor);

/// The same a revolution at a time, for programs that must answer in between.
typedef struct whirl_recorder whirl_recorder;

/// Starts a recorder; all that is given must outlive it. `lanes`: how many motions go side by side at least, where they
/// can (0: as many as are fast). Errors as whirl_record_motions. Freed by whirl_recorder_free, which abandons what is
/// under way.
whirl_status whirl_recorder_new(const whirl_system *system, const whirl_integrate_options *integrate,
                                const whirl_record_options *options, const whirl_task_source *source, size_t lanes,
                                whirl_recorder **recorder);

/// Carries the motions under way over a revolution, new ones of the source included. *turned is how many that were: 0
/// when the source has none left. After an error the recorder can only be freed.
whirl_status whirl_recorder_revolve(whirl_recorder *recorder, size_t *turned);

/// Frees a recorder; NULL is none.
void whirl_recorder_free(whirl_recorder *recorder);

#ifdef __cplusplus
}
#endif

#endif
