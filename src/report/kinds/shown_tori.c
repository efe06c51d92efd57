// Findings on tori: quasi-periodic motions past Neimark-Sacker points, a row for each branch.
#include <math.h>
#include <stdlib.h>

#include "machine_at.h"
#include "quantities.h"
#include "shown_kinds.h"

/// Returns the frequency of the largest line at the second frequency. It is in rad/s if `clock`, the speeds at all
/// points, is given; else an order.
static double second_frequency(const finder *of, const whirl_tori *own, size_t point, const double *clock) {
    const double line = whirl_table_field(of->table, point, WHIRL_FIELD_TORUS_FREQUENCY, own->station)[own->axis];
    return clock ? line * clock[point] : line;
}

/// Returns the speeds at all points, rad/s; the caller frees them. NULL if frequencies are shown as orders, or a speed
/// is unknown.
static double *clocks_of(const finder *of) {
    if (!(of->units->frequency > 0.0) || of->table->count == 0) return NULL;
    double *clock = malloc(of->table->count * sizeof *clock);
    bool known = clock != NULL;
    if (!known) of->findings->failed = true;
    for (size_t point = 0; point < of->table->count && known; point++) {
        clock[point] = machine_clock(of->machine, of->result, of->table, point);
        known = isfinite(clock[point]);
    }
    if (known) return clock;
    free(clock);
    return NULL;
}

/// Returns how many motions of a branch are stable: "all", "none" or "12 of 20".
static const char *stable_of(const finder *of, const whirl_tori *own) {
    if (own->stable == 0 || own->stable == own->found) return own->stable ? "all" : "none";
    return find_text(of->findings, "%zu of %zu", own->stable, own->found);
}

static const char *end_of(const finder *of, size_t point) {
    const double *resonance = whirl_table_field(of->table, point, WHIRL_FIELD_TORUS_RESONANCE, 0);
    const double limit = point_number(of->table, point, WHIRL_FIELD_TORUS_LIMIT);
    const double unit = whirl_shown_parameter(of->units, of->table->parameter).size;
    char text[WHIRL_MESSAGE_SIZE];
    if (isnan(point_number(of->table, point, WHIRL_FIELD_TORUS_END))) return "";
    whirl_torus_end_text(point_number(of->table, point, WHIRL_FIELD_TORUS_END), resonance[0], resonance[1], text,
                         sizeof text);
    if (!isfinite(limit)) return find_text(of->findings, "%s", text);
    return find_text(of->findings, "%s, at %.6g", text, limit / unit);
}

static void find_row(const finder *of, whirl_sheet *sheet, const whirl_tori *own, const double *clock) {
    // Write where the branch begins, and its rotation numbers.
    const double rotations[] = {point_number(of->table, own->first, WHIRL_FIELD_TORUS_ROTATION),
                                point_number(of->table, own->last, WHIRL_FIELD_TORUS_ROTATION)};
    const bool line = own->found > 0 && own->station < of->result->station_count;
    sheet_row(of, sheet);
    cell_number(of, sheet, point_number(of->table, own->first, WHIRL_FIELD_TORUS_NUMBER));
    cell_number(of, sheet, point_number(of->table, own->first, WHIRL_FIELD_TORUS_BEGINS));
    cell_number(of, sheet, point_number(of->table, own->first, WHIRL_FIELD_TORUS_BRANCH));
    cell_numbers(of, sheet, own->found > 0 ? 2 : 0, rotations);
    // Write the second frequency, and the station with its largest line.
    if (line) {
        const double lines[] = {second_frequency(of, own, own->first, clock),
                                second_frequency(of, own, own->last, clock)};
        cell_numbers(of, sheet, 2, lines);
        cell_text(of, sheet,
                  find_text(of->findings, "%s %c", of->result->stations[own->station].name, "xy"[own->axis]));
    } else {
        cell_numbers(of, sheet, 0, NULL);
        cell_text(of, sheet, "");
    }
    // Write stability and the end of the branch.
    cell_text(of, sheet, own->found > 0 ? stable_of(of, own) : "");
    cell_number(of, sheet, (double)own->found);
    cell_value(of, sheet, own->last);
    cell_text(of, sheet, end_of(of, own->last));
}

static void tori_find(const finder *of) {
    // Get the speeds; without them, frequencies are shown as orders.
    double *clock = clocks_of(of);
    whirl_sheet *sheet = find_sheet(of, "tori", "Quasi-periodic motions");
    // Set up the columns.
    sheet_column(of, sheet, "torus", "torus", WHIRL_QUANTITY_NUMBER, 6);
    sheet_values(of, sheet, "begins at", 9);
    sheet_column(of, sheet, "branch", "branch", WHIRL_QUANTITY_NUMBER, 6);
    sheet_list(of, sheet, "rotation", "rotation number", WHIRL_QUANTITY_NUMBER, 6, " to ");
    if (clock)
        sheet_list(of, sheet, "frequency", "second frequency", WHIRL_QUANTITY_FREQUENCY, 6, " to ");
    else
        sheet_list(of, sheet, "order", "second frequency, as an order", WHIRL_QUANTITY_NUMBER, 6, " to ");
    sheet_texts(of, sheet, "station", "largest at");
    sheet_texts(of, sheet, "stable", "stable");
    sheet_column(of, sheet, "points", "points", WHIRL_QUANTITY_NUMBER, 9);
    sheet_values(of, sheet, "to", 9);
    sheet_texts(of, sheet, "ends", "ends");
    // Add a row for each branch of tori, whose points follow each other in the table.
    for (size_t point = 0; point < of->table->count; point++) {
        const whirl_tori own = whirl_table_tori(of->table, point);
        find_row(of, sheet, &own, clock);
        point = own.last;
    }
    // State if there is none.
    if (of->table->count == 0)
        phrase_text(of, &find_statement(of, "quasi-periodic motions")->found,
                    "no torus begins along the branches that were followed");
    find_sheet_end(of);
    free(clock);
}

const shown_kind shown_tori = {
    .field = WHIRL_FIELD_TORUS_NUMBER, .anchor = "tori", .name = "Quasi-periodic motions", .find = tori_find};
