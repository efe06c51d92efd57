/// Writes tables for the explorer's page, thinned to what a browser can load.
#ifndef REPORT_EXPLORER_TABLES_H
#define REPORT_EXPLORER_TABLES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/result.h"

/// Writes a table; sections: with the Poincare sections of its motions. Returns false without memory.
bool explorer_write_table(FILE *stream, const whirl_table *table, bool sections);

/// Writes `,"fields": ...`: all fields of one point.
void explorer_write_point(FILE *stream, const whirl_table *table, size_t point);

#endif
