// Findings on undamped critical speeds, forward and backward.
#include <math.h>

#include "shown_kinds.h"
#include "units.h"

enum { LISTED = 6 };

/// Writes a cell with the lowest critical speeds of a direction (1: forward, -1: backward, 0: to and fro).
static void cell_speeds(const finder *of, whirl_sheet *sheet, size_t point, int direction) {
    const whirl_field *field = whirl_layout_field(&of->table->layout, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED);
    const double *speeds = whirl_table_field(of->table, point, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, 0);
    const double *directions = whirl_table_field(of->table, point, WHIRL_FIELD_CRITICAL_SPEEDS_DIRECTION, 0);
    double listed[LISTED];
    size_t count = 0;
    for (size_t i = 0; i < field->rows && count < LISTED && isfinite(speeds[i]); i++)
        if (units_way(directions[i]) == direction) listed[count++] = speeds[i];
    cell_numbers(of, sheet, count, listed);
}

static void critical_speeds_find(const finder *of) {
    whirl_sheet *sheet = find_sheet(of, "critical-speeds", "Critical speeds without damping");
    sheet->of_points = true;
    sheet_values(of, sheet, "", 6);
    sheet_list(of, sheet, "forward", "forward", WHIRL_QUANTITY_SPEED, 5, ", ");
    sheet_list(of, sheet, "backward", "backward", WHIRL_QUANTITY_SPEED, 5, ", ");
    sheet_list(of, sheet, "to_and_fro", "to and fro", WHIRL_QUANTITY_SPEED, 5, ", ");
    sheet_column(of, sheet, "rigid_body", "rigid-body modes, which nothing holds", WHIRL_QUANTITY_NUMBER, 3);
    for (size_t point = 0; point < of->table->count; point++) {
        static const int directions[] = {1, -1, 0};
        if (!whirl_table_done(of->table, point)) continue;
        const double rigid = whirl_table_number(of->table, point, WHIRL_FIELD_CRITICAL_SPEEDS_RIGID_BODY, 0);
        sheet_row(of, sheet);
        cell_value(of, sheet, point);
        for (int i = 0; i < 3; i++) cell_speeds(of, sheet, point, directions[i]);
        cell_number(of, sheet, rigid > 0.0 ? rigid : (double)NAN);
    }
    find_sheet_end(of);
}

const shown_kind shown_critical_speeds = {.field = WHIRL_FIELD_CRITICAL_SPEEDS_SPEED,
                                          .anchor = "critical-speeds",
                                          .name = "Critical speeds without damping",
                                          .about = "Of the machine without damping, the lowest 6 of each direction.",
                                          .find = critical_speeds_find};
