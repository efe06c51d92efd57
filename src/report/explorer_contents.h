/// Writes the findings of a result for the explorer: statements, sheets and figures of every table.
#ifndef REPORT_EXPLORER_CONTENTS_H
#define REPORT_EXPLORER_CONTENTS_H

#include <stdbool.h>
#include <stdio.h>

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"

/// Writes `,"parts": [...],"statements": [...],"sheets": [...],"figures": [...]` for a result with tables of machines
/// at rest, or of motions that the page does not compute; nothing for other results. Returns false without memory.
bool explorer_write_contents(FILE *stream, const whirl_result *result, const whirl_case *machine, const char *units);

#endif
