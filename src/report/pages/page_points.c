// Writes the regimes along the sweep, and the tables of points in detail.
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "html.h"
#include "machine_at.h"
#include "number_shown.h"
#include "number_text.h"
#include "page.h"
#include "quantities.h"
#include "regimes.h"
#include "units.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

enum { SHOWN_LINES = 5, NAMES_SIZE = 512 };

static void write_swatch(FILE *stream, regime_class kind) {
    fprintf(stream, "<span class=\"swatch\" style=\"background:%s\"></span>", regime_class_colour(kind));
}

/// A table of a sweep, with the unit in which its parameter is shown.
typedef struct shown_table {
    const whirl_table *table;
    double unit; ///< unit of the parameter, in SI
} shown_table;

static void write_range(FILE *stream, const shown_table *of, size_t first, size_t last) {
    const double *values = of->table->values;
    if (first == last)
        html_printf(stream, "%.5g", values[first] / of->unit);
    else
        html_printf(stream, "%.5g to %.5g", values[first] / of->unit, values[last] / of->unit);
}

static void write_interval(FILE *stream, const shown_table *of, const regime_interval *interval, bool branches) {
    fputs("<tr><td class=\"whole\">", stream);
    write_range(stream, of, interval->first, interval->last);
    if (of->table->attractors) html_printf(stream, ", attractor %zu", of->table->attractors[interval->first].number);
    if (branches) fputs(interval->branch < 0 ? " <span class=\"soft\">(from the last value)</span>" : "", stream);
    fputs("</td><td class=\"whole\">", stream);
    write_swatch(stream, interval->kind);
    html_text(stream, interval->name);
    fprintf(stream, "</td><td class=\"number\">%zu</td><td class=\"number\">%zu</td></tr>\n", interval->count,
            interval->rubbing);
}

/// Writes several short windows in a row as one line with their regimes.
static void write_windows(FILE *stream, const shown_table *of, const regime_interval *windows, size_t count) {
    size_t points = 0, rubbing = 0;
    char names[NAMES_SIZE];
    fputs("<tr><td class=\"whole\">", stream);
    write_range(stream, of, windows[0].first, windows[count - 1].last);
    fputs("</td><td class=\"wide\">", stream);
    regime_group_name(windows, count, names, sizeof names);
    html_text(stream, names);
    for (size_t i = 0; i < count; i++) {
        points += windows[i].count;
        rubbing += windows[i].rubbing;
    }
    fprintf(stream,
            " <span class=\"soft\">(%zu windows)</span></td><td class=\"number\">%zu</td><td "
            "class=\"number\">%zu</td></tr>\n",
            count, points, rubbing);
}

static void write_interval_head(FILE *stream, const char *parameter) {
    html_table(stream, "Regimes along the sweep", "");
    fputs("<thead><tr><th>", stream);
    html_text(stream, parameter);
    fputs("</th><th>Regime</th><th class=\"number\">Points</th><th class=\"number\">of these with "
          "rub</th></tr></thead>\n<tbody>\n",
          stream);
}

static void write_merged(FILE *stream, const shown_table *of, const regime_interval *intervals, size_t count,
                         bool branches) {
    for (size_t i = 0, group; i < count; i += group) {
        group = regime_group(&intervals[i], count - i);
        if (group > 1)
            write_windows(stream, of, &intervals[i], group);
        else
            write_interval(stream, of, &intervals[i], branches);
    }
}

void page_intervals(const page *to, size_t index) {
    const whirl_result *result = to->results[index];
    const whirl_table *table = whirl_result_role(result, WHIRL_ROLE_SURVEY);
    if (!table || table->count == 0 || !whirl_layout_has_verdict(&table->layout)) return;
    // Divide the sweep into intervals of one regime.
    regime_interval *intervals = malloc(table->count * sizeof *intervals);
    if (!intervals) return;
    const size_t count = regime_intervals(table, result->contact_count, intervals, table->count);
    const whirl_shown_units *units = &to->units[index];
    const shown_table shown = {table, whirl_shown_parameter(units, table->parameter).size};
    char label[UNIT_LABEL_SIZE];
    units_parameter_label(units, table->parameter, label, sizeof label);
    if (count == 0) {
        free(intervals);
        return;
    }
    // Count the narrow intervals that are merged into wide ones.
    const bool branches = intervals[0].branch != intervals[count - 1].branch;
    size_t windows = 0;
    for (size_t i = 0, group; i < count; i += group) {
        group = regime_group(&intervals[i], count - i);
        windows += group - 1;
    }
    // Write merged intervals, and all intervals in a part to unfold.
    fprintf(to->stream, "<h3 id=\"regimes-%zu\">Regimes along the sweep</h3>\n", index + 1);
    write_interval_head(to->stream, label);
    write_merged(to->stream, &shown, intervals, count, branches);
    fputs("</tbody></table></div>\n", to->stream);
    if (windows > 0) {
        fprintf(to->stream, "<details><summary>All %zu intervals</summary>\n", count);
        write_interval_head(to->stream, label);
        for (size_t i = 0; i < count; i++) write_interval(to->stream, &shown, &intervals[i], branches);
        fputs("</tbody></table></div></details>\n", to->stream);
    }
    free(intervals);
}

// ---------------------------------------------------------------- points

static void write_number(FILE *stream, const char *format, double value) {
    fputs("<td class=\"number\">", stream);
    if (isnan(value))
        fputs("&ndash;", stream);
    else {
        char text[64];
        snprintf(text, sizeof text, format, value);
        html_text(stream, text);
    }
    fputs("</td>", stream);
}

/// Data shared by the tables of points.
typedef struct point_page {
    FILE *stream;
    const whirl_result *result;
    const whirl_table *table;
    const whirl_shown_units *units;
    double unit;               ///< unit of the parameter, in SI
    const whirl_case *machine; ///< case that gives the speed at a point; NULL if orders are shown, or there is no case
} point_page;

static void write_value(const point_page *to, size_t point, size_t rows) {
    fprintf(to->stream, "<th scope=\"row\" rowspan=\"%zu\">", rows);
    if (*to->table->parameter)
        html_printf(to->stream, "%.6g", to->table->values[point] / to->unit);
    else
        html_text(to->stream, to->table->name);
    if (to->table->attractors) html_printf(to->stream, ", attractor %zu", to->table->attractors[point].number);
    fputs("</th>", to->stream);
}

/// Begins a table whose first column is the value of the parameter.
static void begin_table(const point_page *to, const char *label) {
    char parameter[UNIT_LABEL_SIZE];
    units_parameter_label(to->units, to->table->parameter, parameter, sizeof parameter);
    html_table(to->stream, label, "");
    fputs("<thead><tr><th>", to->stream);
    html_text(to->stream, *to->table->parameter ? parameter : "Point");
    fputs("</th>", to->stream);
}

static void end_table(const point_page *to) {
    fputs("</tbody></table></div>\n", to->stream);
}

// ---------------------------------------------------------------- verdicts

/// Writes the confidence, "high", and the verdict at the second tolerance if there is one.
static void write_confidence(FILE *stream, const whirl_verdict *verdict) {
    char other[WHIRL_NAME_SIZE];
    const whirl_verdict second = {.regime = verdict->other_regime, .period = verdict->other_period};
    html_text(stream, whirl_confidence_name(verdict->confidence));
    if (!verdict->confirmed) return;
    regime_name(&second, other, sizeof other);
    const bool same = second.regime == verdict->regime && second.period == verdict->period;
    html_printf(stream, same ? ", confirmed" : "; at the second tolerance %s", other);
}

/// Writes all exponents, their sum and its exact value from the equations, if they were computed.
static void write_exponents(FILE *stream, const whirl_table *table, size_t point) {
    const numbers values = point_numbers(table, point, WHIRL_FIELD_EXPONENTS_VALUES, 0);
    const numbers errors = point_numbers(table, point, WHIRL_FIELD_EXPONENTS_ERRORS, 0);
    const numbers sum = point_numbers(table, point, WHIRL_FIELD_EXPONENTS_SUM, 0);
    const numbers exact = point_numbers(table, point, WHIRL_FIELD_EXPONENTS_SUM_EXACT, 0);
    const numbers dimension = point_numbers(table, point, WHIRL_FIELD_EXPONENTS_DIMENSION, 0);
    const numbers failed = point_numbers(table, point, WHIRL_FIELD_EXPONENTS_FAILED, 0);
    if (failed.at && failed.at[0] > 0.5 && sum.at && exact.at) {
        fputs("<br>", stream);
        html_printf(stream, "exponents failed: their sum is %.6g, the equations give %.6g", sum.at[0], exact.at[0]);
        return;
    }
    if (!values.at || !errors.at || errors.rows < values.rows) return;
    fputs("<br>exponents ", stream);
    for (size_t i = 0; i < values.rows; i++) {
        const shown_estimate shown = estimate_shown((whirl_estimate){values.at[i], errors.at[i]});
        fprintf(stream, "%s%.*f&nbsp;&plusmn;&nbsp;%.*f", i ? ", " : "", shown.decimals, shown.value, shown.decimals,
                shown.error);
    }
    if (sum.at && exact.at) html_printf(stream, "; their sum %.6f, exactly %.6f", sum.at[0], exact.at[0]);
    if (dimension.at) html_printf(stream, "; Kaplan-Yorke dimension %.3g", dimension.at[0]);
}

/// Writes the reason of the verdict, advice if it is in doubt, and all exponents.
static void write_reason(const point_page *to, size_t point, const whirl_verdict *verdict) {
    char text[512];
    fputs("<td class=\"why\">", to->stream);
    reason_text(verdict, text, sizeof text);
    html_text(to->stream, text);
    whirl_verdict_advice(verdict, text, sizeof text);
    if (verdict->confidence == WHIRL_LOW && *text) html_printf(to->stream, ". To settle it, %s.", text);
    write_exponents(to->stream, to->table, point);
    fputs("</td>", to->stream);
}

static void write_verdict(const point_page *to, size_t point) {
    const whirl_verdict verdict = whirl_table_verdict(to->table, point);
    const shown_estimate exponent = estimate_shown(point_exponent(to->table, point));
    char text[LABEL_SIZE];
    fputs("<tr>", to->stream);
    // Write the regime with its colour.
    write_value(to, point, 1);
    fputs("<td class=\"whole\">", to->stream);
    write_swatch(to->stream, regime_class_of(&verdict));
    whirl_verdict_name(&verdict, text, sizeof text);
    html_text(to->stream, text);
    fputs("</td><td>", to->stream);
    // Write its confidence, the exponent and the share of rubbing.
    write_confidence(to->stream, &verdict);
    fputs("</td><td class=\"number\">", to->stream);
    if (isnan(exponent.value))
        fputs("&ndash;", to->stream);
    else
        fprintf(to->stream, "%.*f&nbsp;&plusmn;&nbsp;%.*f", exponent.decimals, exponent.value, exponent.decimals,
                exponent.error);
    fputs("</td>", to->stream);
    if (has_rub(to->table, to->result->contact_count))
        write_number(to->stream, "%.3g %%", 100.0 * rub_share(to->table, point, to->result->contact_count));
    // Write the reason for the verdict.
    write_reason(to, point, &verdict);
    fputs("</tr>\n", to->stream);
}

static void write_verdicts(const point_page *to) {
    if (!whirl_layout_has_verdict(&to->table->layout)) return;
    begin_table(to, "Verdicts on the points in detail");
    fputs("<th>Regime</th><th>Confidence</th><th class=\"number\">Largest exponent<br>(1/revolution)</th>", to->stream);
    if (has_rub(to->table, to->result->contact_count))
        fputs("<th class=\"number\">Time in<br>contact</th>", to->stream);
    fputs("<th>Why</th></tr></thead>\n<tbody>\n", to->stream);
    for (size_t i = 0; i < to->table->count; i++)
        if (whirl_table_done(to->table, i)) write_verdict(to, i);
    end_table(to);
    fputs("<p class=\"soft small\">Two exponents of a point are of the same motion: in the table the mean over all "
          "watched revolutions, with an error as chaos has it; under Why that of the evidence, which is weighted where "
          "the motion is regular and then sharper.</p>\n",
          to->stream);
}

// ---------------------------------------------------------------- size and sense

/// Returns true if any station is a journal.
static bool has_bearing(const whirl_result *result) {
    bool found = false;
    for (size_t s = 0; s < result->station_count; s++) found = found || result->stations[s].clearance > 0.0;
    return found;
}

/// Returns true if any station may touch a stator.
static bool has_gap(const whirl_result *result) {
    bool found = false;
    for (size_t s = 0; s < result->station_count; s++) found = found || result->stations[s].gap > 0.0;
    return found;
}

/// Writes the frequency of a line, or its order if the frequency is unknown: with an X where other lines have
/// frequencies.
static void write_place(const point_page *to, double order, double frequency) {
    char text[NUMBER_SIZE];
    number_shown(order * frequency, 4, text, sizeof text);
    if (isfinite(frequency))
        html_text(to->stream, text);
    else
        html_printf(to->stream, to->units->frequency > 0.0 ? "%.4gX" : "%.4g", order);
}

/// Writes the largest lines: orders or frequencies with their amplitudes.
static void write_lines(const point_page *to, size_t point, size_t station) {
    const numbers lines = point_lines(to->table, point, station);
    fputs("<td class=\"wide\">", to->stream);
    const double amplitude = units_length(to->units, to->table, point, WHIRL_AMPLITUDE);
    const double clock = to->units->frequency > 0.0 ? machine_clock(to->machine, to->result, to->table, point) : 0.0;
    for (size_t i = 0; i < lines.rows && i < SHOWN_LINES; i++) {
        const double *line = &lines.at[5 * i];
        if (i) fputs(", ", to->stream);
        write_place(to, line[0], units_order(to->units, clock));
        html_printf(to->stream, ":\u00a0%.3g", amplitude * fmax(line[1], line[2]));
    }
    if (!lines.at) fputs("&ndash;", to->stream);
    const double share = line_share(to->table, point, station);
    if (share < FEW_LINES) html_printf(to->stream, " (lines hold %.3g\u00a0%% of the motion)", 100.0 * share);
    fputs("</td>", to->stream);
}

static void write_station_name(const point_page *to, size_t point, size_t station) {
    fputs(station + 1 < to->result->station_count ? "<tr class=\"open\">" : "<tr>", to->stream);
    if (station == 0) write_value(to, point, to->result->station_count);
    fputs("<td>", to->stream);
    html_text(to->stream, to->result->stations[station].name);
    fputs("</td>", to->stream);
}

static void write_size(const point_page *to, size_t point, size_t s) {
    const machine_walls walls = machine_walls_at(to->machine, to->result, to->table, point, s);
    const double radius = max_radius(to->table, point, s), none = (double)NAN;
    write_station_name(to, point, s);
    write_number(to->stream, to->units->ratio ? "%.4f" : "%.4g",
                 whirl_shown_length(to->units, to->table, point) * radius);
    if (has_bearing(to->result))
        write_number(to->stream, "%.4f", walls.clearance > 0.0 ? radius / walls.clearance : none);
    if (has_gap(to->result)) write_number(to->stream, "%.4f", walls.gap > 0.0 ? radius / walls.gap : none);
    write_number(to->stream, "%.3g %%", 100.0 * backward_share(to->table, point, s));
    write_lines(to, point, s);
    fputs("</tr>\n", to->stream);
}

static void write_sizes(const point_page *to) {
    if (!whirl_layout_field(&to->table->layout, WHIRL_FIELD_ORBIT_MAX_RADIUS) &&
        !whirl_layout_field(&to->table->layout, WHIRL_FIELD_SPECTRUM_LINES))
        return;
    // Write the head, with columns for bearings and gaps only if the machine has them.
    char radius[UNIT_LABEL_SIZE], amplitude[UNIT_LABEL_SIZE];
    units_length_label(to->units, WHIRL_ZERO_TO_PEAK, "radius", radius, sizeof radius);
    units_length_label(to->units, WHIRL_AMPLITUDE, "larger amplitude of x and y", amplitude, sizeof amplitude);
    begin_table(to, "Size and sense of the motion at the points in detail");
    fputs("<th>Station</th><th class=\"number\">Largest<br>", to->stream);
    html_text(to->stream, radius);
    fputs("</th>", to->stream);
    if (has_bearing(to->result)) fputs("<th class=\"number\">Largest<br>eccentricity</th>", to->stream);
    if (has_gap(to->result)) fputs("<th class=\"number\">Largest<br>radius / gap</th>", to->stream);
    fputs("<th class=\"number\">Time against<br>the rotation</th><th>Largest lines: ", to->stream);
    html_printf(to->stream, to->units->frequency > 0.0 ? "frequency (%s), " : "order%s, ", to->units->frequency_name);
    html_text(to->stream, amplitude);
    fputs("</th></tr></thead>\n<tbody>\n", to->stream);
    // Write a row for each station of each point.
    for (size_t i = 0; i < to->table->count; i++)
        for (size_t s = 0; s < to->result->station_count && whirl_table_done(to->table, i); s++) write_size(to, i, s);
    end_table(to);
    fputs(
        "<p class=\"soft small\">Time against the rotation: the share of the time in which the station moves backward "
        "about the centre (0, 0), x&nbsp;y\u2032&nbsp;\u2212&nbsp;y&nbsp;x\u2032&nbsp;&lt;&nbsp;0; an orbit that does "
        "not enclose the centre does so for about half of the time, whatever its sense.</p>\n",
        to->stream);
}

// ---------------------------------------------------------------- the running speed

enum { SYNCHRONOUS_PARTS = 4 };

static void write_synchronous(const point_page *to, size_t point, size_t station) {
    const double *amplitude = whirl_table_field(to->table, point, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, station);
    const double *lag = whirl_table_field(to->table, point, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS_LAG, station);
    const double size = units_length(to->units, to->table, point, WHIRL_AMPLITUDE);
    write_station_name(to, point, station);
    for (int i = 0; i < SYNCHRONOUS_PARTS && amplitude && lag; i++) {
        write_number(to->stream, "%.4g", size * amplitude[i]);
        write_number(to->stream, "%.1f\u00b0", lag[i]);
    }
    fputs("</tr>\n", to->stream);
}

static void write_running_speed(const point_page *to) {
    // Name the speed to which phases refer: that of the keyphasor, if the case names one.
    static const char *const parts[SYNCHRONOUS_PARTS] = {"x", "y", "forward", "backward"};
    char amplitude[UNIT_LABEL_SIZE];
    if (!whirl_layout_field(&to->table->layout, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS)) return;
    units_length_label(to->units, WHIRL_AMPLITUDE, "Amplitudes", amplitude, sizeof amplitude);
    const char *keyphasor = whirl_result_keyphasor(to->result);
    fputs(*keyphasor ? "<h4>At the frequency of the " : "<h4>At the running speed", to->stream);
    html_text(to->stream, keyphasor);
    fputs(" (1X)</h4>\n<p>", to->stream);
    html_text(to->stream, amplitude);
    fputs(" and phase lags of x, of y, and of the circular motions with and against the rotation that make up the "
          "orbit at 1X.</p>\n",
          to->stream);
    // Write the head.
    begin_table(to, *keyphasor ? "Amplitudes and phases at 1X" : "Amplitudes and phases at the running speed");
    fputs("<th>Station</th>", to->stream);
    for (int i = 0; i < SYNCHRONOUS_PARTS; i++)
        fprintf(to->stream, "<th class=\"number\">%s</th><th class=\"number\">lag</th>", parts[i]);
    fputs("</tr></thead>\n<tbody>\n", to->stream);
    // Write a row for each station of each point.
    for (size_t i = 0; i < to->table->count; i++)
        for (size_t s = 0; s < to->result->station_count && whirl_table_done(to->table, i); s++)
            write_synchronous(to, i, s);
    end_table(to);
    // Explain what lags refer to.
    fputs(*keyphasor
              ? "<p class=\"soft small\">Lags are in degrees behind its phase, which begins with every revolution: "
              : "<p class=\"soft small\">Lags are in degrees behind a mark on the shaft that stands on the x axis "
                "at the start of every revolution, where an unbalance without an angle of its own lies: ",
          to->stream);
    fputs("x&nbsp;= a&nbsp;cos(\u03c4&nbsp;\u2212&nbsp;lag).</p>\n", to->stream);
}

// ---------------------------------------------------------------- watched quantities

/// Returns true for fields of the analyses orbit and rub with one row for every station or contact, over the whole
/// record.
static bool is_watched(const whirl_field *field, whirl_extent extent) {
    return field->extent == extent && field->rows == 1 &&
           (strncmp(field->name, "orbit/", 6) == 0 || strncmp(field->name, "rub/", 4) == 0);
}

/// Returns the shown unit of a field of forces, torques or powers; NULL for other fields. Powers are in W unless
/// another unit is chosen, since the losses in contacts are small.
static const whirl_unit *watched_unit(const point_page *to, const whirl_field *field) {
    static const whirl_unit watts = {"W", 1.0};
    static const struct {
        const char *unit;
        whirl_quantity quantity;
    } kinds[] = {{"force", WHIRL_QUANTITY_FORCE}, {"N m", WHIRL_QUANTITY_MOMENT}, {"W", WHIRL_QUANTITY_POWER}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(field->unit, kinds[i].unit) == 0)
            return kinds[i].quantity == WHIRL_QUANTITY_POWER && !to->units->chosen[WHIRL_QUANTITY_POWER]
                       ? &watts
                       : &to->units->of[kinds[i].quantity];
    return NULL;
}

/// Writes a heading "max radius / c", "mean x (um)", "max force (N)", with the meaning of the number as its title.
static void write_watched_head(const point_page *to, const whirl_field *field, size_t column) {
    char name[2 * WHIRL_NAME_SIZE], label[sizeof name + UNIT_LABEL_SIZE];
    char columns[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE];
    const char *part = whirl_field_column_names(field, columns) ? columns[column] : "";
    snprintf(name, sizeof name, "%s%s%s", strchr(field->name, '/') + 1, *part ? " " : "", part);
    for (char *at = name; (at = strchr(at, '_')) != NULL;) *at = ' ';
    const whirl_unit *const unit = watched_unit(to, field);
    snprintf(label, sizeof label, unit ? "%s (%s)" : "%s", name, unit ? unit->name : "");
    if (strcmp(field->unit, "length") == 0)
        units_length_label(to->units, whirl_field_counting(field), name, label, sizeof label);
    fputs("<th class=\"number\" title=\"", to->stream);
    html_text(to->stream, field->meaning);
    fputs("\">", to->stream);
    html_text(to->stream, label);
    fputs("</th>", to->stream);
}

/// Returns the factor from a number of the field to its shown value.
static double watched_factor(const point_page *to, const whirl_field *field, size_t point) {
    if (strcmp(field->unit, "length") == 0)
        return units_length(to->units, to->table, point, whirl_field_counting(field));
    const whirl_unit *const unit = watched_unit(to, field);
    return unit ? whirl_result_si(to->result, to->table, field->unit).size / unit->size : 1.0;
}

static void write_watched_of(const point_page *to, size_t point, size_t which, whirl_extent extent) {
    const bool station = extent == WHIRL_PER_STATION;
    const size_t count = station ? to->result->station_count : to->result->contact_count;
    fputs(which + 1 < count ? "<tr class=\"open\">" : "<tr>", to->stream);
    if (which == 0) write_value(to, point, count);
    fputs("<td>", to->stream);
    html_text(to->stream, station ? to->result->stations[which].name : to->result->contacts[which]);
    fputs("</td>", to->stream);
    for (size_t f = 0; f < to->table->layout.field_count; f++) {
        const whirl_field *field = &to->table->layout.fields[f];
        const double *values = whirl_table_field(to->table, point, field->name, which);
        for (size_t c = 0; is_watched(field, extent) && values && c < field->columns; c++)
            write_number(to->stream, "%.4g", watched_factor(to, field, point) * values[c]);
    }
    fputs("</tr>\n", to->stream);
}

/// Writes a table of all stations, or of all contacts, if the analyses orbit or rub were made there.
static void write_watched(const point_page *to, whirl_extent extent, const char *label, const char *head) {
    const whirl_layout *layout = &to->table->layout;
    size_t fields = 0, repeat = 0;
    for (size_t f = 0; f < layout->field_count; f++) {
        if (!is_watched(&layout->fields[f], extent)) continue;
        repeat = layout->fields[f].repeat;
        fields++;
    }
    if (fields == 0) return;
    begin_table(to, label);
    fprintf(to->stream, "<th>%s</th>", head);
    for (size_t f = 0; f < layout->field_count; f++)
        for (size_t c = 0; is_watched(&layout->fields[f], extent) && c < layout->fields[f].columns; c++)
            write_watched_head(to, &layout->fields[f], c);
    fputs("</tr></thead>\n<tbody>\n", to->stream);
    for (size_t i = 0; i < to->table->count; i++)
        for (size_t which = 0; which < repeat && whirl_table_done(to->table, i); which++)
            write_watched_of(to, i, which, extent);
    end_table(to);
}

void page_motions(const page *to, size_t index, const whirl_table *table) {
    const whirl_result *result = to->results[index];
    const whirl_shown_units *units = &to->units[index];
    const point_page points = {
        to->stream, result, table, units, whirl_shown_parameter(units, table->parameter).size, to->machines[index]};
    write_verdicts(&points);
    write_sizes(&points);
    write_watched(&points, WHIRL_PER_CONTACT, "What was watched of the contacts", "Contact");
}

void page_points(const page *to, size_t index) {
    const whirl_result *result = to->results[index];
    const whirl_table *table = detail_table(result);
    if (!table || table->count == 0 || result->station_count == 0) return;
    const whirl_shown_units *units = &to->units[index];
    const point_page points = {
        to->stream, result, table, units, whirl_shown_parameter(units, table->parameter).size, to->machines[index]};
    fprintf(to->stream, "<h3 id=\"points-%zu\">Points in detail</h3>\n", index + 1);
    write_verdicts(&points);
    write_sizes(&points);
    fputs("<details><summary>All that was watched over the record</summary>\n", to->stream);
    write_watched(&points, WHIRL_PER_STATION, "What was watched of the stations", "Station");
    write_watched(&points, WHIRL_PER_CONTACT, "What was watched of the contacts", "Contact");
    fputs("</details>\n", to->stream);
    write_running_speed(&points);
}
