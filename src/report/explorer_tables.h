/// Tables in the explorer's page, thinned to what a browser takes in.
#ifndef REPORT_EXPLORER_TABLES_H
#define REPORT_EXPLORER_TABLES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/result.h"

/// Writes one table, with sections on request. Returns false without memory.
bool explorer_write_table(FILE *stream, const whirl_table *table, bool sections);

/// Writes `,"fields": ...`: all fields of one point.
void explorer_write_point(FILE *stream, const whirl_table *table, size_t point);

#endif
