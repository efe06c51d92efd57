/// The study of a case: which points, from which states, recorded and analysed how.
#ifndef CASE_PLAN_H
#define CASE_PLAN_H

#include "machine.h"
#include "whirl/study.h"

/// The state that one station starts from.
typedef struct plan_start {
    size_t station;
    setting_list state;
} plan_start;

/// The ranges in which starts of one station lie: both ends have the same keys.
typedef struct plan_range {
    size_t station;
    setting_list low, high;
    size_t *points; ///< [low.count] values of a grid in each, 0 where none was read; NULL: starts fill them evenly
} plan_range;

typedef struct study_plan {
    size_t batch_count;
    whirl_batch batches[WHIRL_MAX_BATCHES]; ///< values are the arena's
    bool rest[WHIRL_MAX_BATCHES];           ///< the batch starts from zero instead of the initial state
    const file_node *values_place[WHIRL_MAX_BATCHES];
    /// [count] of every value, where each has one; NULL: of a sweep, whose ends have.
    const file_node *const *places[WHIRL_MAX_BATCHES];
    const file_node *first_place, *last_place; ///< of the ends of the sweep
    const file_node *across_place;             ///< of the last value from row to row of a map
    const file_node *planes_place;             ///< ... from plane to plane
    whirl_unit unit;        ///< in which the sweep writes its values, where the parameter has another one; size 0: none
    whirl_unit second_unit; ///< the same of the second parameter of a map
    whirl_unit third_unit;  ///< ... and of the third
    double end;             ///< that the steps of the sweep do not meet, NaN where they do
    size_t start_count;
    plan_start *starts;
    size_t range_count;
    plan_range *ranges; ///< of further starts, in the order of the file
} study_plan;

/// A list of numbers, each with its place.
typedef struct formula_list {
    size_t count;
    number_formula *items;
    const file_node **places;
} formula_list;

/// A parameter, and the values that it takes.
typedef struct axis_parts {
    setting_list keys;          ///< that say of it: parameter, from, to, ...
    const parameter *parameter; ///< NULL: none was found
    const char *unit;           ///< of its values, "" where neither the case nor a value read so far tells
    whirl_unit written;         ///< in which its values are written, size 0 where they are plain
    number_formula from, to, step;
    formula_list values; ///< in their place, empty where there is none
} axis_parts;

/// Reads `study:` in two steps. First what can be read without values, and everything that is wrong with it ...
typedef struct plan_parts {
    setting_list study, integrate, keep, detail, branch, curves, map, starts;
    const char *resting;      ///< a study of machines at rest, of which `sweep` is then; NULL: motions are followed
    bool branches, swept_too; ///< branches are traced; and there is a sweep
    axis_parts sweep;         ///< what is swept, along which branches go, or what varies along the rows of a map
    axis_parts across;        ///< what varies from row to row of a map, else without a parameter
    axis_parts planes;        ///< what varies from plane to plane of a map, else without a parameter
    formula_list at;          ///< of the detail
    number_formula low, high; ///< bounds of branches, where they are given
    formula_list begins;      ///< values at which branches begin, empty: at the first bound
    const parameter *second;  ///< of curves
    number_formula second_low, second_high;
    whirl_analysis_set analyses;
} plan_parts;

void plan_read_parts(case_reader *reader, const file_node *where, const machine_parts *machine, plan_parts *parts,
                     study_plan *result);

/// ... then the batches, with the parameters' values. Call it when nothing is wrong so far.
void plan_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result);

/// The state [dimension] that the points of a batch start from, in the scales of the machine: the first of their starts
/// is the initial state, the others lie in the ranges.
whirl_status plan_start_state(const study_plan *plan, size_t batch, size_t start, valuation *v,
                              const whirl_rotor *rotor, double *state);

/// The index of the batch of that name, `batch_count` where there is none.
size_t plan_batch(const study_plan *plan, const char *name);

/// Refuses a speed of 0 where motions are counted in revolutions. WHIRL_BAD_INPUT with a sentence.
whirl_status plan_check_speed(const whirl_batch *batch, double speed);

/// Refuses an initial state that lies outside a bearing of the machine `rotor`: there is no oil film.
void plan_check_start(case_reader *reader, const study_plan *plan, size_t batch, valuation *v,
                      const machine_parts *machine, const whirl_rotor *rotor);

#endif
