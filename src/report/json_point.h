/// One point of a result as JSON.
#ifndef REPORT_JSON_POINT_H
#define REPORT_JSON_POINT_H

#include <jansson.h>

#include "mode_lines.h"
#include "whirl/engine/result.h"

/// Returns the values of given parameters; a varied one has the point's own value. Parameters given by expressions
/// belong to the case as written, not to the point, and are left out.
json_t *point_parameters(bool *well, const whirl_result *result, const whirl_table *table, size_t point);

/// Returns all data of a point. With several starts at a place, `found` identifies the start (labels NULL: one start).
/// `lines` has the names of its modes, NULL: modes were not followed. Without `full`, arrays with a row for every
/// revolution or node are left out. `well` becomes false without memory.
json_t *point_json(bool *well, const whirl_result *result, const whirl_table *table, size_t point,
                   const whirl_coexistence *found, const mode_lines *lines, bool full);

#endif
