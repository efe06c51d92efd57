// What motions in the real films do beside a lateral analysis, in one paragraph: whether they come back, what they take
// of clearances, where they touch and how hard, and what else stands beside them.
#ifndef REPORT_MOTIONS_TOLD_H
#define REPORT_MOTIONS_TOLD_H

#include "whirl/engine/shown.h"

/// Whether a table is of motions that stand beside studies of machines at rest (study: motions).
bool motions_beside(const whirl_table *table);

enum { MOTIONS_TOLD_SIZE = 4096 };

/// Of a table of motions, in a view (whirl_result_by_attractor) of the result.
void motions_told(const whirl_shown_units *units, const whirl_result *view, const whirl_table *table,
                  char text[MOTIONS_TOLD_SIZE]);

#endif
