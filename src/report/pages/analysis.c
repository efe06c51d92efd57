// Writes the pages of a lateral analysis (summary, machine, model, modes, responses with their margins, stability,
// nonlinear motions) and of a torsional one (train, interference, response to torques, runs).
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "found.h"
#include "html.h"
#include "page.h"
#include "page_findings.h"
#include "scaled_response.h"
#include "shown_kinds.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/case.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/engine/system.h"
#include "whirl/internal/model.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"
#include "whirl/version.h"

/// A chapter: all tables that have a certain field or, if it is NULL, all tables of motions.
typedef struct chapter {
    const char *title, *about, *field;
    const char *absent; ///< sentence if the result has no such table
} chapter;

/// A document.
typedef struct analysis_document {
    const char *title;
    const char *asks; ///< why a result may have no criteria
    size_t count;
    const chapter *chapters; ///< [count]
    bool moves;              ///< the document states it if the result has no motions
} analysis_document;

/// Returns true for the tables of a chapter (`by`).
static bool is_of_chapter(const whirl_table *table, const void *by) {
    const chapter *own = by;
    return own->field ? whirl_layout_field(&table->layout, own->field) != NULL : shown_kind_of(table) == &shown_motions;
}

/// Returns true for tables with findings that belong to no chapter of a document (`by`).
static bool is_of_no_chapter(const whirl_table *table, const void *by) {
    const analysis_document *document = by;
    for (size_t i = 0; i < document->count; i++)
        if (is_of_chapter(table, &document->chapters[i])) return false;
    return shown_kind_of(table) != &shown_motions;
}

// ---------------------------------------------------------------- summary

static void write_found(const page *to, const analysis_document *document) {
    fputs("<section id=\"found\">\n<h2>1. What was found</h2>\n<ol>\n", to->stream);
    found_statements(to, document->asks);
    if (document->moves && found_each(to, is_of_chapter, &(chapter){.field = NULL}, NULL, NULL) == 0)
        fputs("<li><strong>Nonlinear motions.</strong> Not computed (study: motions).</li>\n", to->stream);
    fputs("</ol>\n", to->stream);
    page_asked(to);
    fputs("</section>\n", to->stream);
}

// ---------------------------------------------------------------- chapters

/// Writes the statements and sheets of a table.
static void write_findings(const page *to, size_t result, const whirl_table *table) {
    page_statements(to, result, table);
    page_sheets(to, result, table);
}

/// State of a chapter that is being written: the kind of its last table, and its first table with its section.
typedef struct chapter_state {
    const shown_kind *kind;
    const whirl_table *first;
    char *section; ///< text of the first table's section; NULL: none yet
} chapter_state;

/// Returns the length of the text up to the end of its first HTML table; without a table, of the whole text.
static size_t part_length(const char *text) {
    static const char end[] = "</table></div>\n";
    const char *at = strstr(text, end);
    return at ? (size_t)(at - text) + sizeof end - 1 : strlen(text);
}

/// Writes a section; a part that repeats a part of the chapter's first section is replaced by a reference.
static void write_section(const page *to, const whirl_table *table, const char *section, const chapter_state *state) {
    const char *before = state->section && state->first != table ? state->section : "";
    bool same = false;
    while (*section) {
        const size_t length = part_length(section), other = part_length(before);
        const bool equal = length == other && strncmp(section, before, length) == 0;
        if (!equal) fwrite(section, 1, length, to->stream);
        if (equal && !same) {
            fputs("<p>", to->stream);
            html_printf(to->stream, "As %s.", state->first->name);
            fputs("</p>\n", to->stream);
        }
        same = equal;
        section += length;
        before += other;
    }
}

/// Writes all figures of a table except responses of stations that are not checked.
static void write_figures(const page *to, size_t result, const whirl_table *table) {
    const bool response = whirl_layout_field(&table->layout, WHIRL_FIELD_UNBALANCE_PROBE) != NULL;
    size_t left = 0;
    for (size_t i = 0; i < to->figures->count; i++) {
        const drawn_figure *what = &to->figures->items[i];
        if (what->table != table || what->whole) continue;
        const size_t station = what->name.station;
        if (!response || station == SIZE_MAX || scaled_response_checks(to->results[result], table, station))
            page_figure(to, what);
        else
            left++;
    }
    if (left > 0)
        fprintf(to->stream,
                "<p>%zu other station%s without probe, clearance or unbalance: see the figures next to this "
                "document.</p>\n",
                left, left == 1 ? "" : "s");
}

static void write_table(const page *to, size_t result, const whirl_table *table, void *context) {
    // Write a heading: the name of the table, and the values with which it was computed.
    const shown_kind *kind = shown_kind_of(table);
    chapter_state *state = context;
    char fact[2 * WHIRL_NAME_SIZE];
    snprintf(fact, sizeof fact, "%s with", table->name);
    const char *with = whirl_result_fact(to->results[result], fact);
    fputs("<h3>", to->stream);
    html_printf(to->stream, "%s%s%s", table->name, *with ? ", with " : "", with);
    fputs("</h3>\n", to->stream);
    write_figures(to, result, table);
    // Explain the kind of table once.
    if (kind != state->kind && kind->about) {
        fputs("<p>", to->stream);
        html_text(to->stream, kind->about);
        fputs("</p>\n", to->stream);
    }
    // Write statements and sheets, unless they repeat a part of the first table's section.
    state->kind = kind;
    char *section = page_text(to, write_findings, result, table);
    if (section) write_section(to, table, section, state);
    if (state->section) {
        free(section);
    } else {
        state->first = table;
        state->section = section;
    }
}

static const chapter lateral_chapters[] = {
    {"Loads and places of rest",
     "The weight carried by each bearing, sag and bending moments, places of rest, stiffness and damping of bearings; "
     "what elevations couplings ask for.",
     WHIRL_FIELD_STATICS_LOAD, "Not asked for (study: statics)."},
    {"Undamped critical speed map",
     "Critical speeds of the machine without damping, over the stiffness of its supports where the study says so.",
     WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, "Not asked for."},
    {"Damped modes",
     "Natural frequencies over the speed (Campbell diagram), critical speeds with damping, thresholds of stability, "
     "and "
     "shapes.",
     WHIRL_FIELD_MODES_FREQUENCY, "Not asked for."},
    {"Response to unbalance",
     "Amplitudes and lags that probes see, amplification factors and separation margins of the peaks, and responses "
     "scaled "
     "to the vibration limit, compared with clearances.",
     WHIRL_FIELD_UNBALANCE_AMPLITUDE, "Not asked for."},
    {"Stability", "Logarithmic decrements with bearings, stages, seals and impellers.", WHIRL_FIELD_STABILITY_BASIC,
     "Not asked for."},
    {"Nonlinear motions", "Motions in the real films with contacts, computed in time.", NULL, "Not asked for."},
};

static const chapter torsional_chapters[] = {
    {"Torsional modes and interference",
     "Natural frequencies over the speed with the excitations that meet them (interference diagram), their separation "
     "from the excitations where the machine runs, and shapes.",
     WHIRL_FIELD_MODES_TORSION, "Not asked for (study: modes)."},
    {"Response to torques",
     "Steady vibration by torques at orders of the speed and at fixed frequencies: vibratory torques with their shear "
     "stress, peaks with their modes, twists of the stations.",
     WHIRL_FIELD_TORSION_TORQUE, "Not asked for (study: torsion)."},
    {"Starts, short circuits and other runs",
     "Torques over time while motors turn the train: their extremes, their cycles by rain flow, and the damage of a "
     "run "
     "where the case gives S-N curves.",
     WHIRL_FIELD_RUNUP_TORQUE_OF, "Not asked for (study: runup, by torques)."},
};
enum { FIRST_CHAPTER = 3 };

const char *const analysis_names[ANALYSES] = {"lateral", "torsional"};

static const analysis_document documents[ANALYSES] = {
    [ANALYSIS_LATERAL] = {"Lateral analysis",
                          "no response to unbalance has its running speeds (running_from, running_to), and there is no "
                          "study of stability",
                          sizeof lateral_chapters / sizeof *lateral_chapters, lateral_chapters, true},
    [ANALYSIS_TORSIONAL] = {"Torsional analysis", "modes have no running speeds (running_from, running_to)",
                            sizeof torsional_chapters / sizeof *torsional_chapters, torsional_chapters, false},
};

static void write_chapter(const page *to, const chapter *own, size_t index) {
    chapter_state state = {.kind = NULL};
    fprintf(to->stream, "<section id=\"chapter-%zu\">\n<h2>%zu. %s</h2>\n<p>%s</p>\n", index, index + FIRST_CHAPTER,
            own->title, own->about);
    if (found_each(to, is_of_chapter, own, write_table, &state) == 0) fprintf(to->stream, "<p>%s</p>\n", own->absent);
    free(state.section);
    fputs("</section>\n", to->stream);
}

/// Writes a chapter with all tables that no other chapter has. Returns false, and writes nothing, if there are none.
static bool write_others(const page *to, const analysis_document *document, size_t index) {
    chapter_state state = {.kind = NULL};
    if (found_each(to, is_of_no_chapter, document, NULL, NULL) == 0) return false;
    fprintf(to->stream, "<section id=\"chapter-%zu\">\n<h2>%zu. Other studies</h2>\n", index, index + FIRST_CHAPTER);
    found_each(to, is_of_no_chapter, document, write_table, &state);
    free(state.section);
    fputs("</section>\n", to->stream);
    return true;
}

// ---------------------------------------------------------------- machine and model

static void write_machine(const page *to) {
    fputs("<section id=\"machine\">\n<h2>2. Machine and model</h2>\n", to->stream);
    for (size_t r = 0; r < to->count; r++) {
        const whirl_result *result = to->results[r];
        fputs("<h3>", to->stream);
        html_text(to->stream, *result->title ? result->title : to->names[r]);
        fputs("</h3>\n", to->stream);
        page_warnings(to, r);
        page_machine(to, r);
        page_statements(to, r, NULL);
        page_sheets(to, r, NULL);
        page_parameters(to, r);
    }
    fputs("</section>\n", to->stream);
}

// ---------------------------------------------------------------- the whole

static void write_appendix(const page *to, size_t chapters) {
    fprintf(to->stream, "<section id=\"appendix\">\n<h2>%zu. Appendix</h2>\n", chapters + FIRST_CHAPTER);
    fputs("<p>Amplitudes say whether they are zero to peak (0-p) or peak to peak (p-p).</p>\n", to->stream);
    for (size_t r = 0; r < to->count; r++) {
        page_computed(to, r);
        page_provenance(to, r);
        if (!to->results[r]->case_text) continue;
        fputs("<h3>The case</h3>\n<pre class=\"whole-case\">", to->stream);
        html_text(to->stream, to->results[r]->case_text);
        fputs("</pre>\n", to->stream);
    }
    fputs("</section>\n", to->stream);
}

void analysis_write(const page *to, analysis_kind kind) {
    const analysis_document *document = &documents[kind];
    char title[512];
    const char *of = to->count == 1 && *to->results[0]->title ? to->results[0]->title : to->names[0];
    snprintf(title, sizeof title, "%s: %.400s", document->title, to->count > 0 ? of : "");
    page_head(to, title);
    page_document(to);
    fputs("<p class=\"soft\">Written by whirl " WHIRL_VERSION ".</p>\n</header>\n<main>\n", to->stream);
    write_found(to, document);
    write_machine(to);
    for (size_t i = 0; i < document->count; i++) write_chapter(to, &document->chapters[i], i);
    const bool others = write_others(to, document, document->count);
    write_appendix(to, document->count + others);
    fputs("</main>\n</body>\n</html>\n", to->stream);
}
