/// Figures in the explorer of results that it has no view of.
#ifndef REPORT_EXPLORER_FIGURES_H
#define REPORT_EXPLORER_FIGURES_H

#include <stdbool.h>
#include <stdio.h>

#include "whirl/engine/result.h"

/// Writes `,"figures": [...]`, the documents of docs/figures.md, of a machine at rest whose study the explorer has no
/// view of; of all others nothing. False without memory.
bool explorer_write_figures(FILE *stream, const whirl_result *result, const char *units);

#endif
