// Writes how a result was computed: tables, parameters, numerical options, and origin.
#include <math.h>
#include <string.h>

#include "findings_render.h"
#include "html.h"
#include "page.h"
#include "quantities.h"
#include "two_pi.h"
#include "units.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"
#include "whirl/engine/system.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"

static void write_row(FILE *stream, const char *term, const char *text) {
    fputs("<dt>", stream);
    html_text(stream, term);
    fputs("</dt><dd>", stream);
    html_text(stream, text);
    fputs("</dd>\n", stream);
}

/// Appends "r_k from 1 to 0.1".
static void describe_axis(const whirl_shown_units *units, const char *parameter, double first, double last, char *text,
                          size_t size) {
    const size_t used = strlen(text);
    const double unit = whirl_shown_parameter(units, parameter).size;
    char label[UNIT_LABEL_SIZE];
    units_parameter_label(units, parameter, label, sizeof label);
    snprintf(text + used, size - used, "%s from %.6g to %.6g", label, first / unit, last / unit);
}

/// Writes "r_k from 1 to 0.1 by rho from 0.04 to 0.12: 61 by 33, 2013 points"; with a third parameter "... in 3 planes,
/// sigma from 1 to 2: ...".
static void describe_plane(const whirl_shown_units *units, const whirl_table *table, const char *count, char *text,
                           size_t size) {
    const size_t last = table->count - 1;
    *text = '\0';
    describe_axis(units, table->parameter, table->values[0], table->values[last], text, size);
    snprintf(text + strlen(text), size - strlen(text), " by ");
    describe_axis(units, table->second, whirl_table_second(table, 0), whirl_table_second(table, last), text, size);
    if (table->plane > 0) {
        snprintf(text + strlen(text), size - strlen(text), " in %zu planes, ", whirl_table_planes(table));
        describe_axis(units, table->third, whirl_table_third(table, 0), whirl_table_third(table, last), text, size);
    }
    snprintf(text + strlen(text), size - strlen(text), ": %zu by %zu, %s", table->row, whirl_table_rows(table), count);
}

/// Appends ", refined from squares of 16: 7.9 % of all, 612 revolutions each; all would have taken about 4.04e+07".
static void describe_refinement(const whirl_table *table, char *text, size_t size) {
    const size_t used = strlen(text);
    const double each = whirl_table_revolutions(table), grid = (double)table->grid;
    if (table->refine == 0) return;
    snprintf(text + used, size - used,
             ", refined from squares of %zu: %.1f %% of all, %.0f revolutions each; all would have taken about %.3g",
             table->refine, 100.0 * (double)table->count / grid, each, whirl_table_grid_revolutions(table));
}

/// Writes "25 points, 48 starts each and 3 from neighbours".
static void describe_starts(const whirl_table *view, char *text, size_t size) {
    const whirl_table *table = view->source;
    const size_t all = table->count;
    size_t added = 0;
    snprintf(text, size, "%zu points, %zu starts each", whirl_table_places(view), table->starts);
    for (size_t i = 0; i < all; i++) added += whirl_table_from_neighbour(table, i);
    const size_t used = strlen(text);
    if (table->neighbours > 0) snprintf(text + used, size - used, " and %zu from neighbours", added);
}

static void describe_points(const whirl_shown_units *units, const whirl_table *table, char *text, size_t size) {
    char label[UNIT_LABEL_SIZE];
    // Count the points, with their starts and refinement.
    char count[160];
    if (table->source)
        describe_starts(table, count, sizeof count);
    else if (whirl_table_planned(table) > table->count)
        snprintf(count, sizeof count, "%zu of %zu points", table->count, whirl_table_planned(table));
    else
        snprintf(count, sizeof count, "%zu point%s", table->count, table->count == 1 ? "" : "s");
    describe_refinement(table, count, sizeof count);
    if (!*table->parameter) {
        snprintf(text, size, "%s", count);
        return;
    }
    // Name the parameter; maps and tables of starts have ranges of their own.
    units_parameter_label(units, table->parameter, label, sizeof label);
    const double unit = whirl_shown_parameter(units, table->parameter).size;
    if (table->row > 0) {
        describe_plane(units, table, count, text, size);
        return;
    }
    if (table->source) {
        const whirl_table *all = table->source;
        snprintf(text, size, "%s from %.6g to %.6g, %s", label, all->values[0] / unit,
                 all->values[all->count - 1] / unit, count);
        return;
    }
    // Count the points from the first value to the last, and find whether starts were carried.
    size_t forward = 0;
    bool reverse = false;
    for (size_t i = 0; i < table->count; i++) {
        forward += table->branch[i] >= 0;
        reverse = reverse || table->branch[i] < 0;
    }
    const size_t last = forward > 0 && reverse ? forward - 1 : table->count - 1;
    snprintf(text, size, "%s from %.6g to %.6g, %s%s", label, table->values[0] / unit, table->values[last] / unit,
             count,
             forward && reverse ? " (both ways, each start carried from the point before)"
             : reverse || (table->count && table->branch[0] > 0) ? " (each start carried from the point before)"
                                                                 : "");
}

/// Writes method, steps per revolution (or the tolerance), transient and record, as far as they apply: studies of
/// machines at rest have no motions, and branches no transient.
static void write_way(FILE *stream, const whirl_table *table) {
    const whirl_integrate_options *how = &table->integrate;
    const whirl_kind *kind = whirl_analysis_kind(table->analyses);
    fputs("<td>", stream);
    html_text(stream, kind->method ? kind->method : how->method);
    if (how->chosen && !kind->method) fputs(" (by auto)", stream);
    fputs(kind->remark, stream);
    if (!kind->moves) {
        fputs("</td><td class=\"number\">\u2013</td><td class=\"number\">\u2013</td>"
              "<td class=\"number\">\u2013</td>",
              stream);
        return;
    }
    if (whirl_method_is_adaptive(how->method))
        fprintf(stream, "</td><td class=\"number\">tolerance %.0e</td>", how->rtol);
    else
        fprintf(stream, "</td><td class=\"number\">%d</td>", how->steps_per_revolution);
    fprintf(stream, "<td class=\"number\">%d revolutions</td><td class=\"number\">%d revolutions</td>",
            table->record.transient, table->record.record);
}

static void write_tables(FILE *stream, const whirl_result *result, const whirl_shown_units *units) {
    html_table(stream, "Parts of the study", "");
    fputs("<thead><tr><th>Part of the study</th><th>Points</th><th>Method</th>"
          "<th class=\"number\">Steps per revolution</th><th class=\"number\">Transient</th><th "
          "class=\"number\">Recorded</th>"
          "</tr></thead>\n<tbody>\n",
          stream);
    for (size_t t = 0; t < result->table_count; t++) {
        const whirl_table *table = &result->tables[t];
        char points[512];
        if (table->count == 0 && !table->source) continue;
        describe_points(units, table, points, sizeof points);
        fputs("<tr><th>", stream);
        html_text(stream, table->name);
        fputs("</th><td class=\"wide\">", stream);
        html_text(stream, points);
        fputs("</td>", stream);
        write_way(stream, table);
        fputs("</tr>\n", stream);
    }
    fputs("</tbody></table></div>\n", stream);
}

void page_parameters(const page *to, size_t index) {
    FILE *stream = to->stream;
    const whirl_result *result = to->results[index];
    if (result->parameter_count == 0) return;
    html_table(stream, "Parameters", "");
    fputs("<thead><tr><th>Parameter</th><th>As given</th><th class=\"number\">Value</th>"
          "<th>Unit</th></tr></thead>\n<tbody>\n",
          stream);
    for (size_t i = 0; i < result->parameter_count; i++) {
        const whirl_parameter *parameter = &result->parameters[i];
        const whirl_unit unit = whirl_shown_parameter(&to->units[index], parameter->name);
        fputs("<tr><th>", stream);
        html_text(stream, parameter->name);
        fputs("</th><td>", stream);
        html_text(stream, parameter->text);
        fprintf(stream, "</td><td class=\"number\">%.8g</td><td>", parameter->value / unit.size);
        html_text(stream, unit.name);
        fputs("</td></tr>\n", stream);
    }
    fputs("</tbody></table></div>\n", stream);
}

/// Appends " (stator at 1.2 c)".
static void append_gap(const whirl_shown_units *units, const whirl_probe *station, char *text, size_t size) {
    const size_t used = strlen(text);
    snprintf(text + used, size - used, " (stator at %.4g %s)", units->length * station->gap, units->length_name);
}

void page_warnings(const page *to, size_t index) {
    char said[SENTENCE_SIZE];
    for (size_t i = 0; *whirl_result_warning(to->results[index], i); i++) {
        fputs("<p><strong>Warning:</strong> ", to->stream);
        whirl_shown_sentence(&to->units[index], whirl_result_warning(to->results[index], i), said, sizeof said);
        html_text(to->stream, said);
        fputs("</p>\n", to->stream);
    }
}

void page_computed(const page *to, size_t index) {
    const whirl_result *result = to->results[index];
    char text[1024];
    size_t done, total;
    const whirl_shown_units *units = &to->units[index];
    fprintf(to->stream, "<h3 id=\"computed-%zu\">What was computed</h3>\n", index + 1);
    // Warn of a partial result.
    const bool partial = whirl_result_partial(result, &done, &total);
    if (partial && done < total)
        fprintf(to->stream,
                "<p><strong>This result is partial:</strong> the run was stopped when %zu of %zu points were done. The "
                "others are left out below.</p>\n",
                done, total);
    else if (partial)
        fputs("<p><strong>This result is partial:</strong> the run was stopped when all points were done, but before "
              "all verdicts were confirmed or refined.</p>\n",
              to->stream);
    if (!to->printed) page_warnings(to, index);
    // List the case, the speed, sections and scales.
    fputs("<dl>\n", to->stream);
    if (*result->case_name) write_row(to->stream, "Case", result->case_name);
    snprintf(text, sizeof text, "%.6g rad/s (%.6g revolutions a minute)", result->speed,
             result->speed * 60.0 / 6.283185307179586);
    write_row(to->stream, "Speed of rotation", text);
    const double clock = whirl_result_clock(result);
    snprintf(text, sizeof text, "once a turn of the %.80s (%.6g Hz), in which revolutions and orders are counted",
             whirl_result_keyphasor(result), clock / two_pi);
    if (*whirl_result_keyphasor(result)) write_row(to->stream, "Sections", text);
    const whirl_unit *const length = &units->of[WHIRL_QUANTITY_LENGTH];
    snprintf(text, sizeof text, "%.6g %s", result->length_scale / length->size, length->name);
    write_row(to->stream, "Length scale", text);
    // List the stations, with bearings, seals and stators around them.
    text[0] = '\0';
    for (size_t s = 0; s < result->station_count; s++) {
        const size_t used = strlen(text);
        const whirl_probe *station = &result->stations[s];
        snprintf(text + used, sizeof text - used, "%s%s%s", s ? ", " : "", station->name,
                 station->clearance > 0.0 ? " (bearing or seal)" : "");
        if (station->gap > 0.0) append_gap(units, station, text, sizeof text);
    }
    write_row(to->stream, "Stations", text);
    // List fitted coefficients and contacts.
    for (size_t i = 0; *whirl_result_fit(result, i); i++) {
        whirl_shown_sentence(units, whirl_result_fit(result, i), text, sizeof text);
        write_row(to->stream, "Table over frequencies of whirl", text);
    }
    if (result->contact_count > 0) {
        text[0] = '\0';
        for (size_t c = 0; c < result->contact_count; c++) {
            const size_t used = strlen(text);
            snprintf(text + used, sizeof text - used, "%s%s", c ? ", " : "", result->contacts[c]);
        }
        write_row(to->stream, "Contacts", text);
    }
    // Describe each table.
    fputs("</dl>\n", to->stream);
    write_tables(to->stream, result, units);
    if (!to->printed) page_parameters(to, index);
}

void page_provenance(const page *to, size_t index) {
    const whirl_result *result = to->results[index];
    if (result->fact_count > 0) {
        fprintf(to->stream, "<h3 id=\"provenance-%zu\">Provenance</h3>\n<dl>\n", index + 1);
        for (size_t i = 0; i < result->fact_count; i++)
            write_row(to->stream, result->facts[i].name, result->facts[i].value);
        fputs("</dl>\n", to->stream);
    }
    if (!to->printed && result->case_text && *result->case_text) { // printed pages have the case in an appendix
        fputs("<details><summary>The case file</summary>\n<pre>", to->stream);
        html_text(to->stream, result->case_text);
        fputs("</pre></details>\n", to->stream);
    }
}
