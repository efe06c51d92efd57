// Findings on stability: decrements, the limit of the cross coupling, and whether seals must be included.
#include <math.h>

#include "asked.h"
#include "quantities.h"
#include "shown_kinds.h"

static void find_levels(const finder *of) {
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "levels", "Stability by decrements");
    sheet->of_points = true;
    sheet_values(of, sheet, "", 6);
    sheet_column(of, sheet, "anticipated", "anticipated cross coupling", WHIRL_QUANTITY_CROSS, 5);
    sheet_column(of, sheet, "limit", "its limit", WHIRL_QUANTITY_CROSS, 5);
    sheet_column(of, sheet, "times", "limit over anticipated", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "basic", "bearings alone", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "decrement", "with stages", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "complete", "with seals and impellers", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "frequency", "frequency with stages", WHIRL_QUANTITY_FREQUENCY, 5);
    sheet_column(of, sheet, "rigid", "first critical speed on rigid supports", WHIRL_QUANTITY_SPEED, 5);
    sheet_column(of, sheet, "ratio", "critical speed ratio", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "density", "gas", WHIRL_QUANTITY_DENSITY, 4);
    sheet_texts(of, sheet, "region", "region");
    sheet_texts(of, sheet, "follows", "what follows");
    // Add a row for each point; without stages there is no anticipated cross coupling.
    for (size_t point = 0; point < of->table->count; point++) {
        char text[ASKED_TEXT];
        if (!whirl_table_done(of->table, point)) continue;
        const asked_stability at = asked_stability_at(of->table, point);
        asked_stability_text(&at, text);
        sheet_row(of, sheet);
        cell_value(of, sheet, point);
        cell_number(of, sheet, at.stages ? at.anticipated : (double)NAN);
        cell_number(of, sheet, at.stages ? at.limit : (double)NAN);
        cell_number(of, sheet, at.ratio);
        cell_number(of, sheet, point_number(of->table, point, WHIRL_FIELD_STABILITY_BASIC));
        cell_number(of, sheet, at.decrement);
        cell_number(of, sheet, at.complete);
        cell_number(of, sheet, point_number(of->table, point, WHIRL_FIELD_STABILITY_FREQUENCY));
        cell_number(of, sheet, point_number(of->table, point, WHIRL_FIELD_STABILITY_RIGID));
        cell_number(of, sheet, point_number(of->table, point, WHIRL_FIELD_STABILITY_RATIO));
        cell_number(of, sheet, point_number(of->table, point, WHIRL_FIELD_STABILITY_DENSITY));
        cell_text(of, sheet, !isfinite(at.region) ? "" : at.region > 0.5 ? "B" : "A");
        cell_text(of, sheet, find_text(of->findings, "%s", text));
    }
    find_sheet_end(of);
}

/// Adds the sheet of decrements with bearings, and with the seals and impellers of one station.
static void find_parts(const finder *of) {
    whirl_sheet *sheet = find_sheet(of, "parts", "Decrements with bearings, and seals and impellers of one station");
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "station", "seals and impellers at");
    sheet_column(of, sheet, "decrement", "decrement", WHIRL_QUANTITY_NUMBER, 4);
    for (size_t point = 0; point < of->table->count; point++)
        for (size_t station = 0; station < of->result->station_count; station++) {
            const double own = whirl_table_number(of->table, point, WHIRL_FIELD_STABILITY_PART, station);
            if (!whirl_table_done(of->table, point) || !isfinite(own)) continue;
            sheet_row(of, sheet);
            cell_value(of, sheet, point);
            cell_station(of, sheet, station);
            cell_number(of, sheet, own);
        }
    find_sheet_end(of);
}

static void stability_find(const finder *of) {
    ask_stability(of);
    find_levels(of);
    find_parts(of);
}

const shown_kind shown_stability = {.field = WHIRL_FIELD_STABILITY_BASIC,
                                    .anchor = "stability",
                                    .name = "Stability by decrements",
                                    .about = "The smallest logarithmic decrement of the forward modes up to the speed; "
                                             "if the first of them is faster, its decrement. It is computed with "
                                             "bearings alone, with the cross coupling of stages (as anticipated, and "
                                             "the limit at which the decrement is 0), and with seals and impellers. By "
                                             "API 617 (check which edition applies) bearings and stages alone suffice "
                                             "if the limit is at least 2 times the anticipated coupling (10 times in "
                                             "region B of the screening diagram) and the decrement is at least 0.1; "
                                             "otherwise the decrement with seals and impellers must be above 0.1. The "
                                             "critical speed ratio is the speed over "
                                             "the first forward critical speed without damping on rigid supports.",
                                    .find = stability_find};
