/// One point of a result as JSON.
#ifndef REPORT_JSON_POINT_H
#define REPORT_JSON_POINT_H

#include "report_parts.h"
#include "shown_kinds.h"

/// Given values of parameters; those of expressions belong to the case as written, not to the point. What varies has
/// the point's own.
json_t *point_parameters(bool *well, const whirl_result *result, const whirl_table *table, size_t point);

/// All of a point: where every point has several starts, which one this is, by `found` (labels NULL: there is one); its
/// modes by the names that `lines` have for them, NULL: they were not followed. Where not `full`, without what has a
/// row for every revolution or node. `well` becomes false where memory ran out.
json_t *point_json(bool *well, const whirl_result *result, const whirl_table *table, size_t point,
                   const whirl_coexistence *found, const mode_lines *lines, bool full);

#endif
