// Findings on branches: where and why motions change, and where branches begin and end.
#include <math.h>

#include "quantities.h"
#include "shown_kinds.h"

/// Finds the regular points of a branch on both sides of a special point; at an end of the branch both are the same
/// point.
static void find_sides(const whirl_table *table, size_t point, size_t *before, size_t *after) {
    const double branch = point_number(table, point, WHIRL_FIELD_TRACE_NUMBER);
    *before = *after = point;
    while (*before > 0 && point_number(table, *before, WHIRL_FIELD_TRACE_SPECIAL) > 0.0) --*before;
    while (*after + 1 < table->count && point_number(table, *after, WHIRL_FIELD_TRACE_SPECIAL) > 0.0 &&
           point_number(table, *after + 1, WHIRL_FIELD_TRACE_NUMBER) == branch)
        ++*after;
    if (point_number(table, *before, WHIRL_FIELD_TRACE_NUMBER) != branch) *before = *after;
}

/// Returns the name of a special point; for grazing it includes the contact, if every contact has one switching
/// function.
static const char *special_name(const finder *of, const whirl_trace *at) {
    const char *name = whirl_special_name(at->point.special);
    if (at->point.special != WHIRL_GRAZE || at->point.orbit->touch_count != of->result->contact_count) return name;
    return find_text(of->findings, "%s: %s", name, of->result->contacts[at->point.touch]);
}

/// Returns the cause of a change; for grazing with "; contacts in a period: 2 to 1".
static const char *special_cause(const finder *of, const whirl_trace *at, size_t before, size_t after) {
    char text[WHIRL_MESSAGE_SIZE];
    const double *first = whirl_table_field(of->table, before, WHIRL_FIELD_TRACE_TOUCHES, 0);
    const double *then = whirl_table_field(of->table, after, WHIRL_FIELD_TRACE_TOUCHES, 0);
    whirl_special_text(&at->point, text, sizeof text);
    if (at->point.special != WHIRL_GRAZE || !first || !then) return find_text(of->findings, "%s", text);
    return find_text(of->findings, "%s; contacts in a period: %.0f to %.0f", text, first[4 * at->point.touch + 1],
                     then[4 * at->point.touch + 1]);
}

static const char *orbit_name(const finder *of, const whirl_trace *at) {
    char name[WHIRL_NAME_SIZE];
    whirl_orbit_name(at->point.orbit, name, sizeof name);
    return find_text(of->findings, "%s", name);
}

static void find_changes(const finder *of) {
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "changes", "Where and why motions change");
    size_t before, after;
    sheet_values(of, sheet, "", 9);
    sheet_texts(of, sheet, "what", "what");
    sheet_texts(of, sheet, "motion", "motion");
    sheet_column(of, sheet, "branch", "branch", WHIRL_QUANTITY_NUMBER, 6);
    sheet_texts(of, sheet, "unstable", "unstable multipliers");
    sheet_texts(of, sheet, "why", "what begins or ends");
    // Add a row for each special point: what it is, and multipliers on both sides.
    for (size_t point = 0; point < of->table->count; point++) {
        whirl_trace at;
        if (!(point_number(of->table, point, WHIRL_FIELD_TRACE_SPECIAL) > 0.0)) continue;
        if (whirl_table_trace(of->table, point, &at).code != WHIRL_OK) {
            of->findings->failed = true;
            return;
        }
        find_sides(of->table, point, &before, &after);
        sheet_row(of, sheet);
        cell_value(of, sheet, point);
        cell_text(of, sheet, special_name(of, &at));
        cell_text(of, sheet, orbit_name(of, &at));
        cell_number(of, sheet, (double)at.branch);
        cell_text(of, sheet,
                  find_text(of->findings, "%.0f to %.0f", point_number(of->table, before, WHIRL_FIELD_TRACE_UNSTABLE),
                            point_number(of->table, after, WHIRL_FIELD_TRACE_UNSTABLE)));
        cell_text(of, sheet, special_cause(of, &at, before, after));
        whirl_orbit_free(at.point.orbit);
    }
    // State if there is none.
    if (sheet->rows == 0)
        phrase_text(of, &find_statement(of, "changes of motion")->found, "none along the branches that were followed");
    find_sheet_end(of);
}

static void find_ends_of_branches(const finder *of) {
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "branches", "Branches");
    sheet_column(of, sheet, "branch", "branch", WHIRL_QUANTITY_NUMBER, 6);
    sheet_texts(of, sheet, "motion", "motion");
    sheet_values(of, sheet, "from", 9);
    sheet_texts(of, sheet, "begins", "begins at");
    sheet_values(of, sheet, "to", 9);
    sheet_texts(of, sheet, "ends", "ends");
    sheet_column(of, sheet, "points", "points", WHIRL_QUANTITY_NUMBER, 9);
    // Find the last point of each branch, which has a reason for its end, then its first point.
    for (size_t point = 0; point < of->table->count; point++) {
        whirl_trace at;
        if (isnan(point_number(of->table, point, WHIRL_FIELD_TRACE_END))) continue;
        if (whirl_table_trace(of->table, point, &at).code != WHIRL_OK) {
            of->findings->failed = true;
            return;
        }
        size_t first = point;
        while (first > 0 && point_number(of->table, first - 1, WHIRL_FIELD_TRACE_NUMBER) == (double)at.branch) first--;
        // Add the row of the branch.
        sheet_row(of, sheet);
        cell_number(of, sheet, (double)at.branch);
        cell_text(of, sheet, orbit_name(of, &at));
        cell_value(of, sheet, first);
        cell_text(of, sheet,
                  at.parent > 0                  ? find_text(of->findings, "a change of branch %zu", at.parent)
                  : at.point.orbit->period > 0.0 ? "a motion that settled"
                                                 : "its place of rest");
        cell_value(of, sheet, point);
        cell_text(of, sheet, whirl_branch_end_text((whirl_branch_end)at.end));
        cell_number(of, sheet, (double)(point + 1 - first));
        whirl_orbit_free(at.point.orbit);
    }
    find_sheet_end(of);
}

static void branches_find(const finder *of) {
    find_changes(of);
    find_ends_of_branches(of);
}

const shown_kind shown_branches = {.field = WHIRL_FIELD_TRACE_NUMBER,
                                   .anchor = "branches",
                                   .name = "Where and why motions change",
                                   .find = branches_find};
