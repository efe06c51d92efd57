/// The parts of a summary; each writes whole lines.
#ifndef REPORT_SUMMARY_H
#define REPORT_SUMMARY_H

#include <stdbool.h>
#include <stdio.h>

#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

enum { VERDICT_SIZE = 96, SUMMARY_VERDICTS = WHIRL_MAX_PERIOD + 8 };

/// "s", or "" of one.
const char *summary_plural(double count);

/// "2000 to 6000 rpm", or the value where both points are one.
void summary_range(const whirl_unit *unit, const whirl_table *table, size_t first, size_t last, char *text,
                   size_t size);

/// Verdicts in the order in which a table meets them, and how many points have each; in a refined map those of its
/// grid. Their number; 0 of tables without verdicts, or without memory.
typedef struct verdict_count {
    char name[VERDICT_SIZE];
    size_t points;
} verdict_count;
size_t summary_counts(const whirl_table *table, verdict_count counts[SUMMARY_VERDICTS]);

/// The unit of lengths: the one that is asked for, else the one that the case writes them in.
whirl_unit summary_length_unit(const whirl_shown_units *units);

/// The one point of a response, or every attractor that its starts lead to. WHIRL_NO_MEMORY.
whirl_status summarize_response(FILE *out, const whirl_shown_units *units, const whirl_table *table);

/// What motions do to clearances and contacts, in one paragraph (motions_told). WHIRL_NO_MEMORY.
whirl_status summarize_motions(FILE *out, const whirl_shown_units *units, const whirl_table *table);

/// What was done again.
void summarize_refinement(FILE *out, const whirl_table *table);

/// "sweep of r_k: 512 points".
void summarize_heading(FILE *out, const whirl_table *table);

/// How many points of a table rub, have failed exponents, and how far verdicts can be trusted; in a refined map of its
/// grid.
typedef struct summary_tally {
    size_t all, rubbing, failed, sure[WHIRL_HIGH + 1];
} summary_tally;
summary_tally summary_tally_of(const whirl_shown_units *units, const whirl_table *table);

/// What is in doubt, which attractors there are, what was done again, and jumps. WHIRL_NO_MEMORY.
whirl_status summarize_notes(FILE *out, const whirl_shown_units *units, const whirl_table *table);

/// Many points: all that is said below the heading. WHIRL_NO_MEMORY.
whirl_status summarize_points(FILE *out, const whirl_shown_units *units, const whirl_table *table);

/// Why motions of a table are undetermined, how many for one reason, and what would tell them; nothing where none is.
void summarize_doubts(FILE *out, const whirl_shown_units *units, const whirl_table *table);

/// Of a table of a view (whirl_result_by_attractor): attractors with their shares, where several exist side by side,
/// and what the starts may have missed. Nothing for other tables. WHIRL_NO_MEMORY.
whirl_status summarize_starts(FILE *out, const whirl_shown_units *units, const whirl_table *table);

/// "attractor 2, 25 % +- 11 %" of a point of such a table, after `before`; nothing for other tables.
void summarize_share(FILE *out, const whirl_table *table, size_t point, const char *before);

#endif
