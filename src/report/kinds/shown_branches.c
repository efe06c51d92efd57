// How branches are shown: where and why motions change, their special points as a table.
#include <math.h>
#include <string.h>

#include "page.h"
#include "quantities.h"
#include "shown_kinds.h"
#include "summary.h"

// ---------------------------------------------------------------- the summary

/// "  branch 3: P-2, 76 points from 0.3374, where branch 2 changes".
static void print_branch(FILE *out, const whirl_unit *unit, const whirl_trace *first, size_t count) {
    char name[VERDICT_SIZE];
    whirl_orbit_name(first->point.orbit, name, sizeof name);
    fprintf(out, "  branch %zu: %s, %zu point%s from %.6g%s%s", first->branch, name, count,
            summary_plural((double)count), first->point.value / unit->size, *unit->name ? " " : "", unit->name);
    if (first->parent > 0) fprintf(out, ", where branch %zu changes", first->parent);
    fputc('\n', out);
}

static void print_special(FILE *out, const whirl_unit *unit, const whirl_trace *at) {
    char text[WHIRL_MESSAGE_SIZE];
    whirl_special_text(&at->point, text, sizeof text);
    fprintf(out, "    %14.9g%s%s  %-15s %s\n", at->point.value / unit->size, *unit->name ? " " : "", unit->name,
            whirl_special_name(at->point.special), text);
}

static size_t points_of(const whirl_table *table, size_t first) {
    const double branch = whirl_table_number(table, first, WHIRL_FIELD_TRACE_NUMBER, 0);
    size_t count = 0;
    while (first + count < table->count &&
           whirl_table_number(table, first + count, WHIRL_FIELD_TRACE_NUMBER, 0) == branch)
        count++;
    return count;
}

/// What was found along every branch, and where and why it ends.
static void summarize(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter);
    for (size_t point = 0; point < table->count; point++) {
        whirl_trace at;
        const bool begins = point == 0 || whirl_table_number(table, point, WHIRL_FIELD_TRACE_NUMBER, 0) !=
                                              whirl_table_number(table, point - 1, WHIRL_FIELD_TRACE_NUMBER, 0);
        if (whirl_table_trace(table, point, &at).code != WHIRL_OK) continue;
        if (begins) print_branch(out, &unit, &at, points_of(table, point));
        if (at.point.special != WHIRL_REGULAR && isnan(at.point.second)) print_special(out, &unit, &at);
        if (!isnan(at.end))
            fprintf(out, "    %14.9g%s%s  %s\n", at.point.value / unit.size, *unit.name ? " " : "", unit.name,
                    whirl_branch_end_text((whirl_branch_end)at.end));
        whirl_orbit_free(at.point.orbit);
    }
}

// ---------------------------------------------------------------- the page

/// The regular points of the branch on both sides of a special one; both the same where there is one side.
static void find_sides(const whirl_table *table, size_t point, size_t *before, size_t *after) {
    const double branch = point_number(table, point, WHIRL_FIELD_TRACE_NUMBER);
    *before = *after = point;
    while (*before > 0 && point_number(table, *before, WHIRL_FIELD_TRACE_SPECIAL) > 0.0) --*before;
    while (*after + 1 < table->count && point_number(table, *after, WHIRL_FIELD_TRACE_SPECIAL) > 0.0 &&
           point_number(table, *after + 1, WHIRL_FIELD_TRACE_NUMBER) == branch)
        ++*after;
    if (point_number(table, *before, WHIRL_FIELD_TRACE_NUMBER) != branch) *before = *after;
}

/// "0 to 2": how many multipliers are beyond the unit circle on both sides.
static void write_unstable(FILE *stream, const whirl_table *table, size_t point) {
    size_t before, after;
    find_sides(table, point, &before, &after);
    fprintf(stream, "<td>%.0f to %.0f</td>", point_number(table, before, WHIRL_FIELD_TRACE_UNSTABLE),
            point_number(table, after, WHIRL_FIELD_TRACE_UNSTABLE));
}

/// "; contacts in a period: 2 to 1" of what grazes.
static void write_contacts(FILE *stream, const whirl_table *table, size_t point, const whirl_branch_point *at) {
    size_t before, after;
    find_sides(table, point, &before, &after);
    const double *first = whirl_table_field(table, before, WHIRL_FIELD_TRACE_TOUCHES, 0);
    const double *then = whirl_table_field(table, after, WHIRL_FIELD_TRACE_TOUCHES, 0);
    if (at->special == WHIRL_GRAZE && first && then)
        fprintf(stream, "; contacts in a period: %.0f to %.0f", first[4 * at->touch + 1], then[4 * at->touch + 1]);
}

/// The contact that grazes, where every contact has one switching function.
static void write_contact(FILE *stream, const whirl_result *result, const whirl_trace *at) {
    if (at->point.special != WHIRL_GRAZE || at->point.orbit->touch_count != result->contact_count) return;
    fputs(": ", stream);
    html_text(stream, result->contacts[at->point.touch]);
}

static void write_row(FILE *stream, const whirl_result *result, const whirl_table *table, size_t point, double unit) {
    whirl_trace at;
    char text[WHIRL_MESSAGE_SIZE];
    if (whirl_table_trace(table, point, &at).code != WHIRL_OK) return;
    fprintf(stream, "<tr><th class=\"number\">%.9g</th><td>%s", at.point.value / unit,
            whirl_special_name(at.point.special));
    write_contact(stream, result, &at);
    whirl_orbit_name(at.point.orbit, text, sizeof text);
    fprintf(stream, "</td><td>%s</td><td class=\"number\">%zu</td>", text, at.branch);
    write_unstable(stream, table, point);
    whirl_special_text(&at.point, text, sizeof text);
    fputs("<td class=\"wide\">", stream);
    html_text(stream, text);
    write_contacts(stream, table, point, &at.point);
    fputs("</td></tr>\n", stream);
    whirl_orbit_free(at.point.orbit);
}

static void write_end(FILE *stream, const whirl_table *table, size_t point, double unit) {
    char name[WHIRL_NAME_SIZE];
    whirl_trace at;
    if (whirl_table_trace(table, point, &at).code != WHIRL_OK) return;
    size_t first = point;
    while (first > 0 && point_number(table, first - 1, WHIRL_FIELD_TRACE_NUMBER) == (double)at.branch) first--;
    whirl_orbit_name(at.point.orbit, name, sizeof name);
    fprintf(stream, "<tr><th class=\"number\">%zu</th><td>%s</td><td class=\"number\">%.9g</td>", at.branch, name,
            table->values[first] / unit);
    if (at.parent > 0)
        fprintf(stream, "<td>a change of branch %zu</td>", at.parent);
    else
        fprintf(stream, "<td>%s</td>", at.point.orbit->period > 0.0 ? "where a motion settled" : "where it rests");
    fprintf(stream, "<td class=\"number\">%.9g</td><td>%s</td><td class=\"number\">%zu</td></tr>\n",
            at.point.value / unit, whirl_branch_end_text((whirl_branch_end)at.end), point + 1 - first);
    whirl_orbit_free(at.point.orbit);
}

static void write_changes(const page *to, size_t index, const whirl_table *table, const char *label, double unit) {
    size_t count = 0;
    for (size_t point = 0; point < table->count; point++)
        count += point_number(table, point, WHIRL_FIELD_TRACE_SPECIAL) > 0.0;
    if (count == 0) {
        fputs("<p>Along the branches that were followed nothing changes.</p>\n", to->stream);
        return;
    }
    html_table(to->stream, "Where and why motions change", "");
    fputs("<thead><tr><th class=\"number\">", to->stream);
    html_text(to->stream, label);
    fputs("</th><th>What</th><th>Motion</th><th class=\"number\">Branch</th><th>Unstable multipliers</th><th>What "
          "begins or ends</th></tr></thead>\n<tbody>\n",
          to->stream);
    for (size_t point = 0; point < table->count; point++)
        if (point_number(table, point, WHIRL_FIELD_TRACE_SPECIAL) > 0.0)
            write_row(to->stream, to->results[index], table, point, unit);
    fputs("</tbody></table></div>\n", to->stream);
}

static void section(const page *to, size_t index, const whirl_table *table) {
    char label[UNIT_LABEL_SIZE];
    const double unit = whirl_shown_parameter(&to->units[index], table->parameter).size;
    units_parameter_label(&to->units[index], table->parameter, label, sizeof label);
    write_changes(to, index, table, label, unit);
    html_table(to->stream, "Branches", "");
    fputs("<thead><tr><th class=\"number\">Branch</th><th>Motion</th><th class=\"number\">From ", to->stream);
    html_text(to->stream, label);
    fputs("</th><th>Begins</th><th class=\"number\">To</th><th>Ends</th><th class=\"number\">Points</th></tr></thead>\n"
          "<tbody>\n",
          to->stream);
    for (size_t point = 0; point < table->count; point++)
        if (!isnan(point_number(table, point, WHIRL_FIELD_TRACE_END))) write_end(to->stream, table, point, unit);
    fputs("</tbody></table></div>\n", to->stream);
}

const shown_kind shown_branches = {.field = WHIRL_FIELD_TRACE_NUMBER,
                                   .anchor = "branches",
                                   .name = "Where and why motions change",
                                   .summarize = summarize,
                                   .section = section};
