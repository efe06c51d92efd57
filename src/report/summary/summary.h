/// Writes the parts of a summary.
#ifndef REPORT_SUMMARY_H
#define REPORT_SUMMARY_H

#include <stdbool.h>
#include <stdio.h>

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

enum { VERDICT_SIZE = 96, SUMMARY_VERDICTS = WHIRL_MAX_PERIOD + 8 };

/// Returns the plural "s", or "" for 1.
const char *summary_plural(double count);

/// Writes "2000 to 6000 rpm", or one value if both points are the same.
void summary_range(const whirl_unit *unit, const whirl_table *table, size_t first, size_t last, char *text,
                   size_t size);

/// A verdict, and the number of points that have it.
typedef struct verdict_count {
    char name[VERDICT_SIZE];
    size_t points;
} verdict_count;

/// Lists the verdicts of a table in order of appearance, each with its number of points; for a refined map the points
/// of its grid. Returns their number; 0 without verdicts or memory.
size_t summary_counts(const whirl_table *table, verdict_count counts[SUMMARY_VERDICTS]);

/// Returns the unit of lengths: the requested unit, else that of the case.
whirl_unit summary_length_unit(const whirl_shown_units *units);

/// Writes the single point of a response, or every attractor of its starts; machine: the case of the result, or NULL.
/// Fails with WHIRL_NO_MEMORY.
whirl_status summarize_response(FILE *out, const whirl_shown_units *units, const whirl_case *machine,
                                const whirl_table *table);

/// Writes a paragraph on motions, clearances and contacts (motions_text).
void summarize_motions(FILE *out, const whirl_shown_units *units, const whirl_case *machine, const whirl_table *table);

/// Writes the points that refinement computed again.
void summarize_refinement(FILE *out, const whirl_table *table);

/// Writes "sweep of r_k: 512 points".
void summarize_heading(FILE *out, const whirl_table *table);

/// Numbers of points: all, those that rub, those with failed exponents, and those with a verdict by confidence.
typedef struct summary_tally {
    size_t all, rubbing, failed, sure[WHIRL_HIGH + 1];
} summary_tally;

/// Counts the points of a table; for a refined map the points of its grid.
summary_tally summary_tally_of(const whirl_shown_units *units, const whirl_table *table);

/// Writes doubts, attractors, refinement, and jumps. Fails with WHIRL_NO_MEMORY.
whirl_status summarize_notes(FILE *out, const whirl_shown_units *units, const whirl_table *table);

/// Writes the summary of many points below the heading. Fails with WHIRL_NO_MEMORY.
whirl_status summarize_points(FILE *out, const whirl_shown_units *units, const whirl_table *table);

/// Writes the reasons of undetermined motions, their numbers, and the change that would settle them; nothing if there
/// are none.
void summarize_doubts(FILE *out, const whirl_shown_units *units, const whirl_table *table);

/// Writes the coexisting attractors of a table of a view (whirl_result_by_attractor) with their shares, and what the
/// starts may have missed; nothing for other tables. Fails with WHIRL_NO_MEMORY.
whirl_status summarize_starts(FILE *out, const whirl_shown_units *units, const whirl_table *table);

/// Writes `before` and the attractor of a point of such a table, "attractor 2, 25 % +- 11 % of the starts"; nothing for
/// other tables.
void summarize_share(FILE *out, const whirl_table *table, size_t point, const char *before);

#endif
