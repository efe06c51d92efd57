/// Makes the JSON object of one point of a result.
#ifndef REPORT_JSON_POINT_H
#define REPORT_JSON_POINT_H

#include <jansson.h>

#include "mode_lines.h"
#include "whirl/engine/result.h"

/// Returns the parameters that the case gives as numbers; a varied parameter has its value at the point. Parameters
/// given by expressions are left out: the result stores their values for the case, which may differ at the point.
json_t *point_parameters(bool *well, const whirl_result *result, const whirl_table *table, size_t point);

/// Returns all data of a point. found: attractors of places with several starts (labels NULL: one start). lines: names
/// of modes; NULL: modes were not followed. full: with arrays that have a row for every revolution or node. `well`
/// becomes false without memory.
json_t *point_json(bool *well, const whirl_result *result, const whirl_table *table, size_t point,
                   const whirl_coexistence *found, const mode_lines *lines, bool full);

#endif
