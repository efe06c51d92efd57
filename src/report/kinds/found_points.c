// Findings on single motions: verdicts with their reasons, size and sense of the motion at stations, watched numbers of
// stations and contacts, amplitudes and phases at 1X, and lines of the spectrum that have a name.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "found_motions.h"
#include "machine_at.h"
#include "named_lines.h"
#include "quantities.h"
#include "regimes.h"
#include "shown_kinds.h"
#include "units.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"
#include "whirl/engine/system.h"
#include "whirl/internal/shown.h"

// ---------------------------------------------------------------- rows of points

/// Begins a sheet with a row for each station of each motion. Summaries show it for one motion.
static whirl_sheet *sheet_of_stations(const finder *of, const char *name, const char *title) {
    whirl_sheet *sheet = find_sheet(of, name, title);
    sheet->unsummarized = !find_alone(of);
    sheet_points(of, sheet);
    sheet_texts(of, sheet, "station", "station");
    return sheet;
}

// ---------------------------------------------------------------- units of displacements

/// Unit of displacements: a unit of length, or the scale of the machine by which lengths are divided if all points of
/// the table have the same.
static whirl_unit displacement_unit(const finder *of, whirl_counting counting) {
    const whirl_shown_units *units = of->units;
    const bool scales = units->ratio && of->table->length_scales;
    const whirl_unit length = units->of[WHIRL_QUANTITY_LENGTH];
    const char *name = scales ? length.name : units->length_name, *counted = whirl_shown_counted(units, counting);
    const double amplitude = counting == WHIRL_AMPLITUDE ? units->amplitude : 1.0;
    whirl_unit unit = {.size = (scales ? length.size : units->result->length_scale / units->length) / amplitude};
    // A length scale without a name is its size, "(0.2 mm)": write "in 0.2 mm".
    const int letters = (int)strcspn(name + (*name == '('), ")");
    snprintf(unit.name, sizeof unit.name, "%s%.*s%s%s", *name == '(' ? "in " : "", letters, name + (*name == '('),
             *counted ? " " : "", counted);
    return unit;
}

// ---------------------------------------------------------------- verdicts

/// Writes "P-1", the regime of a motion at the second tolerance; "" if it was computed at one tolerance only.
static const char *verdict_second(const finder *of, const whirl_verdict *verdict) {
    char name[LABEL_SIZE];
    // Only the regime is stored; a motion at rest is at rest at both tolerances.
    const whirl_verdict second = {
        .regime = verdict->other_regime, .period = verdict->other_period, .rests = verdict->rests};
    if (!verdict->confirmed) return "";
    regime_name(&second, name, sizeof name);
    return find_text(of->findings, "%s", name);
}

static void find_verdicts(const finder *of) {
    const whirl_table *table = of->table;
    const bool contacts = has_rub(table, of->result->contact_count);
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "verdicts", "Verdicts");
    sheet->unsummarized = find_alone(of);
    sheet->about = "The exponent is the mean over all watched revolutions, with the standard error of a chaotic "
                   "motion. The reason of a verdict, below, may give another exponent: for a regular motion it is "
                   "a weighted mean, which is more accurate.";
    sheet_points(of, sheet);
    if (table->attractors) sheet_list(of, sheet, "share", "% of the starts", WHIRL_QUANTITY_NUMBER, 3, " +- ");
    sheet_texts(of, sheet, "regime", "regime");
    sheet_texts(of, sheet, "confidence", "confidence");
    sheet_texts(of, sheet, "second", "at the second tolerance");
    sheet_exponent(of, sheet);
    if (contacts) sheet_column(of, sheet, "contact", "time in contact", WHIRL_QUANTITY_PERCENT, 3);
    // Add a row for each motion.
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const whirl_verdict verdict = whirl_table_verdict(table, point);
        char name[LABEL_SIZE];
        sheet_row(of, sheet);
        cells_point(of, sheet, point);
        if (table->attractors) {
            const double share[] = {100.0 * table->attractors[point].share, 100.0 * table->attractors[point].error};
            cell_numbers(of, sheet, 2, share);
        }
        whirl_verdict_name(&verdict, name, sizeof name);
        cell_regime(of, sheet, name, regime_class_of(&verdict));
        const bool judged = verdict.regime != WHIRL_NOT_JUDGED;
        cell_text(of, sheet, judged ? whirl_confidence_name(verdict.confidence) : "");
        cell_text(of, sheet, verdict_second(of, &verdict));
        cell_exponent(of, sheet, point);
        if (contacts) cell_number(of, sheet, 100.0 * rub_share(table, point, of->result->contact_count));
    }
    find_sheet_end(of);
}

/// Writes the reason of a verdict, with its exponent rounded.
static const char *verdict_reason(const finder *of, const whirl_verdict *verdict) {
    char text[WHIRL_MESSAGE_SIZE];
    reason_text(verdict, text, sizeof text);
    return find_text(of->findings, "%s", text);
}

/// Writes the change of settings that would settle a verdict in doubt; "" for none.
static const char *verdict_advice(const finder *of, const whirl_verdict *verdict) {
    char text[WHIRL_MESSAGE_SIZE];
    whirl_verdict_advice(verdict, text, sizeof text);
    return verdict->confidence == WHIRL_LOW ? find_text(of->findings, "%s", text) : "";
}

/// Returns true if all exponents of a motion were computed, and failed: their sum is not that of the equations.
static bool exponents_failed(const whirl_table *table, size_t point) {
    return point_number(table, point, WHIRL_FIELD_EXPONENTS_FAILED) > 0.5;
}

/// Writes all exponents of a motion, each with its error.
static const char *exponents_text(const finder *of, size_t point) {
    const numbers values = point_numbers(of->table, point, WHIRL_FIELD_EXPONENTS_VALUES, 0);
    const numbers errors = point_numbers(of->table, point, WHIRL_FIELD_EXPONENTS_ERRORS, 0);
    const char *text = "";
    if (exponents_failed(of->table, point)) return "failed";
    for (size_t i = 0; i < values.rows && errors.rows >= values.rows; i++) {
        const shown_estimate shown = estimate_shown((whirl_estimate){values.at[i], errors.at[i]});
        text = find_text(of->findings, "%s%s%.*f +- %.*f", text, i > 0 ? ", " : "", shown.decimals, shown.value,
                         shown.decimals, shown.error);
    }
    return text;
}

static void find_reasons(const finder *of) {
    const whirl_table *table = of->table;
    whirl_sheet *sheet = find_sheet(of, "reasons", "Reasons of verdicts, and all exponents");
    sheet->looked_up = true;
    sheet_points(of, sheet);
    sheet_texts(of, sheet, "why", "why");
    sheet_texts(of, sheet, "advice", "to settle it");
    sheet_texts(of, sheet, "exponents", "exponents per revolution");
    sheet_column(of, sheet, "sum", "their sum", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "sum_exact", "sum by the equations", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "dimension", "Kaplan-Yorke dimension", WHIRL_QUANTITY_NUMBER, 3);
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const whirl_verdict verdict = whirl_table_verdict(table, point);
        sheet_row(of, sheet);
        cells_point(of, sheet, point);
        cell_text(of, sheet, verdict_reason(of, &verdict));
        cell_text(of, sheet, verdict_advice(of, &verdict));
        cell_text(of, sheet, exponents_text(of, point));
        cell_number(of, sheet, point_number(table, point, WHIRL_FIELD_EXPONENTS_SUM));
        cell_number(of, sheet, point_number(table, point, WHIRL_FIELD_EXPONENTS_SUM_EXACT));
        cell_number(of, sheet, point_number(table, point, WHIRL_FIELD_EXPONENTS_DIMENSION));
    }
    find_sheet_end(of);
}

// ---------------------------------------------------------------- one motion

/// States the verdict of the only motion of a table, its reason, and how far it can be trusted.
static void state_verdict(const finder *of) {
    const whirl_verdict verdict = whirl_table_verdict(of->table, 0);
    char text[WHIRL_MESSAGE_SIZE];
    whirl_verdict_name(&verdict, text, sizeof text);
    phrase_text(of, &find_statement(of, "motion")->found, "%s", text);
    const char *const reason = verdict_reason(of, &verdict), *const advice = verdict_advice(of, &verdict);
    if (*reason) phrase_text(of, &find_statement(of, "reason")->found, "%s", reason);
    whirl_phrase *found = &find_statement(of, "confidence")->found;
    phrase_text(of, found, "%s (%s%s)", whirl_confidence_name(verdict.confidence),
                verdict.confirmed ? "at the second tolerance: " : "one tolerance only", verdict_second(of, &verdict));
    if (*advice) phrase_text(of, found, "; to settle it, %s", advice);
}

/// States how long each contact of a motion is closed.
static void state_contacts(const finder *of) {
    for (size_t i = 0; i < of->result->contact_count; i++) {
        const double share = whirl_table_number(of->table, 0, WHIRL_FIELD_RUB_SHARE, i);
        if (!(share >= 0.0)) continue;
        whirl_phrase *found = &find_statement(of, find_text(of->findings, "%s", of->result->contacts[i]))->found;
        if (share > 0.0) phrase_number(of, found, WHIRL_QUANTITY_PERCENT, 3, 100.0 * share);
        phrase_text(of, found, share > 0.0 ? " of the time" : "no contact");
    }
}

/// States the only motion of a table.
static void state_motion(const finder *of) {
    if (of->table->count == 0 || !whirl_table_done(of->table, 0)) {
        phrase_text(of, &find_statement(of, "motion")->found, "not computed");
        return;
    }
    if (whirl_layout_has_verdict(&of->table->layout))
        state_verdict(of);
    else
        phrase_text(of, &find_statement(of, "motion")->found, "no verdict, as the analyses have no regime");
    if (exponents_failed(of->table, 0)) {
        whirl_phrase *found = &find_statement(of, "exponents")->found;
        phrase_text(of, found, "failed: their sum is ");
        phrase_number(of, found, WHIRL_QUANTITY_NUMBER, 4, point_number(of->table, 0, WHIRL_FIELD_EXPONENTS_SUM));
        phrase_text(of, found, ", the equations give ");
        phrase_number(of, found, WHIRL_QUANTITY_NUMBER, 4, point_number(of->table, 0, WHIRL_FIELD_EXPONENTS_SUM_EXACT));
        phrase_text(of, found, "; take a smaller tolerance or more steps");
    }
    if (!find_described_together(of->table)) state_contacts(of);
}

// ---------------------------------------------------------------- size and sense

enum { MAX_LINES = 5 };

/// Fills two cells with the orders (or frequencies) of the largest lines, and with their amplitudes.
static void cells_lines(const finder *of, whirl_sheet *sheet, size_t point, size_t station, double clock) {
    const numbers lines = point_lines(of->table, point, station);
    const double factor = whirl_result_length_scale(of->result, of->table, point);
    double places[MAX_LINES], sizes[MAX_LINES];
    size_t count = 0;
    for (; count < lines.rows && count < MAX_LINES; count++) {
        const double *line = lines.at + count * lines.columns;
        places[count] = line[0] * clock;
        sizes[count] = factor * fmax(line[1], line[2]);
    }
    cell_numbers(of, sheet, isfinite(clock) ? count : 0, places);
    cell_numbers(of, sheet, count, sizes);
}

/// Adds the columns of size and sense; those of bearings and gaps if the machine has some.
static void sheet_sizes(const finder *of, whirl_sheet *sheet, bool bearings, bool gaps) {
    const whirl_shown_units *units = of->units;
    const whirl_unit radius = displacement_unit(of, WHIRL_ZERO_TO_PEAK);
    const whirl_unit amplitude = displacement_unit(of, WHIRL_AMPLITUDE);
    sheet_units(of, sheet, "radius", "largest radius", &radius, 4);
    if (bearings) sheet_column(of, sheet, "eccentricity", "largest eccentricity", WHIRL_QUANTITY_NUMBER, 4);
    if (gaps) sheet_column(of, sheet, "of_gap", "largest radius / gap", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "backward", "time against the rotation", WHIRL_QUANTITY_PERCENT, 3);
    sheet_list(of, sheet, units->frequency > 0.0 ? "frequencies" : "orders",
               units->frequency > 0.0 ? "frequencies of the largest lines" : "orders of the largest lines",
               units->frequency > 0.0 ? WHIRL_QUANTITY_FREQUENCY : WHIRL_QUANTITY_NUMBER, 4, ", ");
    sheet_list_units(of, sheet, "amplitudes", "their amplitudes, the larger of x and y", &amplitude, 3, ", ");
    sheet_column(of, sheet, "in_lines", "motion in stored lines", WHIRL_QUANTITY_PERCENT, 3);
}

static void find_sizes(const finder *of) {
    const whirl_table *table = of->table;
    const whirl_result *result = of->result;
    if (!whirl_layout_field(&table->layout, WHIRL_FIELD_ORBIT_MAX_RADIUS) &&
        !whirl_layout_field(&table->layout, WHIRL_FIELD_SPECTRUM_LINES))
        return;
    // Find whether any station is a journal, or may touch a stator.
    bool bearings = false, gaps = false;
    for (size_t s = 0; s < result->station_count; s++) {
        bearings = bearings || result->stations[s].clearance > 0.0;
        gaps = gaps || result->stations[s].gap > 0.0;
    }
    // Set up the columns.
    whirl_sheet *sheet = sheet_of_stations(of, "sizes", "Size and sense of the motion");
    sheet_sizes(of, sheet, bearings, gaps);
    sheet->about = "Time against the rotation: the share of the time in which the station moves backward about the "
                   "centre (0, 0), x y\u2032 \u2212 y x\u2032 < 0; an orbit that does not enclose the centre does so "
                   "for about half of the time, whatever its sense.";
    // Add a row for each station of each motion.
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const double clock = of->units->frequency > 0.0 ? machine_clock(of->machine, result, table, point) : 1.0;
        point_machine own;
        const whirl_probe *probes = point_probes(of, point, &own);
        for (size_t s = 0; s < result->station_count; s++) {
            const double radius = max_radius(table, point, s), none = (double)NAN;
            sheet_row(of, sheet);
            cells_point(of, sheet, point);
            cell_station(of, sheet, s);
            cell_number(of, sheet, radius * whirl_result_length_scale(of->result, of->table, point));
            if (bearings) cell_number(of, sheet, probes[s].clearance > 0.0 ? radius / probes[s].clearance : none);
            if (gaps) cell_number(of, sheet, probes[s].gap > 0.0 ? radius / probes[s].gap : none);
            cell_number(of, sheet, 100.0 * backward_share(table, point, s));
            cells_lines(of, sheet, point, s, clock);
            const double share = line_share(table, point, s);
            cell_number(of, sheet, share < FEW_LINES ? 100.0 * share : none);
        }
        point_release(&own);
    }
    find_sheet_end(of);
}

// ---------------------------------------------------------------- lines with a name

/// Adds rows for the largest lines of a station whose orders have a name in the machine.
static void rows_named(const finder *of, whirl_sheet *sheet, size_t point, size_t station, const whirl_system *system) {
    enum { MAX_NAMED = 4 };
    static const double least = 0.01;
    const numbers lines = point_lines(of->table, point, station);
    const double factor = whirl_result_length_scale(of->result, of->table, point),
                 clock = whirl_table_clock(of->result, of->table, point);
    int shown = 0;
    for (size_t i = 0; i < lines.rows && shown < MAX_NAMED; i++) {
        const double *line = lines.at + i * lines.columns;
        char name[LINE_NAME_SIZE];
        whirl_named_order part;
        if (hypot(line[1], line[2]) < least * hypot(lines.at[1], lines.at[2])) break;
        if (!named_line(system, line[0], station, name, &part)) continue;
        sheet_row(of, sheet);
        cells_point(of, sheet, point);
        cell_station(of, sheet, station);
        cell_text(of, sheet, find_text(of->findings, "%s", name));
        cell_text(of, sheet, find_text(of->findings, "%s", part.part));
        cell_number(of, sheet, line[0]);
        cell_number(of, sheet, line[0] * clock);
        cell_number(of, sheet, factor * line[1]);
        cell_number(of, sheet, factor * line[2]);
        shown++;
    }
}

static void find_named(const finder *of) {
    const whirl_unit amplitude = displacement_unit(of, WHIRL_AMPLITUDE);
    if (!whirl_layout_field(&of->table->layout, WHIRL_FIELD_SPECTRUM_LINES)) return;
    whirl_sheet *sheet = sheet_of_stations(of, "named-lines", "Lines at orders of the machine's parts");
    sheet_texts(of, sheet, "line", "line");
    sheet_texts(of, sheet, "part", "part");
    sheet_column(of, sheet, "order", "order", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "frequency", "frequency", WHIRL_QUANTITY_FREQUENCY, 4);
    sheet_units(of, sheet, "x", "amplitude of x", &amplitude, 4);
    sheet_units(of, sheet, "y", "of y", &amplitude, 4);
    for (size_t point = 0; point < of->table->count; point++) {
        whirl_machine own;
        if (!whirl_table_done(of->table, point) || !machine_at(of->machine, of->table, point, &own)) continue;
        for (size_t s = 0; s < of->result->station_count && own.system->named_order; s++)
            rows_named(of, sheet, point, s, own.system);
        own.release(own.owner);
    }
    find_sheet_end(of);
}

// ---------------------------------------------------------------- the running speed

enum { SYNCHRONOUS_PARTS = 4 };

/// Amplitudes below this share of the larger one of x and y are rounding errors.
static const double noise = 1e-12;

static void find_synchronous(const finder *of) {
    static const char *const parts[SYNCHRONOUS_PARTS] = {"x", "y", "forward", "backward"};
    static const char *const lags[SYNCHRONOUS_PARTS] = {"x_lag", "y_lag", "forward_lag", "backward_lag"};
    const whirl_table *table = of->table;
    const whirl_unit amplitude = displacement_unit(of, WHIRL_AMPLITUDE);
    const char *keyphasor = whirl_result_keyphasor(of->result);
    if (!whirl_layout_field(&table->layout, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS)) return;
    // Name the speed to which phases refer: that of the keyphasor, if the case names one.
    whirl_sheet *sheet =
        sheet_of_stations(of, "synchronous",
                          *keyphasor ? find_text(of->findings, "At the frequency of the %s (1X)", keyphasor)
                                     : "At the running speed (1X)");
    sheet->about = find_text(
        of->findings,
        "Amplitudes and phase lags of x, of y, and of the circular motions with and against the rotation that make up "
        "the orbit at 1X. Lags are in degrees behind %s: x = a cos(\u03c4 \u2212 lag).",
        *keyphasor ? "its phase, which begins with every revolution"
                   : "a mark on the shaft that stands on the x axis at the start of every revolution, where an "
                     "unbalance without an angle of its own lies");
    for (int i = 0; i < SYNCHRONOUS_PARTS; i++) {
        sheet_units(of, sheet, parts[i], parts[i], &amplitude, 4);
        sheet_column(of, sheet, lags[i], "lag", WHIRL_QUANTITY_DEGREES, 4);
    }
    const bool axial = whirl_layout_field(&table->layout, WHIRL_FIELD_SPECTRUM_AXIAL_SYNCHRONOUS) != NULL;
    if (axial) {
        sheet_units(of, sheet, "axial", "axial", &amplitude, 4);
        sheet_column(of, sheet, "axial_lag", "lag", WHIRL_QUANTITY_DEGREES, 4);
    }
    const bool twist = whirl_layout_field(&table->layout, WHIRL_FIELD_SPECTRUM_TWIST_SYNCHRONOUS) != NULL;
    if (twist) {
        sheet_column(of, sheet, "twist", "twist", WHIRL_QUANTITY_DEGREES, 4);
        sheet_column(of, sheet, "twist_lag", "lag", WHIRL_QUANTITY_DEGREES, 4);
    }
    // Add a row for each station of each motion.
    for (size_t point = 0; point < table->count; point++)
        for (size_t s = 0; s < of->result->station_count && whirl_table_done(table, point); s++) {
            const double *size = whirl_table_field(table, point, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, s);
            const double *lag = whirl_table_field(table, point, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS_LAG, s);
            const double factor = whirl_result_length_scale(of->result, of->table, point);
            sheet_row(of, sheet);
            cells_point(of, sheet, point);
            cell_station(of, sheet, s);
            for (int i = 0; i < SYNCHRONOUS_PARTS && size && lag; i++) {
                const bool rounding = size[i] < noise * fmax(size[0], size[1]);
                cell_number(of, sheet, rounding ? 0.0 : factor * size[i]);
                cell_number(of, sheet, rounding ? (double)NAN : lag[i]);
            }
            if (axial) {
                const double own = whirl_table_number(table, point, WHIRL_FIELD_SPECTRUM_AXIAL_SYNCHRONOUS, s);
                cell_number(of, sheet, factor * own);
                cell_number(of, sheet, whirl_table_number(table, point, WHIRL_FIELD_SPECTRUM_AXIAL_LAG, s));
            }
            if (twist) {
                const double own = whirl_table_number(table, point, WHIRL_FIELD_SPECTRUM_TWIST_SYNCHRONOUS, s);
                cell_number(of, sheet, 180.0 / acos(-1.0) * own);
                cell_number(of, sheet, whirl_table_number(table, point, WHIRL_FIELD_SPECTRUM_TWIST_LAG, s));
            }
        }
    find_sheet_end(of);
}

// ---------------------------------------------------------------- watched quantities

/// Returns true for fields of the analyses orbit and rub with one row for every station or contact, over the whole
/// record.
static bool is_watched(const whirl_field *field, whirl_extent extent) {
    return field->extent == extent && field->rows == 1 &&
           (strncmp(field->name, "orbit/", 6) == 0 || strncmp(field->name, "rub/", 4) == 0);
}

/// Returns the shown unit of a watched field. Powers are in W unless another unit is chosen, since the losses in
/// contacts are small.
static whirl_unit watched_unit(const finder *of, const whirl_field *field) {
    static const struct {
        const char *unit;
        whirl_quantity quantity;
    } kinds[] = {{"force", WHIRL_QUANTITY_FORCE}, {"N m", WHIRL_QUANTITY_MOMENT}, {"W", WHIRL_QUANTITY_POWER}};
    if (strcmp(field->unit, "length") == 0) return displacement_unit(of, whirl_field_counting(field));
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(field->unit, kinds[i].unit) == 0 &&
            (kinds[i].quantity != WHIRL_QUANTITY_POWER || of->units->chosen[WHIRL_QUANTITY_POWER]))
            return of->units->of[kinds[i].quantity];
    return strcmp(field->unit, "W") == 0 ? (whirl_unit){"W", 1.0} : (whirl_unit){"", 1.0};
}

/// Returns the factor from a number of a watched field to a number in a sheet.
static double watched_factor(const finder *of, const whirl_field *field, size_t point) {
    static const char *const scaled[] = {"force", "N m", "W"};
    if (strcmp(field->unit, "length") == 0) return whirl_result_length_scale(of->result, of->table, point);
    for (size_t i = 0; i < sizeof scaled / sizeof *scaled; i++)
        if (strcmp(field->unit, scaled[i]) == 0) return whirl_result_si(of->result, of->table, field->unit).size;
    return 1.0;
}

/// Adds a column for every column of a watched field: "max radius", "mean x".
static void sheet_watched(const finder *of, whirl_sheet *sheet, const whirl_field *field) {
    char columns[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE], heading[2 * WHIRL_NAME_SIZE], key[2 * WHIRL_NAME_SIZE];
    const bool named = whirl_field_column_names(field, columns);
    const whirl_unit unit = watched_unit(of, field);
    for (size_t c = 0; c < field->columns; c++) {
        const char *part = named ? columns[c] : "";
        snprintf(key, sizeof key, "%.60s%s%.60s", strchr(field->name, '/') + 1, *part ? "_" : "", part);
        memcpy(heading, key, sizeof heading);
        for (char *at = heading; (at = strchr(at, '_')) != NULL;) *at = ' ';
        sheet_units(of, sheet, find_text(of->findings, "%s", key), find_text(of->findings, "%s", heading), &unit, 4);
        if (!of->findings->failed)
            sheet->column[sheet->columns - 1].meaning = find_text(of->findings, "%s", field->meaning);
    }
}

/// Adds a sheet of all stations, or of all contacts, if the analyses orbit or rub were made there.
static void find_watched(const finder *of, whirl_extent extent, const char *name, const char *title) {
    const bool station = extent == WHIRL_PER_STATION;
    const size_t count = station ? of->result->station_count : of->result->contact_count;
    const whirl_layout *layout = &of->table->layout;
    // Set up the columns; without any there is no sheet.
    whirl_sheet *sheet = find_sheet(of, name, title);
    sheet->looked_up = true;
    sheet_points(of, sheet);
    sheet_texts(of, sheet, station ? "station" : "contact", station ? "station" : "contact");
    const size_t before = sheet->columns;
    for (size_t f = 0; f < layout->field_count; f++)
        if (is_watched(&layout->fields[f], extent)) sheet_watched(of, sheet, &layout->fields[f]);
    // Add a row for each station or contact of each motion.
    for (size_t point = 0; point < of->table->count && sheet->columns > before; point++)
        for (size_t which = 0; which < count && whirl_table_done(of->table, point); which++) {
            sheet_row(of, sheet);
            cells_point(of, sheet, point);
            cell_text(of, sheet,
                      find_text(of->findings, "%s",
                                station ? of->result->stations[which].name : of->result->contacts[which]));
            for (size_t f = 0; f < layout->field_count; f++) {
                const whirl_field *field = &layout->fields[f];
                const double *values = whirl_table_field(of->table, point, field->name, which);
                for (size_t c = 0; is_watched(field, extent) && values && c < field->columns; c++)
                    cell_number(of, sheet, watched_factor(of, field, point) * values[c]);
            }
        }
    find_sheet_end(of);
}

void find_points(const finder *of) {
    if (find_alone(of)) state_motion(of);
    if (whirl_layout_has_verdict(&of->table->layout)) {
        find_verdicts(of);
        find_reasons(of);
    }
    find_sizes(of);
    find_named(of);
    find_synchronous(of);
    find_watched(of, WHIRL_PER_STATION, "watched-stations", "What was watched of the stations");
    find_watched(of, WHIRL_PER_CONTACT, "watched-contacts", "What was watched of the contacts");
}
