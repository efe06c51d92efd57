// Findings on unbalance responses: the largest response, peaks with margins, and the share of clearances they take.
#include <math.h>
#include <stdlib.h>

#include "asked.h"
#include "margins.h"
#include "scaled_response.h"
#include "shown_kinds.h"

static const double degree = 3.14159265358979323846 / 180.0;

/// Adds the sheet of unbalances by rule, which replace the machine's own.
static void find_placed(const finder *of) {
    whirl_sheet *sheet = find_sheet(of, "placed", "Unbalances by rule, in place of the machine's own");
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "unbalance", "unbalance", WHIRL_QUANTITY_UNBALANCE, 5);
    sheet_column(of, sheet, "angle", "angle", WHIRL_QUANTITY_DEGREES, 4);
    for (size_t station = 0; station < of->result->station_count && of->table->count > 0; station++) {
        const double *at = whirl_table_field(of->table, 0, WHIRL_FIELD_UNBALANCE_PLACED, station);
        if (!at || !(hypot(at[0], at[1]) > 0.0)) continue;
        sheet_row(of, sheet);
        cell_station(of, sheet, station);
        cell_number(of, sheet, hypot(at[0], at[1]));
        cell_number(of, sheet, fabs(atan2(at[1], at[0]) / degree));
    }
    find_sheet_end(of);
}

/// Adds the sheet of the largest response of every station, and the parameter's value there.
static void find_largest(const finder *of) {
    whirl_sheet *sheet = find_sheet(of, "largest", "Largest response");
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "amplitude", "largest response", WHIRL_QUANTITY_SIZE, 4);
    sheet_values(of, sheet, "at", 6);
    for (size_t station = 0; station < of->result->station_count; station++) {
        double largest = 0.0;
        size_t where = 0;
        for (size_t point = 0; point < of->table->count; point++) {
            const double size = whirl_result_length_scale(of->result, of->table, point) *
                                whirl_table_number(of->table, point, WHIRL_FIELD_UNBALANCE_AXES, station);
            if (whirl_table_done(of->table, point) && size > largest) largest = size, where = point;
        }
        sheet_row(of, sheet);
        cell_station(of, sheet, station);
        cell_number(of, sheet, largest);
        if (largest > 0.0) cell_value(of, sheet, where);
    }
    find_sheet_end(of);
}

/// Adds the sheet of critical speeds: peaks of all stations, at their probes.
static void find_peaks(const finder *of) {
    // Set up the columns; margins need running speeds.
    const bool running = margin_asked(of->table);
    margin_row rows[2 * MARGIN_PEAKS];
    whirl_sheet *sheet = find_sheet(of, "peaks", "Peaks of the response");
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "probe", "probe", WHIRL_QUANTITY_DEGREES, 4);
    sheet_column(of, sheet, "speed", "peak at", WHIRL_QUANTITY_SPEED, 5);
    sheet_column(of, sheet, "amplitude", "amplitude", WHIRL_QUANTITY_SIZE, 4);
    sheet_column(of, sheet, "amplification", "amplification", WHIRL_QUANTITY_NUMBER, 4);
    sheet_texts(of, sheet, "found_by", "found by");
    if (running) {
        sheet_column(of, sheet, "margin", "margin", WHIRL_QUANTITY_PERCENT, 3);
        sheet_texts(of, sheet, "side", "of the running speeds");
        sheet_column(of, sheet, "asked", "asked for", WHIRL_QUANTITY_PERCENT, 3);
        sheet_texts(of, sheet, "verdict", "verdict");
    }
    // Add the peaks of each station.
    for (size_t station = 0; station < of->result->station_count; station++) {
        const size_t count = margin_rows(of->result, of->table, station, rows);
        for (const margin_row *row = rows; row < rows + count; row++) {
            sheet_row(of, sheet);
            cell_station(of, sheet, station);
            cell_number(of, sheet, row->probe);
            cell_number(of, sheet, row->speed);
            cell_number(of, sheet, row->amplitude);
            cell_number(of, sheet, row->amplification);
            cell_text(of, sheet, find_text(of->findings, "%s", row->way));
            if (!running) continue;
            cell_number(of, sheet, row->had);
            cell_text(of, sheet, row->side);
            cell_number(of, sheet, row->asked);
            cell_text(of, sheet, row->verdict);
        }
    }
    find_sheet_end(of);
}

/// Adds the sheet of the share of clearances that scaled responses take.
static void find_clearances(const finder *of, const response_scale *by) {
    // Compute the shares of clearances.
    whirl_sheet *sheet = find_sheet(of, "clearances", "Scaled responses and clearances");
    scaled_response *rows = malloc((of->result->station_count + 1) * sizeof *rows);
    if (!rows) {
        of->findings->failed = true;
        return;
    }
    const size_t count = scaled_response_all(of->result, of->table, by, rows);
    // Set up the columns.
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "axis", "scaled major axis", WHIRL_QUANTITY_SPAN, 4);
    sheet_column(of, sheet, "speed", "speed", WHIRL_QUANTITY_SPEED, 5);
    sheet_column(of, sheet, "clearance", "diametral clearance", WHIRL_QUANTITY_SPAN, 4);
    sheet_column(of, sheet, "share", "share", WHIRL_QUANTITY_PERCENT, 3);
    sheet_texts(of, sheet, "verdict", "75 % allowed");
    // Add a row for each station with a clearance.
    for (const scaled_response *row = rows; row < rows + count; row++) {
        sheet_row(of, sheet);
        cell_station(of, sheet, row->station);
        cell_number(of, sheet, row->axis);
        cell_number(of, sheet, row->speed);
        cell_number(of, sheet, row->clearance);
        cell_number(of, sheet, 100.0 * row->axis / row->clearance);
        cell_text(of, sheet, row->holds ? "holds" : "fails");
    }
    find_sheet_end(of);
    free(rows);
}

/// States the factor by which responses are scaled, or why they are not scaled.
static void find_scaled(const finder *of) {
    // If the limit or running speeds are missing, state that.
    response_scale by;
    if (!scaled_response_scale(of->result, of->table, &by)) {
        if (!margin_asked(of->table)) return;
        phrase_text(of, &find_statement(of, "scaled responses")->found, "none: %s", scaled_response_lacks);
        return;
    }
    // State the limit, the largest response and the factor.
    whirl_statement *own = find_statement(of, "scaled responses");
    phrase_text(of, &own->found, "the vibration limit is ");
    phrase_number(of, &own->found, WHIRL_QUANTITY_SPAN, 4, by.limit);
    phrase_text(of, &own->found, ", the largest that a probe sees where the machine runs ");
    phrase_number(of, &own->found, WHIRL_QUANTITY_SPAN, 4, by.largest);
    phrase_text(of, &own->found, " (%s): responses are scaled by ", of->result->stations[by.station].name);
    phrase_number(of, &own->found, WHIRL_QUANTITY_NUMBER, 4, by.factor);
    phrase_text(of, &own->found, " (6 at most)%s", by.beyond ? "; the limit is passed" : "");
    // State up to which speed clearances count.
    if (by.trip > 0.0) {
        phrase_text(of, &own->found,
                    by.reaches ? "; clearances count up to the trip speed, "
                               : "; points do not reach the trip speed, ");
        phrase_number(of, &own->found, WHIRL_QUANTITY_SPEED, 5, by.trip);
        if (!by.reaches) phrase_text(of, &own->found, ": compute more points");
    }
    find_clearances(of, &by);
}

static void unbalance_find(const finder *of) {
    ask_response(of);
    find_placed(of);
    if (whirl_layout_field(&of->table->layout, WHIRL_FIELD_UNBALANCE_SEEN))
        phrase_text(of, &find_statement(of, "runout")->found,
                    "responses are without it; readings of probes with it are in |||" WHIRL_FIELD_UNBALANCE_SEEN);
    find_largest(of);
    find_peaks(of);
    find_scaled(of);
}

const shown_kind shown_unbalance = {
    .field = WHIRL_FIELD_UNBALANCE_AMPLITUDE,
    .anchor = "peaks",
    .name = "Peaks of the response",
    .about = "Critical speeds as peaks of all stations, as probes there see them, with the amplification "
             "factor, speed over the width at half power, and, where the running "
             "speeds are given, the separation margin after API 617 (which edition "
             "counts is for the user to check).",
    .find = unbalance_find};
