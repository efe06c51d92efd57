// Writes findings as sentences: critical speeds, margins, clearances and stability of studies at rest, and motions.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "findings_render.h"
#include "found.h"
#include "html.h"
#include "page.h"
#include "page_findings.h"
#include "quantities.h"
#include "regimes.h"
#include "shown_kinds.h"
#include "summary.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/findings.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

size_t found_each(const page *to, choose_table *chosen, const void *by, each_table *act, void *context) {
    size_t count = 0;
    for (size_t r = 0; r < to->count; r++)
        for (size_t t = 0; t < to->results[r]->table_count; t++) {
            const whirl_table *table = &to->results[r]->tables[t];
            if (table->count == 0 || !chosen(table, by)) continue;
            if (act) act(to, r, table, context);
            count++;
        }
    return count;
}

// ---------------------------------------------------------------- machines at rest

/// Writes the criteria with a judgement, and their tables: "; fails: separation margin (unbalance), stability, Level II
/// (stability)".
static void list_judged(const page *to, whirl_judgement judgement) {
    size_t count = 0;
    for (size_t r = 0; r < to->count; r++)
        for (size_t i = 0; i < to->findings[r]->statement_count; i++) {
            const whirl_statement *own = &to->findings[r]->statements[i];
            if (!*own->clause || own->judgement != judgement) continue;
            if (count == 0) html_printf(to->stream, "; %s: ", whirl_judgement_name(judgement));
            html_printf(to->stream, "%s%s (%s)", count++ ? ", " : "", own->what, own->table);
        }
}

/// Writes the number of acceptance criteria that hold, and names the criteria that fail; `lacks`: why there may be
/// none.
static void write_judgements(const page *to, const char *lacks) {
    size_t all = 0, held = 0;
    for (size_t r = 0; r < to->count; r++)
        for (size_t i = 0; i < to->findings[r]->statement_count; i++) {
            const whirl_statement *own = &to->findings[r]->statements[i];
            all += *own->clause && own->judgement != WHIRL_NOT_ASKED;
            held += *own->clause && own->judgement == WHIRL_HOLDS;
        }
    fputs("<li><strong>What is asked for.</strong> ", to->stream);
    if (all == 0)
        fprintf(to->stream, "Nothing: %s", lacks);
    else
        fprintf(to->stream, "%zu of %zu hold", held, all);
    list_judged(to, WHIRL_FAILS);
    list_judged(to, WHIRL_NOT_KNOWN);
    fputs(all > 0 ? ". See the table below.</li>\n" : ".</li>\n", to->stream);
}

void found_at_rest(const page *to, const char *lacks) {
    for (size_t r = 0; r < to->count; r++)
        for (size_t i = 0; i < to->findings[r]->statement_count; i++) {
            const whirl_statement *own = &to->findings[r]->statements[i];
            char text[STATEMENT_SIZE];
            if (!*own->table || *own->clause || own->at.count > 0) continue;
            statement_text(own, text, sizeof text);
            fputs("<li><strong>", to->stream);
            html_text(to->stream, own->table);
            fputs(".</strong> ", to->stream);
            html_text(to->stream, text);
            fputs(".</li>\n", to->stream);
        }
    write_judgements(to, lacks);
}

// ---------------------------------------------------------------- motions, and lines of the summary

enum { MAX_RANGES = 12, MAX_LINES = 8, RANGE_SIZE = 512 };

/// Writes "P-1 from 1 to 3.25 rad/s; changing: P-3, chaotic from 3.3 to 3.5 rad/s". Returns false, and writes nothing,
/// if there are too many ranges.
static bool write_ranges(const page *to, size_t index, const whirl_table *table) {
    const whirl_unit unit = whirl_shown_parameter(&to->units[index], table->parameter);
    regime_interval *intervals = malloc((table->count + 1) * sizeof *intervals);
    if (!intervals) *to->failed = true;
    const size_t count =
        intervals ? regime_intervals(table, to->results[index]->contact_count, intervals, table->count) : 0;
    size_t groups = 0;
    for (size_t i = 0; i < count; i += regime_group(&intervals[i], count - i)) groups++;
    const bool few = groups > 0 && groups <= MAX_RANGES;
    for (size_t i = 0, group; i < count && few; i += group) {
        char name[RANGE_SIZE], range[VERDICT_SIZE];
        group = regime_group(&intervals[i], count - i);
        const size_t first = intervals[i].first, last = intervals[i + group - 1].last;
        regime_group_name(&intervals[i], group, name, sizeof name);
        summary_range(&unit, table, first, last, range, sizeof range);
        html_printf(to->stream, "%s%s %s %s", i ? "; " : "", name, last > first ? "from" : "at", range);
        if (intervals[i].branch < 0) fputs(" on the way back", to->stream);
        if (table->attractors) html_printf(to->stream, " (attractor %zu)", table->attractors[first].number);
    }
    free(intervals);
    return few;
}

/// Writes "P-1 at 46 points, chaotic at 6 points".
static void write_verdicts(const page *to, const whirl_table *table) {
    verdict_count counts[SUMMARY_VERDICTS];
    const size_t count = summary_counts(table, counts);
    for (size_t i = 0; i < count; i++)
        html_printf(to->stream, "%s%s at %zu point%s", i ? ", " : "", counts[i].name, counts[i].points,
                    summary_plural((double)counts[i].points));
}

/// Writes " 61 of 61 points rub. Confidence: high at 0, fair at 59, low at 2 points."
static void write_confidence(const page *to, size_t index, const whirl_table *table) {
    const summary_tally tally = summary_tally_of(&to->units[index], table);
    if (tally.all < 2) return;
    if (to->results[index]->contact_count > 0) fprintf(to->stream, " %zu of %zu points rub.", tally.rubbing, tally.all);
    if (tally.failed > 0) fprintf(to->stream, " Exponents of %zu points failed.", tally.failed);
    fprintf(to->stream, " Confidence: high at %zu, fair at %zu, low at %zu points.", tally.sure[WHIRL_HIGH],
            tally.sure[WHIRL_FAIR], tally.sure[WHIRL_LOW]);
}

/// Writes lines of a summary as items of a list, at most MAX_LINES of them.
static void write_lines(FILE *stream, char *text) {
    size_t count = 0;
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        line += strspn(line, " ");
        if (!*line || count++ >= MAX_LINES) continue;
        fputs(count == 1 ? "<ul class=\"notes\">\n<li>" : "<li>", stream);
        plus_minus(line);
        html_text(stream, line);
        fputs("</li>\n", stream);
    }
    if (count > MAX_LINES) fprintf(stream, "<li>and %zu more lines: see its table</li>\n", count - MAX_LINES);
    if (count > 0) fputs("</ul>\n", stream);
}

/// Returns true for a table with a single motion, which the summary describes completely.
static bool is_single(const whirl_table *table) {
    return !*table->parameter && !table->source && table->count == 1;
}

/// Writes what the summary has about motions below its heading.
static void write_motion_text(const page *to, size_t index, const whirl_table *table) {
    const whirl_shown_units *units = &to->units[index];
    if (!whirl_layout_has_verdict(&table->layout)) {
        summarize_motions(to->stream, units, to->machines[index], table);
    } else if (is_single(table)) {
        summarize_response(to->stream, units, to->machines[index], table);
    } else {
        summarize_notes(to->stream, units, table);
    }
}

static void write_heading(const page *to, size_t index, const whirl_table *table) {
    (void)index;
    summarize_heading(to->stream, table);
}

void found_table(const page *to, size_t index, const whirl_table *table) {
    // Begin the item with the first line of the summary's heading, without its colon.
    char *heading = page_text(to, write_heading, index, table);
    if (!heading) return;
    heading[strcspn(heading, "\n")] = '\0';
    const size_t length = strlen(heading);
    if (length > 0 && heading[length - 1] == ':') heading[length - 1] = '\0';
    fputs("<li><strong>", to->stream);
    html_text(to->stream, heading);
    fputs(".</strong> ", to->stream);
    free(heading);
    // Write the verdicts of a sweep or a map, and their confidence.
    if (whirl_layout_has_verdict(&table->layout) && !is_single(table)) {
        if (table->row > 0 || !*table->parameter || !write_ranges(to, index, table)) write_verdicts(to, table);
        fputs(".", to->stream);
        write_confidence(to, index, table);
    }
    // Write the statements, or the text about motions.
    if (shown_kind_of(table)) {
        if (page_statements(to, index, table) == 0) fputs("See its tables.", to->stream);
    } else {
        char *text = page_text(to, write_motion_text, index, table);
        if (text) write_lines(to->stream, text);
        free(text);
        page_statements(to, index, table);
    }
    fputs("</li>\n", to->stream);
}
