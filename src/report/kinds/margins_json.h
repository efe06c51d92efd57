/// Margins of responses to unbalance as a part of a JSON document.
#ifndef REPORT_MARGINS_JSON_H
#define REPORT_MARGINS_JSON_H

#include "document.h"
#include "whirl/engine/shown.h"

/// Of every response over the speed, by the name of its table: unbalances by rule, peaks with their margins, and scaled
/// responses beside clearances; lengths in m, zero to peak where not said, speeds in rad/s, angles in degrees.
json_t *margins_json(bool *well, const whirl_result *result);

#endif
