/// The parts of a summary; each writes whole lines.
#ifndef REPORT_SUMMARY_H
#define REPORT_SUMMARY_H

#include <stdbool.h>
#include <stdio.h>

#include "whirl/result.h"
#include "whirl/shown.h"

enum { VERDICT_SIZE = 96 };

/// "s", or "" of one.
const char *summary_plural(double count);

/// The verdict without what is different from point to point: all divergences are one, and all quasi-periodic motions.
void summary_name(const whirl_verdict *verdict, char *name, size_t size);

/// Those of the result, and its unit of lengths: the one that the case asks for, else the one that it writes them in.
whirl_shown_units summary_units(const whirl_result *result);
whirl_unit summary_length_unit(const whirl_shown_units *units);

/// The one point of a response, or every attractor that its starts lead to. WHIRL_NO_MEMORY.
whirl_status summarize_response(FILE *out, const whirl_result *result, const whirl_table *table);

/// Tells a point of a table.
typedef void summary_point(FILE *out, const whirl_result *result, const whirl_table *table, size_t point);

/// The first and the last point, with their values where there is a parameter.
void summary_ends(FILE *out, const whirl_result *result, const whirl_table *table, summary_point *tell);

/// What was done again.
void summarize_refinement(FILE *out, const whirl_table *table);

/// Many points: all that is said below the heading. WHIRL_NO_MEMORY.
whirl_status summarize_points(FILE *out, const whirl_result *result, const whirl_table *table);

/// Why motions of a table are undetermined, how many for one reason, and what would tell them; nothing where none is.
void summarize_doubts(FILE *out, const whirl_result *result, const whirl_table *table);

/// Of a table of a view (whirl_result_by_attractor): attractors with their shares, where several exist side by side,
/// and what the starts may have missed. Nothing for other tables. WHIRL_NO_MEMORY.
whirl_status summarize_starts(FILE *out, const whirl_result *view, const whirl_table *table);

/// "attractor 2, 25 % +- 11 %" of a point of such a table, after `before`; nothing for other tables.
void summarize_share(FILE *out, const whirl_table *table, size_t point, const char *before);

#endif
