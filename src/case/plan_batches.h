/// Steps of making the batches of a study.
#ifndef CASE_PLAN_BATCHES_H
#define CASE_PLAN_BATCHES_H

#include "plan_parts.h"
#include "schema.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/study.h"

#include <stddef.h>

/// Evaluates a formula; returns false after a problem.
bool plan_formula_value(case_reader *reader, valuation *v, const file_node *where, const number_formula *formula,
                        double *value);

/// Copies a list of keys to memory that lasts as long as the case; NULL for NULL or without memory, which the reader
/// notes.
const setting_list *plan_keep_keys(case_reader *reader, const setting_list *keys);

/// Returns the origin of the batch that is added next: its places in the case, and the keys it is made from.
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

/// Extends the spectra of a batch to the orders at which parts of a machine act (plus one sideband), unless the case
/// gives `highest_order` in its key `keep`. Increases the samples to match, unless `keep` gives `samples`.
void plan_raise_order(const plan_parts *parts, const whirl_system *system, whirl_batch *batch);

/// Returns the smallest clearance of a film in a housing that stands, or gap of a stator, in length scales; INFINITY if
/// there is none.
double plan_smallest_gap(const whirl_system *system);

/// Lowers the absolute tolerance of a batch to 1e-9 of the machine's smallest gap, unless `integrate` gives one: so
/// that a large length scale does not make the motion in a small gap coarse.
void plan_lower_tolerance(const plan_parts *parts, const whirl_system *system, whirl_batch *batch);

/// Notes in the origin of a batch which keys give its options: `integrate`, `keep`, and those of its points in detail
/// or of its branches.
void plan_keep_options(case_reader *reader, const plan_parts *parts, const whirl_batch *batch, plan_origin *origin);

/// Sets the starts of a batch of motions, and their options.
void plan_finish_points(case_reader *reader, valuation *v, const plan_parts *parts, const study_plan *plan,
                        whirl_batch *batch);

/// Sets the record to what the chosen analyses need; studies at rest and branches record nothing.
void plan_choose_analyses(whirl_batch *batch, whirl_analysis_set chosen, bool spectra);

#endif
