/// What was found, as data: statements, and tables as documents show them. Derived once, from the fields of a result;
/// renderers (text, HTML, JSON, CSV, LaTeX) know none by its name.
#ifndef WHIRL_FINDINGS_H
#define WHIRL_FINDINGS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A verdict on what is asked of a machine. Rising: of several verdicts the largest counts.
typedef enum whirl_judgement {
    WHIRL_NOT_ASKED, ///< nothing is asked for
    WHIRL_HOLDS,     ///< what is asked for was found
    WHIRL_NOT_KNOWN, ///< what was computed does not tell
    WHIRL_FAILS      ///< what was found is not enough
} whirl_judgement;

/// "none asked for", "holds", "not known", "fails". Static text.
const char *whirl_judgement_name(whirl_judgement judgement);

/// A piece of a phrase: a text, or a number with what it is.
typedef struct whirl_piece {
    const char *text; ///< NULL: a number
    double value;     ///< in SI (whirl_quantity)
    const char *unit; ///< in which it is shown, "" of none
    double size;      ///< of that unit: value / size is shown, less
    double zero;      ///< of temperatures (whirl_shown_units.zero); else 0
    int digits;       ///< significant ones
} whirl_piece;

enum { WHIRL_PHRASE_PIECES = 24 };

/// A sentence, or a part of one, whose numbers are still numbers.
typedef struct whirl_phrase {
    size_t count;                            ///< of pieces
    whirl_piece pieces[WHIRL_PHRASE_PIECES]; ///< [count]
} whirl_phrase;

/// One finding about a machine.
typedef struct whirl_statement {
    const char *what;          ///< "separation margin"
    const char *table;         ///< name of the table of the result that it is of
    const char *station;       ///< or ""
    const char *clause;        ///< of the standard that asks for it; "" where none does
    whirl_judgement judgement; ///< whether it holds
    whirl_phrase at;           ///< the value of the table's parameter that it is of; empty: of the whole table
    whirl_phrase asked;        ///< what is asked for; empty where nothing is
    whirl_phrase found;        ///< what was found
    whirl_phrase told;         ///< the judgement in words, with its reason; empty where nothing is asked for
} whirl_statement;

/// A column of a sheet.
typedef struct whirl_column {
    const char *key;     ///< in JSON and CSV: "amplification"
    const char *heading; ///< without its unit
    const char *unit;    ///< in which its numbers are shown, "" of none
    double size;         ///< of that unit: number / size is shown, less
    double zero;         ///< of temperatures (whirl_shown_units.zero); else 0
    int digits;          ///< significant ones; 0: a column of texts
    const char *between; ///< between several numbers of a cell: ", " or " to "; NULL: each cell has one
} whirl_column;

/// A cell: a text, numbers, or nothing.
typedef struct whirl_cell {
    const char *text;      ///< NULL: none
    size_t count;          ///< of numbers; 0: none
    double number;         ///< the first one, in SI
    const double *numbers; ///< [count] where there are several; else NULL
} whirl_cell;

/// A table as documents show it.
typedef struct whirl_sheet {
    const char *name;     ///< "peaks": no other of its table has it
    const char *title;    ///< one line
    const char *table;    ///< name of the table of the result that it is of
    const char *about;    ///< sentences that explain it, or ""
    size_t columns, rows; ///< of cells
    bool of_points;       ///< a row is a point: summaries show the first and the last alone
    whirl_column *column; ///< [columns]
    whirl_cell *cells;    ///< [rows][columns]
    size_t given;         ///< cells of the last row that were filled in
} whirl_sheet;

/// All that was found.
typedef struct whirl_findings {
    size_t statement_count, sheet_count; ///< of the next two
    whirl_statement *statements;         ///< [statement_count]
    whirl_sheet *sheets;                 ///< [sheet_count]
    void *memory;                        ///< of all texts and numbers
    bool failed;                         ///< memory was lacking while it was made
} whirl_findings;

/// What was found in a result, table by table in their order; `units` as whirl_result_shown_units has them. Borrows
/// the result. Freed by whirl_findings_free. WHIRL_NO_MEMORY, WHIRL_BAD_INPUT for words that are no units.
whirl_status whirl_findings_new(const whirl_result *result, const char *units, whirl_findings **findings);

/// Frees findings; NULL is none.
void whirl_findings_free(whirl_findings *findings);

/// The sheet of that name, "peaks", or "TABLE/peaks" where several tables have one. WHIRL_BAD_INPUT with a sentence,
/// and the nearest name, for one that is not there, or is there more than once.
whirl_status whirl_findings_sheet(const whirl_findings *findings, const char *name, const whirl_sheet **sheet);

/// The heading of a column with its unit: "speed (rpm)".
void whirl_column_heading(const whirl_column *column, char *text, size_t size);

/// A cell as it is shown, without its unit; "" of an empty one.
void whirl_cell_text(const whirl_column *column, const whirl_cell *cell, char *text, size_t size);

/// A phrase as it is shown.
void whirl_phrase_text(const whirl_phrase *phrase, char *text, size_t size);

/// The name by which whirl_findings_sheet knows a sheet of these findings: "peaks", or "TABLE/peaks" where several
/// tables have one.
void whirl_sheet_name(const whirl_findings *findings, const whirl_sheet *sheet, char *text, size_t size);

/// How sheets are written to files.
typedef enum whirl_sheet_form {
    WHIRL_SHEET_TEXT,
    WHIRL_SHEET_CSV,
    WHIRL_SHEET_LATEX,
    WHIRL_SHEET_JSON
} whirl_sheet_form;

/// The form of a name: "text", "csv", "latex" or "json". WHIRL_BAD_INPUT for any other.
whirl_status whirl_sheet_form_of(const char *name, whirl_sheet_form *form);

/// Writes a sheet: aligned text, CSV (RFC 4180, numbers as they are shown with all their digits), a LaTeX table with
/// rules of booktabs, or JSON as whirl_findings_write_json has it. Text and LaTeX leave out columns that are empty.
/// WHIRL_NO_MEMORY, WHIRL_IO_ERROR.
whirl_status whirl_sheet_write(const whirl_sheet *sheet, whirl_sheet_form form, FILE *stream);

/// Writes statements and sheets as lines of text: of statements that say the same of many points ("warning") the first
/// 20. For findings of one subject, such as a bearing's. WHIRL_NO_MEMORY.
whirl_status whirl_findings_write_text(const whirl_findings *findings, FILE *stream);

/// Writes statements and sheets as one JSON object: numbers in SI beside what is shown (docs/result-file.md,
/// "Findings as JSON"). WHIRL_NO_MEMORY, WHIRL_IO_ERROR.
whirl_status whirl_findings_write_json(const whirl_findings *findings, FILE *stream);

#ifdef __cplusplus
}
#endif

#endif
