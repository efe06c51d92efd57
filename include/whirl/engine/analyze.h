/// Analyses: the numbers of one point (one parameter value, one start).
///
/// A motion is first *recorded* (whirl/engine/record.h). Each *analysis* then turns the record into numbers. The
/// numbers of a point form one block of doubles; a *layout* names them. Analyses describe their fields, and case files,
/// result files and exports follow from these descriptions.
#ifndef WHIRL_ANALYZE_H
#define WHIRL_ANALYZE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/branch.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/fit.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/record.h"
#include "whirl/engine/running.h"
#include "whirl/engine/system.h"
#include "whirl/engine/torus_branch.h"
#include "whirl/engine/verdict.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Roles of the points of a table in a study, whatever their analyses.
typedef enum whirl_role {
    WHIRL_ROLE_POINT,      ///< one point at the case's own parameters: "response"
    WHIRL_ROLE_SURVEY,     ///< points along a parameter: "sweep"
    WHIRL_ROLE_DETAIL,     ///< some points of a survey, recorded longer: "detail"
    WHIRL_ROLE_MAP,        ///< points over two or three parameters: "map"
    WHIRL_ROLE_BASIN,      ///< starts of one machine: "basin"
    WHIRL_ROLE_BRANCHES,   ///< orbits along a parameter: "branch"
    WHIRL_ROLE_CURVES,     ///< special points over two parameters: "curves"
    WHIRL_ROLE_TORI,       ///< points of branches of tori: "tori"
    WHIRL_ROLE_MOTIONS,    ///< motions that accompany studies at rest: "motions"
    WHIRL_ROLE_REST,       ///< machines at rest: "modes", "statics", ...
    WHIRL_ROLE_TOLERANCES, ///< samples of parameters with tolerances, in motion or at rest
    WHIRL_ROLE_RECORDS,    ///< records of a data set: "records"
    WHIRL_ROLES
} whirl_role;

/// Returns the name of a role in results: "survey", "detail", ... Static text.
const char *whirl_role_name(whirl_role role);

/// Returns the role of that name; WHIRL_ROLES if there is none.
whirl_role whirl_role_of(const char *name);

/// A field: one named group of numbers in the block of a point. For every point, station (probe) or contact it is an
/// array [rows][columns] (1 x 1: a number), row-major. Missing values are NaN.
typedef struct whirl_field {
    char name[WHIRL_NAME_SIZE]; ///< "analysis/quantity", as "lyapunov/largest"
    const char *unit; ///< "length", "force", "1", "revolution", "1/revolution", "order"; "length" is the case's scale
    const char *meaning;  ///< one line; for columns their names, separated by ", "
    whirl_extent extent;  ///< extent: point, station or contact
    size_t rows, columns; ///< size of the array
    size_t repeat;        ///< 1, or the number of stations or contacts
    size_t offset;        ///< index of its first number in the block; the next repetition follows after rows * columns
    /// 0; or the number of single-precision numbers in a row, two in each column. Result files store such fields
    /// separately (whirl_signals_read); tables, exports and documents leave them out.
    size_t singles;
} whirl_field;

/// Maximum number of fields of a block, and of columns with names.
enum { WHIRL_MAX_FIELDS = 384, WHIRL_MAX_COLUMNS = 32 };

/// The fields of a point's block.
typedef struct whirl_layout {
    size_t field_count;                   ///< number of fields
    whirl_field fields[WHIRL_MAX_FIELDS]; ///< in the order of the block
    size_t size;                          ///< doubles of the block
} whirl_layout;

/// A kind of points: their common behaviour. Users of batches and tables read these members instead of comparing kinds.
typedef struct whirl_kind {
    const char *name;   ///< "motion", "rest", "branch", "torus"
    const char *asked;  ///< the way a case asks for its analyses, a sentence
    const char *method; ///< the method of finding its points; NULL: integration, by the method of their options
    const char *place; ///< words for the state of points at rest: "about where the machine rests"; NULL for other kinds
    const char *begins; ///< points at which its branches begin, in words; NULL: they begin at values of the parameter
    const char *remark; ///< remark that follows the name of `method` in texts, or ""
    /// True if its points are motions: with a start, a transient, a record and a verdict, and so with several starts,
    /// confirmation and refinement.
    bool moves;
    bool settles; ///< motions are at least integrated until they settle
    /// True if a run finds its points: their number, at most record.trace.points, and their parameter values are known
    /// at the end. Their options also include those of whirl_trace_members.
    bool found;
    double cost; ///< approximate cost of a point in revolutions, 1 at rest; 0: the revolutions of its motion
    bool still;  ///< true if its machines may have speed 0, and so no revolutions
} whirl_kind;

// clang-format off
/// Studies of machines at rest: name, meaning, source, and `STILL` if also for machines at speed 0, `RUNNING` if the
/// speed changes, `FITTED` if motions are fitted to measured ones, else `TURNING`. Each is both an analysis and a part
/// of a study of that name.
#define WHIRL_STUDIES_AT_REST(study)                                                                                   \
    study(modes, "frequencies, damping, whirl and shapes of small motions about the position of rest",                 \
          "Friswell, Penny, Garvey, Lees 2010; Floquet 1883 where coefficients turn with the shaft", STILL)            \
    study(unbalance, "synchronous response to unbalance about the position of rest",                                   \
          "Friswell, Penny, Garvey, Lees 2010", TURNING)                                                               \
    study(critical_speeds, "critical speeds without damping, all at once, forward and backward",                       \
          "Friswell, Penny, Garvey, Lees 2010", TURNING)                                                               \
    study(stability, "decrements over the cross coupling of stages, its limit, and the effect of seals and impellers", \
          "Wachel, von Nimitz 1981; API 617", TURNING)                                                                 \
    study(statics, "sag, bending moments and loads of bearings by the weight, and elevations of bearings",             \
          "Przemieniecki 1968", STILL)                                                                                 \
    study(torsion, "steady response of stations that twist to torques at orders of the speed and fixed frequencies",   \
          "Holzer 1921; Nestorides 1958; API RP 684", TURNING)                                                         \
    study(runup, "run up or down: the motion over time while the speed changes, by a rate or by a drive",              \
          "Lewis 1932; Sommerfeld 1902; Kononenko 1969", RUNNING)                                                      \
    study(fit, "parameters at which motions are the measured ones, with their errors",                                 \
          "Levenberg 1944; Marquardt 1963; More 1978", FITTED)
// clang-format on

/// Description of an analysis.
typedef struct whirl_analysis {
    const char *name;    ///< as written in a case file: "poincare", "spectrum", ...
    const char *meaning; ///< one line
    const char *source;  ///< author, year; "" if nothing is cited
    bool usual;          ///< true if computed by default
    bool kept;           ///< true if it is computed whenever waveforms are stored, and only then (whirl_analysis_fit)
    const whirl_kind *kind; ///< kind of its points
} whirl_analysis;

/// Returns all analyses; static, ended by an entry whose name is NULL.
const whirl_analysis *whirl_analyses(void);

/// A set of analyses, one bit per index in whirl_analyses().
typedef unsigned whirl_analysis_set;

/// Adds the analysis of that name; false if there is none.
bool whirl_analysis_add(whirl_analysis_set *set, const char *name);

/// Returns true if a set has the analysis of that name.
bool whirl_analysis_has(whirl_analysis_set set, const char *name);

/// Returns the kind of points of a set, which is the same for all of its analyses; that of motions for an empty set.
/// Static.
const whirl_kind *whirl_analysis_kind(whirl_analysis_set set);

/// Returns the default analyses.
whirl_analysis_set whirl_analysis_usual(void);

/// Returns the name of the analysis whose fields hold the verdict.
const char *whirl_analysis_of_verdicts(void);

/// Returns the name of the analysis that compares results with the ranges of validity of the machine's laws
/// (whirl_law_range). Every set for motions or machines at rest contains it.
const char *whirl_analysis_of_ranges(void);

/// Returns the set with the analyses that need stored waveforms (whirl_analysis.kept) added if the options store
/// waveforms, and removed otherwise.
whirl_analysis_set whirl_analysis_fit(whirl_analysis_set set, const whirl_record_options *options);

/// Makes options record the inputs of the analyses: the waveform, the growth of perturbations. Other options stay.
void whirl_analysis_needs(whirl_analysis_set set, whirl_record_options *options);

/// Builds the layout of a point's block for a system, options and analyses. WHIRL_BAD_INPUT for contradicting options.
whirl_status whirl_layout_new(const whirl_system *system, const whirl_integrate_options *integrate,
                              const whirl_record_options *options, whirl_analysis_set set, whirl_layout *layout);

/// Checks that a system has what the analyses look at, such as torques of a response to torques. WHIRL_BAD_INPUT.
whirl_status whirl_analysis_check(const whirl_system *system, whirl_analysis_set set);

/// Builds the layout of all fields, for a machine of one station and one contact, with several rows for each field that
/// can have them.
whirl_status whirl_layout_known(whirl_layout *layout);

/// Checks the layout of a table of branches or tori that was read: all fields of these analyses exist, with the rows
/// required by the options and the dimension (from the first field), and with bounded revolutions and nodes.
/// WHIRL_BAD_INPUT names the error.
whirl_status whirl_layout_check(const whirl_layout *layout, whirl_analysis_set set,
                                const whirl_record_options *options);

/// Checks a block of such a table in the same way.
whirl_status whirl_block_check(const whirl_layout *layout, const double *block, const whirl_record_options *options);

/// Returns true if blocks hold a verdict.
bool whirl_layout_has_verdict(const whirl_layout *layout);

/// Returns the field of that name, or NULL.
const whirl_field *whirl_layout_field(const whirl_layout *layout, const char *name);

/// Writes the names of a field's columns, "x", "y"; false if they have none.
bool whirl_field_column_names(const whirl_field *field, char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE]);

/// Conventions for the size of a displacement.
typedef enum whirl_counting {
    WHIRL_FROM_CENTRE = 0, ///< a position, an extent, or the size of a part: the choice between 0-p and p-p does not
                           ///< apply
    WHIRL_ZERO_TO_PEAK,    ///< a distance from the centre: zero to peak for any `units`, as it is not sinusoidal
    WHIRL_AMPLITUDE        ///< amplitude of a sinusoid: stored zero to peak, shown as `units` require
} whirl_counting;

/// Returns the unit of a column, as whirl_field.unit, and also "length/radian", "rad/s" and "parameter" (SI), for
/// columns whose name gives them. Static text, or the field's.
const char *whirl_column_unit(const whirl_field *field, size_t column);

/// Returns the convention for the lengths of a field: its meaning says "0-p amplitude" for sinusoids, "0-p" for other
/// distances.
whirl_counting whirl_field_counting(const whirl_field *field);

/// Returns true if the analyses have a field of that name with rows, also if options give it a single row.
bool whirl_analysis_has_rows(const char *field);

/// Fills `block` [layout->size] with the analyses of a record.
whirl_status whirl_analyze(const whirl_record *record, const whirl_record_options *options, whirl_analysis_set set,
                           const whirl_layout *layout, double *block);

/// Kinds of points located between two values of a parameter.
typedef enum whirl_critical_kind {
    WHIRL_CRITICAL_SPEED = 1, ///< a mode's damped frequency is the speed of the shaft
    WHIRL_ONSET,              ///< the machine loses its stability as the parameter grows
    WHIRL_RECOVERY,           ///< the machine regains its stability as the parameter grows
    WHIRL_TORSIONAL_SPEED,    ///< the frequency of a torsional mode is the speed of the shaft
    WHIRL_AXIAL_SPEED         ///< the frequency of an axial mode is the speed of the shaft
} whirl_critical_kind;

/// A critical speed, or a threshold of stability.
typedef struct whirl_critical {
    whirl_critical_kind kind; ///< its kind
    double value;             ///< value of the parameter, in SI
    double speed;             ///< speed of the shaft there, rad/s
    double frequency, ratio;  ///< frequency of the mode, rad/s, and its damping ratio
    double direction;         ///< direction of its whirl
} whirl_critical;

/// Variants of a machine.
typedef enum whirl_variant {
    WHIRL_AS_STUDIED,     ///< as in the study, possibly with springs as bearings
    WHIRL_AS_GIVEN,       ///< with its own bearings
    WHIRL_BEARINGS_OF_IT, ///< its bearings only, on stations of 1 kg
    WHIRL_WITH_STAGES,    ///< with its bearings and `value` times its stages, without seals and other impellers
    WHIRL_WITH_DRAG_AT,   ///< with its bearings, and the seals and impellers at station `value`
    WHIRL_HELD,           ///< with springs of `value` N/m to the ground as bearings, also under their housings
    WHIRL_WITH_STATICS,   ///< as WHIRL_AS_GIVEN, with the effects of weight on its shafts
} whirl_variant;

/// A measured run as samples at equal angles of the shaft, the beginning of each turn first.
typedef struct whirl_measured {
    size_t turns, samples; ///< number of turns, samples of a turn
    const double *time;    ///< [turns][samples] s, from the beginning of the record
    const double *end;     ///< [turns] s, end of each turn
    const double *x, *y;   ///< [stations][turns][samples] displacements in the unit of length of the block
} whirl_measured;

/// Saving of a long computation of a point, so that another process can continue it; no bit of the result depends on
/// it.
typedef struct whirl_saving {
    void *saved;       ///< [saved_size] state from which the computation continues; NULL: it begins at its start
    size_t saved_size; ///< bytes
    /// Returns true if the state is to be saved now; called after every turn of a run-up. NULL: it is never saved.
    bool (*due)(void *context);
    /// Receives the state after `turns` turns. If it cannot be saved, the computation goes on.
    void (*save)(void *context, double turns, const void *bytes, size_t size);
    void *context; ///< passed to both
} whirl_saving;

/// A machine at rest, for its analyses.
typedef struct whirl_resting {
    const whirl_system *system;     ///< the machine; for a measured run its stations
    const whirl_measured *measured; ///< NULL, or the measured run from which a run-up is read; the system then has only
                                    ///< its stations
    const double *start;            ///< [dimension] start of the search for its equilibrium
    double clock, speed;            ///< rates of the system's time and of the shaft, rad/s
    const whirl_modes *modes;       ///< its modes if requested, else NULL
    size_t critical_count;          ///< number of critical points
    const whirl_critical *critical; ///< critical points between the preceding point and this one
    const size_t *before; ///< [modes->count] matching mode of the preceding point, from 1; 0: none; NULL: unknown
    /// Makes the same machine at another speed (rad/s; 0: its own), which the caller releases. `value`: number that
    /// some variants need (whirl_variant). Errors as those of machines.
    whirl_status (*at_speed)(const void *context, double speed, whirl_variant variant, double value,
                             whirl_machine *machine);
    /// Makes the same machine at a speed, and with speeds of shafts that have their own, as whirl_machine_at does.
    whirl_status (*at_speeds)(const void *context, double speed, const double *spools, whirl_machine *machine);
    /// Makes the same machine at its own speed, with coefficients at a frequency of whirl, rad/s, where they depend on
    /// it; the caller releases it.
    whirl_status (*at_frequency)(const void *context, double frequency, whirl_variant variant, double value,
                                 whirl_machine *machine);
    /// Makes the same machine with a speed that changes between `lowest` and `highest`, rad/s: `driven` by its torques,
    /// or at a given rate; spools: ranges of shafts with a speed of their own. happened [count]: the events of its
    /// course that have happened, in this order. Errors as whirl_running_new.
    whirl_status (*running)(const void *context, double lowest, double highest, bool driven,
                            const whirl_spool_range *spools, size_t count, const unsigned char *happened,
                            whirl_running **running);
    const void *context; ///< passed to at_speed, at_speeds, at_frequency and running
    /// Called by run-ups after every turn, with the time up to which the block is filled in, s, and the share of the
    /// run that is done; NULL: not called.
    void (*passed)(void *watcher, double time, double share);
    void *watcher;                  ///< passed to it
    const whirl_saving *saving;     ///< NULL, or how the state of a run-up is saved
    double drive_speed;             ///< whirl_machine.drive_speed
    const whirl_run_course *course; ///< whirl_machine.course
    const whirl_runup_options *run; ///< NULL, or the options of its run-up, in place of those of the analysis; they
                                    ///< have the same method, tolerances, samples, sensitivity, and numbers of rows
                                    ///< and views
    whirl_run_motion *motion;       ///< NULL, or receives the motion of a run-up at equal times; borrowed
    const whirl_stop *stop;         ///< NULL, or a flag that becomes true when long work shall end; the numbers of the
                                    ///< block are then meaningless
    size_t placed_count;            ///< number of placed unbalances
    const whirl_placed *placed;     ///< [placed_count] unbalances that replace its own
    const double *rest;             ///< [dimension] equilibrium found from the start; may be NULL without `elsewhere`
    const double *elsewhere;        ///< [dimension] another equilibrium, found from a neighbouring value's; NULL: none
    double elsewhere_growth;        ///< largest real part of all eigenvalues there, per unit of the system's time
    const whirl_fit *fit;           ///< NULL, or the fit of a study of fits
    const whirl_fit_solution *solution; ///< NULL, or the result of that fit; the system and all other pointers are then
                                        ///< NULL
} whirl_resting;

/// Computes kxx, kxy, ... of the bearings at a speed (rad/s) about the machine's equilibrium, coefficients
/// [probe_count][8] as in whirl_bearing_coefficients; 0 for a cavitating film with a centred journal, whose derivatives
/// depend on the side. Errors as whirl_bearing_coefficients.
whirl_status whirl_bearings_at(const whirl_resting *point, double speed, double *coefficients);

/// Fills `block` [layout->size] with analyses of machines at rest. Errors as whirl_forced_response.
whirl_status whirl_analyze_resting(const whirl_resting *point, const whirl_record_options *options,
                                   whirl_analysis_set set, const whirl_layout *layout, double *block);

/// Fills the blocks [count][layout->size] of points as whirl_analyze_resting does. statuses [count]: on entry, points
/// with an error are left out, and their blocks get missing numbers; on return, the statuses of all other points.
/// Run-ups are carried together, in vector lanes where these take their machines; no bit of a block depends on the
/// other points. If there are several points, none may be a measured run. WHIRL_NO_MEMORY.
whirl_status whirl_analyze_resting_together(size_t count, const whirl_resting *points,
                                            const whirl_record_options *options, whirl_analysis_set set,
                                            const whirl_layout *layout, double *const *blocks, whirl_status *statuses);

/// Fills `block` [layout->size] for a machine without an equilibrium. `share` is whirl_equilibrium_share. It is 1 if
/// this machine has an equilibrium, but another machine that the analyses need has none. All numbers but ranges/rest
/// are missing.
void whirl_unfound_at_rest(const whirl_layout *layout, double share, double *block);

/// A point of a branch within a study.
typedef struct whirl_trace {
    const whirl_system *system; ///< its machine
    whirl_branch_point point;   ///< the orbit there, and its kind
    size_t branch;              ///< number of its branch, from 1 in the order in which they were found
    /// Number of the branch from which this branch begins; 0: it begins at a settled motion or an equilibrium.
    size_t parent;
    double end; ///< whirl_branch_end at the last point of the branch, else NaN
} whirl_trace;

/// Fills `block` [layout->size] of the analysis "trace" with a point. WHIRL_BAD_INPUT if an orbit has more revolutions
/// or segments than the options allow.
whirl_status whirl_analyze_trace(const whirl_trace *trace, const whirl_record_options *options,
                                 const whirl_layout *layout, double *block);

/// Reads the point that a block holds at a parameter value into *trace, except the system and the orbit's bounds low
/// and high. The orbit is freed by whirl_orbit_free. WHIRL_BAD_INPUT if the block holds no point, WHIRL_NO_MEMORY.
whirl_status whirl_block_trace(const whirl_layout *layout, const double *block, double value,
                               const whirl_record_options *options, whirl_trace *trace);

/// Returns "fold", "period doubling", "Neimark-Sacker", ...; "" for a regular point. Static text.
const char *whirl_special_name(whirl_special special);

/// Writes the event at a special point in words, with the sense of its criticality if known, at most `size` bytes.
void whirl_special_text(const whirl_branch_point *point, char *text, size_t size);

/// Writes the name of an orbit, at most `size` bytes: "P-2", "limit cycle", "equilibrium".
void whirl_orbit_name(const whirl_orbit *orbit, char *text, size_t size);

/// Returns the reason for the end of a branch, in words. Static text.
const char *whirl_branch_end_text(whirl_branch_end end);

/// Value of whirl_torus_trace.end if no torus was found at the point.
enum { WHIRL_TORUS_NONE = WHIRL_TORUS_STOPPED + 1 };

/// A torus of a branch within a study.
typedef struct whirl_torus_trace {
    const whirl_system *system;   ///< its machine
    const whirl_torus *torus;     ///< NULL if none was found
    const whirl_torus_view *view; ///< its view
    size_t number; ///< number of its branch of tori, from 1 in the order of the points at which these begin
    size_t branch; ///< number of the branch of orbits at which it begins
    size_t point;  ///< Neimark-Sacker point in the table of branches, from 1
    double begins; ///< parameter value of that point
    double end;    ///< whirl_torus_end or WHIRL_TORUS_NONE at the last torus of the branch, else NaN
    double limit;  ///< whirl_torus_branch.limit there, else NaN
} whirl_torus_trace;

/// Fills `block` [layout->size] of the analysis "torus". WHIRL_BAD_INPUT if a torus has more nodes or revolutions than
/// the options allow.
whirl_status whirl_analyze_torus(const whirl_torus_trace *trace, const whirl_record_options *options,
                                 const whirl_layout *layout, double *block);

/// Writes the reason for the end of a branch of tori, at most `size` bytes; its last torus is near the resonance p/q
/// (NaN: none): "it locks near 2/5".
void whirl_torus_end_text(double end, double p, double q, char *text, size_t size);

/// Returns the verdict of a block; regime WHIRL_NOT_JUDGED with NaN evidence if it holds none.
whirl_verdict whirl_block_verdict(const whirl_layout *layout, const double *block);

/// Searches for coexisting attractors (whirl_record_coexisting) if the block's verdict is chaos by clear evidence, and
/// stores the outcome in the block. WHIRL_NO_MEMORY is the only error.
whirl_status whirl_block_seek_coexisting(const whirl_layout *layout, double *block, const whirl_system *system,
                                         const whirl_integrate_options *integrate, const whirl_record *record);

/// Follows perturbed copies (whirl_record_survival) if the block's verdict is chaos with high agreement and without a
/// coexisting attractor, and stores their survival in the block; adds their revolutions to those integrated.
/// WHIRL_NO_MEMORY, WHIRL_STOPPED.
whirl_status whirl_block_survive(const whirl_layout *layout, double *block, const whirl_system *system,
                                 const whirl_integrate_options *integrate, const whirl_record *record);

/// Confirms (whirl_verdict_confirm) the verdict of a block with that at another tolerance.
void whirl_block_confirm(const whirl_layout *layout, double *block, const whirl_verdict *other);

/// Adds the verdict on a copy of the motion (whirl_verdict_follow) to that of a block.
void whirl_block_follow(const whirl_layout *layout, double *block, const whirl_verdict *later, double revolutions);

/// Adds to the errors of a block's exponents their differences from those of the same motion at another tolerance, in a
/// block of another layout: these are errors of the method.
void whirl_block_compare_exponents(const whirl_layout *layout, double *block, const whirl_layout *other_layout,
                                   const double *other);

#ifdef __cplusplus
}
#endif
#endif
