/// The study of a case as its file has it, before parameters have values.
#ifndef CASE_PLAN_PARTS_H
#define CASE_PLAN_PARTS_H

#include "machine.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/sensitivity.h"
#include "whirl/engine/spread.h"
#include "whirl/engine/study.h"

#include <stddef.h>

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

/// The distribution of a parameter as it is written in the case.
typedef struct distribution_parts {
    const parameter *parameter;
    const file_node *place;
    setting_list keys;                        ///< keys of a mapping; none for a text alone
    bool within, own;                         ///< within: bounds around a value are given; own: that value is the
                                              ///< parameter's own
    bool relative;                            ///< `below` and `above` are parts of the value
    double value, below, above;               ///< the middle value, and the distances of its bounds
    number_formula from, to, mean, deviation; ///< if their keys are given
} distribution_parts;

/// Numbers of every point that a part of the study asks for.
typedef struct asked_parts {
    size_t count;
    whirl_spread_of spreads[PLAN_MAX_SPREADS];
    const file_node *places[PLAN_MAX_SPREADS];
    const char *units[PLAN_MAX_SPREADS]; ///< SI unit of the limits, "1" for plain numbers
    bool found[PLAN_MAX_SPREADS];        ///< some table of the study has the number
} asked_parts;

/// Parameters by which numbers are differentiated.
typedef struct sensitivity_parts {
    setting_list keys; ///< without a place: nothing is differentiated
    size_t count;
    const parameter *parameters[WHIRL_MAX_SENSITIVITIES];
    const file_node *places[WHIRL_MAX_SENSITIVITIES];
    asked_parts asked;
} sensitivity_parts;

/// Parameters with tolerances, and the numbers that are asked of all samples.
typedef struct tolerance_parts {
    setting_list keys; ///< without a place: there is no study of tolerances
    size_t count;
    distribution_parts distributions[WHIRL_MAX_TOLERANCES];
    asked_parts asked;
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

/// A label of a data set as it is written in the case.
typedef struct label_parts {
    const file_node *place;
    setting_list keys;
    size_t graded_count;
    graded_parts *graded;
    distribution_list varied;
} label_parts;

/// Numbers of a channel whose unit depends on the sensor.
enum { CHANNEL_SENSITIVITY, CHANNEL_FROM, CHANNEL_TO, CHANNEL_NOISE, CHANNEL_FULL_SCALE, CHANNEL_NUMBERS };

/// A channel of a data set as it is written in the case.
typedef struct channel_parts {
    const file_node *place;
    setting_list keys;
    whirl_sensor sensor;
    size_t station;
    const char *name;
    const setting *given[CHANNEL_NUMBERS];
    number_formula numbers[CHANNEL_NUMBERS];
} channel_parts;

/// A data set as it is written in the case.
typedef struct dataset_parts {
    setting_list keys; ///< without a place: there is no data set
    const machine_parts *machine;
    distribution_list vary, conditions;
    const setting_list *runup;         ///< keys of the run of its records, or NULL
    const struct course_parts *course; ///< their table of speeds
    size_t label_count, channel_count;
    label_parts *labels;
    channel_parts *channels;
} dataset_parts;

/// The parts of `study:` that can be read before parameters have values.
typedef struct plan_parts {
    setting_list study, integrate, keep, detail, branch, curves, map, starts;
    tolerance_parts tolerances;
    sensitivity_parts sensitivity;
    dataset_parts dataset;
    size_t resting_count, condition_count;
    /// Studies at rest, in the order of the registry and of the file, then motions next to them.
    resting_parts resting[PLAN_MAX_RESTING];
    condition_parts conditions[PLAN_MAX_CONDITIONS];
    bool moves;               ///< motions are followed: a response, a sweep or a map
    bool beside;              ///< motions are followed next to studies at rest (motions)
    bool branches, swept_too; ///< branches: branches are traced; swept_too: next to a sweep
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

/// Reads a part of the study; an absent one is empty.
void plan_read_part(case_reader *reader, const setting_list *study, const char *key, const whirl_group *group,
                    setting_list *part);

/// Returns the parameter that a key names; NULL after a problem.
const parameter *plan_find_parameter(case_reader *reader, const setting *given);

/// Reads the parameter and its values from the keys of an axis.
void plan_read_axis(case_reader *reader, axis_parts *axis);

#endif
