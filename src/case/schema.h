/// The keys of a case file outside stations and elements, and of a claims file.
#ifndef CASE_SCHEMA_H
#define CASE_SCHEMA_H

#include "plan_course.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/spread.h"
#include "whirl/engine/study.h"

#include <stddef.h>

enum { SCHEMA_VERSION = 1, SCHEMA_MAX_POINTS = 10000000, SCHEMA_MAX_DETAIL = 1000 };

/// Group `rotor` for studies that allow speed 0. It is not listed, since only the range of its speed differs.
extern const whirl_group schema_still_rotor;
extern const whirl_group schema_case, schema_document, schema_rotor, schema_study, schema_response, schema_sweep,
    schema_map, schema_basin, schema_axis, schema_motions, schema_branch, schema_curves, schema_initial, schema_starts,
    schema_integrate, schema_keep, schema_detail, schema_event, schema_shaft_run, schema_fit_unknown, schema_fit_data,
    schema_tolerances, schema_distribution, schema_limit, schema_sensitivity, schema_number, schema_dataset,
    schema_label, schema_grade, schema_channel;

#define SCHEMA_INDEX_AT_REST(name, ...) SCHEMA_AT_REST_##name,

/// Number of studies at rest.
enum { WHIRL_STUDIES_AT_REST(SCHEMA_INDEX_AT_REST) SCHEMA_AT_REST };

/// Groups of the studies at rest (WHIRL_STUDIES_AT_REST), ended by one without a name.
extern const whirl_group schema_at_rest[];

/// Returns the unit that a number of the initial state may have, "m" or "m/s", instead of being in scales; "" for all
/// other keys.
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
    size_t *points; ///< [low.count] number of grid values of each key, 0 if none was read; NULL: starts fill the ranges
                    ///< evenly
} plan_range;

/// Lists of options of a batch: `integrate`, `keep`, those of points in detail or branches, and those of its study.
enum { PLAN_OPTIONS = 4, PLAN_OWN_OPTIONS = PLAN_OPTIONS - 1 };

/// Places of a batch in the case.
typedef struct plan_origin {
    const struct course_parts *course; ///< events and laws of a run-up, or NULL
    const struct fit_parts *fit;       ///< parts of a fit, whose runs have keys of their own, or NULL
    const setting_list *runup; ///< keys of a run-up, or of the run of a data set's records, whose numbers differ from
                               ///< point to point; or NULL
    const setting_list *options[PLAN_OPTIONS]; ///< keys that have one value for all points, or NULL
    const file_node *place;                    ///< place of the whole batch
    const file_node *const *each;  ///< [count] places of the values, if each has one; NULL: only the ends have
    const file_node *first, *last; ///< places of the ends of the sweep
    const file_node *across;       ///< place of the last value from row to row of a map
    const file_node *planes;       ///< place of the last value from plane to plane of a map
    whirl_unit units[3]; ///< units of the values, where they differ from the parameter's; size 0: the parameter's
    double end;          ///< end that the steps of the sweep do not reach; NaN if they reach it
    bool rest;           ///< points start from zero instead of the initial state
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
    whirl_tolerance *tolerated;                  ///< parameters with tolerances
    whirl_spread_of *spreads;                    ///< numbers whose spread over the samples is reported
    const struct whirl_derivatives *derivatives; ///< numbers to be differentiated, and by which parameters; or NULL
    const whirl_dataset *dataset;                ///< data set, or NULL
} study_plan;

#endif
