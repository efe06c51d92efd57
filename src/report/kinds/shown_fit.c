// Findings on fits: the fitted parameters, how far the measured numbers determine them, and how well the machine
// agrees.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "quantities.h"
#include "shown_kinds.h"
#include "whirl/engine/fit.h"
#include "whirl/internal/fit_columns.h"

/// Least size of a correlation that is stated.
static const double much_correlated = 0.95;

/// Residuals above this many times the given noise are more than noise.
static const double much_more_noise = 1.5;

size_t fit_best(const whirl_table *table) {
    size_t best = table->count;
    double least = INFINITY;
    for (size_t point = 0; point < table->count; point++) {
        const double *outcome = whirl_table_field(table, point, WHIRL_FIELD_FIT_OUTCOME, 0);
        if (!whirl_table_done(table, point) || !outcome || !(outcome[FIT_SUM] < least)) continue;
        least = outcome[FIT_SUM];
        best = point;
    }
    return best;
}

/// The fit that is shown: the start with the least sum of squares.
typedef struct shown_fit {
    const finder *of;
    size_t point;
    size_t unknowns, numbers;
    const double *outcome, *unknown, *correlation, *number;
    const double *profile; ///< NULL: not asked for
} shown_fit_of;

static const char *fit_name(const shown_fit_of *f, size_t u) {
    const double index = f->unknown[FIT_UNKNOWN_COLUMNS * u + FIT_PARAMETER];
    const whirl_result *result = f->of->result;
    return index >= 0.0 && index < (double)result->parameter_count ? result->parameters[(size_t)index].name : "";
}

/// Returns the unit of a parameter. If the case gives a zero, such as "0 deg", the value does not give the unit's size:
/// it is read from the text.
static whirl_unit fit_unit(const shown_fit_of *f, size_t u) {
    const char *name = fit_name(f, u);
    whirl_unit unit = whirl_shown_parameter(f->of->units, name), written = {.name = ""};
    for (size_t i = 0; i < f->of->result->parameter_count; i++) {
        const whirl_parameter *own = &f->of->result->parameters[i];
        char one[WHIRL_NAME_SIZE + 8], *end;
        if (strcmp(own->name, name) != 0 || own->value != 0.0 || strcmp(own->unit, unit.name) != 0) continue;
        strtod(own->text, &end);
        snprintf(written.name, sizeof written.name, "%.40s", end + strspn(end, " "));
        snprintf(one, sizeof one, "1 %.40s", written.name);
        if (*written.name && whirl_quantity_value(one, own->unit, &written.size).code == WHIRL_OK) unit = written;
    }
    return unit;
}

/// Returns the name of a number that does not belong to a motion.
static const char *fit_value_name(double quantity) {
    switch ((whirl_fit_quantity)quantity) {
    case WHIRL_FIT_ONSET:
        return "onset of instability at rest";
    case WHIRL_FIT_ORBIT_ONSET:
        return "onset of instability of the orbit";
    case WHIRL_FIT_CRITICAL:
        return "critical speed";
    case WHIRL_FIT_SHARE:
        return "share of the time in contact";
    case WHIRL_FIT_FREQUENCY:
        return "frequency of the mode";
    default:
        return "damping ratio of the mode";
    }
}

static bool fit_is_value(const double *row) {
    return !whirl_fit_is_motion((whirl_fit_quantity)row[FIT_QUANTITY]);
}

static bool fit_is_statistic(const double *row) {
    return whirl_fit_is_statistic((whirl_fit_quantity)row[FIT_QUANTITY]);
}

/// Counts the motions of a fit that are rows of run-ups.
static size_t fit_count_runs(const whirl_table *table, size_t point) {
    const whirl_field *motions = whirl_layout_field(&table->layout, WHIRL_FIELD_FIT_MOTION);
    const double *motion = whirl_table_field(table, point, WHIRL_FIELD_FIT_MOTION, 0);
    size_t count = 0;
    for (size_t i = 0; motions && i < motions->rows; i++) count += isfinite(motion[FIT_MOTION_COLUMNS * i + FIT_TIME]);
    return count;
}

/// Returns true for the row of a number that is a displacement in a run-up.
static bool fit_is_of_run(const whirl_table *table, size_t point, const double *row) {
    const double *motion = whirl_table_field(table, point, WHIRL_FIELD_FIT_MOTION, 0);
    return row[FIT_QUANTITY] == WHIRL_FIT_WAVEFORM &&
           isfinite(motion[FIT_MOTION_COLUMNS * (size_t)row[FIT_MOTION] + FIT_TIME]);
}

/// Counts the run-ups of a fit whose displacements are compared; *samples gets the number of these.
static size_t fit_count_waveforms(const whirl_table *table, size_t point, size_t *samples) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_FIT_NUMBER);
    const double *row = whirl_table_field(table, point, WHIRL_FIELD_FIT_NUMBER, 0);
    double last = -1.0;
    size_t count = 0;
    *samples = 0;
    for (size_t i = 0; field && i < field->rows; i++, row += FIT_NUMBER_COLUMNS) {
        if (!fit_is_of_run(table, point, row)) continue;
        count += row[FIT_MOTION] != last;
        last = row[FIT_MOTION];
        ++*samples;
    }
    return count;
}

/// States which motion or number was not found at the start.
static void fit_phrase_lost(const finder *of, whirl_statement *own, size_t point, double lost) {
    const whirl_field *field = whirl_layout_field(&of->table->layout, WHIRL_FIELD_FIT_NUMBER);
    const double *rows = whirl_table_field(of->table, point, WHIRL_FIELD_FIT_NUMBER, 0);
    const double *motion = whirl_table_field(of->table, point, WHIRL_FIELD_FIT_MOTION, 0);
    const int revolutions = of->table->record.fit.revolutions;
    for (size_t i = 0; field && rows && motion && i < field->rows; i++) {
        const double *row = rows + FIT_NUMBER_COLUMNS * i;
        if (row[FIT_MOTION] != lost || !fit_is_of_run(of->table, point, row)) continue;
        phrase_text(of, &own->found,
                    "the run of entry %.0f of the data does not last as long as its times with the start values: other "
                    "start values, or a longer run",
                    row[FIT_SET] + 1.0);
        return;
    }
    if (motion && lost >= 0.0 && isfinite(motion[FIT_MOTION_COLUMNS * (size_t)lost + FIT_TIME])) {
        phrase_text(of, &own->found,
                    "row %.0f of the measured ones is not in its run-up with the start values: the run does not last, "
                    "does not reach the speed or time of this row, or passes its speed twice: other start values, a "
                    "longer run, or a table over the time",
                    lost + 1.0);
        return;
    }
    for (size_t i = 0; field && rows && i < field->rows; i++, rows += FIT_NUMBER_COLUMNS) {
        if (rows[FIT_MOTION] != lost || rows[FIT_QUANTITY] < WHIRL_FIT_ONSET) continue;
        if (fit_is_statistic(rows)) {
            phrase_text(of, &own->found, "motion %.0f of the measured ones diverges with the start values: give others",
                        lost + 1.0);
            return;
        }
        phrase_text(of, &own->found,
                    "the machine has no %s for number %.0f of the data at the start, or one without derivatives: other "
                    "start values%s",
                    fit_value_name(rows[FIT_QUANTITY]), rows[FIT_SET] + 1.0,
                    rows[FIT_QUANTITY] <= WHIRL_FIT_CRITICAL ? ", from or to" : "");
        return;
    }
    phrase_text(of, &own->found,
                "motion %.0f of the measured ones has no orbit of %d revolution%s at the start: other start values, "
                "revolutions, a longer transient, or compare: statistics",
                lost + 1.0, revolutions, revolutions == 1 ? "" : "s");
}

/// Returns true for a fit some of whose motions are compared by statistics.
static bool fit_has_statistics(const whirl_table *table, size_t point) {
    const whirl_field *motions = whirl_layout_field(&table->layout, WHIRL_FIELD_FIT_MOTION);
    const double *motion = whirl_table_field(table, point, WHIRL_FIELD_FIT_MOTION, 0);
    for (size_t i = 0; motions && i < motions->rows; i++)
        if (isfinite(motion[FIT_MOTION_COLUMNS * i + FIT_SCATTER])) return true;
    return false;
}

/// States why fits have failed.
static void fit_find_failures(const finder *of) {
    static const char *const why[] = {"", "it stopped at the limit of steps; increase the key steps",
                                      "no shorter step makes the sum of squares smaller", ""};
    for (size_t point = 0; point < of->table->count; point++) {
        const double *outcome = whirl_table_field(of->table, point, WHIRL_FIELD_FIT_OUTCOME, 0);
        if (!whirl_table_done(of->table, point) || !outcome || !(outcome[FIT_END] > 0.0)) continue;
        const bool scatters = outcome[FIT_END] == (double)WHIRL_FIT_STUCK && fit_has_statistics(of->table, point);
        whirl_statement *own = find_judgement(of, "fit", "", scatters ? WHIRL_NOT_KNOWN : WHIRL_FAILS);
        phrase_text(of, &own->asked, "a minimum of the sum of squares");
        if (of->table->count > 1) phrase_text(of, &own->at, "start %zu", point + 1);
        if (outcome[FIT_END] == (double)WHIRL_FIT_NO_MOTION)
            fit_phrase_lost(of, own, point, outcome[FIT_LOST]);
        else
            phrase_text(of, &own->found, "%s%s", why[(int)outcome[FIT_END]],
                        scatters ? ", which scatters with the statistics of motions" : "");
    }
}

/// States an end of a profile interval.
static void fit_phrase_end(const finder *of, whirl_statement *own, const whirl_unit *unit, double end) {
    if (isfinite(end))
        phrase_unit(of, &own->found, unit, 6, end);
    else
        phrase_text(of, &own->found, "beyond its bounds");
}

/// States a parameter's value, and judges it if the measured numbers do not determine it.
static void fit_find_unknown(const shown_fit_of *f, size_t u) {
    static const char *const not_known[] = {
        "", "at its bound: give wider bounds, or the measurement has another cause",
        "hardly determined by the measured numbers: its interval is as wide as its bounds or its value",
        "not determined: the measured numbers do not depend on it, or only together with others"};
    // Choose a statement, or a judgement if the parameter is not determined.
    const finder *of = f->of;
    const double *row = f->unknown + FIT_UNKNOWN_COLUMNS * u;
    const whirl_unit unit = fit_unit(f, u);
    const int known = (int)row[FIT_KNOWN];
    const char *what = find_text(of->findings, "parameter %s", fit_name(f, u));
    whirl_statement *own =
        known == WHIRL_FIT_DETERMINED ? find_statement(of, what) : find_judgement(of, what, "", WHIRL_NOT_KNOWN);
    // State the value with its interval.
    phrase_unit(of, &own->found, &unit, 8, row[FIT_VALUE]);
    if (isfinite(row[FIT_ERROR])) {
        phrase_text(of, &own->found, ", standard error ");
        phrase_unit(of, &own->found, &unit, 3, row[FIT_ERROR]);
        phrase_text(of, &own->found, ", 95 %% within ");
        phrase_unit(of, &own->found, &unit, 6, row[FIT_VALUE] - row[FIT_HALF]);
        phrase_text(of, &own->found, " to ");
        phrase_unit(of, &own->found, &unit, 6, row[FIT_VALUE] + row[FIT_HALF]);
    }
    if (f->profile && isfinite(row[FIT_ERROR])) {
        phrase_text(of, &own->found, ", by its profile ");
        fit_phrase_end(of, own, &unit, f->profile[2 * u]);
        phrase_text(of, &own->found, " to ");
        fit_phrase_end(of, own, &unit, f->profile[2 * u + 1]);
    }
    // State why it is not determined.
    if (known == WHIRL_FIT_DETERMINED) return;
    phrase_text(of, &own->asked, "determined by the measured numbers");
    phrase_text(of, &own->judged, ": %s", not_known[known]);
}

const char *fit_determined(const double *row) {
    static const char *const known[] = {"yes", "at its bound", "hardly", "no"};
    return known[(int)row[FIT_KNOWN]];
}

static void fit_find_sheet(const shown_fit_of *f) {
    const finder *of = f->of;
    // Set up the columns; numbers are in the parameter's own unit, which is a column.
    whirl_sheet *sheet = find_sheet(of, "unknowns", "Fitted parameters");
    sheet_texts(of, sheet, "parameter", "parameter");
    sheet_column(of, sheet, "start", "start", WHIRL_QUANTITY_NUMBER, 8);
    sheet_column(of, sheet, "found", "found", WHIRL_QUANTITY_NUMBER, 8);
    sheet_column(of, sheet, "error", "standard error", WHIRL_QUANTITY_NUMBER, 3);
    sheet_column(of, sheet, "low", "95 % from", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "high", "to", WHIRL_QUANTITY_NUMBER, 6);
    if (f->profile) sheet_column(of, sheet, "profile_low", "by profile from", WHIRL_QUANTITY_NUMBER, 6);
    if (f->profile) sheet_column(of, sheet, "profile_high", "by profile to", WHIRL_QUANTITY_NUMBER, 6);
    sheet_texts(of, sheet, "unit", "unit");
    sheet_texts(of, sheet, "determined", "determined");
    // Add a row for each parameter.
    for (size_t u = 0; u < f->unknowns; u++) {
        const double *row = f->unknown + FIT_UNKNOWN_COLUMNS * u;
        const whirl_unit unit = fit_unit(f, u);
        sheet_row(of, sheet);
        cell_text(of, sheet, find_text(of->findings, "%s", fit_name(f, u)));
        cell_number(of, sheet, row[FIT_START] / unit.size);
        cell_number(of, sheet, row[FIT_VALUE] / unit.size);
        cell_number(of, sheet, row[FIT_ERROR] / unit.size);
        cell_number(of, sheet, (row[FIT_VALUE] - row[FIT_HALF]) / unit.size);
        cell_number(of, sheet, (row[FIT_VALUE] + row[FIT_HALF]) / unit.size);
        for (size_t k = 0; k < 2 && f->profile; k++) cell_number(of, sheet, f->profile[2 * u + k] / unit.size);
        cell_text(of, sheet, find_text(of->findings, "%s", unit.name));
        cell_text(of, sheet, fit_determined(row));
    }
    find_sheet_end(of);
}

static void fit_find_correlations(const shown_fit_of *f) {
    const finder *of = f->of;
    // Show the correlation of every pair.
    whirl_sheet *sheet = find_sheet(of, "correlations", "Correlations of the parameters' errors");
    sheet_texts(of, sheet, "parameter", "parameter");
    sheet_texts(of, sheet, "other", "with");
    sheet_column(of, sheet, "correlation", "correlation", WHIRL_QUANTITY_NUMBER, 4);
    for (size_t u = 0; u < f->unknowns; u++)
        for (size_t k = u + 1; k < f->unknowns; k++) {
            sheet_row(of, sheet);
            cell_text(of, sheet, find_text(of->findings, "%s", fit_name(f, u)));
            cell_text(of, sheet, find_text(of->findings, "%s", fit_name(f, k)));
            cell_number(of, sheet, f->correlation[WHIRL_MAX_UNKNOWNS * u + k]);
        }
    find_sheet_end(of);
    // State the pairs with nearly full correlation.
    for (size_t u = 0; u < f->unknowns; u++)
        for (size_t k = u + 1; k < f->unknowns; k++) {
            const double correlation = f->correlation[WHIRL_MAX_UNKNOWNS * u + k];
            if (!(fabs(correlation) >= much_correlated)) continue;
            whirl_statement *own = find_statement(of, "correlation");
            phrase_text(of, &own->found, "%s and %s: %.4f: the measurement determines neither of them well by itself",
                        fit_name(f, u), fit_name(f, k), correlation);
        }
}

/// Sums over the numbers of one probe in one file.
typedef struct fit_channel {
    const double *first; ///< row of its first number
    size_t count;
    double squares, largest, measured;
} fit_channel;

/// Returns true for a displacement at an instant; false for a part of an order.
static bool fit_is_displacement(const double *row) {
    return row[FIT_QUANTITY] == WHIRL_FIT_SAMPLE || row[FIT_QUANTITY] == WHIRL_FIT_WAVEFORM;
}

static bool fit_same_channel(const double *a, const double *b) {
    return a[FIT_SET] == b[FIT_SET] && fit_is_statistic(a) == fit_is_statistic(b) &&
           (!fit_is_statistic(a) || a[FIT_QUANTITY] == b[FIT_QUANTITY]) && a[FIT_STATION] == b[FIT_STATION] &&
           a[FIT_ANGLE] == b[FIT_ANGLE] && fit_is_displacement(a) == fit_is_displacement(b) &&
           (fit_is_displacement(a) || a[FIT_AT] == b[FIT_AT]);
}

void fit_name_probe(const whirl_result *result, const double *row, char *name, size_t size) {
    const double degrees = row[FIT_ANGLE] * 57.295779513082321;
    const char *station =
        row[FIT_STATION] < (double)result->station_count ? result->stations[(size_t)row[FIT_STATION]].name : "";
    char direction[32];
    if (fabs(degrees) < 1e-9 || fabs(degrees - 90.0) < 1e-9)
        snprintf(direction, sizeof direction, "%s", degrees > 45.0 ? "y" : "x");
    else
        snprintf(direction, sizeof direction, "%.4g deg", degrees);
    if (fit_is_displacement(row))
        snprintf(name, size, "%s %s", station, direction);
    else if (row[FIT_QUANTITY] == WHIRL_FIT_HIGHEST || row[FIT_QUANTITY] == WHIRL_FIT_LOWEST)
        snprintf(name, size, "%s %s %s", station, direction, row[FIT_QUANTITY] == WHIRL_FIT_HIGHEST ? "max" : "min");
    else
        snprintf(name, size, "%s %s %gX", station, direction, row[FIT_AT]);
}

static void fit_find_channels(const shown_fit_of *f) {
    enum { MAX_CHANNELS = 256 };
    const finder *of = f->of;
    fit_channel channels[MAX_CHANNELS];
    size_t count = 0;
    // Sum up squares over the numbers of each channel: a probe in one file.
    for (size_t i = 0; i < f->numbers; i++) {
        const double *row = f->number + FIT_NUMBER_COLUMNS * i;
        size_t c = 0;
        if (fit_is_value(row)) continue;
        while (c < count && !fit_same_channel(channels[c].first, row)) c++;
        if (c == MAX_CHANNELS) continue;
        if (c == count) channels[count++] = (fit_channel){.first = row};
        const double off = row[FIT_MODEL] - row[FIT_MEASURED];
        channels[c].count++;
        channels[c].squares += off * off;
        channels[c].measured += row[FIT_MEASURED] * row[FIT_MEASURED];
        channels[c].largest = fmax(channels[c].largest, fabs(off));
    }
    if (count == 0) return;
    // Show each channel with its root mean squares.
    whirl_sheet *sheet = find_sheet(of, "residuals", "Measured numbers and the fitted machine");
    sheet_column(of, sheet, "file", "file", WHIRL_QUANTITY_NUMBER, 4);
    sheet_texts(of, sheet, "probe", "probe");
    sheet_column(of, sheet, "numbers", "numbers", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "rms", "measured, rms", WHIRL_QUANTITY_LENGTH, 4);
    sheet_column(of, sheet, "residual", "residual, rms", WHIRL_QUANTITY_LENGTH, 3);
    sheet_column(of, sheet, "largest", "largest residual", WHIRL_QUANTITY_LENGTH, 3);
    for (size_t c = 0; c < count; c++) {
        char name[2 * WHIRL_NAME_SIZE];
        const fit_channel *own = &channels[c];
        fit_name_probe(of->result, own->first, name, sizeof name);
        sheet_row(of, sheet);
        cell_number(of, sheet, own->first[FIT_SET] + 1.0);
        cell_text(of, sheet, find_text(of->findings, "%s", name));
        cell_number(of, sheet, (double)own->count);
        cell_number(of, sheet, sqrt(own->measured / (double)own->count));
        cell_number(of, sheet, sqrt(own->squares / (double)own->count));
        cell_number(of, sheet, own->largest);
    }
    find_sheet_end(of);
}

/// Returns the unit of a number that does not belong to a motion.
static whirl_unit fit_value_unit(const shown_fit_of *f, const double *row) {
    const whirl_result *result = f->of->result;
    if (row[FIT_QUANTITY] == WHIRL_FIT_SHARE) return f->of->units->of[WHIRL_QUANTITY_PERCENT];
    if (row[FIT_QUANTITY] == WHIRL_FIT_DAMPING) return (whirl_unit){"", 1.0};
    if (row[FIT_QUANTITY] == WHIRL_FIT_FREQUENCY) return f->of->units->of[WHIRL_QUANTITY_FREQUENCY];
    if (!(row[FIT_AT] >= 0.0 && row[FIT_AT] < (double)result->parameter_count))
        return f->of->units->of[WHIRL_QUANTITY_SPEED];
    return whirl_shown_parameter(f->of->units, result->parameters[(size_t)row[FIT_AT]].name);
}

/// Shows onsets, critical speeds, numbers of modes, and shares of the time in contact.
static void fit_find_values(const shown_fit_of *f) {
    const finder *of = f->of;
    size_t count = 0;
    for (size_t i = 0; i < f->numbers; i++) count += fit_is_value(f->number + FIT_NUMBER_COLUMNS * i);
    if (count == 0) return;
    const double *motion = whirl_table_field(of->table, f->point, WHIRL_FIELD_FIT_MOTION, 0);
    whirl_sheet *sheet =
        find_sheet(of, "values", "Measured onsets, critical speeds, modes and shares, and the fitted machine");
    sheet_column(of, sheet, "data", "data", WHIRL_QUANTITY_NUMBER, 4);
    sheet_texts(of, sheet, "what", "number");
    sheet_column(of, sheet, "speed", "speed", WHIRL_QUANTITY_SPEED, 6);
    sheet_column(of, sheet, "measured", "measured", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "fitted", "fitted", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "noise", "noise", WHIRL_QUANTITY_NUMBER, 3);
    sheet_texts(of, sheet, "unit", "unit");
    for (size_t i = 0; i < f->numbers; i++) {
        const double *row = f->number + FIT_NUMBER_COLUMNS * i;
        if (!fit_is_value(row)) continue;
        const whirl_unit unit = fit_value_unit(f, row);
        sheet_row(of, sheet);
        cell_number(of, sheet, row[FIT_SET] + 1.0);
        cell_text(of, sheet, fit_value_name(row[FIT_QUANTITY]));
        cell_number(of, sheet, motion ? motion[FIT_MOTION_COLUMNS * (size_t)row[FIT_MOTION]] : (double)NAN);
        cell_number(of, sheet, row[FIT_MEASURED] / unit.size);
        cell_number(of, sheet, row[FIT_MODEL] / unit.size);
        cell_number(of, sheet, row[FIT_NOISE] / unit.size);
        cell_text(of, sheet, find_text(of->findings, "%s", unit.name));
    }
    find_sheet_end(of);
}

/// States how well the fit agrees.
static void fit_find_agreement(const shown_fit_of *f) {
    const finder *of = f->of;
    const double *outcome = f->outcome;
    const bool noise = of->table->record.fit.noise > 0.0, poor = noise && outcome[FIT_DEVIATION] > much_more_noise;
    if (!(outcome[FIT_DEGREES] > 0.0)) {
        whirl_statement *none = find_statement(of, "agreement");
        phrase_text(of, &none->found,
                    "there are as many parameters as numbers, so that the fit cannot be tested (%.0f steps)",
                    outcome[FIT_STEPS]);
        return;
    }
    // Judge the residuals if the noise is given; otherwise only state them.
    whirl_statement *own =
        noise ? find_judgement(of, "agreement", "", poor ? WHIRL_FAILS : WHIRL_HOLDS) : find_statement(of, "agreement");
    if (noise) phrase_text(of, &own->asked, "residuals as large as the given noise");
    phrase_text(of, &own->found, "residuals have the standard deviation ");
    if (noise)
        phrase_text(of, &own->found, "%.4g of the given noise", outcome[FIT_DEVIATION]);
    else
        phrase_number(of, &own->found, WHIRL_QUANTITY_LENGTH, 4, outcome[FIT_DEVIATION]);
    phrase_text(of, &own->found, " (%.0f degrees of freedom, %.0f steps)", outcome[FIT_DEGREES], outcome[FIT_STEPS]);
    if (poor)
        phrase_text(of, &own->judged, ": the machine does not agree with the measurement, or the noise is larger");
}

/// Judges whether the motions are stable: an unstable motion cannot have been measured.
static void fit_find_stability(const shown_fit_of *f) {
    const finder *of = f->of;
    const whirl_field *motions = whirl_layout_field(&of->table->layout, WHIRL_FIELD_FIT_MOTION);
    const double *motion = whirl_table_field(of->table, f->point, WHIRL_FIELD_FIT_MOTION, 0);
    size_t unstable = 0, first = 0;
    for (size_t i = motions ? motions->rows : 0; i-- > 0;)
        if (motion[FIT_MOTION_COLUMNS * i + FIT_MULTIPLIER] > 1.0) unstable++, first = i;
    if (unstable == 0) return;
    whirl_statement *own = find_judgement(of, "stable motions", "", WHIRL_FAILS);
    phrase_text(of, &own->asked, "all fitted motions are stable");
    phrase_text(of, &own->found, "%zu of %zu fitted motions are unstable, first number %zu at ", unstable,
                motions->rows, first + 1);
    phrase_number(of, &own->found, WHIRL_QUANTITY_SPEED, 5, motion[FIT_MOTION_COLUMNS * first]);
    phrase_text(of, &own->judged, ": no machine shows them");
}

/// States which motions are compared by statistics, and judges whether these scatter less than the noise.
static void fit_find_statistics(const shown_fit_of *f) {
    const finder *of = f->of;
    const whirl_fit_options *options = &of->table->record.fit;
    const whirl_field *motions = whirl_layout_field(&of->table->layout, WHIRL_FIELD_FIT_MOTION);
    const double *motion = whirl_table_field(of->table, f->point, WHIRL_FIELD_FIT_MOTION, 0);
    size_t count = 0;
    double largest = 0.0;
    for (size_t i = 0; motions && i < motions->rows; i++) {
        const double scatter = motion[FIT_MOTION_COLUMNS * i + FIT_SCATTER];
        count += isfinite(scatter);
        largest = fmax(largest, isfinite(scatter) ? scatter : 0.0);
    }
    if (count == 0) return;
    whirl_statement *own = find_judgement(of, "statistics", "", largest > 1.0 ? WHIRL_NOT_KNOWN : WHIRL_HOLDS);
    phrase_text(of, &own->asked, "statistics that scatter less than their noise");
    phrase_text(of, &own->found,
                "%zu of %zu motions are compared by statistics of %d revolutions, not as orbits; their derivatives are "
                "differences over %g %% of the parameters; they scatter by up to %.2g of the noise, and the standard "
                "errors include this scatter",
                count, motions->rows, options->record, 100.0 * options->difference, largest);
    if (largest > 1.0) phrase_text(of, &own->judged, ": a longer record is needed, or the noise is larger");
}

/// States which motions are compared with run-ups.
static void fit_find_runs(const shown_fit_of *f) {
    const whirl_field *motions = whirl_layout_field(&f->of->table->layout, WHIRL_FIELD_FIT_MOTION);
    size_t samples;
    const size_t waveforms = fit_count_waveforms(f->of->table, f->point, &samples);
    const size_t count = fit_count_runs(f->of->table, f->point) - waveforms;
    if (waveforms > 0)
        phrase_text(f->of, &find_statement(f->of, "run-ups")->found,
                    "%zu displacements of %zu run%s are compared with the machine at a changing speed, each at its "
                    "time; their derivatives are differences of whole runs",
                    samples, waveforms, waveforms == 1 ? "" : "s");
    if (count == 0) return;
    phrase_text(
        f->of, &find_statement(f->of, "run-ups")->found,
        "%zu of %zu rows of the measured tables are compared with the machine at a changing speed, by the orders "
        "of single turns; their derivatives are differences of whole runs",
        count, motions->rows);
}

/// States how many starts led to the same minimum.
static void fit_find_starts(const shown_fit_of *f) {
    const finder *of = f->of;
    size_t same = 0, done = 0;
    if (of->table->count < 2) return;
    for (size_t point = 0; point < of->table->count; point++) {
        const double *outcome = whirl_table_field(of->table, point, WHIRL_FIELD_FIT_OUTCOME, 0);
        if (!whirl_table_done(of->table, point) || !outcome) continue;
        done++;
        same += outcome[FIT_SUM] <= f->outcome[FIT_SUM] * (1.0 + 1e-6);
    }
    whirl_statement *own = find_statement(of, "starts");
    phrase_text(of, &own->found, "%zu of %zu starts led to the least sum of squares", same, done);
}

static void fit_find(const finder *of) {
    const whirl_layout *layout = &of->table->layout;
    const whirl_field *unknown = whirl_layout_field(layout, WHIRL_FIELD_FIT_UNKNOWN);
    const whirl_field *number = whirl_layout_field(layout, WHIRL_FIELD_FIT_NUMBER);
    shown_fit_of f = {.of = of, .point = fit_best(of->table)};
    fit_find_failures(of);
    if (f.point == of->table->count || !unknown || !number) return;
    f.unknowns = unknown->rows;
    f.numbers = number->rows;
    f.outcome = whirl_table_field(of->table, f.point, WHIRL_FIELD_FIT_OUTCOME, 0);
    f.unknown = whirl_table_field(of->table, f.point, WHIRL_FIELD_FIT_UNKNOWN, 0);
    f.correlation = whirl_table_field(of->table, f.point, WHIRL_FIELD_FIT_CORRELATION, 0);
    f.number = whirl_table_field(of->table, f.point, WHIRL_FIELD_FIT_NUMBER, 0);
    f.profile = whirl_table_field(of->table, f.point, WHIRL_FIELD_FIT_PROFILE, 0);
    for (size_t u = 0; u < f.unknowns; u++) fit_find_unknown(&f, u);
    fit_find_agreement(&f);
    fit_find_stability(&f);
    fit_find_statistics(&f);
    fit_find_runs(&f);
    fit_find_starts(&f);
    fit_find_sheet(&f);
    fit_find_correlations(&f);
    fit_find_channels(&f);
    fit_find_values(&f);
}

const shown_kind shown_fit = {
    .field = WHIRL_FIELD_FIT_UNKNOWN, .anchor = "fit", .name = "Fit to measured motions", .find = fit_find};
