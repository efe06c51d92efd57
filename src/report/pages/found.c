// What was found, in sentences: critical speeds, margins, clearances and stability of studies at rest, and motions.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "page.h"
#include "quantities.h"
#include "report_parts.h"
#include "shown_kinds.h"
#include "summary.h"

size_t found_each(const page *to, found_part part, const char *field, each_table *act, void *context) {
    size_t count = 0;
    for (size_t r = part.first; r < part.end; r++)
        for (size_t t = 0; t < to->results[r]->table_count; t++) {
            const whirl_table *table = &to->results[r]->tables[t];
            if (table->count == 0 ||
                !(field ? whirl_layout_field(&table->layout, field) != NULL : shown_kind_of(table) == NULL))
                continue;
            if (act) act(to, r, table, context);
            count++;
        }
    return count;
}

static void begin_sentence(const page *to, const char *what) {
    fputs("<li><strong>", to->stream);
    html_text(to->stream, what);
    fputs(".</strong> ", to->stream);
}

static void end_sentence(const page *to) {
    fputs("</li>\n", to->stream);
}

/// A row of WHIRL_FIELD_MODES_CRITICAL: "2753.2 rpm", "unstable from 6100 rpm", or, of a parameter that is not the
/// speed, "unstable from q = 1e+07 N/m".
static void tell_change(const page *to, const whirl_shown_units *units, const whirl_table *table, const double *row) {
    const char *const what = row[0] < 1.5 ? "" : row[0] < 2.5 ? "unstable from " : "stable from ";
    const whirl_unit speed = margin_speed_unit(units), unit = whirl_shown_parameter(units, table->parameter);
    if (row[0] < 1.5 || fabs(row[1] - row[2]) <= 1e-9 * row[2])
        html_printf(to->stream, "%s%.5g %s", what, row[2] / speed.size, speed.name);
    else
        html_printf(to->stream, "%s%s = %.5g%s%s", what, table->parameter, row[1] / unit.size, *unit.name ? " " : "",
                    unit.name);
}

/// "unstable at all 5 values", where no value was located at which that begins or ends.
static size_t tell_unstable(const page *to, const whirl_table *table, const char *before) {
    size_t unstable = 0, done = 0;
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        done++;
        unstable += shown_modes_growing(table, point) > 0;
    }
    if (unstable == done && done > 0) html_printf(to->stream, "%sunstable at all %zu values", before, done);
    if (unstable > 0 && unstable < done)
        html_printf(to->stream, "%sunstable at %zu of %zu values", before, unstable, done);
    return unstable;
}

/// Critical speeds with damping, as far as modes were followed over the speed.
static void tell_critical(const page *to, size_t result, const whirl_table *table, void *context) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    size_t *const told = context;
    size_t found = 0, changes = 0;
    if (!*table->parameter) return;
    html_printf(to->stream, "%s%s: ", (*told)++ ? "; " : "", table->name);
    for (size_t point = 0; point < table->count; point++) {
        const double *row = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; row && whirl_table_done(table, point) && i < field->rows; i++, row += field->columns)
            if (row[0] >= 1.0 && row[0] <= 3.0) {
                fputs(found++ ? ", " : "", to->stream);
                changes += row[0] > 1.5;
                tell_change(to, &to->units[result], table, row);
            }
    }
    if (changes == 0) found += tell_unstable(to, table, found ? ", " : "");
    if (!found) html_printf(to->stream, "none between the speeds that were looked at");
}

static void count_swept(const page *to, size_t result, const whirl_table *table, void *context) {
    (void)to, (void)result;
    *(size_t *)context += *table->parameter != '\0';
}

/// Peaks with margins, of all responses.
typedef struct peak_count {
    asked_verdict verdict; ///< of all of them
    size_t told, held, tables, unjudged;
    bool probed;       ///< stations with probes are said
    double more;       ///< what the worst has more than is asked for, % (margin_tally)
    char unknown[512]; ///< the first table of which peaks may have escaped, and why
    char worst[512];   ///< the one that lacks most
} peak_count;

static void count_peaks(const page *to, size_t result, const whirl_table *table, void *context) {
    peak_count *const all = context;
    const margin_tally own = margin_count(to->results[result], table, &to->units[result]);
    all->tables += margin_asked(table);
    if (own.verdict > all->verdict) all->verdict = own.verdict;
    if (own.lacks && !*all->unknown)
        snprintf(all->unknown, sizeof all->unknown, "Peaks of %s may be missing: %s.", table->name, own.lacks);
    all->told += own.told;
    all->unjudged += own.unjudged;
    all->probed = all->probed || *table->record.probes_at;
    all->held += own.held;
    if (own.held == own.told || (*all->worst && own.more >= all->more)) return;
    all->more = own.more;
    snprintf(all->worst, sizeof all->worst, "%s at %s, %.5g %s, amplification %.3g: %.100s", table->name,
             to->results[result]->stations[own.station].name, own.worst.speed,
             margin_speed_unit(&to->units[result]).name, own.worst.amplification, own.worst.text);
}

/// The clearance of which scaled responses take most.
typedef struct tightest {
    bool any;
    double share;
    scaled_row row;
    const char *verdict;
    whirl_unit speed; ///< in which that of the row is told
    char where[256];
} tightest;

static void find_tightest(const page *to, size_t result, const whirl_table *table, void *context) {
    tightest *const found = context;
    const whirl_result *own = to->results[result];
    scaled by;
    scaled_row row;
    if (!scaled_of(own, table, &by) || !scaled_tightest(own, table, &by, &row)) return;
    const double share = row.axis / row.clearance;
    if (found->any && share <= found->share) return;
    *found = (tightest){.any = true,
                        .share = share,
                        .row = row,
                        .verdict = scaled_verdict(&by, &row),
                        .speed = margin_speed_unit(&to->units[result])};
    snprintf(found->where, sizeof found->where, "%s (%s)", own->stations[row.station].name, table->name);
}

/// Stability of all tables, and the one of the least decrement.
typedef struct stability_count {
    asked_stability_tally all;
    const char *where;
} stability_count;

static void count_stability(const page *to, size_t result, const whirl_table *table, void *context) {
    stability_count *const count = context;
    const asked_stability_tally own = asked_stability_count(table);
    (void)to, (void)result;
    count->all.points += own.points;
    count->all.without += own.without;
    count->all.screened += own.screened;
    count->all.dense += own.dense;
    if (own.level_two > count->all.level_two) count->all.level_two = own.level_two;
    if (count->where && !(own.least.complete < count->all.least.complete)) return;
    count->all.least = own.least;
    if (isfinite(own.least.complete)) count->where = table->name;
}

static void write_critical(const page *to, found_part part) {
    size_t told = 0, swept = 0;
    found_each(to, part, WHIRL_FIELD_MODES_CRITICAL, count_swept, &swept);
    if (swept == 0 && !part.all) return;
    begin_sentence(to, "Critical speeds with damping");
    found_each(to, part, WHIRL_FIELD_MODES_CRITICAL, tell_critical, &told);
    fputs(told ? "." : "Not looked for (study: modes over the speed).", to->stream);
    end_sentence(to);
}

static void write_margins(const page *to, found_part part) {
    peak_count peaks = {.told = 0};
    found_each(to, part, WHIRL_FIELD_UNBALANCE_PROBE, count_peaks, &peaks);
    if (peaks.tables == 0 && !part.all) return;
    begin_sentence(to, "Separation margins");
    if (peaks.tables == 0)
        fputs("Not told: no response to unbalance has its running speeds (running_from, running_to).", to->stream);
    else if (peaks.verdict == ASKED_UNKNOWN && peaks.told == 0)
        fputs("Not known.", to->stream);
    else if (peaks.verdict == ASKED_UNKNOWN)
        html_printf(to->stream, "Not known: all %zu peaks that were found and of which a margin is asked for have it.",
                    peaks.told);
    else if (peaks.verdict == ASKED_NOTHING)
        html_printf(to->stream,
                    "No peak%s at the speeds that were looked at has an amplification of 2.5 or more: no margin is "
                    "asked for.",
                    peaks.probed ? " that a probe sees" : "");
    else if (peaks.verdict == ASKED_HOLDS)
        html_printf(to->stream, "All %zu peaks of which a margin is asked for have it.", peaks.told);
    else
        html_printf(to->stream, "%zu of %zu peaks lack the margin that is asked for; the worst is %s.",
                    peaks.told - peaks.held, peaks.told, peaks.worst);
    if (*peaks.unknown) html_printf(to->stream, " %s", peaks.unknown);
    if (peaks.unjudged > 0)
        html_printf(to->stream, " %zu peak%s of that amplification at stations without a probe %s not judged.",
                    peaks.unjudged, summary_plural((double)peaks.unjudged), peaks.unjudged == 1 ? "is" : "are");
    end_sentence(to);
}

static void write_clearances(const page *to, found_part part) {
    tightest close = {.any = false};
    found_each(to, part, WHIRL_FIELD_UNBALANCE_CLEARANCE, find_tightest, &close);
    if (!close.any && !part.all) return;
    begin_sentence(to, "Clearances");
    if (close.any)
        html_printf(to->stream,
                    "Responses scaled to the vibration limit take at most %.3g %% of a diametral clearance, at %s at "
                    "%.5g %s, 75 %% allowed: %s.",
                    100.0 * close.share, close.where, close.row.speed / close.speed.size, close.speed.name,
                    close.verdict);
    else
        fputs("Not told: no station with a clearance, or no running speeds with points between them.", to->stream);
    end_sentence(to);
}

static void write_stability(const page *to, found_part part) {
    stability_count count = {.all = {.least = {.complete = NAN}}};
    if (found_each(to, part, WHIRL_FIELD_STABILITY_COMPLETE, count_stability, &count) == 0 && !part.all) return;
    const asked_stability_tally *const all = &count.all;
    const asked_stability *const least = &all->least;
    begin_sentence(to, "Stability");
    if (count.where) {
        html_printf(to->stream,
                    "The least logarithmic decrement is %.3g with seals and impellers (%s), %.3g with bearings "
                    "and stages",
                    least->complete, count.where, least->decrement);
        if (least->ratio == 0.0)
            fputs(", below 0 without any cross coupling", to->stream);
        else if (isfinite(least->ratio))
            html_printf(to->stream, ", whose cross coupling is at its limit when it is %.3g times as large",
                        least->ratio);
        html_printf(to->stream,
                    least->level_two == ASKED_HOLDS ? "; above %g: holds%s."
                    : least->decides                ? "; not above %g: fails%s."
                                                    : "; not above %g: fails%s, though Level I holds there.",
                    asked_decrement, all->without > 0 ? " there" : "");
        if (all->screened > 0)
            html_printf(to->stream, " In the screening diagram %zu of %zu points are in region B.", all->dense,
                        all->screened);
        if (all->without > 0)
            html_printf(to->stream, " Not known at %zu of %zu points: no mode that does not go backward.", all->without,
                        all->points);
    } else if (all->without > 0) {
        fputs("Not known: no mode was found that does not go backward.", to->stream);
    } else {
        fputs("Not looked for (study: stability).", to->stream);
    }
    end_sentence(to);
}

// ---------------------------------------------------------------- motions, and what summaries tell

enum { MOST_RANGES = 12, MOST_LINES = 8, RANGE_SIZE = 512 };

/// "P-1 from 1 to 3.25 rad/s; changing: P-3, chaotic from 3.3 to 3.5 rad/s"; false, and nothing, of too many ranges.
static bool write_ranges(const page *to, size_t index, const whirl_table *table) {
    const whirl_unit unit = whirl_shown_parameter(&to->units[index], table->parameter);
    regime_interval *intervals = malloc((table->count + 1) * sizeof *intervals);
    const size_t count =
        intervals ? regime_intervals(table, to->results[index]->contact_count, intervals, table->count) : 0;
    size_t groups = 0;
    for (size_t i = 0; i < count; i += regime_group(&intervals[i], count - i)) groups++;
    const bool few = groups > 0 && groups <= MOST_RANGES;
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

/// "P-1 at 46 points, chaotic at 6 points".
static void write_verdicts(const page *to, const whirl_table *table) {
    verdict_count counts[SUMMARY_VERDICTS];
    const size_t count = summary_counts(table, counts);
    for (size_t i = 0; i < count; i++)
        html_printf(to->stream, "%s%s at %zu point%s", i ? ", " : "", counts[i].name, counts[i].points,
                    summary_plural((double)counts[i].points));
}

/// " 61 of 61 points rub. Confidence: high at 0, fair at 59, low at 2 points."
static void write_tally(const page *to, size_t index, const whirl_table *table) {
    const summary_tally tally = summary_tally_of(&to->units[index], table);
    if (tally.all < 2) return;
    if (to->results[index]->contact_count > 0) fprintf(to->stream, " %zu of %zu points rub.", tally.rubbing, tally.all);
    if (tally.failed > 0) fprintf(to->stream, " Exponents of %zu points failed.", tally.failed);
    fprintf(to->stream, " Confidence: high at %zu, fair at %zu, low at %zu points.", tally.sure[WHIRL_HIGH],
            tally.sure[WHIRL_FAIR], tally.sure[WHIRL_LOW]);
}

/// Lines of a summary as items of a list; all but the first so many are left to its table.
static void write_lines(FILE *stream, char *text) {
    size_t count = 0;
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        line += strspn(line, " ");
        if (!*line || count++ >= MOST_LINES) continue;
        fputs(count == 1 ? "<ul class=\"notes\">\n<li>" : "<li>", stream);
        plus_minus(line);
        html_text(stream, line);
        fputs("</li>\n", stream);
    }
    if (count > MOST_LINES) fprintf(stream, "<li>and %zu more lines: see its table</li>\n", count - MOST_LINES);
    if (count > 0) fputs("</ul>\n", stream);
}

/// One motion, of which the summary tells all.
static bool is_single(const whirl_table *table) {
    return !*table->parameter && !table->source && table->count == 1;
}

/// What the summary says of a table, below its heading.
static void tell_table(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    const shown_kind *kind = shown_kind_of(table);
    if (kind) {
        kind->summarize(out, units, table);
    } else if (!whirl_layout_has_verdict(&table->layout)) {
        summarize_motions(out, units, table);
    } else if (is_single(table)) {
        summarize_response(out, units, table);
    } else {
        summarize_notes(out, units, table);
    }
}

/// What is told of a table, to be freed; NULL without memory.
static char *told_of(const page *to, size_t index, const whirl_table *table) {
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out) return NULL;
    tell_table(out, &to->units[index], table);
    if (fclose(out) == 0) return text;
    free(text);
    return NULL;
}

/// The first table of a result of the same kind at rest over the same parameter, at other conditions: that table itself
/// where none stands before it.
static const whirl_table *first_alike(const whirl_result *result, const whirl_table *table) {
    const whirl_table *first = result->tables;
    while (first < table && !(shown_kind_of(first) && shown_kind_of(first) == shown_kind_of(table) &&
                              strcmp(first->parameter, table->parameter) == 0 && first->count > 0))
        first++;
    return first;
}

static bool has_line(const char *text, const char *line, size_t length) {
    for (; *text; text += strcspn(text, "\n"), text += *text != '\0')
        if (strcspn(text, "\n") == length && strncmp(text, line, length) == 0) return true;
    return false;
}

/// Takes the lines out of `text` that stand in `before`; whether any did.
static bool drop_told(char *text, const char *before) {
    char *to = text;
    bool any = false;
    for (const char *line = text; *line;) {
        const size_t length = strcspn(line, "\n"), whole = length + (line[length] == '\n');
        const bool told = has_line(before, line, length);
        any = any || told;
        if (!told) memmove(to, line, whole), to += whole;
        line += whole;
    }
    *to = '\0';
    return any;
}

/// What an earlier table of the kind tells as well is told there.
static void write_told(const page *to, size_t index, const whirl_table *table) {
    const whirl_table *first = first_alike(to->results[index], table);
    char *text = told_of(to, index, table), *before = first == table ? NULL : told_of(to, index, first);
    if (text && before && drop_told(text, before)) {
        html_printf(to->stream, *text ? "As %s, but for:" : "The same as %s.", first->name);
        fputc('\n', to->stream);
    }
    if (text) write_lines(to->stream, text);
    free(before);
    free(text);
}

void found_table(const page *to, size_t index, const whirl_table *table) {
    char *heading = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&heading, &size);
    if (!out) return;
    summarize_heading(out, table);
    if (fclose(out) == 0) {
        heading[strcspn(heading, "\n")] = '\0';
        const size_t length = strlen(heading);
        if (length > 0 && heading[length - 1] == ':') heading[length - 1] = '\0';
        fputs("<li><strong>", to->stream);
        html_text(to->stream, heading);
        fputs(".</strong> ", to->stream);
        if (whirl_layout_has_verdict(&table->layout) && !is_single(table)) {
            if (table->row > 0 || !*table->parameter || !write_ranges(to, index, table)) write_verdicts(to, table);
            fputs(".", to->stream);
            write_tally(to, index, table);
        }
        write_told(to, index, table);
        fputs("</li>\n", to->stream);
    }
    free(heading);
}

void found_at_rest(const page *to, found_part part) {
    write_critical(to, part);
    write_margins(to, part);
    write_clearances(to, part);
    write_stability(to, part);
}
