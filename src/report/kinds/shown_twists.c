// Findings on responses to torques: excitations, the largest torques with their stress, peaks with their modes, angles.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "margins.h"
#include "shown_kinds.h"
#include "whirl/engine/torsion.h"
#include "whirl/internal/response_peaks.h"

static const double degree = 3.14159265358979323846 / 180.0;

static const double *twists_numbers(const finder *of, size_t point, const char *field, size_t which) {
    return whirl_table_done(of->table, point) ? whirl_table_field(of->table, point, field, which) : NULL;
}

static size_t twists_rows(const whirl_table *table, const char *field) {
    const whirl_field *found = whirl_layout_field(&table->layout, field);
    return found ? found->rows : 0;
}

void torque_name(const whirl_result *result, const double *of, char *name, size_t size) {
    // Words for kinds of torques.
    static const char *const kinds[WHIRL_TORQUE_KINDS] = {[WHIRL_TORQUE_BETWEEN] = "twist",
                                                          [WHIRL_TORQUE_INDUCTION_MOTOR] = "induction motor",
                                                          [WHIRL_TORQUE_SYNCHRONOUS_START] = "synchronous start",
                                                          [WHIRL_TORQUE_SHORT_CIRCUIT] = "short circuit",
                                                          [WHIRL_TORQUE_TIMED] = "torque over time",
                                                          [WHIRL_TORQUE_MESH] = "mesh",
                                                          [WHIRL_TORQUE_RIGID_GEAR] = "rigid gear",
                                                          [WHIRL_TORQUE_WITH_PLAY] = "spring with play"};
    // Name both ends, if they are stations.
    const char *station[2];
    for (size_t end = 0; end < 2; end++) {
        const bool named = of[1 + end] >= 0.0 && of[1 + end] < (double)result->station_count;
        station[end] = named ? result->stations[(size_t)of[1 + end]].name : "";
    }
    // Join kind and ends: a shaft has two stations, a mesh may end at the ground, all other kinds have one station.
    const size_t kind = of[0] > 0.0 && of[0] < (double)WHIRL_TORQUE_KINDS ? (size_t)of[0] : 0;
    if (kind == WHIRL_TORQUE_BETWEEN)
        snprintf(name, size, "%s to %s", *station[0] ? station[0] : "between stations",
                 *station[1] ? station[1] : "between stations");
    else if (kind >= WHIRL_TORQUE_MESH)
        snprintf(name, size, "%s, %s to %s", kinds[kind], *station[0] ? station[0] : "ground",
                 *station[1] ? station[1] : "ground");
    else
        snprintf(name, size, *station[0] ? "%s at %s" : "%s", kinds[kind], station[0]);
}

/// Returns the first computed point, or the number of points if none is computed.
static size_t twists_first(const whirl_table *table) {
    size_t point = 0;
    while (point < table->count && !whirl_table_done(table, point)) point++;
    return point;
}

void twists_name_excitation(const whirl_table *table, size_t index, char *name, size_t size) {
    const size_t point = twists_first(table);
    *name = '\0';
    if (point == table->count) return;
    if (whirl_table_field(table, point, WHIRL_FIELD_TORSION_FIXED, 0)[index] > 0.0)
        snprintf(name, size, "%.5g Hz",
                 whirl_table_field(table, point, WHIRL_FIELD_TORSION_FREQUENCY, 0)[index] / (360.0 * degree));
    else
        snprintf(name, size, "%.5gX", whirl_table_field(table, point, WHIRL_FIELD_TORSION_ORDER, 0)[index]);
}

static const char *twists_excitation(const finder *of, size_t index) {
    char name[WHIRL_NAME_SIZE];
    twists_name_excitation(of->table, index, name, sizeof name);
    return find_text(of->findings, "%s", name);
}

/// Returns the name of a torque; it is the same at all points.
static const char *twists_torque(const finder *of, size_t path) {
    char name[2 * WHIRL_NAME_SIZE + 40] = "";
    const size_t point = twists_first(of->table);
    if (point < of->table->count)
        torque_name(of->result, whirl_table_field(of->table, point, WHIRL_FIELD_TORSION_TORQUE_OF, 0) + 3 * path, name,
                    sizeof name);
    return find_text(of->findings, "%s", name);
}

/// Returns true if a point is within the running speeds.
static bool twists_runs(const finder *of, size_t point) {
    static const double rounding = 1e-9;
    double low, high;
    const double speed = whirl_table_number(of->table, point, WHIRL_FIELD_TORSION_SPEED, 0);
    return margin_running(of->table, &low, &high) && speed >= low * (1.0 - rounding) &&
           speed <= high * (1.0 + rounding);
}

/// Finds the point at which a number of a field is largest, among all points or points at running speeds. Returns false
/// if no point has a number.
static bool twists_largest(const finder *of, const char *field, size_t which, size_t row, bool running, size_t *at) {
    double largest = -1.0;
    for (size_t point = 0; point < of->table->count; point++) {
        const double *own = twists_numbers(of, point, field, which);
        if (!own || !(own[row] > largest) || (running && !twists_runs(of, point))) continue;
        largest = own[row];
        *at = point;
    }
    return largest >= 0.0;
}

/// Returns true if two torques are between the same stations: pieces of one stretch of a shaft.
static bool twists_are_one(const whirl_table *table, size_t one, size_t other) {
    const size_t point = twists_first(table);
    const double *of = point < table->count ? whirl_table_field(table, point, WHIRL_FIELD_TORSION_TORQUE_OF, 0) : NULL;
    bool same = of != NULL;
    for (size_t i = 0; i < 3 && same; i++) same = of[3 * one + i] == of[3 * other + i];
    return same;
}

/// Returns true for the first torque between its stations.
static bool twists_leads(const whirl_table *table, size_t path) {
    for (size_t k = 0; k < path; k++)
        if (twists_are_one(table, k, path)) return false;
    return true;
}

/// Finds the largest sum of amplitudes among torques between the same stations as `path`, at all points or at running
/// speeds: its point and its torque. Returns false if there is no number.
static bool twists_largest_of(const finder *of, size_t path, bool running, size_t *at, size_t *which) {
    double largest = -1.0;
    for (size_t k = path; k < twists_rows(of->table, WHIRL_FIELD_TORSION_TORQUE_OF); k++) {
        size_t point = 0;
        if (!twists_are_one(of->table, path, k) ||
            !twists_largest(of, WHIRL_FIELD_TORSION_TORQUE_SUM, 0, k, running, &point))
            continue;
        const double own = twists_numbers(of, point, WHIRL_FIELD_TORSION_TORQUE_SUM, 0)[k];
        if (!(own > largest)) continue;
        largest = own;
        *at = point;
        *which = k;
    }
    return largest >= 0.0;
}

size_t twists_choose(const whirl_table *table, size_t most, size_t *chosen) {
    const size_t paths = twists_rows(table, WHIRL_FIELD_TORSION_TORQUE_OF);
    double *sizes = calloc(paths + 1, sizeof *sizes);
    size_t count = 0;
    // Find the largest sum of each torque over all points.
    for (size_t point = 0; sizes && point < table->count; point++) {
        const double *own = whirl_table_field(table, point, WHIRL_FIELD_TORSION_TORQUE_SUM, 0);
        for (size_t k = 0; k < paths && own && whirl_table_done(table, point); k++)
            sizes[k] = fmax(sizes[k], isnan(own[k]) ? 0.0 : own[k]);
    }
    // Keep the largest of the pieces of one stretch of a shaft.
    for (size_t k = 0; sizes && k < paths; k++)
        for (size_t other = 0; other < k; other++)
            if (sizes[other] >= 0.0 && sizes[k] >= 0.0 && twists_are_one(table, k, other))
                sizes[sizes[k] > sizes[other] ? other : k] = -1.0;
    // Insert the others into the list, the largest first.
    for (size_t k = 0; sizes && k < paths; k++) {
        if (sizes[k] < 0.0) continue;
        size_t at = count < most ? count++ : most;
        for (; at > 0 && sizes[chosen[at - 1]] < sizes[k]; at--)
            if (at < most) chosen[at] = chosen[at - 1];
        if (at < most) chosen[at] = k;
    }
    free(sizes);
    return count;
}

// ---------------------------------------------------------------- sheets

/// Adds the sheet of excitations, with their frequencies at the first and the last point.
static void twists_find_excitations(const finder *of) {
    size_t ends[2];
    const size_t count = find_ends(of->table, ends);
    whirl_sheet *sheet = find_sheet(of, "excitations", "Excitations of torsion");
    sheet_texts(of, sheet, "excitation", "excitation");
    sheet_values(of, sheet, "at", 6);
    sheet_column(of, sheet, "frequency", "frequency", WHIRL_QUANTITY_FREQUENCY, 5);
    for (size_t i = 0; i < twists_rows(of->table, WHIRL_FIELD_TORSION_ORDER); i++)
        for (size_t *point = ends; point < ends + count; point++) {
            sheet_row(of, sheet);
            cell_text(of, sheet, twists_excitation(of, i));
            cell_value(of, sheet, *point);
            cell_number(of, sheet, twists_numbers(of, *point, WHIRL_FIELD_TORSION_FREQUENCY, 0)[i]);
        }
    find_sheet_end(of);
}

/// Writes the row of a torque at the point at which its sum is largest.
static void twists_row(const finder *of, whirl_sheet *sheet, size_t path, size_t point, bool running) {
    const size_t excitations = twists_rows(of->table, WHIRL_FIELD_TORSION_ORDER);
    const double *own = twists_numbers(of, point, WHIRL_FIELD_TORSION_TORQUE, 0) + path * excitations;
    size_t most = 0;
    for (size_t i = 1; i < excitations; i++)
        if (own[i] > own[most]) most = i;
    sheet_row(of, sheet);
    cell_text(of, sheet, twists_torque(of, path));
    if (margin_asked(of->table)) cell_text(of, sheet, running ? "where it runs" : "all");
    cell_number(of, sheet, twists_numbers(of, point, WHIRL_FIELD_TORSION_TORQUE_SUM, 0)[path]);
    cell_value(of, sheet, point);
    cell_text(of, sheet, twists_excitation(of, most));
    cell_number(of, sheet, own[most]);
    cell_number(of, sheet, twists_numbers(of, point, WHIRL_FIELD_TORSION_STEADY, 0)[path]);
    cell_number(of, sheet, twists_numbers(of, point, WHIRL_FIELD_TORSION_STRESS, 0)[path]);
    cell_number(of, sheet, twists_numbers(of, point, WHIRL_FIELD_TORSION_POWER, 0)[path]);
}

/// Adds the sheet of the largest vibratory torque of every shaft, coupling and gear, at all points and at running
/// speeds.
static void twists_find_torques(const finder *of) {
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "torques", "Largest vibratory torques");
    sheet->about =
        "Zero to peak: the sum of the amplitudes of all excitations, which is the worst case; the excitation "
        "with the largest part; the steady torque there; the shear stress by the sum in the weakest section "
        "where its diameter is known, without stress concentration; the power that damping takes.";
    sheet_texts(of, sheet, "torque", "torque");
    if (margin_asked(of->table)) sheet_texts(of, sheet, "speeds", "speeds");
    sheet_column(of, sheet, "sum", "largest sum", WHIRL_QUANTITY_MOMENT, 5);
    sheet_values(of, sheet, "at", 6);
    sheet_texts(of, sheet, "excitation", "most by");
    sheet_column(of, sheet, "amplitude", "its amplitude", WHIRL_QUANTITY_MOMENT, 5);
    sheet_column(of, sheet, "steady", "steady torque", WHIRL_QUANTITY_MOMENT, 5);
    sheet_column(of, sheet, "stress", "shear stress", WHIRL_QUANTITY_PRESSURE, 4);
    sheet_column(of, sheet, "power", "power of damping", WHIRL_QUANTITY_POWER, 4);
    // Add each torque at the point of its largest sum, of all points and of the running speeds.
    for (size_t k = 0; k < twists_rows(of->table, WHIRL_FIELD_TORSION_TORQUE_OF); k++) {
        size_t point = 0, which = 0;
        for (int running = 0; running < 2; running++)
            if (twists_leads(of->table, k) && twists_largest_of(of, k, running == 1, &point, &which))
                twists_row(of, sheet, which, point, running == 1);
    }
    find_sheet_end(of);
}

/// Finds the torsional mode whose frequency is nearest to a frequency and within 10 % of it, at the point nearest to a
/// speed. Returns its number from 1, or 0 without one: the peak belongs to a lateral mode, or to no mode.
static size_t twists_mode(const finder *of, double speed, double frequency, double *natural) {
    size_t nearest = of->table->count, mode = 0;
    double least = INFINITY;
    for (size_t point = 0; point < of->table->count; point++) {
        const double apart = fabs(whirl_table_number(of->table, point, WHIRL_FIELD_TORSION_SPEED, 0) - speed);
        if (whirl_table_done(of->table, point) && apart < least) least = apart, nearest = point;
    }
    const double *own = nearest < of->table->count ? twists_numbers(of, nearest, WHIRL_FIELD_TORSION_NATURAL, 0) : NULL;
    least = log(1.1);
    for (size_t i = 0; own && i < twists_rows(of->table, WHIRL_FIELD_TORSION_NATURAL) && isfinite(own[i]); i++) {
        if (!(fabs(log(own[i] / frequency)) < least)) continue;
        least = fabs(log(own[i] / frequency));
        mode = i + 1;
        *natural = own[i];
    }
    return mode;
}

/// Adds the peaks of a torque by one excitation along the speed. speeds, sizes, lags [number of points]: workspace.
static void twists_find_peaks_of(const finder *of, whirl_sheet *sheet, size_t path, size_t index, double *speeds,
                                 double *sizes, double *lags) {
    static const double nothing = 1e-3; // maxima below this share of the largest torque by the excitation are no peaks
    static const char *const ways[] = {"half power", "half power on one side", "slope of the lag"};
    const size_t excitations = twists_rows(of->table, WHIRL_FIELD_TORSION_ORDER), place = path * excitations + index;
    whirl_response_peak peaks[MARGIN_PEAKS];
    double largest = 0.0;
    size_t count = 0;
    for (size_t point = 0; point < of->table->count; point++) {
        const double *torque = twists_numbers(of, point, WHIRL_FIELD_TORSION_TORQUE, 0);
        const double speed = whirl_table_number(of->table, point, WHIRL_FIELD_TORSION_SPEED, 0);
        if (!torque || isnan(torque[place])) continue;
        if (count > 0 && !(speed > speeds[count - 1])) return;
        speeds[count] = speed;
        sizes[count] = torque[place];
        lags[count++] = twists_numbers(of, point, WHIRL_FIELD_TORSION_TORQUE_LAG, 0)[place];
        for (size_t k = 0; k < twists_rows(of->table, WHIRL_FIELD_TORSION_TORQUE_OF); k++)
            largest = fmax(largest, torque[k * excitations + index]);
    }
    const size_t first = twists_first(of->table);
    if (count < 3 || twists_numbers(of, first, WHIRL_FIELD_TORSION_FIXED, 0)[index] > 0.0) return;
    const double order = twists_numbers(of, first, WHIRL_FIELD_TORSION_ORDER, 0)[index];
    const size_t found = whirl_response_peaks(count, speeds, sizes, lags, MARGIN_PEAKS, peaks);
    for (size_t i = 0; i < found; i++) {
        double natural = NAN;
        if (!(peaks[i].amplitude > nothing * largest)) continue;
        const size_t mode = twists_mode(of, peaks[i].speed, order * peaks[i].speed, &natural);
        sheet_row(of, sheet);
        cell_text(of, sheet, twists_torque(of, path));
        cell_text(of, sheet, twists_excitation(of, index));
        cell_number(of, sheet, peaks[i].speed);
        cell_number(of, sheet, order * peaks[i].speed);
        cell_number(of, sheet, peaks[i].amplitude);
        cell_text(of, sheet, mode > 0 ? find_text(of->findings, "%zuT", mode) : "");
        cell_number(of, sheet, natural);
        cell_number(of, sheet, peaks[i].amplification);
        cell_text(of, sheet,
                  peaks[i].points < 4.0 ? find_text(of->findings, "%s, of %.2g points: compute more there",
                                                    ways[peaks[i].way], peaks[i].points)
                                        : ways[peaks[i].way]);
    }
}

/// Adds the sheet of peaks along the speed, with the nearest mode.
static void twists_find_peaks(const finder *of) {
    // Make memory for the amplitudes along the speed.
    size_t point = 0, which = 0;
    double *speeds = malloc((3 * of->table->count + 1) * sizeof *speeds);
    if (!speeds) {
        of->findings->failed = true;
        return;
    }
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "peaks", "Peaks of vibratory torques");
    sheet_texts(of, sheet, "torque", "torque");
    sheet_texts(of, sheet, "excitation", "excitation");
    sheet_column(of, sheet, "speed", "peak at", WHIRL_QUANTITY_SPEED, 5);
    sheet_column(of, sheet, "frequency", "frequency", WHIRL_QUANTITY_FREQUENCY, 5);
    sheet_column(of, sheet, "amplitude", "amplitude", WHIRL_QUANTITY_MOMENT, 5);
    sheet_texts(of, sheet, "mode", "mode");
    sheet_column(of, sheet, "natural", "its frequency", WHIRL_QUANTITY_FREQUENCY, 5);
    sheet_column(of, sheet, "amplification", "amplification", WHIRL_QUANTITY_NUMBER, 4);
    sheet_texts(of, sheet, "found_by", "found by");
    // Add the peaks of each torque by each excitation.
    for (size_t k = 0; k < twists_rows(of->table, WHIRL_FIELD_TORSION_TORQUE_OF); k++)
        for (size_t i = 0; i < twists_rows(of->table, WHIRL_FIELD_TORSION_ORDER); i++)
            if (twists_leads(of->table, k) && twists_largest_of(of, k, false, &point, &which))
                twists_find_peaks_of(of, sheet, which, i, speeds, speeds + of->table->count,
                                     speeds + 2 * of->table->count);
    find_sheet_end(of);
    free(speeds);
}

/// Adds the sheet of the largest twists of stations, and their angular velocity over the station's speed.
static void twists_find_angles(const finder *of) {
    // Set up the columns.
    const size_t excitations = twists_rows(of->table, WHIRL_FIELD_TORSION_ORDER);
    whirl_sheet *sheet = find_sheet(of, "angles", "Largest twists of the stations");
    sheet->about = "Zero to peak, summed over all excitations; the angular velocity is summed likewise.";
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "degrees", "twist", WHIRL_QUANTITY_DEGREES, 4);
    sheet_column(of, sheet, "angle", "twist", WHIRL_QUANTITY_SLOPE, 4);
    sheet_values(of, sheet, "at", 6);
    sheet_column(of, sheet, "rate", "angular velocity", WHIRL_QUANTITY_ANGULAR, 4);
    sheet_column(of, sheet, "share", "over the speed of the station", WHIRL_QUANTITY_PERCENT, 3);
    // Add each station at the point of its largest twist.
    for (size_t s = 0; s < of->result->station_count; s++) {
        size_t point = 0;
        if (!twists_largest(of, WHIRL_FIELD_TORSION_ANGLE_SUM, s, 0, false, &point)) continue;
        const double angle = *twists_numbers(of, point, WHIRL_FIELD_TORSION_ANGLE_SUM, s);
        const double speed = *twists_numbers(of, point, WHIRL_FIELD_TORSION_STATION_SPEED, s);
        double rate = 0.0;
        for (size_t i = 0; i < excitations; i++) rate += twists_numbers(of, point, WHIRL_FIELD_TORSION_RATE, s)[i];
        sheet_row(of, sheet);
        cell_station(of, sheet, s);
        cell_number(of, sheet, angle / degree);
        cell_number(of, sheet, angle);
        cell_value(of, sheet, point);
        cell_number(of, sheet, rate);
        cell_number(of, sheet, speed > 0.0 ? 100.0 * rate / speed : (double)NAN);
    }
    find_sheet_end(of);
}

// ---------------------------------------------------------------- statements

/// States the torque with the largest sum of amplitudes, at all points or at running speeds.
static void twists_find_worst(const finder *of, bool running) {
    // Find the largest of all torques at all points, or at running speeds.
    size_t path = 0, point = 0;
    if (twists_choose(of->table, 1, &path) == 0) return;
    if (running) {
        double largest = -1.0;
        for (size_t k = 0; k < twists_rows(of->table, WHIRL_FIELD_TORSION_TORQUE_OF); k++) {
            if (!twists_largest(of, WHIRL_FIELD_TORSION_TORQUE_SUM, 0, k, true, &point)) continue;
            const double own = twists_numbers(of, point, WHIRL_FIELD_TORSION_TORQUE_SUM, 0)[k];
            if (own > largest) largest = own, path = k;
        }
    }
    if (!twists_largest(of, WHIRL_FIELD_TORSION_TORQUE_SUM, 0, path, running, &point)) return;
    // State the largest torque, where it acts, and the point.
    const double steady = twists_numbers(of, point, WHIRL_FIELD_TORSION_STEADY, 0)[path];
    const double sum = twists_numbers(of, point, WHIRL_FIELD_TORSION_TORQUE_SUM, 0)[path];
    whirl_phrase *found =
        &find_statement(of, running ? "largest vibratory torque where the machine runs" : "largest vibratory torque")
             ->found;
    phrase_number(of, found, WHIRL_QUANTITY_MOMENT, 5, sum);
    phrase_text(of, found, " in %s", twists_torque(of, path));
    if (*of->table->parameter) {
        phrase_text(of, found, " at %s = ", of->table->parameter);
        phrase_value(of, found, 6, of->table->values[point]);
    }
    // State the steady torque, and whether the sum exceeds it.
    if (isfinite(steady) && fabs(steady) > 1e-9 * sum) {
        phrase_text(of, found, ", with a steady torque of ");
        phrase_number(of, found, WHIRL_QUANTITY_MOMENT, 5, steady);
        if (sum > fabs(steady)) phrase_text(of, found, ": the torque changes its sign");
    }
}

/// States steady torques that do not balance.
static void twists_find_unbalanced(const finder *of) {
    for (size_t point = 0; point < of->table->count; point++) {
        const double *left = twists_numbers(of, point, WHIRL_FIELD_TORSION_UNBALANCED, 0);
        if (!left || !(fabs(*left) > 0.0)) continue;
        whirl_phrase *found = find_at(of, point, "steady torques");
        phrase_number(of, found, WHIRL_QUANTITY_MOMENT, 5, *left);
        phrase_text(of, found,
                    " are taken up by nothing (referred to the speed of the shaft): steady torques of "
                    "shafts are not known; expected steady torques that balance, or an element drive "
                    "whose motor takes up the others");
        return;
    }
}

static void twists_find(const finder *of) {
    twists_find_worst(of, false);
    if (margin_asked(of->table)) twists_find_worst(of, true);
    twists_find_unbalanced(of);
    twists_find_excitations(of);
    twists_find_torques(of);
    twists_find_peaks(of);
    twists_find_angles(of);
}

const shown_kind shown_twists = {
    .field = WHIRL_FIELD_TORSION_TORQUE,
    .anchor = "torques",
    .name = "Response to torques",
    .about = "Steady vibration in torsion by torques at orders of the speed and at fixed frequencies, linear about the "
             "place of rest. Amplitudes are zero to peak.",
    .find = twists_find};
