// Writes the findings of a result for the explorer's page: statements, sheets and figures of every table.
#include "explorer_contents.h"
#include "document.h"
#include "explorer_fit.h"
#include "findings_render.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "shaft_bends.h"
#include "shown_kinds.h"
#include "whirl/engine/figure.h"

/// Largest size of a figure, and of all figures of a result, in bytes. Figures beyond these limits are left out, since
/// they would be too much for a browser.
enum { MAX_FIGURE = 4 << 20, MAX_FIGURES = 24 << 20 };

/// A result whose findings are written.
typedef struct contents {
    FILE *stream;
    whirl_result *view; ///< the result, with each attractor as a table of its own
    whirl_shown_units units;
    const whirl_case *machine;
    whirl_findings *findings;
    figure_list figures;
} contents;

/// Returns true if the page shows findings of a result: for studies of machines at rest, and of motions that the page
/// cannot compute. Other results are shown in the page's live views.
static bool has_contents(const whirl_result *result) {
    for (size_t t = 0; t < result->table_count; t++) {
        const whirl_kind *kind = whirl_analysis_kind(result->tables[t].analyses);
        if ((!kind->moves && !kind->found) || accompanying_motions(&result->tables[t])) return true;
    }
    return false;
}

/// Writes JSON within a script element; escapes everything that could end the script.
static void put_safely(FILE *stream, const char *json) {
    for (; *json; json++)
        if (*json == '<')
            fputs("\\u003c", stream);
        else if (*json != '\n')
            fputc(*json, stream);
}

/// Writes a comma, a key and a value; frees the value. Returns false without memory.
static bool put_value(FILE *stream, const char *key, bool well, json_t *value) {
    char *text = well && value ? json_dumps(value, JSON_COMPACT | JSON_REAL_PRECISION(17)) : NULL;
    json_decref(value);
    if (!text) return false;
    fprintf(stream, ",\"%s\":", key);
    put_safely(stream, text);
    free(text);
    return true;
}

// ---------------------------------------------------------------- tables

/// Returns the name of the live view in which the page shows a table; "" if it has none. Live views compute motions of
/// the case's machine.
static const char *view_of(const contents *of, const whirl_table *table) {
    const shown_kind *kind = shown_kind_of(table);
    const whirl_kind *points = whirl_analysis_kind(table->analyses);
    if (points->moves || points->found) return accompanying_motions(table) ? "" : "motions";
    if (kind == &shown_runup) return "runup";
    if (kind == &shown_fit) return explorer_fit_is_live(of->view, of->machine, table) ? "fit" : "";
    return kind == &shown_modes ? "modes" : kind == &shown_unbalance ? "unbalance" : "";
}

/// Writes every table: name, kind, live view.
static bool put_tables(const contents *of) {
    bool well = true;
    json_t *tables = json_array();
    for (const whirl_table *table = of->view->tables; table < of->view->tables + of->view->table_count; table++) {
        const shown_kind *kind = shown_kind_of(table);
        json_t *one = json_object();
        document_put(&well, one, "table", document_text(table->name));
        document_put(&well, one, "title", document_text(kind->name));
        document_put(&well, one, "view", document_text(view_of(of, table)));
        document_append(&well, tables, one);
    }
    return put_value(of->stream, "parts", well, tables);
}

// ---------------------------------------------------------------- sheets

static bool put_findings(const contents *of) {
    bool well = true;
    json_t *statements = statements_json(&well, of->findings), *sheets = sheets_json(&well, of->findings);
    const bool put = put_value(of->stream, "statements", well, statements);
    return put_value(of->stream, "sheets", well, sheets) && put;
}

// ---------------------------------------------------------------- figures

/// Returns a figure as JSON, to be freed; NULL if it cannot be made.
static char *figure_json(const contents *of, const figure_place *place, size_t *size) {
    const drawing drawn = {of->view, &of->units, of->machine};
    whirl_figure *figure = NULL;
    char *json = NULL;
    FILE *text = open_memstream(&json, size);
    bool well = text && figure_make(&drawn, place, NULL, &figure).code == WHIRL_OK &&
                whirl_figure_write_json(figure, text).code == WHIRL_OK;
    if (text && fclose(text) != 0) well = false;
    whirl_figure_free(figure);
    if (well) return json;
    free(json);
    return NULL;
}

/// Writes all figures, each with the name of its table ("" for the machine), and the titles of figures that are left
/// out.
static bool put_figures(const contents *of) {
    size_t all = 0, put = 0;
    bool well = true;
    json_t *left = json_array();
    fputs(",\"figures\":[", of->stream);
    // Write figures until their limit of size is reached.
    for (size_t i = 0; i < of->figures.count && well; i++) {
        const figure_place *place = &of->figures.items[i];
        size_t size = 0;
        char *json = figure_json(of, place, &size);
        well = json != NULL;
        if (well && size <= MAX_FIGURE && all + size <= MAX_FIGURES) {
            if (put++ > 0) fputc(',', of->stream);
            script_text_member(of->stream, '{', "table", place->kind->whole ? "" : place->table->name);
            fputs(",\"figure\":", of->stream);
            put_safely(of->stream, json);
            fputc('}', of->stream);
            all += size;
        } else if (well)
            document_append(&well, left, document_text(place->name.title));
        free(json);
    }
    // Write the titles of figures that are left out.
    fputc(']', of->stream);
    return put_value(of->stream, "left_out", well, left);
}

// ---------------------------------------------------------------- shaft lines

/// Limits of shaft lines: number of points of a table (the machine of each is built again), and of all numbers.
enum { MAX_BENT = 256, MAX_BENT_NUMBERS = 1 << 21 };

/// Shaft lines of a table at rest: places along the shafts (those of the first point), and shapes [points][modes, or
/// 1][places][4] as x_cos, x_sin, y_cos, y_sin; NaN for points without a line.
typedef struct bent_table {
    const whirl_table *table;
    size_t modes, places, *shaft;
    double *position, *moved;
} bent_table;

static bool bent_has_places(const bent_table *b, const whirl_shaft_line *line) {
    bool same = line->count == b->places;
    for (size_t i = 0; i < b->places && same; i++)
        same = line->shaft[i] == b->shaft[i] && line->position[i] == b->position[i];
    return same;
}

/// Copies the places of the first line, and allocates all shapes. Returns false if there are too many.
static bool bent_begin(bent_table *b, const whirl_shaft_line *line) {
    const size_t numbers = b->table->count * b->modes * line->count * 4;
    if (numbers > MAX_BENT_NUMBERS) return false;
    b->places = line->count;
    b->shaft = malloc(b->places * sizeof *b->shaft);
    b->position = malloc(b->places * sizeof *b->position);
    b->moved = malloc(numbers * sizeof *b->moved);
    if (!b->shaft || !b->position || !b->moved) return false;
    memcpy(b->shaft, line->shaft, b->places * sizeof *b->shaft);
    memcpy(b->position, line->position, b->places * sizeof *b->position);
    for (size_t i = 0; i < numbers; i++) b->moved[i] = (double)NAN;
    return true;
}

/// Computes the shapes of a point, as figures draw them. Returns false if there are too many numbers.
static bool bent_fill(const contents *of, bent_table *b, size_t point) {
    const drawing drawn = {of->view, &of->units, of->machine};
    shaft_bends *bends = whirl_table_done(b->table, point) ? bends_new(&drawn, b->table, point) : NULL;
    bool allocated = true;
    if (bends && !b->moved) allocated = bent_begin(b, bends_line(bends));
    for (size_t mode = 0; bends && allocated && mode < b->modes && bent_has_places(b, bends_line(bends)); mode++) {
        double *moved = b->moved + 4 * b->places * (point * b->modes + mode);
        const bool response = shown_kind_of(b->table) == &shown_unbalance;
        const bool missing =
            !response && !isfinite(whirl_table_field(b->table, point, WHIRL_FIELD_MODES_FREQUENCY, 0)[mode]);
        if (missing || !(response ? bends_response(bends, moved) : bends_mode(bends, mode, moved)))
            for (size_t i = 0; i < 4 * b->places; i++) moved[i] = (double)NAN;
    }
    bends_free(bends);
    return allocated;
}

static void bent_write(FILE *stream, const bent_table *b, const char *before) {
    base64 to = {.stream = stream};
    fputs(before, stream);
    script_text_member(stream, '{', "table", b->table->name);
    fprintf(stream, ",\"modes\":%zu,\"shaft\":[", b->modes);
    for (size_t i = 0; i < b->places; i++) fprintf(stream, i > 0 ? ",%zu" : "%zu", b->shaft[i]);
    fputs("],\"position\":\"", stream);
    for (size_t i = 0; i < b->places; i++) base64_float64(&to, b->position[i]);
    base64_end(&to);
    fputs("\",\"moved\":\"", stream);
    to = (base64){.stream = stream};
    for (size_t i = 0; i < b->table->count * b->modes * b->places * 4; i++) base64_float32(&to, b->moved[i]);
    base64_end(&to);
    fputs("\"}", stream);
}

/// Writes the shaft lines of modes and responses, for tables within the limits.
static void put_lines(const contents *of) {
    bool first = true;
    fputs(",\"lines\":[", of->stream);
    for (const whirl_table *table = of->view->tables; table < of->view->tables + of->view->table_count; table++) {
        const shown_kind *kind = shown_kind_of(table);
        const whirl_field *modes = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_FREQUENCY);
        bent_table b = {.table = table, .modes = kind == &shown_modes && modes ? modes->rows : 1};
        const bool wanted = (kind == &shown_modes || kind == &shown_unbalance) && table->count <= MAX_BENT;
        bool allocated = wanted;
        for (size_t point = 0; point < table->count && allocated; point++) allocated = bent_fill(of, &b, point);
        if (allocated && b.moved) bent_write(of->stream, &b, first ? "" : ",");
        first = first && !(allocated && b.moved);
        free(b.shaft);
        free(b.position);
        free(b.moved);
    }
    fputc(']', of->stream);
}

static bool put_warnings(const contents *of) {
    bool well = true;
    json_t *warnings = json_array();
    char said[SENTENCE_SIZE];
    for (size_t i = 0; *whirl_result_warning(of->view, i); i++) {
        whirl_shown_sentence(&of->units, whirl_result_warning(of->view, i), said, sizeof said);
        document_append(&well, warnings, document_text(said));
    }
    return put_value(of->stream, "warnings", well, warnings);
}

bool explorer_write_contents(FILE *stream, const whirl_result *result, const whirl_case *machine, const char *units) {
    contents of = {.stream = stream, .machine = machine};
    if (!has_contents(result)) return true;
    bool well = whirl_result_by_attractor(result, &of.view).code == WHIRL_OK &&
                whirl_result_shown_units(of.view, units, &of.units).code == WHIRL_OK &&
                findings_of(of.view, &of.units, machine, &of.findings).code == WHIRL_OK;
    const drawing drawn = {of.view, &of.units, of.machine};
    well = well && figures_list(&drawn, &of.figures).code == WHIRL_OK && put_tables(&of) && put_findings(&of) &&
           put_figures(&of) && put_warnings(&of);
    if (well) put_lines(&of);
    if (well) explorer_write_fits(stream, of.view, machine);
    free(of.figures.items);
    whirl_findings_free(of.findings);
    whirl_result_view_free(of.view);
    return well;
}
