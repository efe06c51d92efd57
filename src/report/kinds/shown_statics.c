// Findings on a machine at rest: weight and sag, positions in films, coefficients of bearings.
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "margins.h"
#include "shown_kinds.h"

/// Returns a number of a station at a point, in SI if it is a length.
static double number(const finder *of, size_t point, const char *field, size_t station) {
    return whirl_table_number(of->table, point, field, station);
}
static double length(const finder *of, size_t point, const char *field, size_t station) {
    return whirl_result_length_scale(of->result, of->table, point) * number(of, point, field, station);
}

/// Returns 0 for a value that is a rounding error of the largest value of its kind.
static double without_noise(double value, double largest) {
    return fabs(value) <= 1e-12 * largest ? 0.0 : value;
}

/// Returns the largest slope of the shafts at a point, rad.
static double largest_slope(const finder *of, size_t point) {
    double largest = 0.0;
    for (size_t station = 0; station < of->result->station_count; station++)
        largest = fmax(largest, fabs(number(of, point, WHIRL_FIELD_STATICS_SLOPE, station)));
    return largest;
}

static void find_weight(const finder *of, const size_t *ends, size_t count) {
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "weight", "Weight, loads of bearings and sag");
    sheet->about = "Each shaft under its weight on its own bearings, which are taken as rigid; couplings, springs and "
                   "mounts are left out.";
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "load", "bearing carries", WHIRL_QUANTITY_FORCE, 5);
    sheet_column(of, sheet, "elevation", "raised by", WHIRL_QUANTITY_LENGTH, 5);
    sheet_column(of, sheet, "deflection", "deflection upwards", WHIRL_QUANTITY_LENGTH, 4);
    sheet_column(of, sheet, "slope", "slope", WHIRL_QUANTITY_SLOPE, 4);
    sheet_column(of, sheet, "moment", "bending moment", WHIRL_QUANTITY_MOMENT, 5);
    sheet_column(of, sheet, "mass_left", "mass to the left", WHIRL_QUANTITY_MASS, 5);
    sheet_column(of, sheet, "mass_right", "mass to the right", WHIRL_QUANTITY_MASS, 5);
    // Add the stations on shafts, at the first and the last point.
    for (const size_t *point = ends; point < ends + count; point++)
        for (size_t station = 0; station < of->result->station_count; station++) {
            const double deflection = length(of, *point, WHIRL_FIELD_STATICS_DEFLECTION, station);
            const double *mass = whirl_table_field(of->table, *point, WHIRL_FIELD_STATICS_MASS, station);
            if (isnan(deflection)) continue;
            sheet_row(of, sheet);
            cell_value(of, sheet, *point);
            cell_station(of, sheet, station);
            cell_number(of, sheet, number(of, *point, WHIRL_FIELD_STATICS_LOAD, station));
            cell_number(of, sheet, length(of, *point, WHIRL_FIELD_STATICS_ELEVATION, station));
            cell_number(of, sheet, deflection);
            cell_number(
                of, sheet,
                without_noise(number(of, *point, WHIRL_FIELD_STATICS_SLOPE, station), largest_slope(of, *point)));
            cell_number(of, sheet, number(of, *point, WHIRL_FIELD_STATICS_MOMENT, station));
            cell_number(of, sheet, mass ? mass[0] : (double)NAN);
            cell_number(of, sheet, mass ? mass[1] : (double)NAN);
        }
    // Show rows that are equal at both points once.
    sheet_once(of, sheet);
    find_sheet_end(of);
}

/// Adds the sheet of axial forces of vertical shafts, and the parts that carry them.
static void find_axial(const finder *of, const size_t *ends, size_t count) {
    // Look for a vertical shaft.
    bool stands = false;
    for (const size_t *point = ends; point < ends + count; point++)
        for (size_t station = 0; station < of->result->station_count; station++)
            stands = stands || isfinite(number(of, *point, WHIRL_FIELD_STATICS_THRUST, station));
    if (!stands) return;
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "axial", "Axial forces of shafts that stand");
    sheet->about =
        "The load of the thrust bearing, and the axial force in the shaft on both sides of a station, positive in "
        "tension. Both follow from the weight and the axial forces of segments.";
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "thrust_mass", "mass held", WHIRL_QUANTITY_MASS, 5);
    sheet_column(of, sheet, "thrust", "load held", WHIRL_QUANTITY_FORCE, 5);
    sheet_column(of, sheet, "axial_left", "axial force to the left", WHIRL_QUANTITY_FORCE, 5);
    sheet_column(of, sheet, "axial_right", "axial force to the right", WHIRL_QUANTITY_FORCE, 5);
    // Add the stations on vertical shafts, at the first and the last point.
    for (const size_t *point = ends; point < ends + count; point++)
        for (size_t station = 0; station < of->result->station_count; station++) {
            const double *axial = whirl_table_field(of->table, *point, WHIRL_FIELD_STATICS_AXIAL_FORCE, station);
            if (!axial || isnan(*axial)) continue;
            sheet_row(of, sheet);
            cell_value(of, sheet, *point);
            cell_station(of, sheet, station);
            cell_number(of, sheet, number(of, *point, WHIRL_FIELD_STATICS_THRUST_MASS, station));
            cell_number(of, sheet, number(of, *point, WHIRL_FIELD_STATICS_THRUST, station));
            cell_number(of, sheet, axial[0]);
            cell_number(of, sheet, axial[1]);
        }
    // Show rows that are equal at both points once.
    sheet_once(of, sheet);
    find_sheet_end(of);
}

/// Writes the numbers of pads without a film, "2, 3", from the digits of a field.
static const char *pads_of(const finder *of, double unloaded) {
    char digits[32] = "", list[96] = "";
    size_t used = 0;
    if (unloaded > 0.0) snprintf(digits, sizeof digits, "%.0f", unloaded);
    for (const char *digit = digits; *digit; digit++)
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%c", used ? ", " : "", *digit);
    return find_text(of->findings, "%s", list);
}

/// Largest number of points whose equilibria are listed: as many as fit on a page.
enum { MAX_RESTS = 9 };

/// Returns the computed point whose value is nearest to a speed, or SIZE_MAX if no point is computed.
static size_t rest_nearest(const finder *of, double speed) {
    size_t nearest = SIZE_MAX;
    for (size_t point = 0; point < of->table->count; point++) {
        const double value = of->table->values[point];
        if (!whirl_table_done(of->table, point)) continue;
        if (nearest == SIZE_MAX || fabs(value - speed) < fabs(of->table->values[nearest] - speed)) nearest = point;
    }
    return nearest;
}

/// Chooses the points whose rest positions are listed (listed [points of the table]): all points if they are few; else
/// the first, the last, the points nearest to running speeds of any table of the result, and some between.
static void rest_choose(const finder *of, const size_t *ends, size_t count, bool *listed) {
    enum { EVEN = 5 };
    const bool few = of->table->count <= MAX_RESTS;
    for (size_t point = 0; point < of->table->count; point++) listed[point] = few;
    for (size_t i = 0; i < count; i++) listed[ends[i]] = true;
    for (size_t i = 1; i < EVEN - 1 && count == 2; i++) listed[ends[0] + (ends[1] - ends[0]) * i / (EVEN - 1)] = true;
    if (few || count == 0 || strcmp(whirl_result_parameter_unit(of->result, of->table->parameter), "rad/s") != 0)
        return;
    for (size_t t = 0; t < of->result->table_count; t++) {
        double running[2];
        if (!margin_running(&of->result->tables[t], &running[0], &running[1])) continue;
        for (size_t i = 0; i < 2; i++) listed[rest_nearest(of, running[i])] = true;
        return;
    }
}

/// Adds the rows of one point, one for each film and seal.
static void find_rest(const finder *of, whirl_sheet *sheet, size_t point) {
    for (size_t station = 0; station < of->result->station_count; station++) {
        const double film = length(of, point, WHIRL_FIELD_STATICS_FILM, station);
        if (!isfinite(film)) continue;
        const bool seal = number(of, point, WHIRL_FIELD_STATICS_SEAL, station) == 1.0;
        sheet_row(of, sheet);
        cell_value(of, sheet, point);
        cell_station(of, sheet, station);
        cell_text(of, sheet, seal ? "seal" : "film");
        cell_number(of, sheet, number(of, point, WHIRL_FIELD_STATICS_LOAD, station));
        cell_number(of, sheet, number(of, point, WHIRL_FIELD_STATICS_ECCENTRICITY, station));
        cell_number(of, sheet, number(of, point, WHIRL_FIELD_STATICS_ATTITUDE, station));
        cell_number(of, sheet, film);
        cell_text(of, sheet, pads_of(of, number(of, point, WHIRL_FIELD_STATICS_UNLOADED, station)));
    }
}

/// Adds the sheet of rest positions of shafts in films and seals.
static void find_films(const finder *of, const size_t *ends, size_t count) {
    whirl_sheet *sheet = find_sheet(of, "films", "Shafts at rest in films and seals");
    bool *listed = calloc(of->table->count + 1, sizeof *listed);
    if (!listed) of->findings->failed = true;
    sheet->about = "The weight carried is that of each shaft on its bearings alone: seals and springs may take a part "
                   "of it. The eccentricity ratio is over the clearance "
                   "as assembled, the attitude from the load with the rotation.";
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "station", "station");
    sheet_texts(of, sheet, "in", "in");
    sheet_column(of, sheet, "load", "weight carried", WHIRL_QUANTITY_FORCE, 5);
    sheet_column(of, sheet, "eccentricity", "eccentricity ratio", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "attitude", "attitude", WHIRL_QUANTITY_DEGREES, 4);
    sheet_column(of, sheet, "film", "least thickness", WHIRL_QUANTITY_LENGTH, 4);
    sheet_texts(of, sheet, "unloaded", "pads that carry nothing");
    if (listed) rest_choose(of, ends, count, listed);
    for (size_t point = 0; listed && point < of->table->count; point++)
        if (listed[point] && whirl_table_done(of->table, point)) find_rest(of, sheet, point);
    free(listed);
    find_sheet_end(of);
}

/// Adds the sheet of stiffness and damping of bearings at all points.
static void find_coefficients(const finder *of) {
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "coefficients", "Coefficients of bearings");
    sheet->about = "Stiffness and damping of bearings about where the machine rests: forces against displacements and "
                   "velocities, kxy along x by y.";
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "station", "bearing");
    sheet_coefficients(of, sheet, NULL);
    // Add a row for each bearing; coefficients far below the largest are rounding errors, and shown as 0.
    for (size_t point = 0; point < of->table->count; point++)
        for (size_t station = 0; station < of->result->station_count; station++) {
            const double *const k = whirl_table_field(of->table, point, WHIRL_FIELD_STATICS_STIFFNESS, station);
            const double *const c = whirl_table_field(of->table, point, WHIRL_FIELD_STATICS_DAMPING, station);
            if (!whirl_table_done(of->table, point) || !k || !c || isnan(*k)) continue;
            sheet_row(of, sheet);
            cell_value(of, sheet, point);
            cell_station(of, sheet, station);
            for (size_t i = 0; i < 8; i++) {
                const double *const own = i < 4 ? k : c;
                const double largest = fmax(fmax(fabs(own[0]), fabs(own[1])), fmax(fabs(own[2]), fabs(own[3])));
                cell_number(of, sheet, without_noise(own[i % 4], largest));
            }
        }
    find_sheet_end(of);
}

static void statics_find(const finder *of) {
    size_t ends[2];
    const size_t count = find_ends(of->table, ends);
    if (*of->table->record.coupling)
        phrase_text(of, &find_statement(of, "alignment")->found,
                    "bearings are raised so that there is no moment and no shear at %s", of->table->record.coupling);
    find_weight(of, ends, count);
    find_axial(of, ends, count);
    find_films(of, ends, count);
    find_coefficients(of);
}

const shown_kind shown_statics = {.field = WHIRL_FIELD_STATICS_LOAD,
                                  .anchor = "statics",
                                  .name = "Weight and loads of bearings",
                                  .held = "sag and loads leave out",
                                  .find = statics_find};
