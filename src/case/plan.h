/// The study of a case: its points, their initial states, and the options of records and analyses.
#ifndef CASE_PLAN_H
#define CASE_PLAN_H

#include "machine.h"
#include "plan_parts.h"
#include "schema.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/study.h"

#include <stddef.h>

/// Reads the parts of `study:` that do not depend on values of parameters, and reports all their problems.
void plan_read_parts(case_reader *reader, const file_node *where, const machine_parts *machine, plan_parts *parts,
                     study_plan *result);

/// Makes the batches of a study from its parts with the values of parameters. Call it only if there are no problems so
/// far.
void plan_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result);

/// Fills in the initial state [dimension] of a batch's points, in the scales of the machine. Start 0 is the case's
/// initial state; others are in the ranges.
whirl_status plan_start_state(const study_plan *plan, size_t batch, size_t start, valuation *v,
                              const whirl_rotor *rotor, double *state);

/// Bounds of the number of parameter values at which a batch has its machines, and of their text.
enum {
    PLAN_MAX_GIVEN = 3 + 2 * WHIRL_MAX_GIVEN + WHIRL_MAX_DRAWN,
    PLAN_GIVEN_TEXT = PLAN_MAX_GIVEN * (2 * WHIRL_NAME_SIZE + 32)
};

/// Fills in the parameter values at which a batch has its machines, and returns their number: varied ones (NaN: none),
/// fixed ones, and those of the sample that the batch requests.
size_t plan_given(const whirl_batch *batch, double value, double second, double third,
                  whirl_given given[PLAN_MAX_GIVEN]);

/// Fills in the parameter values of one point of a batch, as plan_given does, and returns their number. point: its
/// index among the values of the axes.
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

#endif
