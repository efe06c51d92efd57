#include "explorer.h"
#include "explorer_bands.h"
#include "explorer_contents.h"
#include "explorer_tables.h"
#include "machine_at.h"
#include "report_file.h"
#include "shown_kinds.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/report.h"
#include "whirl/engine/result.h"
#include "whirl/engine/system.h"
#include "whirl/internal/shown.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"
#include "input.h"
#include "unit_words.h"
#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

/// Placeholder in the page's template that the results replace.
static const char mark[] = "@WHIRL-RUNS@";

enum { MAX_TEMPLATE = 1 << 26 };

// ---------------------------------------------------------------- the template

static whirl_status unreadable(const char *path, const char *why) {
    return whirl_fail(WHIRL_BAD_INPUT, "the explorer's template %.200s %s", path, why);
}

/// Reads a file into memory, with a zero byte at its end.
static whirl_status read_template(const char *path, char **text) {
    input_file in;
    size_t length;
    if (!input_read(path, MAX_TEMPLATE + 1, &in, text, &length))
        return whirl_fail(in.no_memory ? WHIRL_NO_MEMORY : WHIRL_BAD_INPUT,
                          "the explorer's template %.200s cannot be read: %s", path, in.reason);
    if (length <= MAX_TEMPLATE) return whirl_ok();
    free(*text);
    *text = NULL;
    return unreadable(path, "is larger than 64 MiB");
}

static void write_parameters(FILE *stream, const whirl_result *result) {
    script_key(stream, ',', "parameters");
    fputc('[', stream);
    for (size_t i = 0; i < result->parameter_count; i++) {
        const whirl_parameter *parameter = &result->parameters[i];
        if (i > 0) fputc(',', stream);
        script_text_member(stream, '{', "name", parameter->name);
        script_text_member(stream, ',', "unit", parameter->unit);
        script_text_member(stream, ',', "text", parameter->text);
        script_number_member(stream, ',', "value", parameter->value);
        fputc('}', stream);
    }
    fputc(']', stream);
}

static void write_stations(FILE *stream, const whirl_result *result) {
    script_key(stream, ',', "stations");
    fputc('[', stream);
    for (size_t i = 0; i < result->station_count; i++) {
        const whirl_probe *station = &result->stations[i];
        if (i > 0) fputc(',', stream);
        script_text_member(stream, '{', "name", station->name);
        script_members(stream, whirl_probe_members(), station);
        fputc('}', stream);
    }
    fputc(']', stream);
    script_key(stream, ',', "contacts");
    fputc('[', stream);
    for (size_t i = 0; i < result->contact_count; i++) {
        if (i > 0) fputc(',', stream);
        script_text(stream, result->contacts[i]);
    }
    fputc(']', stream);
}

static void write_facts(FILE *stream, const whirl_result *result) {
    script_key(stream, ',', "facts");
    fputc('[', stream);
    for (size_t i = 0; i < result->fact_count; i++) {
        if (i > 0) fputc(',', stream);
        script_text_member(stream, '{', "name", result->facts[i].name);
        script_text_member(stream, ',', "value", result->facts[i].value);
        fputc('}', stream);
    }
    fputc(']', stream);
}

// ---------------------------------------------------------------- point shown when the page opens

static bool is_sure(const whirl_table *table, size_t point) {
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    return verdict.regime != WHIRL_UNDETERMINED && verdict.confidence != WHIRL_LOW;
}

/// Returns the finished point nearest to a value; sure: only points with a trusted verdict count. table->count if there
/// is none.
static size_t nearest_point(const whirl_table *table, double wanted, bool sure) {
    size_t best = table->count;
    for (size_t p = 0; p < table->count; p++) {
        if (!whirl_table_done(table, p) || (sure && !is_sure(table, p))) continue;
        if (best == table->count || fabs(table->values[p] - wanted) < fabs(table->values[best] - wanted)) best = p;
    }
    return best;
}

/// Returns the first table of motions that the page can compute itself; NULL if there is none.
static const whirl_table *diagram_of(const whirl_result *result) {
    for (const whirl_table *table = result->tables; table < result->tables + result->table_count; table++)
        if (whirl_analysis_kind(table->analyses)->moves && !accompanying_motions(table)) return table;
    return NULL;
}

/// Chooses the point with which the page opens: the case's detail point, else the middle of the sweep, then the point
/// with a trusted verdict nearest to that, if any. Returns its table; NULL if no point is done.
static const whirl_table *find_opening(const whirl_result *result, size_t *point) {
    const whirl_table *diagram = diagram_of(result), *table = diagram;
    *point = 0;
    if (!diagram || diagram->count == 0 || diagram->row > 0 || !whirl_layout_has_verdict(&diagram->layout)) return NULL;
    if (!*diagram->parameter) return whirl_table_done(diagram, 0) ? diagram : NULL;
    double wanted = 0.5 * (diagram->values[0] + diagram->values[diagram->count - 1]);
    for (size_t t = 0; t < result->table_count && table == diagram; t++)
        if (result->tables[t].role == WHIRL_ROLE_DETAIL && strcmp(result->tables[t].parameter, diagram->parameter) == 0)
            table = &result->tables[t];
    if (table != diagram) wanted = table->values[0];
    *point = nearest_point(table, wanted, true);
    if (*point == table->count) *point = nearest_point(table = diagram, wanted, true);
    if (*point == table->count) *point = nearest_point(table, wanted, false);
    return *point < table->count ? table : NULL;
}

static void write_verdict(FILE *stream, const whirl_verdict *verdict) {
    char name[WHIRL_NAME_SIZE], text[WHIRL_MESSAGE_SIZE];
    whirl_verdict_name(verdict, name, sizeof name);
    script_text_member(stream, '{', "regime", whirl_regime_name(verdict->regime));
    script_text_member(stream, ',', "name", name);
    whirl_verdict_reason(verdict, text, sizeof text);
    script_text_member(stream, ',', "reason", text);
    whirl_verdict_advice(verdict, text, sizeof text);
    script_text_member(stream, ',', "advice", text);
    script_text_member(stream, ',', "confidence", whirl_confidence_name(verdict->confidence));
    fprintf(stream, ",\"period\":%d,\"curves\":%d", verdict->period, verdict->curves);
    script_number_member(stream, ',', "exponent", verdict->exponent.value);
    script_number_member(stream, ',', "exponentError", verdict->exponent.error);
    fputc('}', stream);
}

/// Writes the stored data of the motion with which the page opens, so that it is shown before anything is computed.
static void write_opening(FILE *stream, const whirl_result *result, const whirl_case *machine) {
    size_t point;
    const whirl_table *table = find_opening(result, &point);
    if (!table) return;
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    script_key(stream, ',', "opening");
    script_text_member(stream, '{', "parameter", table->parameter);
    script_number_member(stream, ',', "value", *table->parameter ? table->values[point] : (double)NAN);
    script_number_member(stream, ',', "speed", machine_clock(machine, result, table, point));
    script_number_member(stream, ',', "length_scale", whirl_result_length_scale(result, table, point));
    script_text_member(stream, ',', "keyphasor", whirl_result_keyphasor(result));
    script_members(stream, whirl_integrate_members(), &table->integrate);
    script_members(stream, whirl_record_members(), &table->record);
    script_key(stream, ',', "verdict");
    write_verdict(stream, &verdict);
    explorer_write_point(stream, table, point);
    fputc('}', stream);
}

static void write_unit(FILE *stream, char before, const char *name, const whirl_unit *unit) {
    script_key(stream, before, name);
    script_text_member(stream, '{', "unit", unit->name);
    script_number_member(stream, ',', "size", unit->size);
    fputc('}', stream);
}

/// Returns true if lengths are shown over the length scale, because the units of the report or of the case have the
/// word "scale".
static bool scale_chosen(const whirl_result *result, const char *asked) {
    const char *const texts[] = {asked ? asked : "", whirl_result_fact(result, "units")};
    unit_choice choice;
    for (size_t i = 0; i < 2; i++) {
        if (unit_choice_read(texts[i], &choice).code != WHIRL_OK) continue;
        if (choice.of[UNIT_LENGTH]) return !(choice.of[UNIT_LENGTH]->size > 0.0);
        if (choice.of[UNIT_SYSTEM]) return false;
    }
    return false;
}

/// Writes the units that the report or the case chose: how amplitudes are counted, and units of lengths, places along
/// shafts, speeds, frequencies (size in Hz; absent: orders) and parameters (by SI unit). A unit that was not chosen is
/// absent.
static void write_units(FILE *stream, const whirl_result *result, const char *asked) {
    whirl_shown_units units;
    if (whirl_result_shown_units(result, asked, &units).code != WHIRL_OK)
        return; // the report has rejected invalid units
    script_key(stream, ',', "shown");
    script_text_member(stream, '{', "amplitude", units.amplitude_name);
    if (units.size.size > 0.0) write_unit(stream, ',', "length", &units.size);
    script_key(stream, ',', "scale");
    fputs(scale_chosen(result, asked) ? "true" : "false", stream);
    // Places, speeds and frequencies.
    const whirl_unit *position = &units.of[WHIRL_QUANTITY_POSITION];
    if (units.chosen[WHIRL_QUANTITY_POSITION]) write_unit(stream, ',', "position", position);
    if (units.speed.size > 0.0) write_unit(stream, ',', "speed", &units.speed);
    if (units.frequency > 0.0) {
        whirl_unit frequency = {.size = units.frequency};
        snprintf(frequency.name, sizeof frequency.name, "%s", units.frequency_name);
        write_unit(stream, ',', "frequency", &frequency);
    }
    // Parameters.
    script_key(stream, ',', "parameters");
    fputc('{', stream);
    whirl_unit unit;
    const char *si;
    char before = ' ';
    for (size_t i = 0; (si = whirl_shown_si(&units, i, &unit)) != NULL; i++) {
        if (!(unit.size > 0.0)) continue;
        write_unit(stream, before, si, &unit);
        before = ',';
    }
    fputs("}}", stream);
}

static bool write_run(FILE *stream, const whirl_result *result, const whirl_case *machine, const char *name,
                      const char *units) {
    bool well = true;
    script_text_member(stream, '{', "name", name);
    script_text_member(stream, ',', "title", result->title);
    script_text_member(stream, ',', "case_name", result->case_name);
    script_text_member(stream, ',', "case_text", result->case_text);
    script_number_member(stream, ',', "speed", whirl_result_clock(result));
    script_number_member(stream, ',', "length_scale", result->length_scale);
    script_number_member(stream, ',', "force_scale", result->force_scale);
    write_parameters(stream, result);
    write_stations(stream, result);
    write_facts(stream, result);
    write_units(stream, result, units);
    script_key(stream, ',', "tables");
    fputc('[', stream);
    const whirl_table *diagram = diagram_of(result);
    // Tables of sampled machines are left out: the page shows only their figures and sheets.
    for (size_t t = 0, shown = 0; t < result->table_count; t++) {
        if (result->tables[t].tolerances.samples > 0) continue;
        if (shown++ > 0) fputc(',', stream);
        well = explorer_write_table(stream, &result->tables[t], &result->tables[t] == diagram) && well;
    }
    fputc(']', stream);
    write_opening(stream, result, machine);
    well = explorer_write_bands(stream, result) && well;
    well = explorer_write_contents(stream, result, machine, units) && well;
    fputc('}', stream);
    return well;
}

/// Writes the template, with the runs in place of the mark at `place`. Returns false without memory.
static bool write_page(FILE *stream, const char *page, const char *place, const whirl_result *const *results,
                       const whirl_case *const *machines, const char *const *names, size_t count, const char *units) {
    bool well = true;
    fwrite(page, 1, (size_t)(place - page), stream);
    fputc('[', stream);
    for (size_t r = 0; r < count; r++) {
        if (r > 0) fputs(",\n", stream);
        well = write_run(stream, results[r], machines[r], names[r], units) && well;
    }
    fputc(']', stream);
    fputs(place + strlen(mark), stream);
    return well;
}

whirl_status explorer_write(const char *template_path, const whirl_result *const *results,
                            const whirl_case *const *machines, const char *const *names, size_t count,
                            const char *directory, const char *units) {
    char *page;
    whirl_status status = read_template(template_path, &page);
    if (status.code != WHIRL_OK) return status;
    const char *place = strstr(page, mark);
    if (place) {
        report_file file = {0};
        status = report_file_open(&file, directory, "explorer.html");
        if (status.code == WHIRL_OK) {
            if (write_page(file.stream, page, place, results, machines, names, count, units)) {
                status = report_file_close(&file);
            } else {
                report_file_drop(&file);
                status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the page, or a figure of it cannot be made");
            }
        }
    } else
        status = unreadable(template_path, "has no place for results: it is no template of the explorer");
    free(page);
    return status;
}

whirl_status whirl_explorer_write(const char *template_path, const whirl_result *const *results,
                                  const char *const *names, size_t count, const char *directory) {
    whirl_case **machines;
    whirl_status status = machines_of(results, count, &machines);
    if (status.code == WHIRL_OK)
        status =
            explorer_write(template_path, results, (const whirl_case *const *)machines, names, count, directory, NULL);
    machines_free(machines, count);
    return status;
}
