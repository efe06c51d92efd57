// The machine at a point of a result, which its parameter may change, from the case that the result holds.
#ifndef REPORT_MACHINE_AT_H
#define REPORT_MACHINE_AT_H

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/engine/study.h"

/// The case that a result came from, with the parameters that the run used; NULL where it holds none that can be read.
/// Freed by whirl_case_free.
whirl_case *machine_of(const whirl_result *result);

/// The machine of a point as the study has it, with the values of its condition, but with its own unbalances where the
/// study places others; false where it cannot be made. To be released.
bool machine_at(const whirl_case *machine, const whirl_table *table, size_t point, whirl_machine *out);

/// rad/s; NaN where it cannot be told.
double machine_clock(const whirl_case *machine, const whirl_result *result, const whirl_table *table, size_t point);

/// What is around a station, in length scales of the point; 0: nothing.
typedef struct machine_walls {
    double clearance; ///< of its bearing
    double gap;       ///< to the stator
} machine_walls;

/// Of a point, or of the result's own case where the point cannot be told of.
machine_walls machine_walls_at(const whirl_case *machine, const whirl_result *result, const whirl_table *table,
                               size_t point, size_t station);

#endif
