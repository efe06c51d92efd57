/// Analyses: what is said of one point (one parameter set, one start).
///
/// First a motion is *recorded* (whirl_record_motion): states once per revolution, waveforms, extremes, contact
/// statistics and the growth of a small perturbation are gathered while the integrator runs. Then each *analysis*
/// turns the record into numbers. The numbers of a point lie in one block of doubles whose *layout* names them:
/// analyses describe their fields, and case files, result files and exports follow from that.
#ifndef WHIRL_ANALYZE_H
#define WHIRL_ANALYZE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/fields.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/orbit.h"
#include "whirl/engine/system.h"
#include "whirl/engine/torus.h"
#include "whirl/engine/watched.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------- recording

/// What is followed of small perturbations while a motion is watched.
typedef enum whirl_growth {
    WHIRL_GROWTH_NONE = 0, ///< none
    WHIRL_GROWTH_LARGEST,  ///< one, by a second trajectory, which any system has
    WHIRL_GROWTH_ALL       ///< as many as the state has coordinates, by the system's Jacobian
} whirl_growth;

/// Most revolutions that cases and result files may say.
enum { WHIRL_MAX_TRANSIENT = 1000000000, WHIRL_MAX_RECORD = 100000000 };

/// How branches of orbits are looked for. The first orbit is found where a motion has settled after the transient.
typedef struct whirl_trace_options {
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
    double revolutions; ///< that were integrated: fewer than asked for where the motion settled or diverged
    double diverged_at; ///< revolution (counted from 1) in which the motion left its bounds, 0 where it did not

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

// ---------------------------------------------------------------- single analyses, for any record

/// A mean with its standard error.
typedef struct whirl_estimate {
    double value, error; ///< the mean, its standard error
} whirl_estimate;

/// Largest Lyapunov exponent per revolution (natural logarithm): the mean growth of a perturbation over the watched
/// revolutions after the first tenth, with the standard error of block means and, where all perturbations were
/// followed, by what the sum of their exponents misses. NaN where nothing was followed, or that is too much
/// (whirl_lyapunov_spectrum).
whirl_estimate whirl_lyapunov_largest(const whirl_record *record);

/// All Lyapunov exponents per revolution [dimension], as whirl_lyapunov_largest has the first one. False, and NaN,
/// where not all perturbations were followed, or where the sum of the exponents misses that by the divergence by more
/// than their standard errors and by more than a thousandth of their sizes.
bool whirl_lyapunov_spectrum(const whirl_record *record, whirl_estimate *exponents);

/// Kaplan and Yorke's dimension of the attractor in the section, from exponents [count], largest first: how many of
/// them sum to zero or more, the next one in part. Exponents within 3 errors of zero, and within 0.002, count as zero.
double whirl_kaplan_yorke(const whirl_estimate *exponents, size_t count);

/// What kind of motion a record is of.
typedef enum whirl_regime {
    WHIRL_UNDETERMINED = 0, ///< the evidence does not decide
    WHIRL_PERIODIC,         ///< it returns after some revolutions: P-k
    WHIRL_QUASI_PERIODIC,   ///< it has frequencies of its own
    WHIRL_CHAOTIC,          ///< small perturbations grow
    WHIRL_DIVERGING         ///< it left its bounds
} whirl_regime;

/// The longest period that is told.
enum { WHIRL_MAX_PERIOD = 128 };

/// How far a verdict can be trusted.
typedef enum whirl_confidence { WHIRL_LOW = 0, WHIRL_FAIR, WHIRL_HIGH } whirl_confidence;

/// What would make a verdict more certain.
typedef enum whirl_remedy {
    WHIRL_NO_REMEDY = 0,    ///< nothing is to be done
    WHIRL_LONGER_TRANSIENT, ///< the motion has not settled: a run of `factor` times as many revolutions
    WHIRL_LONGER_WATCH,     ///< more points of the section would tell: `factor` times as many revolutions watched
    WHIRL_TIGHTER,          ///< the tolerance decides: errors of a step smaller by `factor`
    WHIRL_MORE_STEPS,       ///< fixed steps are too long: `factor` times as many, or a method with a tolerance
    WHIRL_OTHER_START       ///< the motion stays on an unstable one: another start, beside it (no option of a run does)
} whirl_remedy;

/// Number of remedies.
enum { WHIRL_REMEDIES = WHIRL_OTHER_START + 1 };

/// What to do for a verdict that is more certain.
typedef struct whirl_advice {
    whirl_remedy remedy; ///< what is to be changed
    double factor;       ///< above 1 where there is a remedy but another start, else 1
} whirl_advice;

/// whirl_verdict.refuge of an equilibrium.
enum { WHIRL_REFUGE_AT_REST = -1 };

/// A verdict with the evidence it rests on.
typedef struct whirl_verdict {
    whirl_regime regime; ///< the kind of motion
    int period;          ///< k of P-k for a periodic motion, else 0
    int curves; ///< closed curves of a quasi-periodic motion's section, 0 where that may be a surface, and else
    /// Of a quasi-periodic motion: 2 for closed curves, and without curves where a phase forces it that fits no
    /// revolution; 3 where the section is a surface and a second exponent is zero
    /// as well, 0 where that cannot be told, and else.
    int frequencies;
    double diverged_at; ///< revolution, else 0
    // trust
    whirl_confidence confidence; ///< after the second tolerance, if there was one; at most fair without it
    whirl_confidence agreement;  ///< what the evidence of this record would be worth, were no step ever wrong
    whirl_advice advice;         ///< what would settle it
    bool confirmed;              ///< whether it was compared with a verdict at another tolerance, namely
    whirl_regime other_regime;   ///< of the verdict at the other tolerance
    int other_period;            ///< k of P-k there, else 0
    double followed; ///< revolutions that copies of a chaotic motion were followed beyond its end, all together
    whirl_regime later_regime; ///< what they were then: the first of these that is not chaotic
    int later_period;          ///< k of P-k then, else 0
    // evidence
    whirl_estimate exponent; ///< largest, per revolution
    bool exponents_failed;   ///< all perturbations were followed, and the sum of their growth is wrong: none counts
    double recurrence;       ///< smallest over k of the largest return distance |z(n+k) - z(n)|, over the size of the
                             ///< motion
    int recurrence_period;   ///< the k that gives it (the smallest k below the tolerance, where there is one)
    int longest_period;      ///< that was looked for: 128 where three of them were watched, else fewer
    double recurrence_trend; ///< that distance in the last quarter of the watched revolutions over that in the first: <
                             ///< 1 settles
    double regularity; ///< decimal digits to which weighted Birkhoff averages over two halves agree: high on tori, low
                       ///< in chaos
    double chaos;      ///< K of the 0-1 test, near 1 in chaos, near 0 for regular motion; NaN for P-k
    int neighbours;  ///< of a quasi-periodic motion: median revolutions between visits of neighbours on a curve, else 0
    int unlocked;    ///< of a quasi-periodic motion: it is locked on no period up to this, else 0
    double rotation; ///< turns round its closed curve from one visit to the next, 0 to 1/2; NaN but for a
                     ///< quasi-periodic motion
    /// Of an undetermined motion that drifts evenly along a closed curve: revolutions once round it; NaN for others.
    double round;
    whirl_orbit_search orbit; ///< what became of the search for the orbit of a motion that returns, and of that orbit
    int orbit_period;         ///< revolutions after which that orbit closes
    double orbit_residual, orbit_distance, orbit_modulus; ///< as whirl_record_orbit has them; NaN where there is none
    double step_growth; ///< whirl_step_quality.growth; NaN for methods with a tolerance
    double step_error;  ///< whirl_step_quality.error
    double revolutions; ///< that were integrated
    double swelling;    ///< per revolution, at which the section grows from half to half of the watched revolutions
    bool sought;        ///< of a chaotic motion: whether it was looked for what else draws in where it goes, namely
    int refuge;         ///< k of a stable P-k, WHIRL_REFUGE_AT_REST of a stable equilibrium; 0: none was found
    bool rests;         ///< of P-1: it rests at a stable equilibrium; then the exponent is that of its slowest mode
    double rest_distance, rest_order; ///< as whirl_record_rest has them; NaN where it does not rest
} whirl_verdict;

/// Judges the motion. See docs/theory.md, "Verdicts".
whirl_verdict whirl_judge(const whirl_record *record);

/// Looks for what draws motions in where a chaotic motion goes: stable equilibria near its section, and stable orbits
/// that motions from 32 starts, near states of its section by a tenth of the size of its box, come to within 200
/// revolutions.
/// *refuge as whirl_verdict has it. WHIRL_BAD_INPUT where the system gives no Jacobian; WHIRL_NO_MEMORY.
whirl_status whirl_record_refuge(const whirl_system *system, const whirl_integrate_options *integrate,
                                 const whirl_record *record, int *refuge);

/// Compares with the verdict on the same motion at another tolerance (whirl_integrate_tighter), which settles the
/// confidence: high needs the same regime (and period) from both, and of chaos that a refuge was looked for from there
/// and none was found; where they differ it is low.
void whirl_verdict_confirm(whirl_verdict *verdict, const whirl_verdict *other);

/// Sets beside a chaotic verdict what a copy of the motion was after `revolutions` more than the point's own `all`.
/// Chaos that has ended was a transient: the confidence is low then, and fair where the copy does not tell. The order
/// of copies changes nothing.
void whirl_verdict_follow(whirl_verdict *verdict, const whirl_verdict *copy, double revolutions, double all);

/// Options with errors of a step smaller by `factor` >= 1: tolerances divided by it, steps of a fixed-step method times
/// its fourth root (rounded up; 16 gives twice the steps). Tolerances are not taken below 1e-14.
whirl_integrate_options whirl_integrate_tighter(const whirl_integrate_options *options, double factor);

/// Changes options as the advice says (not at all where it is another start). The record keeps its length and the
/// samples of its waveform, so that the layout of a point's block stays.
void whirl_advice_apply(whirl_advice advice, whirl_integrate_options *integrate, whirl_record_options *record);

/// "periodic", "quasi-periodic", "chaotic", "diverged", "undetermined". Static text.
const char *whirl_regime_name(whirl_regime regime);

/// "low", "fair", "high". Static text.
const char *whirl_confidence_name(whirl_confidence confidence);

/// "P-2", "rests", "quasi-periodic (1 curve)", "chaotic", "diverged at revolution 17", "undetermined". Writes at most
/// `size` bytes.
void whirl_verdict_name(const whirl_verdict *verdict, char *text, size_t size);

/// Why, in one sentence from the evidence. Writes at most `size` bytes.
void whirl_verdict_reason(const whirl_verdict *verdict, char *text, size_t size);

/// What would settle it, in words: "let it run 3 times as long", or "" where nothing is advised. Writes at most `size`
/// bytes.
void whirl_verdict_advice(const whirl_verdict *verdict, char *text, size_t size);

/// The most lines that are told of a spectrum.
enum { WHIRL_MAX_LINES = 16 };

/// A line of a spectrum. Amplitudes are zero to peak.
typedef struct whirl_line {
    double order;             ///< frequency over the running speed, > 0
    double x, y;              ///< amplitudes of the two coordinates
    double forward, backward; ///< of the two circular motions that make it up (full spectrum of x + iy)
} whirl_line;

/// The synchronous (1X) part of a motion: of x, of y, and of the circular motions with the rotation (forward) and
/// against it (backward) of which both are made, in this order. The mark on the shaft, from which phases count, stands
/// on the x axis at tau = 0, 2 pi, ...: there an unbalance without an angle of its own points along x. x is
/// amplitude[0] cos(tau - lag[0]), y likewise; forward is the vector at the angle tau - lag[2], backward that at -(tau
/// - lag[3]).
typedef struct whirl_synchronous {
    double amplitude[4]; ///< zero to peak
    /// Degrees, 0 <= ... < 360, by which the peak, or the vector on its way through the x axis, comes after the mark;
    /// NaN where the amplitude is below 1e-12 of the largest displacement.
    double lag[4];
} whirl_synchronous;

/// Spectra of one probe over the record: Hann window over all samples, mean removed, resolution 1/record orders.
typedef struct whirl_spectrum {
    size_t count;                       ///< orders 0 .. highest
    double resolution;                  ///< orders between two bins
    double *x, *y, *forward, *backward; ///< [count] amplitudes, zero to peak; one block, freed by whirl_spectrum_free
    size_t line_count;                  ///< of lines
    whirl_line lines[WHIRL_MAX_LINES];  ///< interpolated peaks, largest first
    whirl_synchronous synchronous;      ///< NaN where there are fewer than 3 samples per revolution
} whirl_spectrum;

/// Spectrum of probe `probe` up to `highest_order`. WHIRL_BAD_INPUT when the record has no waveform.
whirl_status whirl_spectrum_new(const whirl_record *record, size_t probe, double highest_order,
                                whirl_spectrum **spectrum);

/// Frees a spectrum; NULL is none.
void whirl_spectrum_free(whirl_spectrum *spectrum);

// ---------------------------------------------------------------- peaks of responses

/// How an amplification factor was found.
typedef enum whirl_amplification_way {
    WHIRL_BY_HALF_POWER, ///< speed/(high - low)
    WHIRL_BY_ONE_SIDE,   ///< speed over twice the distance of the one point of half power that there is
    WHIRL_BY_PHASE_SLOPE ///< half of the speed times the slope of the lag: there is no such point
} whirl_amplification_way;

/// A peak of a response over the speed.
typedef struct whirl_response_peak {
    double speed, amplitude;     ///< of its top, by cubic interpolation
    double low, high;            ///< speeds at which the amplitude is 1/sqrt(2) of the top's; NaN where it rises before
    double amplification;        ///< factor
    whirl_amplification_way way; ///< it was found
    double points;               ///< of the response in the width speed/amplification: few tell it roughly
} whirl_response_peak;

/// The peaks of a response [count] at rising speeds, by rising speed, at most `most` of them; how many. lags: degrees
/// by which its phase is behind. Ends count as no peaks. (Amplification by half power: API 617, API 684; closed form of
/// a damped rotor: docs/theory.md.)
size_t whirl_response_peaks(size_t count, const double *speeds, const double *amplitudes, const double *lags,
                            size_t most, whirl_response_peak *peaks);

/// The largest of a response [count] at rising speeds from `low` to `high`: at points, at tops between them and at both
/// ends of that range, by cubic interpolation; NaN where points do not reach over it.
double whirl_response_largest(size_t count, const double *speeds, const double *amplitudes, double low, double high);

/// The critical speed ratio, of the speed over the first critical speed on rigid supports, above which a machine whose
/// gas has that average density (kg/m3) is in region B of the screening diagram of API 617: 2.5, falling from 16.53 to
/// 2.0 at 60 kg/m3, 0 beyond. Which edition counts is the user's to check.
double whirl_screening_ratio(double density);

/// The separation margin, in percent of the lowest (or, `above`, the highest) running speed, that a peak of that
/// amplification asks for: 17 (1 - 1/(A - 1.5)), and 10 more above; 0 below A = 2.5. After API 617; which edition
/// counts, and what it caps, is the user's to check.
double whirl_margin_required(double amplification, bool above);

// ---------------------------------------------------------------- analyses by name, and their fields

/// One named group of numbers in the block of a point: for every point, station (probe) or contact
/// an array [rows][columns] (1 x 1: a number), row-major. Missing values are NaN.
typedef struct whirl_field {
    char name[WHIRL_NAME_SIZE]; ///< "analysis/quantity", as "lyapunov/largest"
    const char *unit; ///< "length", "force", "1", "revolution", "1/revolution", "order"; "length" is the case's scale
    const char *meaning;  ///< one line; for columns their names, separated by ", "
    whirl_extent extent;  ///< what it stands once for
    size_t rows, columns; ///< of the array
    size_t repeat;        ///< 1, or the number of stations or contacts
    size_t offset;        ///< of the first number in the block; the next repetition follows after rows * columns
} whirl_field;

/// The most fields of a block, and the most columns that have names.
enum { WHIRL_MAX_FIELDS = 256, WHIRL_MAX_COLUMNS = 32 };

/// The fields of a point's block.
typedef struct whirl_layout {
    size_t field_count;                   ///< of fields
    whirl_field fields[WHIRL_MAX_FIELDS]; ///< in the order of the block
    size_t size;                          ///< doubles of the block
} whirl_layout;

/// A kind of points, with all that who handles batches and tables may ask of it: nobody asks which kind it is.
typedef struct whirl_kind {
    const char *name;   ///< "motion", "rest", "branch", "torus"
    const char *asked;  ///< how a case asks for its analyses, a sentence
    const char *method; ///< how its points are found, NULL: they are integrated, by the method of their options
    const char *begins; ///< what its points are followed from, NULL: values of the parameter
    const char *beside; ///< what is said behind the name of that method, "" nothing
    /// Its points are motions: from a start on, over a transient and a record, with a verdict, and so with several
    /// starts, confirmations and refinement.
    bool moves;
    bool settles; ///< motions are integrated at least until they have settled
    /// Its points are found as a run goes on: how many they are, at most record.trace.points, and at which values is
    /// known when they are there. Their options are those of whirl_trace_members, too.
    bool found;
    double cost; ///< of a point, about, in revolutions, 1 at rest; 0: those of its motion
    bool still;  ///< also of machines that stand still, of which no revolutions are counted
} whirl_kind;

// clang-format off
/// The studies of machines at rest: name, what it is of, source, and `STILL` where it is also of machines that stand
/// still, else `TURNING`. Each is an analysis, and a part of a study, of that name.
#define WHIRL_STUDIES_AT_REST(study)                                                                                   \
    study(modes, "frequencies, damping, whirl and shapes of small motions about where the machine rests",              \
          "Friswell, Penny, Garvey, Lees 2010; Floquet 1883 where coefficients turn with the shaft", STILL)            \
    study(unbalance, "synchronous response to unbalance about where the machine rests",                                \
          "Friswell, Penny, Garvey, Lees 2010", TURNING)                                                               \
    study(critical_speeds, "critical speeds without damping, all at once, forward and backward",                       \
          "Friswell, Penny, Garvey, Lees 2010", TURNING)                                                               \
    study(stability, "decrements over the cross coupling of stages, its limit, and what seals and impellers do",       \
          "Wachel, von Nimitz 1981; API 617", TURNING)                                                                 \
    study(statics, "sag, bending moments and loads of bearings by the weight, and elevations of bearings",             \
          "Przemieniecki 1968", STILL)
// clang-format on

/// An analysis as it describes itself.
typedef struct whirl_analysis {
    const char *name;       ///< as written in a case file: "poincare", "spectrum", ...
    const char *meaning;    ///< one line
    const char *source;     ///< author, year; "" where there is nothing to cite
    bool usual;             ///< computed where a case does not say which
    bool kept;              ///< of waveforms that are kept: computed exactly where some are (whirl_analysis_fit)
    const whirl_kind *kind; ///< of the points that it is of
} whirl_analysis;

/// All analyses; static, ended by an entry whose name is NULL.
const whirl_analysis *whirl_analyses(void);

/// A choice of analyses, one bit for the index in whirl_analyses().
typedef unsigned whirl_analysis_set;

/// Adds the analysis of that name; false when there is none.
bool whirl_analysis_add(whirl_analysis_set *set, const char *name);

/// Whether a choice has the analysis of that name.
bool whirl_analysis_has(whirl_analysis_set set, const char *name);

/// The kind of points that a choice is of, all of one; that of motions where nothing is chosen. Static.
const whirl_kind *whirl_analysis_kind(whirl_analysis_set set);

/// Those that are computed where a case does not say which.
whirl_analysis_set whirl_analysis_usual(void);

/// Name of the analysis whose fields hold the verdict.
const char *whirl_analysis_of_verdicts(void);

/// Name of the analysis of the ranges of laws, which every choice of motions or rests has.
const char *whirl_analysis_of_ranges(void);

/// The choice with all analyses of kept waveforms where some are kept, and without them where none are.
whirl_analysis_set whirl_analysis_fit(whirl_analysis_set set, const whirl_record_options *options);

/// Makes options record what the chosen analyses are made of: the waveform, the growth of perturbations. What is
/// recorded already stays.
void whirl_analysis_needs(whirl_analysis_set set, whirl_record_options *options);

/// The layout of a point's block for a system, options and choice. WHIRL_BAD_INPUT for contradicting options.
whirl_status whirl_layout_new(const whirl_system *system, const whirl_integrate_options *integrate,
                              const whirl_record_options *options, whirl_analysis_set set, whirl_layout *layout);

/// All fields that there are, as for a machine of one station and one contact, with more than one row where there can
/// be more.
whirl_status whirl_layout_known(whirl_layout *layout);

/// What is taken for granted of tables of branches and tori, for layouts and blocks that were read: all fields of these
/// analyses are there, with as many rows as the options and the dimension (that the first of them tells) ask for; and
/// revolutions and nodes are not more than there is room for. WHIRL_BAD_INPUT with what is wrong.
whirl_status whirl_layout_check(const whirl_layout *layout, whirl_analysis_set set,
                                const whirl_record_options *options);

/// The same of a block.
whirl_status whirl_block_check(const whirl_layout *layout, const double *block, const whirl_record_options *options);

/// Whether blocks hold a verdict.
bool whirl_layout_has_verdict(const whirl_layout *layout);

/// The field of that name, or NULL.
const whirl_field *whirl_layout_field(const whirl_layout *layout, const char *name);

/// The names of a field's columns, "x", "y"; false where they have none.
bool whirl_field_column_names(const whirl_field *field, char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE]);

/// How a displacement is counted.
typedef enum whirl_counting {
    WHIRL_FROM_CENTRE = 0, ///< a place, an extent, the size of a part: there is one way
    WHIRL_ZERO_TO_PEAK,    ///< a distance from the centre: zero to peak whatever `units` says, as it is no sinusoid's
    WHIRL_AMPLITUDE        ///< of a sinusoid: held zero to peak, shown as `units` says
} whirl_counting;

/// The unit of a column, as whirl_field.unit; besides "length/radian", "rad/s" and "parameter" (SI), of columns whose
/// names tell so beside others. Static text, or the field's.
const char *whirl_column_unit(const whirl_field *field, size_t column);

/// How the lengths of a field are counted: its meaning says "0-p amplitude" of sinusoids, "0-p" of other distances.
whirl_counting whirl_field_counting(const whirl_field *field);

/// Whether the analyses have a field of that name whose numbers stand in rows: also where options leave one row of
/// them.
bool whirl_analysis_has_rows(const char *field);

/// Fills `block` [layout->size] with what the chosen analyses say of the record.
whirl_status whirl_analyze(const whirl_record *record, const whirl_record_options *options, whirl_analysis_set set,
                           const whirl_layout *layout, double *block);

/// What was located between two values of a parameter.
typedef enum whirl_critical_kind {
    WHIRL_CRITICAL_SPEED = 1, ///< a mode's damped frequency is the speed of the shaft
    WHIRL_ONSET,              ///< the machine loses its stability as the parameter grows
    WHIRL_RECOVERY            ///< ... regains it
} whirl_critical_kind;

/// A critical speed, or a threshold of stability.
typedef struct whirl_critical {
    whirl_critical_kind kind; ///< which of these
    double value;             ///< of the parameter, in SI
    double speed;             ///< of the shaft there, rad/s
    double frequency, ratio;  ///< of the mode, rad/s, and its damping ratio
    double direction;         ///< of its whirl
} whirl_critical;

/// A machine as it is studied, or otherwise.
typedef enum whirl_variant {
    WHIRL_AS_STUDIED,     ///< with springs for its bearings, where the study says so
    WHIRL_AS_GIVEN,       ///< with its own bearings
    WHIRL_BEARINGS_OF_IT, ///< these alone, on stations of 1 kg
    WHIRL_WITH_STAGES,    ///< with its own bearings and, `value` times, its stages, without seals and other impellers
    WHIRL_WITH_DRAG_AT,   ///< with its own bearings, and the seals and impellers at station `value`
    WHIRL_HELD,           ///< on springs of `value` N/m to the ground for its bearings, which hold their housings, too
    WHIRL_WITH_STATICS,   ///< as WHIRL_AS_GIVEN, with what its weight does to its shafts
} whirl_variant;

/// A machine at rest: what analyses of it are made of.
typedef struct whirl_resting {
    const whirl_system *system;     ///< of the machine
    const double *start;            ///< [dimension] where its equilibrium is looked for
    double clock, speed;            ///< rad/s: of the system's time, and of the shaft
    const whirl_modes *modes;       ///< of it, where they are asked for, else NULL
    size_t critical_count;          ///< of critical
    const whirl_critical *critical; ///< what lies between the point before and this one
    const size_t *before; ///< [modes->count] which mode of that point each was, from 1; 0: none; NULL: unknown
    /// Makes the same machine at another speed (rad/s; 0: its own), to be released; value: of the variant. Errors as
    /// those of machines.
    whirl_status (*at_speed)(const void *context, double speed, whirl_variant variant, double value,
                             whirl_machine *machine);
    /// Makes the same machine with its coefficients at a frequency of whirl, rad/s.
    whirl_status (*at_frequency)(const void *context, double frequency, whirl_variant variant, double value,
                                 whirl_machine *machine);
    const void *context;        ///< handed to at_speed and at_frequency
    size_t placed_count;        ///< of placed
    const whirl_placed *placed; ///< [placed_count] unbalances that it has in the place of its own
} whirl_resting;

/// kxx, kxy, ... of the bearings at a speed (rad/s) about where the machine rests, coefficients [probe_count][8] as
/// whirl_bearing_coefficients has them; 0 of a film that cavitates with the journal in its middle, where slopes differ
/// with the side. Errors as these.
whirl_status whirl_bearings_at(const whirl_resting *point, double speed, double *coefficients);

/// Fills `block` [layout->size] with what the chosen analyses, all of machines at rest, say of one. Errors as
/// whirl_forced_response.
whirl_status whirl_analyze_resting(const whirl_resting *point, const whirl_record_options *options,
                                   whirl_analysis_set set, const whirl_layout *layout, double *block);

/// A point of a branch, as it stands among those of a study.
typedef struct whirl_trace {
    const whirl_system *system; ///< of its machine
    whirl_branch_point point;   ///< the orbit there and what happens at it
    size_t branch;              ///< which it is of, from 1 in the order in which they were found
    size_t parent;              ///< along which that one begins; 0: at a motion that settled, or at rest
    double end;                 ///< whirl_branch_end at its last point, else NaN
} whirl_trace;

/// Fills `block` [layout->size] of the analysis "trace" with a point. WHIRL_BAD_INPUT where an orbit has more
/// revolutions or segments than the options say.
whirl_status whirl_analyze_trace(const whirl_trace *trace, const whirl_record_options *options,
                                 const whirl_layout *layout, double *block);

/// The point that a block holds, at a value, but for its bounds: *trace, whose orbit is freed by whirl_orbit_free and
/// whose system is not known. WHIRL_BAD_INPUT where it holds none, WHIRL_NO_MEMORY.
whirl_status whirl_block_trace(const whirl_layout *layout, const double *block, double value,
                               const whirl_record_options *options, whirl_trace *trace);

/// "fold", "period doubling", "Neimark-Sacker", ...; "" of a regular point. Static text.
const char *whirl_special_name(whirl_special special);

/// What begins or ends at a special point, in words, with the sense of its criticality where that is known. Writes at
/// most `size` bytes.
void whirl_special_text(const whirl_branch_point *point, char *text, size_t size);

/// "P-2", "limit cycle", "equilibrium". Writes at most `size` bytes.
void whirl_orbit_name(const whirl_orbit *orbit, char *text, size_t size);

/// Why a branch ends, in words. Static text.
const char *whirl_branch_end_text(whirl_branch_end end);

/// What whirl_torus_trace.end says besides whirl_torus_end: no torus was found at the point.
enum { WHIRL_TORUS_NONE = WHIRL_TORUS_STOPPED + 1 };

/// A torus as it stands among those of a study.
typedef struct whirl_torus_trace {
    const whirl_system *system;   ///< of its machine
    const whirl_torus *torus;     ///< NULL where none was found
    const whirl_torus_view *view; ///< of it
    size_t number;                ///< of its branch of tori, from 1 in the order of the points at which these begin
    size_t branch;                ///< of orbits, along which it begins
    size_t point;                 ///< of the table of branches: the Neimark-Sacker point, from 1
    double begins;                ///< value of the parameter there
    double end;                   ///< whirl_torus_end or WHIRL_TORUS_NONE at its last torus, else NaN
    double limit;                 ///< whirl_torus_branch.limit there, else NaN
} whirl_torus_trace;

/// Fills `block` [layout->size] of the analysis "torus". WHIRL_BAD_INPUT where a torus has more nodes or revolutions
/// than the options say.
whirl_status whirl_analyze_torus(const whirl_torus_trace *trace, const whirl_record_options *options,
                                 const whirl_layout *layout, double *block);

/// Why a branch of tori ends whose last one is near the resonance p/q (NaN: near none), in words: "it locks near 2/5".
/// Writes at most `size` bytes.
void whirl_torus_end_text(double end, double p, double q, char *text, size_t size);

/// The verdict that a block holds; regime WHIRL_UNDETERMINED with NaN evidence when it holds none.
whirl_verdict whirl_block_verdict(const whirl_layout *layout, const double *block);

/// Looks for a refuge (whirl_record_refuge) of the motion whose block this is, where that calls it chaotic by clear
/// evidence, and notes it there. WHIRL_NO_MEMORY alone is an error.
whirl_status whirl_block_seek_refuge(const whirl_layout *layout, double *block, const whirl_system *system,
                                     const whirl_integrate_options *integrate, const whirl_record *record);

/// Confirms (whirl_verdict_confirm) the verdict that a block holds with that at another tolerance.
void whirl_block_confirm(const whirl_layout *layout, double *block, const whirl_verdict *other);

/// Sets beside the verdict that a block holds what became of a copy of its motion (whirl_verdict_follow).
void whirl_block_follow(const whirl_layout *layout, double *block, const whirl_verdict *later, double revolutions);

/// Adds to the errors of the exponents that a block holds by how much they differ from those of the same motion at
/// another tolerance, in a block of another layout: that much is the method's own.
void whirl_block_compare_exponents(const whirl_layout *layout, double *block, const whirl_layout *other_layout,
                                   const double *other);

#ifdef __cplusplus
}
#endif
#endif
