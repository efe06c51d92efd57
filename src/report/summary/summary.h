/// Writes the parts of a summary.
#ifndef REPORT_SUMMARY_H
#define REPORT_SUMMARY_H

#include <stdio.h>

#include "whirl/engine/result.h"

/// Returns the plural "s", or "" for 1.
const char *summary_plural(double count);

/// Writes "sweep of r_k: 512 points".
void summarize_heading(FILE *out, const whirl_table *table);

#endif
