/// Writes fits for the explorer: the fitted parameters, the measured numbers, and a case whose motions the page
/// computes.
#ifndef REPORT_EXPLORER_FIT_H
#define REPORT_EXPLORER_FIT_H

#include <stdbool.h>
#include <stdio.h>

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"

/// Returns true if a table is a fit whose machine the page can show in its live views.
bool explorer_fit_is_live(const whirl_result *result, const whirl_case *machine, const whirl_table *table);

/// Writes `,"fits": [...]`, an item for each such table.
void explorer_write_fits(FILE *stream, const whirl_result *result, const whirl_case *machine);

#endif
