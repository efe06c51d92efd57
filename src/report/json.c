// Writes a result as one JSON document, point by point.
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "document.h"
#include "findings_render.h"
#include "json_point.h"
#include "whirl/engine/report.h"
#include "whirl/engine/result.h"
#include "whirl/version.h"

// Writes "key": value after the text `before`.
static bool dump_member(const char *before, const char *key, json_t *value, FILE *stream) {
    fputs(before, stream);
    const bool named = document_write(true, document_text(key), stream);
    fputs(": ", stream);
    return document_write(true, value, stream) && named;
}

static bool dump_table(const char *key, const whirl_result *result, const whirl_table *table,
                       const whirl_coexistence *found, bool full, FILE *stream) {
    fprintf(stream, ",\n\"%s\": [", key);
    bool first = true, well = true;
    mode_lines lines;
    const bool followed = mode_lines_of(table, &lines);
    for (size_t point = 0; point < table->count && well; ++point) {
        if (!whirl_table_done(table, point)) continue;
        json_t *object = point_json(&well, result, table, point, found, followed ? &lines : NULL, full);
        fputs(first ? "\n" : ",\n", stream);
        well = document_write(well, object, stream);
        first = false;
    }
    mode_lines_free(&lines);
    fputs("\n]", stream);
    return well;
}

static bool dump_points(const char *key, const whirl_result *result, const whirl_table *table, bool full,
                        FILE *stream) {
    whirl_coexistence found = {.labels = NULL};
    if (table->starts > 1 && whirl_table_coexistence(table, &found).code != WHIRL_OK) return false;
    const bool well = dump_table(key, result, table, &found, full, stream);
    whirl_coexistence_free(&found);
    return well;
}

enum { MAX_JUMPS = 1000 };

// Returns the jumps of motions within a regime: parameter values on both sides, station, size of the jump and usual
// size of a step.
static json_t *jumps_of(bool *well, const whirl_result *result, const whirl_table *table) {
    json_t *array = json_array();
    size_t count = 0;
    whirl_jump *jumps = calloc(MAX_JUMPS, sizeof *jumps);
    if (!jumps || whirl_table_jumps(table, jumps, MAX_JUMPS, &count).code != WHIRL_OK) *well = false;
    for (size_t i = 0; i < count && i < MAX_JUMPS; ++i) {
        json_t *jump = json_object();
        document_put(well, jump, "from", document_number(table->values[jumps[i].from]));
        document_put(well, jump, "to", document_number(table->values[jumps[i].to]));
        document_put(well, jump, "station", document_text(result->stations[jumps[i].station].name));
        document_put(well, jump, "change", document_number(jumps[i].change));
        document_put(well, jump, "usual", document_number(jumps[i].usual));
        document_append(well, array, jump);
    }
    free(jumps);
    return array;
}

static bool dump_jumps(const whirl_result *result, FILE *stream) {
    bool well = true;
    json_t *object = json_object();
    for (size_t t = 0; t < result->table_count; ++t) {
        const whirl_table *table = &result->tables[t];
        if (table->role == WHIRL_ROLE_SURVEY && table->starts <= 1)
            document_put(&well, object, table->name, jumps_of(&well, result, table));
    }
    return dump_member(",\n", "jumps", object, stream) && well;
}

// Writes the findings: statements, and sheets if there are any.
static whirl_status dump_findings(const whirl_result *result, FILE *stream) {
    bool well = true;
    whirl_findings *findings;
    const whirl_status status = whirl_findings_new(result, NULL, &findings);
    if (status.code != WHIRL_OK) return status;
    if (findings->statement_count > 0)
        well = dump_member(",\n", "statements", statements_json(&well, findings), stream) && well;
    if (findings->sheet_count > 0) well = dump_member(",\n", "sheets", sheets_json(&well, findings), stream) && well;
    whirl_findings_free(findings);
    return well ? status : whirl_fail(WHIRL_NO_MEMORY, "no memory to write JSON");
}

enum { MAX_ATTRACTORS = 64 };

// Returns the attractors of a basin, the one with most starts first, each with its first point (from 1 in "points").
static json_t *attractors_of(bool *well, const whirl_table *table) {
    json_t *array = json_array();
    whirl_attractor found[MAX_ATTRACTORS];
    size_t count;
    if (whirl_table_attractors(table, NULL, found, MAX_ATTRACTORS, &count).code != WHIRL_OK) *well = false;
    for (size_t k = 0; k < count && k < MAX_ATTRACTORS && *well; ++k) {
        json_t *one = json_object();
        const whirl_verdict verdict = whirl_table_verdict(table, found[k].first);
        document_put(well, one, "first", json_integer((json_int_t)whirl_table_slot(table, found[k].first) + 1));
        document_put(well, one, "regime", document_text(whirl_regime_name(verdict.regime)));
        document_put(well, one, "period", json_integer(verdict.period));
        document_put(well, one, "starts", json_integer((json_int_t)found[k].points));
        document_put(well, one, "share", document_number(found[k].share));
        document_put(well, one, "error", document_number(found[k].error));
        document_append(well, array, one);
    }
    return array;
}

// Appends the attractors of all places of a table with several starts, place by place.
static void append_coexisting(bool *well, const whirl_result *result, const whirl_table *table, json_t *array) {
    whirl_coexistence found;
    if (whirl_table_coexistence(table, &found).code != WHIRL_OK) *well = false;
    for (size_t k = 0; *well && k < found.count; ++k) {
        const whirl_coexisting *at = &found.items[k];
        const whirl_verdict verdict = whirl_table_verdict(table, at->first);
        json_t *one = json_object();
        document_put(well, one, "table", document_text(table->name));
        document_put(well, one, "parameters", point_parameters(well, result, table, at->first));
        document_put(well, one, "attractor", json_integer((json_int_t)at->number));
        document_put(well, one, "first", json_integer((json_int_t)whirl_table_slot(table, at->first) + 1));
        document_put(well, one, "regime", document_text(whirl_regime_name(verdict.regime)));
        document_put(well, one, "period", json_integer(verdict.period));
        document_put(well, one, "starts", json_integer((json_int_t)at->starts));
        document_put(well, one, "of", json_integer((json_int_t)at->of));
        document_put(well, one, "share", document_number(at->share));
        document_put(well, one, "error", document_number(at->error));
        document_append(well, array, one);
    }
    whirl_coexistence_free(&found);
}

static bool dump_attractors(const whirl_result *result, FILE *stream) {
    bool well = true;
    const whirl_table *basin = whirl_result_role(result, WHIRL_ROLE_BASIN);
    if (basin) return dump_member(",\n", "attractors", attractors_of(&well, basin), stream) && well;
    json_t *array = NULL;
    for (size_t t = 0; t < result->table_count; ++t) {
        if (result->tables[t].starts <= 1) continue;
        if (!array) array = json_array();
        append_coexisting(&well, result, &result->tables[t], array);
    }
    return well && (!array || dump_member(",\n", "attractors", array, stream));
}

// Writes the refinement of a map: points of the grid and of a row, computed points and their mean revolutions, width of
// the first squares, and the estimated revolutions of the whole grid.
static bool dump_refined(const whirl_result *result, FILE *stream) {
    bool well = true;
    const whirl_table *table = result->table_count ? &result->tables[0] : NULL;
    size_t done = 0;
    if (!table || table->refine == 0) return true;
    for (size_t i = 0; i < table->count; ++i) done += whirl_table_done(table, i);
    json_t *object = json_object();
    document_put(&well, object, "from", json_integer((json_int_t)table->refine));
    document_put(&well, object, "computed", json_integer((json_int_t)done));
    document_put(&well, object, "grid", json_integer((json_int_t)table->grid));
    document_put(&well, object, "row", json_integer((json_int_t)table->row));
    document_put(&well, object, "revolutions", document_number(whirl_table_revolutions(table)));
    document_put(&well, object, "grid_revolutions", document_number(whirl_table_grid_revolutions(table)));
    return dump_member(",\n", "refined", object, stream) && well;
}

// Returns the version that computed the result; the present version if none is recorded.
static const char *version_of(const whirl_result *result) {
    for (size_t i = 0; i < result->fact_count; ++i)
        if (strcmp(result->facts[i].name, "version") == 0) return result->facts[i].value;
    return WHIRL_VERSION;
}

// Writes the computing options of every table, by table name.
static bool dump_methods(const whirl_result *result, FILE *stream) {
    json_t *methods = json_object();
    bool well = true;
    for (size_t i = 0; i < result->table_count; ++i) {
        json_t *object = json_object();
        const whirl_table *table = &result->tables[i];
        const whirl_member *members;
        for (size_t group = 0, at; (members = whirl_table_options(table, group, &at)) != NULL; group++)
            document_put_members(&well, object, members, (const char *)table + at);
        document_put(&well, methods, result->tables[i].name, object);
    }
    return dump_member(",\n", "integrated", methods, stream) && well;
}

/// Writes how weight acts on the machine, and the keyphasor if it is not the shaft.
static bool dump_machine(const whirl_result *result, FILE *stream) {
    const char *keyphasor = whirl_result_keyphasor(result);
    const char *weight = whirl_result_fact(result, "weight");
    if (*weight && !dump_member(",\n", "weight", document_text(weight), stream)) return false;
    return !*keyphasor || (dump_member(",\n", "keyphasor", document_text(keyphasor), stream) &&
                           dump_member(",\n", "keyphasor_rate", document_number(whirl_result_clock(result)), stream));
}

/// Writes the film tables that machines used, if any.
static bool dump_film_tables(const whirl_result *result, FILE *stream) {
    const char *tables = whirl_result_film_tables(result);
    return !*tables || dump_member(",\n", "film_tables", document_text(tables), stream);
}

/// Writes texts by their index, up to the first empty one, in shown units.
static bool dump_texts(const char *key, const char *(*text_of)(const whirl_result *, size_t),
                       const whirl_result *result, FILE *stream) {
    bool well = true;
    whirl_shown_units units;
    char said[SENTENCE_SIZE];
    json_t *texts = json_array();
    whirl_result_shown_units(result, NULL, &units); // invalid units in a file choose nothing
    for (size_t i = 0; *text_of(result, i); ++i) {
        whirl_shown_sentence(&units, text_of(result, i), said, sizeof said);
        document_append(&well, texts, document_text(said));
    }
    return dump_member(",\n", key, texts, stream) && well;
}

/// Writes warnings about the case, and curve fits of frequency-dependent tables, if any.
static bool dump_warnings(const whirl_result *result, FILE *stream) {
    return dump_texts("warnings", whirl_result_warning, result, stream) &&
           (!*whirl_result_fit(result, 0) || dump_texts("fits", whirl_result_fit, result, stream));
}

/// Puts the number of points, and the first of them, counted from 1.
static void put_points(bool *well, json_t *object, const whirl_left *left) {
    document_put(well, object, "points", document_number((double)left->points));
    document_put(well, object, "first", document_number((double)left->first + 1.0));
}

/// Writes the validity ranges of laws that points have left.
static bool dump_beyond(const whirl_result *result, FILE *stream) {
    bool well = true;
    json_t *all = json_array();
    whirl_left left;
    for (size_t t = 0; t < result->table_count; t++)
        for (size_t i = 0; *whirl_result_law_range(result, i); i++) {
            const whirl_table *table = &result->tables[t];
            if (whirl_table_left(table, i, &left) == 0) continue;
            json_t *one = json_object();
            document_put(&well, one, "table", document_text(table->name));
            document_put(&well, one, "law", document_text(whirl_result_law_range(result, i)));
            document_put(&well, one, "reached", document_number(left.reached));
            document_put(&well, one, "most", document_number(left.most));
            put_points(&well, one, &left);
            document_append(&well, all, one);
        }
    return dump_member(",\n", "beyond", all, stream) && well;
}

/// Writes the contacts that are closed at rest.
static bool dump_held(const whirl_result *result, FILE *stream) {
    bool well = true;
    json_t *all = json_array();
    whirl_left left;
    for (size_t t = 0; t < result->table_count; t++)
        for (size_t c = 0; c < result->contact_count; c++) {
            if (whirl_table_held(&result->tables[t], c, &left) == 0) continue;
            json_t *one = json_object();
            document_put(&well, one, "table", document_text(result->tables[t].name));
            document_put(&well, one, "contact", document_text(result->contacts[c]));
            document_put(&well, one, "force", document_number(left.reached * result->force_scale));
            put_points(&well, one, &left);
            document_append(&well, all, one);
        }
    return dump_member(",\n", "held", all, stream) && well;
}

/// Writes the points of machines at rest for which no equilibrium was found.
static bool dump_unfound(const whirl_result *result, FILE *stream) {
    bool well = true;
    json_t *all = json_array();
    whirl_left left;
    for (size_t t = 0; t < result->table_count; t++) {
        if (whirl_table_unfound(&result->tables[t], &left) == 0) continue;
        json_t *one = json_object();
        document_put(&well, one, "table", document_text(result->tables[t].name));
        document_put(&well, one, "followed", document_number(left.reached));
        put_points(&well, one, &left);
        document_append(&well, all, one);
    }
    return dump_member(",\n", "unfound", all, stream) && well;
}

/// Writes the tables of machines at rest with points that have another equilibrium.
static bool dump_elsewhere(const whirl_result *result, FILE *stream) {
    bool well = true;
    json_t *all = json_array();
    whirl_left left;
    for (size_t t = 0; t < result->table_count; t++) {
        if (whirl_table_elsewhere(&result->tables[t], &left) == 0) continue;
        json_t *one = json_object();
        document_put(&well, one, "table", document_text(result->tables[t].name));
        document_put(&well, one, "distance", document_number(left.reached));
        document_put(&well, one, "growth", document_number(left.most));
        put_points(&well, one, &left);
        document_append(&well, all, one);
    }
    return dump_member(",\n", "elsewhere", all, stream) && well;
}

/// Version of the document, raised when a key is removed or changes its meaning; the schema is
/// docs/reference/result.schema.json.
enum { DOCUMENT_FORMAT = 1 };

static bool dump_head(const whirl_result *result, FILE *stream) {
    const whirl_table *first = result->table_count ? &result->tables[0] : NULL;
    size_t done, total;
    const bool partial = whirl_result_partial(result, &done, &total);
    return dump_member("{", "format", json_integer(DOCUMENT_FORMAT), stream) &&
           dump_member(",\n", "whirl", document_text(version_of(result)), stream) &&
           dump_member(",\n", "title", document_text(result->title), stream) &&
           dump_member(",\n", "case", document_text(result->case_name), stream) &&
           dump_member(",\n", "speed", document_number(result->speed), stream) && dump_machine(result, stream) &&
           dump_film_tables(result, stream) &&
           dump_member(",\n", "length_scale", document_number(result->length_scale), stream) &&
           dump_member(",\n", "amplitudes", document_text("0-p"), stream) && // as in the fields of analyses
           dump_member(",\n", "force_scale", document_number(result->force_scale), stream) &&
           dump_member(",\n", "partial", json_boolean(partial), stream) && dump_warnings(result, stream) &&
           dump_beyond(result, stream) && dump_held(result, stream) && dump_unfound(result, stream) &&
           dump_elsewhere(result, stream) &&
           dump_member(",\n", "table", first ? document_text(first->name) : json_null(), stream) &&
           dump_methods(result, stream);
}

// Rejects table names that are keys of the document.
static whirl_status check_names(const whirl_result *result) {
    static const char *const taken[] = {
        "format",     "whirl",          "title",      "case",       "speed",   "length_scale", "force_scale",
        "partial",    "table",          "points",     "parameters", "jumps",   "integrated",   "fits",
        "keyphasor",  "keyphasor_rate", "attractors", "refined",    "beyond",  "warnings",     "film_tables",
        "amplitudes", "statements",     "sheets",     "held",       "unfound", "elsewhere",    "weight"};
    for (size_t t = 0; t < result->table_count; ++t)
        for (size_t i = 0; i < sizeof taken / sizeof *taken; ++i)
            if (strcmp(result->tables[t].name, taken[i]) == 0 || strpbrk(result->tables[t].name, "\"\\\n"))
                return whirl_fail(WHIRL_BAD_INPUT, "'%s' cannot name a table in JSON", result->tables[t].name);
    return whirl_ok();
}

static whirl_status write_document(const whirl_result *result, bool full, FILE *stream) {
    const whirl_status names = check_names(result);
    if (names.code != WHIRL_OK) return names;
    errno = 0;
    bool well = dump_head(result, stream);
    if (result->table_count == 0) fputs(",\n\"points\": []", stream);
    for (size_t i = 0; well && i < result->table_count; ++i)
        well = dump_points(i == 0 ? "points" : result->tables[i].name, result, &result->tables[i], full, stream);
    whirl_status found = whirl_ok();
    if (well) found = dump_findings(result, stream);
    well = well && found.code == WHIRL_OK && dump_jumps(result, stream) && dump_attractors(result, stream) &&
           dump_refined(result, stream);
    fputs("}\n", stream);
    if (fflush(stream) != 0 || ferror(stream))
        return whirl_fail(WHIRL_IO_ERROR, "cannot write JSON: %s", strerror(errno ? errno : EIO));
    if (found.code != WHIRL_OK) return found;
    return well ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory to write JSON");
}

whirl_status whirl_result_write_json(const whirl_result *result, FILE *stream) {
    return write_document(result, true, stream);
}

whirl_status whirl_result_write_json_summary(const whirl_result *result, FILE *stream) {
    return write_document(result, false, stream);
}
