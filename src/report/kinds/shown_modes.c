// Findings on modes: critical speeds, stability thresholds, the lowest modes at both ends of the parameter, shapes of
// torsional and axial modes, and axial displacements at rest.
#include <math.h>

#include "mode_lines.h"
#include "quantities.h"
#include "shown_kinds.h"
#include "two_pi.h"
#include "units.h"

/// Adds the columns of a mode to a sheet.
static void mode_columns(const finder *of, whirl_sheet *sheet) {
    sheet_column(of, sheet, "angular_frequency", "angular frequency", WHIRL_QUANTITY_ANGULAR, 5);
    sheet_column(of, sheet, "frequency", "frequency", WHIRL_QUANTITY_FREQUENCY, 5);
    sheet_column(of, sheet, "damping_ratio", "damping ratio", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "decrement", "logarithmic decrement", WHIRL_QUANTITY_NUMBER, 4);
    sheet_texts(of, sheet, "whirl", "whirl");
}

/// Writes the cells of a mode in these columns; a damping ratio as small as rounding becomes 0.
static void mode_cells(const finder *of, whirl_sheet *sheet, double frequency, double damping, int way) {
    const double rounding = 1e-10, ratio = fabs(damping) < rounding ? 0.0 : damping;
    cell_number(of, sheet, frequency);
    cell_number(of, sheet, frequency);
    cell_number(of, sheet, ratio);
    cell_number(of, sheet, fabs(ratio) < 1.0 ? two_pi * ratio / sqrt(1.0 - ratio * ratio) : (double)NAN);
    cell_text(of, sheet, mode_way_name(way));
}

int shown_modes_growing(const whirl_table *table, size_t point) {
    const double stability = whirl_table_number(table, point, WHIRL_FIELD_MODES_STABILITY, 0);
    return (stability > 0.0) - (stability < 0.0);
}

// ---------------------------------------------------------------- statements of a point

/// States the peak sensitivity of control loops and its zone; an unstable machine has no zone.
static void find_sensitivity(const finder *of, size_t point) {
    const double peak = point_number(of->table, point, WHIRL_FIELD_MODES_SENSITIVITY);
    const char zone = peak < 3.0 ? 'A' : peak < 4.0 ? 'B' : peak < 5.0 ? 'C' : 'D';
    if (!isfinite(peak)) return;
    whirl_phrase *found = find_at(of, point, "peak sensitivity of the loops of control");
    phrase_number(of, found, WHIRL_QUANTITY_NUMBER, 4, peak);
    phrase_text(of, found, " at ");
    phrase_number(of, found, WHIRL_QUANTITY_FREQUENCY, 5,
                  point_number(of->table, point, WHIRL_FIELD_MODES_SENSITIVITY_FREQUENCY));
    if (shown_modes_growing(of->table, point) > 0)
        phrase_text(of, found, ": no zone of ISO 14839-3, as the machine is unstable");
    else
        phrase_text(of, found, ": zone %c of ISO 14839-3", zone);
}

static void find_stability(const finder *of, size_t point) {
    static const char *const names[] = {"stable", "undamped", "unstable"};
    const double stability = point_number(of->table, point, WHIRL_FIELD_MODES_STABILITY);
    const double rigid = point_number(of->table, point, WHIRL_FIELD_MODES_RIGID_BODY);
    if (isfinite(stability)) {
        whirl_phrase *found = find_at(of, point, "stability");
        phrase_text(of, found, "%s: the largest real part of all eigenvalues%s is ",
                    names[shown_modes_growing(of->table, point) + 1], rigid > 0.0 ? " but zeros" : "");
        phrase_number(of, found, WHIRL_QUANTITY_RATE, 4, stability);
    }
    if (rigid > 0.0) phrase_text(of, find_at(of, point, "rigid-body modes"), "%g, which nothing holds", rigid);
}

/// States the range of frequencies that are known.
static void find_limits(const finder *of, size_t point) {
    const double modulo = point_number(of->table, point, WHIRL_FIELD_MODES_MODULO);
    const double *known = whirl_table_field(of->table, point, WHIRL_FIELD_MODES_KNOWN, 0);
    const double *frequency = whirl_table_field(of->table, point, WHIRL_FIELD_MODES_FREQUENCY, 0);
    if (isfinite(modulo)) {
        whirl_phrase *found = find_at(of, point, "frequencies");
        phrase_text(of, found, "known but for multiples of ");
        phrase_number(of, found, WHIRL_QUANTITY_ANGULAR, 5, modulo);
        phrase_text(of, found, ": coefficients turn with the shaft");
    }
    if (known && isfinite(known[0])) {
        whirl_phrase *found = find_at(of, point, "frequencies");
        phrase_text(of, found, frequency && isfinite(frequency[0]) ? "modes from " : "no modes from ");
        phrase_number(of, found, WHIRL_QUANTITY_ANGULAR, 5, known[0]);
        phrase_text(of, found, " to ");
        phrase_number(of, found, WHIRL_QUANTITY_ANGULAR, 5, known[1]);
        phrase_text(of, found,
                    ": coefficients of bearings are those at the damped frequency of each mode, and their tables "
                    "end there");
    }
}

// ---------------------------------------------------------------- along the parameter

enum { MAX_LOCATED = 6 };

/// Appends a row of WHIRL_FIELD_MODES_CRITICAL: "2753.2 rpm", "unstable from 6100 rpm" or, for a parameter other than
/// the speed, "3000 rpm at k = 8e+06 N/m", "unstable from q = 1e+07 N/m".
static void phrase_change(const finder *of, whirl_phrase *found, const double *row) {
    const bool critical = row[0] < 1.5, by_speed = fabs(row[1] - row[2]) <= 1e-9 * row[2];
    phrase_text(of, found, "%s%s", found->count ? ", " : "",
                critical       ? ""
                : row[0] < 2.5 ? "unstable from "
                               : "stable from ");
    if (critical || by_speed) phrase_number(of, found, WHIRL_QUANTITY_SPEED, 5, row[2]);
    if (by_speed) return;
    phrase_text(of, found, "%s%s = ", critical ? " at " : "", of->table->parameter);
    phrase_value(of, found, 5, row[1]);
}

/// Appends the number of unstable values, for tables in which no threshold was located.
static void phrase_unstable(const finder *of, whirl_phrase *found) {
    size_t unstable = 0, done = 0;
    for (size_t point = 0; point < of->table->count; point++) {
        if (!whirl_table_done(of->table, point)) continue;
        done++;
        unstable += shown_modes_growing(of->table, point) > 0;
    }
    if (unstable == 0) return;
    phrase_text(of, found, unstable == done ? "%sunstable at all %zu values" : "%sunstable at %zu of %zu values",
                found->count ? ", " : "", unstable, done);
}

/// Returns true if frequencies at any point are known only modulo the speed.
static bool is_modulated(const finder *of) {
    for (size_t point = 0; point < of->table->count; point++)
        if (whirl_table_done(of->table, point) && isfinite(point_number(of->table, point, WHIRL_FIELD_MODES_MODULO)))
            return true;
    return false;
}

/// Adds the sheet of critical speeds and thresholds of stability along the parameter, and a statement of them.
static void find_critical(const finder *of) {
    static const char *const names[] = {"",
                                        "critical speed",
                                        "instability begins",
                                        "instability ends",
                                        "torsional frequency at the speed",
                                        "axial frequency at the speed"};
    const whirl_field *field = whirl_layout_field(&of->table->layout, WHIRL_FIELD_MODES_CRITICAL);
    const bool speeds =
        units_of_speed(of->table, WHIRL_FIELD_MODES_SPEED); // the parameter is the speed: no column of speeds
    whirl_phrase found = {.count = 0};
    size_t located = 0, changes = 0;
    whirl_sheet *sheet = find_sheet(of, "critical", "Critical speeds and thresholds of stability");
    sheet_texts(of, sheet, "what", "what");
    sheet_values(of, sheet, "", 5);
    if (!speeds) sheet_column(of, sheet, "speed", "speed", WHIRL_QUANTITY_SPEED, 5);
    mode_columns(of, sheet);
    // Add a row for each crossing of each point, and state the first crossings.
    for (size_t point = 0; field && point < of->table->count; point++) {
        const double *row = whirl_table_field(of->table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; row && whirl_table_done(of->table, point) && i < field->rows; i++, row += field->columns) {
            if (!(row[0] >= WHIRL_CRITICAL_SPEED && row[0] <= WHIRL_AXIAL_SPEED)) continue;
            const int way = row[0] == WHIRL_TORSIONAL_SPEED ? MODE_TORSIONAL
                            : row[0] == WHIRL_AXIAL_SPEED   ? MODE_AXIAL
                                                            : units_way(row[5]);
            changes += row[0] == WHIRL_ONSET || row[0] == WHIRL_RECOVERY;
            if (way <= MODE_FORWARD && located++ < MAX_LOCATED) phrase_change(of, &found, row);
            sheet_row(of, sheet);
            cell_text(of, sheet, names[(int)row[0]]);
            cell_number(of, sheet, row[1]);
            if (!speeds) cell_number(of, sheet, row[2]);
            mode_cells(of, sheet, row[3], row[4], way);
        }
    }
    find_sheet_end(of);
    // State how many crossings are left out, whether the machine is unstable everywhere, or that nothing was found.
    if (located > MAX_LOCATED) phrase_text(of, &found, " and %zu more", located - MAX_LOCATED);
    if (changes == 0) phrase_unstable(of, &found);
    if (found.count == 0)
        phrase_text(of, &found,
                    is_modulated(of)
                        ? "coefficients turn with the shaft, so that critical speeds are not reported; between "
                          "the computed values the machine neither loses nor regains its stability"
                        : "between the computed values no natural frequency meets the speed of "
                          "the shaft, and the machine neither loses nor regains its stability");
    find_statement(of, "critical speeds with damping, and thresholds of stability")->found = found;
}

/// Adds the sheet of the lowest modes at the first and the last value.
static void find_lowest(const finder *of, const mode_lines *lines, const size_t *ends, size_t count) {
    // Set up the columns.
    const whirl_field *field = whirl_layout_field(&of->table->layout, WHIRL_FIELD_MODES_FREQUENCY);
    whirl_sheet *sheet = find_sheet(of, "lowest", "Lowest modes");
    sheet_values(of, sheet, "", 6);
    sheet_column(of, sheet, "mode", "mode", WHIRL_QUANTITY_NUMBER, 4);
    sheet_texts(of, sheet, "name", "name");
    mode_columns(of, sheet);
    // Add the modes of both ends; unused places of a point have no frequency.
    for (const size_t *point = ends; point < ends + count; point++) {
        const double *frequency = whirl_table_field(of->table, *point, WHIRL_FIELD_MODES_FREQUENCY, 0);
        const double *ratios = whirl_table_field(of->table, *point, WHIRL_FIELD_MODES_DAMPING_RATIO, 0);
        for (size_t i = 0; field && frequency && i < field->rows && isfinite(frequency[i]); i++) {
            sheet_row(of, sheet);
            cell_value(of, sheet, *point);
            cell_number(of, sheet, (double)i + 1.0);
            cell_text(of, sheet, find_text(of->findings, "%s", mode_lines_name(lines, *point, i)));
            mode_cells(of, sheet, frequency[i], ratios[i], mode_way(of->table, *point, i));
        }
    }
    find_sheet_end(of);
}

/// Adds the sheet of the shapes of torsional or axial modes (`way`) at a point. `field` is the name of the field that
/// holds their twists or their axial displacements.
static void find_shapes(const finder *of, const mode_lines *lines, size_t point, int way, const char *field) {
    const bool torsional = way == MODE_TORSIONAL;
    const whirl_field *shape = whirl_layout_field(&of->table->layout, field);
    if (!shape || shape->rows == 0) return;
    whirl_sheet *sheet =
        torsional ? find_sheet(of, "twists", "Shapes of torsional modes: twists of the stations")
                  : find_sheet(of, "axial_shapes", "Shapes of axial modes: axial displacements of the stations");
    sheet_texts(of, sheet, "name", "mode");
    sheet_column(of, sheet, "frequency", "frequency", WHIRL_QUANTITY_FREQUENCY, 5);
    sheet_texts(of, sheet, "station", "station");
    if (torsional)
        sheet_column(of, sheet, "twist", "twist", WHIRL_QUANTITY_NUMBER, 4);
    else
        sheet_column(of, sheet, "axial", "axial displacement", WHIRL_QUANTITY_NUMBER, 4);
    for (size_t i = 0; i < shape->rows; i++) {
        const double frequency = whirl_table_field(of->table, point, WHIRL_FIELD_MODES_FREQUENCY, 0)[i];
        if (!isfinite(frequency) || mode_way(of->table, point, i) != way) continue;
        for (size_t s = 0; s < of->result->station_count; s++) {
            const double *moved = whirl_table_field(of->table, point, field, s) + 2 * i;
            sheet_row(of, sheet);
            cell_text(of, sheet, find_text(of->findings, "%s", mode_lines_name(lines, point, i)));
            cell_number(of, sheet, frequency);
            cell_station(of, sheet, s);
            cell_number(of, sheet, copysign(hypot(moved[0], moved[1]), moved[0]));
        }
    }
    find_sheet_end(of);
}

/// Displacements at rest that are rounding, m.
static const double axial_rounding = 1e-15;

/// Adds the sheet of axial displacements at rest, at the first and the last value.
static void find_axial_rest(const finder *of, const size_t *ends, size_t count) {
    if (!whirl_layout_field(&of->table->layout, WHIRL_FIELD_MODES_AXIAL_REST)) return;
    whirl_sheet *sheet = find_sheet(of, "axial_rest", "Axial displacements at rest");
    sheet->about = "Positive in the direction in which positions grow.";
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "axial", "axial displacement", WHIRL_QUANTITY_LENGTH, 5);
    for (const size_t *point = ends; point < ends + count; point++)
        for (size_t s = 0; s < of->result->station_count; s++) {
            const double *rest = whirl_table_field(of->table, *point, WHIRL_FIELD_MODES_AXIAL_REST, s);
            if (!rest) continue;
            sheet_row(of, sheet);
            cell_value(of, sheet, *point);
            cell_station(of, sheet, s);
            cell_number(of, sheet, fabs(*rest) < axial_rounding ? 0.0 : *rest);
        }
    find_sheet_end(of);
}

static void modes_find(const finder *of) {
    size_t ends[2];
    const size_t count = find_ends(of->table, ends);
    if (*of->table->parameter) find_critical(of);
    for (const size_t *point = ends; point < ends + count; point++) {
        find_stability(of, *point);
        find_limits(of, *point);
        find_sensitivity(of, *point);
    }
    // Follow the modes along the parameter: a mode has the name of its line.
    mode_lines lines;
    if (!mode_lines_of(of->table, &lines)) lines = (mode_lines){.line = NULL};
    find_lowest(of, &lines, ends, count);
    if (count > 0) {
        find_torsion(of, &lines);
        find_shapes(of, &lines, ends[count - 1], MODE_TORSIONAL, WHIRL_FIELD_MODES_TWIST);
        find_shapes(of, &lines, ends[count - 1], MODE_AXIAL, WHIRL_FIELD_MODES_AXIAL);
        find_axial_rest(of, ends, count);
    }
    mode_lines_free(&lines);
}

const shown_kind shown_modes = {.field = WHIRL_FIELD_MODES_FREQUENCY,
                                .anchor = "critical",
                                .name = "Critical speeds and stability",
                                .find = modes_find};
