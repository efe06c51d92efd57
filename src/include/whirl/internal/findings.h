/// Findings as data: statements, and tables as documents show them. They are derived once from the fields of a result;
/// renderers (text, HTML, JSON, CSV, LaTeX) treat all of them alike.
#ifndef WHIRL_FINDINGS_H
#define WHIRL_FINDINGS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Judgements on a requirement, in rising order: of several the largest counts.
typedef enum whirl_judgement {
    WHIRL_NOT_ASKED, ///< there is no requirement
    WHIRL_HOLDS,     ///< the requirement is met
    WHIRL_NOT_KNOWN, ///< the computed results do not decide
    WHIRL_FAILS      ///< the requirement is not met
} whirl_judgement;

/// Returns "none asked for", "holds", "not known" or "fails". Static text.
const char *whirl_judgement_name(whirl_judgement judgement);

/// A piece of a phrase: a text, or a number with its unit.
typedef struct whirl_piece {
    const char *text; ///< NULL: a number
    double value;     ///< in SI (whirl_quantity)
    const char *unit; ///< unit in which it is shown, "" for none
    double size;      ///< size of that unit: value / size - zero is shown
    double zero;      ///< offset of temperatures (whirl_shown_units.zero); else 0
    int digits;       ///< significant digits
} whirl_piece;

/// A sentence, or a part of one, with its numbers as numbers.
typedef struct whirl_phrase {
    size_t count;        ///< number of pieces
    whirl_piece *pieces; ///< [count]
} whirl_phrase;

/// One finding about a machine.
typedef struct whirl_statement {
    const char *what;          ///< "separation margin"
    const char *table;         ///< name of the result's table
    const char *station;       ///< or ""
    const char *clause;        ///< clause of the standard with the requirement; "" for none
    whirl_judgement judgement; ///< judgement on the requirement
    whirl_phrase at;           ///< its value of the table's parameter; empty: the whole table
    whirl_phrase asked;        ///< the requirement; empty for none
    whirl_phrase found;        ///< the finding
    whirl_phrase judged;       ///< the judgement in words, with its reason; empty without a requirement
} whirl_statement;

/// A column of a sheet.
typedef struct whirl_column {
    const char *key;     ///< name in JSON and CSV: "amplification"
    const char *heading; ///< heading without the unit
    const char *unit;    ///< unit in which its numbers are shown, "" for none
    double size;         ///< size of that unit: number / size - zero is shown
    double zero;         ///< offset of temperatures (whirl_shown_units.zero); else 0
    int digits;          ///< significant digits; 0: a column of texts
    const char *between; ///< separator of several numbers in a cell: ", " or " to "; NULL: one number per cell
    const char *meaning; ///< meaning of the numbers, in a sentence; NULL if the heading says it
} whirl_column;

/// A cell: a text, numbers, or nothing.
typedef struct whirl_cell {
    const char *text;      ///< NULL: none
    size_t count;          ///< number of numbers; 0: none
    double number;         ///< the first number, in SI
    const double *numbers; ///< [count] if there are several; else NULL
    const char *colour;    ///< colour of a regime or an attractor in figures, "#366EFB"; NULL: none
} whirl_cell;

/// A table as documents show it.
typedef struct whirl_sheet {
    const char *name;     ///< "peaks": unique within its table
    const char *title;    ///< one line
    const char *table;    ///< name of the result's table
    const char *about;    ///< sentences that explain it, or ""
    size_t columns, rows; ///< numbers of columns and rows
    bool of_points;       ///< rows are points: summaries show only the first and the last
    bool looked_up;       ///< pages fold it, and summaries leave it out
    bool unsummarized;    ///< summaries leave it out, as statements say the same or it is long
    whirl_column *column; ///< [columns]
    whirl_cell *cells;    ///< [rows][columns]
    size_t given;         ///< number of cells of the last row that are filled
} whirl_sheet;

/// All findings of a result, bearing or rotor.
typedef struct whirl_findings {
    size_t statement_count, sheet_count; ///< lengths of the following arrays
    whirl_statement *statements;         ///< [statement_count]
    whirl_sheet *sheets;                 ///< [sheet_count]
    void *memory;                        ///< memory of all texts and numbers
    bool failed;                         ///< true if memory was exhausted while the findings were built
} whirl_findings;

/// Builds the findings of a result, table by table in order; `units` as in whirl_result_shown_units. Borrows the
/// result. Freed by whirl_findings_free. WHIRL_NO_MEMORY, WHIRL_BAD_INPUT for words that are not units.
whirl_status whirl_findings_new(const whirl_result *result, const char *units, whirl_findings **findings);

/// Frees findings; accepts NULL.
void whirl_findings_free(whirl_findings *findings);

/// Finds the sheet of that name: "peaks", or "TABLE/peaks" if several tables have one. WHIRL_BAD_INPUT with a sentence,
/// and the nearest name, for a name that is unknown or ambiguous.
whirl_status whirl_findings_sheet(const whirl_findings *findings, const char *name, const whirl_sheet **sheet);

/// Writes the heading of a column with its unit: "speed (rpm)".
void whirl_column_heading(const whirl_column *column, char *text, size_t size);

/// Writes a cell as shown, without its unit; "" for an empty one.
void whirl_cell_text(const whirl_column *column, const whirl_cell *cell, char *text, size_t size);

/// Writes a phrase as shown.
void whirl_phrase_text(const whirl_phrase *phrase, char *text, size_t size);

/// Writes a sentence of a result, such as whirl_result_warning, with its numbers in the shown units: "5 MPa" is
/// "725.2 psi". A number keeps its digits, from four to six; a unit without a choice stays, but K follows the
/// documents.
void whirl_shown_sentence(const whirl_shown_units *units, const char *sentence, char *text, size_t size);

/// Writes the name of a sheet for whirl_findings_sheet: "peaks", or "TABLE/peaks" if several tables have one.
void whirl_sheet_name(const whirl_findings *findings, const whirl_sheet *sheet, char *text, size_t size);

/// File formats of sheets.
typedef enum whirl_sheet_form {
    WHIRL_SHEET_TEXT,
    WHIRL_SHEET_CSV,
    WHIRL_SHEET_LATEX,
    WHIRL_SHEET_MARKDOWN,
    WHIRL_SHEET_JSON
} whirl_sheet_form;

/// Returns the format of a name: "text", "csv", "latex", "markdown" or "json". WHIRL_BAD_INPUT for any other.
whirl_status whirl_sheet_form_of(const char *name, whirl_sheet_form *form);

/// Writes a sheet: aligned text, CSV (RFC 4180, numbers in shown units with all their digits), a LaTeX table with rules
/// of booktabs, a Markdown table, or JSON as in whirl_findings_write_json. Text, LaTeX and Markdown omit empty columns.
/// WHIRL_NO_MEMORY, WHIRL_IO_ERROR.
whirl_status whirl_sheet_write(const whirl_sheet *sheet, whirl_sheet_form form, FILE *stream);

/// Writes statements and sheets as lines of text; of statements that repeat for many points ("warning") only the first
/// 20. For findings of one subject, such as a bearing. WHIRL_NO_MEMORY.
whirl_status whirl_findings_write_text(const whirl_findings *findings, FILE *stream);

/// Writes statements and sheets as one JSON object, with numbers in SI and as shown (docs/result-file.md, "Findings as
/// JSON"). WHIRL_NO_MEMORY, WHIRL_IO_ERROR.
whirl_status whirl_findings_write_json(const whirl_findings *findings, FILE *stream);

#ifdef __cplusplus
}
#endif

#endif
