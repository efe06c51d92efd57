/// Describes nonlinear motions in one paragraph: their kinds, their share of clearances, contacts and forces, and
/// coexisting motions.
#ifndef REPORT_MOTIONS_TEXT_H
#define REPORT_MOTIONS_TEXT_H

#include <stdbool.h>

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

/// Returns true if a table has motions next to studies at rest (study: motions).
bool motions_beside(const whirl_table *table);

enum { MOTIONS_TEXT_SIZE = 4096 };

/// Describes a table of motions in a view (whirl_result_by_attractor) of the result; machine: its case, or NULL.
void motions_text(const whirl_shown_units *units, const whirl_result *view, const whirl_case *machine,
                  const whirl_table *table, char text[MOTIONS_TEXT_SIZE]);

#endif
