/// Whether points of a table show the same motion.
#ifndef STUDY_ALIKE_H
#define STUDY_ALIKE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/result.h"

/// What is remembered of points that were looked at.
typedef struct alike alike;

/// Of a table that lives longer; NULL without memory. Freed by alike_free, which takes NULL.
alike *alike_new(const whirl_table *table);
void alike_free(alike *labels);

/// Whether two points that are done have one regime and period and, in a basin, one attractor. A verdict that is
/// undetermined or of low confidence is like no other. What stands in their blocks must not change any more.
bool alike_are(alike *labels, size_t a, size_t b);

#endif
