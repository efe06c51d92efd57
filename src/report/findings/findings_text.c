// Writes findings as texts: numbers, phrases, headings, and sheets as aligned text, CSV, LaTeX and Markdown.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "findings_render.h"
#include "number_shown.h"
#include "number_text.h"
#include "whirl/internal/findings.h"

enum { CELL_SIZE = 1024 };

/// Appends formatted text, cut off at the buffer's end.
#define APPEND(text, size, ...) snprintf((text) + strlen(text), (size)-strlen(text), __VA_ARGS__)

void number_shown(double number, int digits, char *text, size_t size) {
    const double plain = 1e7;
    snprintf(text, size, "%.*g", digits, number);
    // Write "1.4028e+05" as 140280.
    if (strchr(text, 'e') && fabs(number) >= 1.0 && fabs(number) < plain)
        snprintf(text, size, "%.0f", strtod(text, NULL));
}

void whirl_phrase_text(const whirl_phrase *phrase, char *text, size_t size) {
    char number[NUMBER_SIZE];
    *text = '\0';
    for (size_t i = 0; i < phrase->count; i++) {
        const whirl_piece *piece = &phrase->pieces[i];
        if (piece->text) {
            APPEND(text, size, "%s", piece->text);
            continue;
        }
        number_shown(piece->value / piece->size - piece->zero, piece->digits, number, sizeof number);
        APPEND(text, size, "%s%s%s", number, *piece->unit ? " " : "", piece->unit);
    }
}

void whirl_column_heading(const whirl_column *column, char *text, size_t size) {
    snprintf(text, size, *column->unit ? "%s (%s)" : "%s", column->heading, column->unit);
}

/// Writes the text of a cell with a given number of digits.
static void cell_write_text(const whirl_column *column, const whirl_cell *cell, int digits, char *text, size_t size) {
    char shown[NUMBER_SIZE];
    *text = '\0';
    if (cell->text) snprintf(text, size, "%s", cell->text);
    for (size_t i = 0; i < cell->count; i++) {
        const double number = cell->numbers ? cell->numbers[i] : cell->number;
        number_shown(number / column->size - column->zero, digits, shown, sizeof shown);
        APPEND(text, size, "%s%s", i ? column->between : "", shown);
    }
}

void whirl_cell_text(const whirl_column *column, const whirl_cell *cell, char *text, size_t size) {
    cell_write_text(column, cell, column->digits, text, size);
}

void statement_text(const whirl_statement *statement, char *text, size_t size) {
    char part[STATEMENT_SIZE];
    *text = '\0';
    if (statement->at.count > 0) {
        whirl_phrase_text(&statement->at, part, sizeof part);
        APPEND(text, size, "at %s: ", part);
    }
    APPEND(text, size, "%s%s%s", statement->what, *statement->station ? " at " : "", statement->station);
    const whirl_phrase *const phrases[] = {&statement->asked, &statement->found, &statement->judged};
    static const char *const before[] = {", asked for ", ": ", ": "};
    for (size_t i = 0; i < 3; i++) {
        if (phrases[i]->count == 0) continue;
        whirl_phrase_text(phrases[i], part, sizeof part);
        APPEND(text, size, "%s%s", before[i], part);
    }
}

bool sheet_column_empty(const whirl_sheet *sheet, size_t column) {
    for (size_t r = 0; r < sheet->rows; r++) {
        const whirl_cell *cell = &sheet->cells[r * sheet->columns + column];
        if (cell->count > 0 || (cell->text && *cell->text)) return false;
    }
    return true;
}

// ---------------------------------------------------------------- aligned text
// A sheet has its headings above the rows; a few rows that are wider than a terminal have them on the left.

enum { MAX_WIDTH = 118, MAX_BESIDE = 3 };

/// A sheet as a grid of texts, without empty columns; the first line has the headings.
typedef struct text_grid {
    size_t lines, columns;
    char **texts;   ///< [lines][columns]
    bool *right;    ///< [columns] true for numbers, which are aligned right
    size_t *widths; ///< [columns] letters of the longest text
} text_grid;

static void grid_free(text_grid *grid) {
    for (size_t i = 0; grid->texts && i < grid->lines * grid->columns; i++) free(grid->texts[i]);
    free(grid->texts);
    free(grid->right);
    free(grid->widths);
}

/// Returns the number of letters of a text in UTF-8, its columns in a terminal.
static size_t letters_of(const char *text) {
    size_t count = 0;
    for (; *text; text++) count += ((unsigned char)*text & 0xC0u) != 0x80u;
    return count;
}

/// Measures the columns; returns false without memory.
static bool grid_measure(text_grid *grid) {
    grid->widths = calloc(grid->columns + 1, sizeof *grid->widths);
    for (size_t i = 0; grid->widths && i < grid->lines * grid->columns; i++) {
        size_t *widest = &grid->widths[i % grid->columns];
        const size_t own = letters_of(grid->texts[i]);
        if (own > *widest) *widest = own;
    }
    return grid->widths != NULL;
}

/// Makes the grid of rows [count] of a sheet. Returns false without memory.
static bool grid_make(const whirl_sheet *sheet, const size_t *rows, size_t count, text_grid *grid) {
    char text[CELL_SIZE];
    // Count the columns that have any text, and make memory for them.
    *grid = (text_grid){.lines = count + 1};
    for (size_t c = 0; c < sheet->columns; c++) grid->columns += !sheet_column_empty(sheet, c);
    grid->texts = calloc(grid->lines * grid->columns + 1, sizeof *grid->texts);
    grid->right = calloc(grid->columns + 1, sizeof *grid->right);
    bool well = grid->texts && grid->right;
    // Fill in headings and texts; numbers are aligned to the right.
    for (size_t c = 0, to = 0; c < sheet->columns && well; c++) {
        const whirl_column *column = &sheet->column[c];
        if (sheet_column_empty(sheet, c)) continue;
        grid->right[to] = column->digits > 0 && !column->between;
        for (size_t line = 0; line < grid->lines && well; line++) {
            if (line == 0)
                whirl_column_heading(column, text, sizeof text);
            else
                whirl_cell_text(column, &sheet->cells[rows[line - 1] * sheet->columns + c], text, sizeof text);
            grid->texts[line * grid->columns + to] = strdup(text);
            well = grid->texts[line * grid->columns + to] != NULL;
        }
        to++;
    }
    well = well && grid_measure(grid);
    if (!well) grid_free(grid);
    return well;
}

/// Transposes the grid; returns false without memory, with the grid unchanged.
static bool grid_turn(text_grid *grid) {
    text_grid turned = {.lines = grid->columns,
                        .columns = grid->lines,
                        .texts = calloc(grid->lines * grid->columns + 1, sizeof *turned.texts),
                        .right = calloc(grid->lines + 1, sizeof *turned.right)};
    for (size_t line = 0; line < grid->lines && turned.texts; line++)
        for (size_t c = 0; c < grid->columns; c++)
            turned.texts[c * turned.columns + line] = grid->texts[line * grid->columns + c];
    const bool well = turned.texts && turned.right && grid_measure(&turned);
    text_grid *const old = well ? grid : &turned;
    free(old->texts);
    free(old->right);
    free(old->widths);
    if (well) *grid = turned;
    return well;
}

static void grid_write(FILE *stream, const text_grid *grid) {
    for (size_t line = 0; line < grid->lines; line++) {
        fputs("   ", stream);
        for (size_t c = 0; c < grid->columns; c++) {
            const char *text = grid->texts[line * grid->columns + c];
            const int gap = (int)(grid->widths[c] - letters_of(text));
            const bool last = c + 1 == grid->columns;
            fprintf(stream, " %*s%s", grid->right[c] ? gap : 0, "", text);
            if (!grid->right[c] && !last) fprintf(stream, "%*s", gap, "");
            fputs(last ? "\n" : " ", stream);
        }
    }
}

bool sheet_write_text(FILE *stream, const whirl_sheet *sheet, size_t most) {
    size_t *rows = calloc(sheet->rows + 1, sizeof *rows), count = 0, width = 0;
    text_grid grid;
    if (!rows) return false;
    for (size_t r = 0; r < sheet->rows; r++)
        if (r + 1 == sheet->rows || r + 1 < most) rows[count++] = r;
    bool well = grid_make(sheet, rows, count, &grid);
    free(rows);
    if (!well) return false;
    fprintf(stream, "  %s", sheet->title);
    if (count < sheet->rows && count <= 2)
        fprintf(stream, " (the first and the last of %zu rows)", sheet->rows);
    else if (count < sheet->rows)
        fprintf(stream, " (%zu of %zu rows)", count, sheet->rows);
    fputs(":\n", stream);
    for (size_t c = 0; c < grid.columns; c++) width += grid.widths[c] + 2;
    if (width > MAX_WIDTH && count <= MAX_BESIDE) well = grid_turn(&grid);
    if (well) grid_write(stream, &grid);
    grid_free(&grid);
    return well;
}

// ---------------------------------------------------------------- CSV, LaTeX and Markdown

/// Writes a CSV field (RFC 4180), quoted if necessary.
static void write_field(FILE *stream, const char *text) {
    if (!text[strcspn(text, "\",\n\r")]) {
        fputs(text, stream);
        return;
    }
    fputc('"', stream);
    for (; *text; text++) fputs(*text == '"' ? "\"\"" : (char[]){*text, '\0'}, stream);
    fputc('"', stream);
}

/// Writes a text with LaTeX's special characters escaped.
static void write_letters(FILE *stream, const char *text) {
    for (; *text; text++) {
        if (strncmp(text, "\u00b5", 2) == 0) {
            fputs("$\\mu$", stream);
            text++;
        } else if (strncmp(text, "+-", 2) == 0) {
            fputs("$\\pm$", stream);
            text++;
        } else if (*text == '\\' || *text == '~' || *text == '^') {
            fprintf(stream, *text == '\\' ? "\\textbackslash{}" : *text == '~' ? "\\textasciitilde{}" : "\\^{}");
        } else {
            fprintf(stream, strchr("&%$#_{}", *text) ? "\\%c" : "%c", *text);
        }
    }
}

/// Writes a row (0: the headings), with separators between cells and an end. digits: significant digits of numbers in a
/// file for programs, which has all columns; 0: each column's own digits, without empty columns.
static void write_cells(FILE *stream, const whirl_sheet *sheet, size_t row, void (*write)(FILE *, const char *),
                        int digits, const char *between, const char *end) {
    const bool drop = digits == 0; // a file for programs has all columns
    char text[CELL_SIZE];
    bool first = true;
    for (size_t c = 0; c < sheet->columns; c++) {
        const whirl_column *column = &sheet->column[c];
        if (drop && sheet_column_empty(sheet, c)) continue;
        if (row == 0)
            whirl_column_heading(column, text, sizeof text);
        else
            cell_write_text(column, &sheet->cells[(row - 1) * sheet->columns + c], digits ? digits : column->digits,
                            text, sizeof text);
        if (!first) fputs(between, stream);
        first = false;
        write(stream, text);
    }
    fputs(end, stream);
}

void sheet_write_latex(FILE *stream, const whirl_sheet *sheet) {
    fputs("\\begin{tabular}{", stream);
    for (size_t c = 0; c < sheet->columns; c++)
        if (!sheet_column_empty(sheet, c))
            fputc(sheet->column[c].digits > 0 && !sheet->column[c].between ? 'r' : 'l', stream);
    fputs("}\n\\toprule\n", stream);
    for (size_t row = 0; row <= sheet->rows; row++) {
        write_cells(stream, sheet, row, write_letters, 0, " & ", " \\\\\n");
        if (row == 0) fputs("\\midrule\n", stream);
    }
    fputs("\\bottomrule\n\\end{tabular}\n", stream);
}

/// Writes a text with Markdown's separators of cells escaped.
static void write_piped(FILE *stream, const char *text) {
    for (; *text; text++) fprintf(stream, *text == '|' ? "\\%c" : "%c", *text);
}

void sheet_write_markdown(FILE *stream, const whirl_sheet *sheet) {
    for (size_t row = 0; row <= sheet->rows; row++) {
        fputs("| ", stream);
        write_cells(stream, sheet, row, write_piped, 0, " | ", " |\n");
        for (size_t c = 0; c < sheet->columns && row == 0; c++)
            if (!sheet_column_empty(sheet, c))
                fputs(sheet->column[c].digits > 0 && !sheet->column[c].between ? "|---:" : "|---", stream);
        if (row == 0) fputs("|\n", stream);
    }
}

void sheet_write_csv(FILE *stream, const whirl_sheet *sheet) {
    enum { ALL_DIGITS = 17 };
    for (size_t row = 0; row <= sheet->rows; row++)
        write_cells(stream, sheet, row, write_field, ALL_DIGITS, ",", "\r\n");
}
