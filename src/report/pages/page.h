// Writes the HTML page of a report, section by section.
#ifndef REPORT_PAGE_H
#define REPORT_PAGE_H

#include "claim_parts.h"
#include "whirl/engine/claims.h"
#include "whirl/engine/figure.h"
#include "whirl/engine/result.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"

#include <stdbool.h>
#include <stdio.h>

enum { FOLDER_NAME_SIZE = 96, FIGURE_FILE_SIZE = 208 };

/// A figure of a report: NAME.png, NAME.pdf, NAME.gp and NAME.dat in the folder of its result.
typedef struct drawn_figure {
    size_t result;            ///< index of the result it shows
    const whirl_table *table; ///< its table
    whirl_figure_name name;
    char caption[900];
    bool whole; ///< a drawing of the machine, not of a table's points
    bool drawn; ///< gnuplot made its pictures
} drawn_figure;

typedef struct drawn_figures {
    size_t count;
    drawn_figure *items;
} drawn_figures;

/// Content of a page. All pointers are borrowed.
typedef struct page {
    FILE *stream;
    const whirl_result *const *results;      ///< [count]
    const char *const *names;                ///< [count] as the caller names them
    const char (*folders)[FOLDER_NAME_SIZE]; ///< [count] folders of the results' files, next to the page
    size_t count;
    const whirl_claims *claims;    ///< NULL: none
    const claim_outcome *outcomes; ///< [claims->count][count]
    const drawn_figures *figures;
    const whirl_shown_units *units;    ///< [count]
    whirl_findings *const *findings;   ///< [count]
    const whirl_case *const *machines; ///< [count] cases of the results (machine_of)
    bool *failed;                      ///< becomes true if memory is missing for a part of the page
    bool explorer;                     ///< explorer.html is next to the page
    bool printed;                      ///< for printing: all figures are loaded at once
} page;

/// Writes the whole page.
void page_write(const page *to);

/// Kinds of documents of an analysis; their chapters have the usual order of such reports.
typedef enum analysis_kind { ANALYSIS_LATERAL, ANALYSIS_TORSIONAL, ANALYSES } analysis_kind;

/// Names of the documents' files, without ending: "lateral", "torsional".
extern const char *const analysis_names[ANALYSES];

/// Writes the page of an analysis.
void analysis_write(const page *to, analysis_kind kind);

/// Write the sections of a page.
void page_head(const page *to, const char *title);
void page_document(const page *to); ///< tag, customer, revision, ... of the first result
void page_style(FILE *stream);
void page_claims(const page *to);               ///< the table of claims, and claims that were not reproduced
void page_found(const page *to, size_t result); ///< verdicts in numbers, and the main figure
void page_parameters(const page *to, size_t result);
void page_computed(const page *to, size_t result); ///< computed tables, parameters
void page_warnings(const page *to, size_t result); ///< warnings of the run
void page_provenance(const page *to, size_t result);
const char *
page_diagrams_title(const whirl_result *result);  ///< title of a result's diagrams over parameters; static text
void page_machine(const page *to, size_t result); ///< the machine's drawing
void page_figures(const page *to, size_t result); ///< all figures except the machine's drawing and the main one
void page_figure(const page *to, const drawn_figure *what);
const drawn_figure *page_main_figure(const page *to,
                                     size_t result); ///< first diagram of a result; NULL without one

#endif
