/// Weight on the machine of a result, if the result comes from a case.
#ifndef REPORT_WEIGHT_H
#define REPORT_WEIGHT_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

/// Size of the text of weight_text.
enum { WEIGHT_SIZE = 256 };

/// Writes "9.80665 m/s2 across the shafts", in the shown unit; "" if unknown.
void weight_text(const whirl_shown_units *units, char *text, size_t size);

/// Returns true if weight acts along the shafts.
bool weight_stands(const whirl_result *result);

/// Returns true if a summary begins with the weight: the machine is vertical, or journals in clearances carry no
/// weight. Statics report it themselves.
bool weight_heads(const whirl_result *result);

#endif
