/// The study of a case: its points, their initial states, and the options of records and analyses.
#ifndef CASE_PLAN_H
#define CASE_PLAN_H

#include "machine.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/claims.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/spread.h"
#include "whirl/engine/study.h"

#include <stddef.h>

// ---------------------------------------------------------------- schema
// The keys of a case file outside stations and elements, and of a claims file.

enum { SCHEMA_VERSION = 1, SCHEMA_MAX_POINTS = 10000000, SCHEMA_MAX_DETAIL = 1000 };

/// Group `rotor` for studies that allow speed 0. It is not listed, since only the range of its speed differs.
extern const whirl_group schema_still_rotor;
extern const whirl_group schema_case, schema_document, schema_rotor, schema_study, schema_response, schema_sweep,
    schema_map, schema_basin, schema_axis, schema_motions, schema_branch, schema_curves, schema_initial, schema_starts,
    schema_integrate, schema_keep, schema_detail, schema_event, schema_fit_unknown, schema_fit_data, schema_tolerances,
    schema_distribution, schema_limit, schema_dataset, schema_label, schema_grade, schema_channel;

#define SCHEMA_INDEX_AT_REST(name, ...) SCHEMA_AT_REST_##name,

/// Number of studies at rest.
enum { WHIRL_STUDIES_AT_REST(SCHEMA_INDEX_AT_REST) SCHEMA_AT_REST };

/// Groups of the studies at rest (WHIRL_STUDIES_AT_REST), ended by one without a name.
extern const whirl_group schema_at_rest[];

/// The unit that a plain number of the initial state may have instead, "m" or "m/s"; "" for all other keys.
const char *schema_scaled_unit(const whirl_key *key);

extern const whirl_group schema_claims, schema_claim;

/// The initial state of one station.
typedef struct plan_start {
    size_t station;
    setting_list state;
} plan_start;

/// Ranges of starts at one station; both ends have the same keys.
typedef struct plan_range {
    size_t station;
    setting_list low, high;
    size_t *points; ///< [low.count] grid values in each, 0 if none was read; NULL: starts fill the ranges evenly
} plan_range;

/// Places of a batch in the case.
typedef struct plan_origin {
    const struct course_parts *course; ///< events and laws of a run-up, or NULL
    const file_node *place;            ///< place of the whole batch
    const file_node *const *each;      ///< [count] places of the values, if each has one; NULL: only the ends have
    const file_node *first, *last;     ///< places of the ends of the sweep
    const file_node *across;           ///< place of the last value from row to row of a map
    const file_node *planes;           ///< ... from plane to plane
    whirl_unit units[3];               ///< units of the values where their parameter has another unit, size 0: none
    double end;                        ///< end that the steps of the sweep do not reach; NaN if they reach it
    bool rest;                         ///< points start from zero instead of the initial state
} plan_origin;

typedef struct study_plan {
    size_t batch_count;
    whirl_batch batches[WHIRL_MAX_BATCHES]; ///< values are the arena's
    plan_origin origins[WHIRL_MAX_BATCHES];
    size_t start_count;
    plan_start *starts;
    size_t range_count;
    plan_range *ranges; ///< ranges of further starts, in the order of the file
    size_t tolerated_count, spread_count;
    whirl_tolerance *tolerated;   ///< parameters with tolerances
    whirl_spread_of *spreads;     ///< numbers that are asked of all samples
    const whirl_dataset *dataset; ///< data set, or NULL
} study_plan;

/// A list of numbers, each with its place.
typedef struct formula_list {
    size_t count;
    number_formula *items;
    const file_node **places;
} formula_list;

/// A parameter and its values.
typedef struct axis_parts {
    setting_list keys;          ///< keys of the axis: parameter, from, to, ...
    const parameter *parameter; ///< NULL: none was found
    const char *unit;           ///< unit of its values, "" if neither the case nor a value so far has one
    whirl_unit written;         ///< unit in which its values are written, size 0 for plain ones
    number_formula from, to, step;
    formula_list values; ///< list of values instead, or empty
} axis_parts;

/// A condition of the machine, such as its least clearance, at which studies at rest are done: parameters at values.
typedef struct condition_parts {
    const file_node *place;
    size_t count;
    const parameter *parameters[WHIRL_MAX_GIVEN];
    const file_node *places[WHIRL_MAX_GIVEN];
    number_formula values[WHIRL_MAX_GIVEN];
} condition_parts;

/// A study at rest, or motions next to such studies.
typedef struct resting_parts resting_parts;
struct resting_parts {
    char name[WHIRL_NAME_SIZE];        ///< name of its table
    axis_parts axis;                   ///< axis with its group; without a parameter there is one point
    const resting_parts *unbalances;   ///< for motions: the study that places their unbalances, or NULL
    const struct course_parts *course; ///< for run-ups: their events and laws, or NULL
    const struct fit_parts *fit;       ///< for fits: their unknowns and tables, or NULL
};

enum { PLAN_MAX_RESTING = 16, PLAN_MAX_CONDITIONS = 8, PLAN_MAX_SPREADS = 16 };

/// The distribution of a parameter as the case has it.
typedef struct distribution_parts {
    const parameter *parameter;
    const file_node *place;
    setting_list keys;                        ///< keys of a mapping; none for a text alone
    bool within, own;                         ///< bounds around a value are given; that value is the parameter's own
    bool relative;                            ///< `below` and `above` are parts of the value
    double value, below, above;               ///< that value, and the distances of its bounds
    number_formula from, to, mean, deviation; ///< if their keys are given
} distribution_parts;

/// Parameters with tolerances, and the numbers that are asked of all samples.
typedef struct tolerance_parts {
    setting_list keys; ///< without a place: there is no study of tolerances
    size_t count;
    distribution_parts distributions[WHIRL_MAX_TOLERANCES];
    size_t spread_count;
    whirl_spread_of spreads[PLAN_MAX_SPREADS];
    const file_node *spread_places[PLAN_MAX_SPREADS];
    const char *units[PLAN_MAX_SPREADS]; ///< SI unit of the limits, "1" for plain numbers
} tolerance_parts;

/// Distributions of several parameters.
typedef struct distribution_list {
    size_t count;
    distribution_parts *items; ///< [count]
} distribution_list;

/// A parameter that the severity of a fault sets.
typedef struct graded_parts {
    const parameter *parameter;
    const file_node *place;
    setting_list keys;
    number_formula from, to;
} graded_parts;

/// A label of a data set as the case has it.
typedef struct label_parts {
    const file_node *place;
    setting_list keys;
    size_t graded_count;
    graded_parts *graded;
    distribution_list varied;
} label_parts;

/// Numbers of a channel whose unit depends on the sensor.
enum { CHANNEL_SENSITIVITY, CHANNEL_FROM, CHANNEL_TO, CHANNEL_NOISE, CHANNEL_FULL_SCALE, CHANNEL_NUMBERS };

/// A channel of a data set as the case has it.
typedef struct channel_parts {
    const file_node *place;
    setting_list keys;
    whirl_sensor sensor;
    size_t station;
    const char *name;
    const setting *given[CHANNEL_NUMBERS];
    number_formula numbers[CHANNEL_NUMBERS];
} channel_parts;

/// A data set as the case has it.
typedef struct dataset_parts {
    setting_list keys; ///< without a place: there is no data set
    const machine_parts *machine;
    distribution_list vary, conditions;
    size_t label_count, channel_count;
    label_parts *labels;
    channel_parts *channels;
} dataset_parts;

/// Reads `study:` in two steps. First everything that needs no values, with all its problems ...
typedef struct plan_parts {
    setting_list study, integrate, keep, detail, branch, curves, map, starts;
    tolerance_parts tolerances;
    dataset_parts dataset;
    size_t resting_count, condition_count;
    /// Studies at rest, in the order of the registry and of the file, then motions next to them.
    resting_parts resting[PLAN_MAX_RESTING];
    condition_parts conditions[PLAN_MAX_CONDITIONS];
    bool moves;               ///< motions are followed: a response, a sweep or a map
    bool beside;              ///< motions are followed next to studies at rest (motions)
    bool branches, swept_too; ///< branches are traced; and there is a sweep
    axis_parts sweep;         ///< parameter of a sweep, of branches, or along the rows of a map
    axis_parts across;        ///< parameter from row to row of a map, else empty
    axis_parts planes;        ///< parameter from plane to plane of a map, else empty
    formula_list at;          ///< values of the detail
    number_formula low, high; ///< bounds of branches, if given
    formula_list begins;      ///< values at which branches begin, empty: at the first bound
    const parameter *second;  ///< parameter of curves
    number_formula second_low, second_high;
    whirl_analysis_set analyses; ///< analyses of motions
} plan_parts;

void plan_read_parts(case_reader *reader, const file_node *where, const machine_parts *machine, plan_parts *parts,
                     study_plan *result);

/// ... then the batches, with the parameters' values. Call it when nothing is wrong so far.
void plan_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result);

/// Fills in the initial state [dimension] of a batch's points, in the scales of the machine. Start 0 is the case's
/// initial state; others are in the ranges.
whirl_status plan_start_state(const study_plan *plan, size_t batch, size_t start, valuation *v,
                              const whirl_rotor *rotor, double *state);

/// Returns the number of parameter values at which a batch has its machines: varied ones (NaN: none), fixed ones, and
/// those of the sample that the batch requests.
enum {
    PLAN_MAX_GIVEN = 3 + 2 * WHIRL_MAX_GIVEN + WHIRL_MAX_DRAWN,
    PLAN_GIVEN_TEXT = PLAN_MAX_GIVEN * (2 * WHIRL_NAME_SIZE + 32)
};
size_t plan_given(const whirl_batch *batch, double value, double second, double third,
                  whirl_given given[PLAN_MAX_GIVEN]);

/// As plan_given, for one point of a batch, by its index among the values of its axes.
size_t plan_given_at(const whirl_batch *batch, size_t point, whirl_given given[PLAN_MAX_GIVEN]);

/// Returns the index of the batch of a name; `batch_count` if there is none.
size_t plan_batch(const study_plan *plan, const char *name);

/// Returns true if a batch has motions, or traces them; false for studies at rest.
bool plan_moves(const whirl_batch *batch);

/// Refuses speed 0 if motions are counted in revolutions. WHIRL_BAD_INPUT with a sentence.
whirl_status plan_check_speed(const whirl_batch *batch, double speed);

/// Refuses an initial state outside a bearing of the machine `rotor`, where there is no oil film.
void plan_check_start(case_reader *reader, const study_plan *plan, size_t batch, valuation *v,
                      const machine_parts *machine, const whirl_rotor *rotor);

// ---------------------------------------------------------------- parts of a study, for the files plan*.c

/// Reads a part of the study; an absent one is empty.
void plan_read_part(case_reader *reader, const setting_list *study, const char *key, const whirl_group *group,
                    setting_list *part);

/// Returns the parameter that a key names; NULL after a problem.
const parameter *plan_find_parameter(case_reader *reader, const setting *given);

/// Reads the parameter and its values from the keys of an axis.
void plan_read_axis(case_reader *reader, axis_parts *axis);

/// Evaluates a formula; returns false after a problem.
bool plan_formula_value(case_reader *reader, valuation *v, const file_node *where, const number_formula *formula,
                        double *value);

/// Returns the origin of the batch that is added next.
plan_origin *plan_next_origin(study_plan *result);

/// Adds a batch of one point.
whirl_batch *plan_add_batch(study_plan *result, whirl_role role, const char *name, const file_node *place);

/// Adds a batch like the one at index `like`, with another role, name and place.
whirl_batch *plan_add_like(study_plan *result, size_t like, whirl_role role, const char *name, const file_node *place);

/// Adds a batch along an axis, with the name of the axis's group; NULL after a problem.
whirl_batch *plan_make_axis(case_reader *reader, valuation *v, const axis_parts *axis, whirl_role role,
                            study_plan *result);

/// Sets the options of all motions of a study.
void plan_options(valuation *v, const plan_parts *parts, whirl_integrate_options *integrate,
                  whirl_record_options *record);

/// Extends the spectra of a batch to the orders at which parts of a machine act (plus one sideband), unless `keep` has
/// a limit, and increases the samples to match, unless `keep` has their number.
void plan_raise_order(const plan_parts *parts, const whirl_system *system, whirl_batch *batch);

/// Sets the starts of a batch of motions, and their options.
void plan_finish_points(case_reader *reader, valuation *v, const plan_parts *parts, const study_plan *plan,
                        whirl_batch *batch);

/// Sets the record to what the chosen analyses need; studies at rest and branches record nothing.
void plan_choose_analyses(whirl_batch *batch, whirl_analysis_set chosen, bool spectra);

// ---------------------------------------------------------------- claims_read
// Claims from memory.

/// Like whirl_claims_load, from memory; `name` is used in messages.
whirl_status claims_parse(const char *text, size_t length, const char *name, whirl_problems *problems,
                          whirl_claims **claims);

// ---------------------------------------------------------------- plan_resting
// Studies of machines at rest, any number of them in a case, each at every condition that the case names.

/// Reads the studies of machines at rest, and their conditions.
void resting_read(case_reader *reader, const machine_parts *machine, plan_parts *parts);

/// Makes the batches of studies at rest after the existing ones, as plan_make does.
void resting_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result);

// ---------------------------------------------------------------- plan_names
// What studies name: stations of the machine, and parameters with values.

/// Reads one station, or several as a list, or as a text with blanks as in options of analyses.
void plan_read_stations(case_reader *reader, const machine_parts *machine, const setting_list *keys, const char *key,
                        bool several);

/// Returns the parameter that the key of a place names; NULL after a problem.
const parameter *plan_find_named(case_reader *reader, const file_node *where);

/// Refuses a parameter that is an expression over others, where one with a number of its own is needed; false then.
bool plan_check_free(case_reader *reader, const file_node *where, const parameter *own);

/// Reads a value that a condition, or a change, gives to a parameter.
void plan_read_given(case_reader *reader, const file_node *where, condition_parts *condition);

/// Reads the key `change`: parameters with the values that they have after it.
void plan_read_change(case_reader *reader, setting_list *keys, condition_parts *change);

// ---------------------------------------------------------------- plan_tolerances
// Studies of tolerances: distributions of parameters, and batches of samples of other batches.

/// Reads the distribution of the parameter that a key names; false after a problem with its name.
bool distribution_read(case_reader *reader, const file_node *where, distribution_parts *own);

/// Evaluates a distribution; returns false after a problem.
bool distribution_make(case_reader *reader, valuation *v, const distribution_parts *own, whirl_tolerance *to);

/// Reads distributions and limits.
void tolerances_read(case_reader *reader, plan_parts *parts);

/// Adds a batch of samples for every batch of points, motions or machines at rest, after all others.
void tolerances_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result);

/// Notes which of the numbers that are asked for a batch of samples has; then reports those that none has.
void tolerances_check(case_reader *reader, const plan_parts *parts, const whirl_batch *batch,
                      const whirl_layout *layout, const machine_parts *machine, const whirl_rotor *rotor,
                      bool found[PLAN_MAX_SPREADS]);
void tolerances_unfound(case_reader *reader, const plan_parts *parts, const bool found[PLAN_MAX_SPREADS]);

// ---------------------------------------------------------------- plan_dataset
// Data sets: labels with their faults, and sensors.

/// Reads the data set of a study, if it has one.
void dataset_read(case_reader *reader, const machine_parts *machine, plan_parts *parts);

/// Adds the batch of its records, after those of plan_make. Its motions are long and dense enough for the samples.
void dataset_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result);

// ---------------------------------------------------------------- iso_286
// Tolerance classes of sizes, "H7" (ISO 286-1:2010).

/// Finds the limits of a class, from the nominal size, all in m. On failure `why` is the reason.
bool iso_286_limits(const char *name, double size, double *lower, double *upper, char why[WHY_SIZE]);

// ---------------------------------------------------------------- plan_course
// The course of a run: its events, and its laws of speed, torque and ground.

/// An event as the case has it.
typedef struct course_event {
    const file_node *place;
    setting_list keys; ///< its keys, or those of the run
    bool alone;        ///< it is the change that the run's own keys give
    const char *name;  ///< or NULL
    size_t after;      ///< index of the event before, or WHIRL_NO_EVENT
    const char *when;  ///< formula, or NULL
    size_t station;    ///< where an unbalance appears; the number of stations: nowhere
    bool trip, end;
    condition_parts change; ///< parameters that change
} course_event;

/// A row of a table over the time.
typedef struct course_row {
    const file_node *place;
    number_formula time, value;
} course_row;

/// A table over the time: of the case, or of a file.
typedef struct course_table {
    size_t count;
    course_row *rows; ///< [count]
} course_table;

typedef struct course_parts {
    size_t event_count;
    course_event events[WHIRL_MAX_EVENTS];
    course_table speeds;
    const char *laws[WHIRL_FORMULA_EVENT];    ///< formulas in the order of whirl_run_formula, or NULL
    course_table tables[WHIRL_FORMULA_EVENT]; ///< ... or tables in their place
} course_parts;

/// A course with the values of a point.
typedef struct course_run course_run;

/// Reads the course from the keys of a run; NULL if there is none, or no memory.
const course_parts *course_read(case_reader *reader, const machine_parts *machine, setting_list *keys);

/// Evaluates its expressions and reports wrong ones. Returns false if there are any.
bool course_check(case_reader *reader, valuation *v, const course_parts *parts);

/// Makes the course at a point, of a machine with that unit of displacement, m. *out is freed by course_free, after a
/// failure, too.
whirl_status course_make(const course_parts *parts, const machine_parts *machine, valuation *v, double length,
                         course_run **out);
const whirl_run_course *course_shown(const course_run *run);

/// Checks that its laws have values at the beginning, at a speed in rad/s, and their tables to the end, s.
/// WHIRL_BAD_INPUT with a sentence.
whirl_status course_covers(const course_run *run, double speed, double end);
void course_free(course_run *run);

/// Adds the values that an event gives to parameters behind given [*count], at most WHIRL_MAX_GIVEN.
whirl_status course_given(const course_parts *parts, size_t event, valuation *v, whirl_given *given, size_t *count);

// ---------------------------------------------------------------- plan_fit
// A fit: unknown parameters, and tables of measured numbers.

/// Most parameters that a table of measured numbers gives.
enum { FIT_MAX_AT = WHIRL_MAX_GIVEN - WHIRL_MAX_UNKNOWNS - 1 };

typedef struct fit_unknown {
    const file_node *place;
    setting_list keys;
    const parameter *parameter; ///< NULL after a problem
    number_formula start, low, high;
} fit_unknown;

typedef struct fit_set {
    const file_node *place, *file; ///< place of the table in the case, and of its path; NULL after a problem
    setting_list keys;
    condition_parts at; ///< parameters with their values in its motions
} fit_set;

typedef struct fit_parts {
    setting_list keys;
    const machine_parts *machine;
    size_t unknown_count, set_count;
    fit_unknown unknowns[WHIRL_MAX_UNKNOWNS];
    fit_set sets[WHIRL_MAX_FIT_SETS];
} fit_parts;

/// Reads the keys of a fit; NULL without memory.
const fit_parts *fit_read(case_reader *reader, const machine_parts *machine, const setting_list *keys);

/// Reads the tables, and completes the batch of a fit, whose options are set. Tables that cannot be read are not
/// reported: the study is refused (whirl_fit.trouble).
void fit_make(case_reader *reader, valuation *v, const fit_parts *parts, whirl_batch *batch);

#endif
