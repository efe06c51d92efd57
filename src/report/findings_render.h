/// Functions that renderers of findings share.
#ifndef REPORT_FINDINGS_RENDER_H
#define REPORT_FINDINGS_RENDER_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/internal/bearing_table.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

enum { STATEMENT_SIZE = 2048, SENTENCE_SIZE = 512 };

/// Makes the findings of a view of a result (whirl_result_by_attractor). machine: case of the result (machine_of), or
/// NULL. WHIRL_NO_MEMORY.
whirl_status findings_of(const whirl_result *view, const whirl_shown_units *units, const whirl_case *machine,
                         whirl_findings **findings);

/// Writes a statement: "separation margin, asked for 16 % (amplification 5): 12 % above: left at 3000 rpm: fails: 1 of
/// 4 peaks".
void statement_text(const whirl_statement *statement, char *text, size_t size);

/// Returns true if a column is empty in all rows. Only files for programs have such a column.
bool sheet_column_empty(const whirl_sheet *sheet, size_t column);

/// Writes a sheet as aligned text below its title. A sheet with more than `most` rows (at least 2) is cut to its first
/// rows and the last one. Returns false without memory.
bool sheet_write_text(FILE *stream, const whirl_sheet *sheet, size_t most);

/// Write a sheet as CSV, as LaTeX and as Markdown, in the form of whirl_sheet_write.
void sheet_write_csv(FILE *stream, const whirl_sheet *sheet);
void sheet_write_latex(FILE *stream, const whirl_sheet *sheet);
void sheet_write_markdown(FILE *stream, const whirl_sheet *sheet);

/// Writes statements and sheets of a table as text. points, rows: largest numbers of rows of sheets with a row for each
/// point, and of other sheets; SIZE_MAX: all, and sheets that summaries leave out. Returns false without memory.
bool findings_write_table(FILE *stream, const whirl_findings *findings, const char *table, size_t points, size_t rows);

/// Writes a warning about a point of a bearing, or about the bearing as a whole (point NULL). units: NULL for those of
/// its file. Returns false without memory.
bool bearing_remark_text(const whirl_bearing *bearing, const char *units, const whirl_bearing_point *point,
                         whirl_bearing_remark remark, char text[STATEMENT_SIZE]);

/// Writes a sheet as a JSON document. WHIRL_NO_MEMORY, WHIRL_IO_ERROR.
whirl_status sheet_write_json(const whirl_sheet *sheet, FILE *stream);

/// Return statements and sheets as parts of a JSON document.
json_t *statements_json(bool *well, const whirl_findings *findings);
json_t *sheets_json(bool *well, const whirl_findings *findings);

#endif
