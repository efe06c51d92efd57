// Builds findings: their memory, statements and sheets.
#include "findings_build.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "arena.h"

const char *whirl_judgement_name(whirl_judgement judgement) {
    static const char *const names[] = {"none asked for", "holds", "not known", "fails"};
    return names[judgement];
}

// ---------------------------------------------------------------- memory

/// Memory of texts and numbers, and a statement and a sheet to which calls write after a failed allocation; the
/// findings are then discarded.
typedef struct find_memory {
    memory_arena arena;
    whirl_statement statement;
    whirl_piece piece;
    whirl_sheet sheet;
    whirl_cell cell;
} find_memory;

static find_memory *find_lost(const finder *of) {
    of->findings->failed = true;
    return of->findings->memory;
}

static void *find_take(whirl_findings *findings, size_t size) {
    find_memory *memory = findings->memory;
    void *taken = findings->failed ? NULL : arena_take(&memory->arena, size);
    if (!taken) findings->failed = true;
    return taken;
}

static const char *find_copy(whirl_findings *findings, const char *format, va_list arguments) {
    char text[2048];
    const int length = vsnprintf(text, sizeof text, format, arguments);
    char *copy = find_take(findings, (size_t)(length < 0 ? 0 : length) + 1);
    if (!copy) return "";
    return memcpy(copy, text, strlen(text) + 1);
}

const char *find_text(whirl_findings *findings, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const char *text = find_copy(findings, format, arguments);
    va_end(arguments);
    return text;
}

/// Makes room for one more item in an array of `count` items, whose size doubles; returns false without memory.
static bool find_room(whirl_findings *findings, void **items, size_t count, size_t size) {
    if (findings->failed) return false;
    if ((count & (count - 1)) != 0) return true;
    void *larger = realloc(*items, (count ? 2 * count : 1) * size);
    if (larger) *items = larger;
    findings->failed = !larger;
    return larger != NULL;
}

size_t find_ends(const whirl_table *table, size_t ends[2]) {
    size_t count = 0;
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        if (count == 0) ends[count++] = point;
        ends[1] = point;
    }
    return count > 0 && ends[1] > ends[0] ? 2 : count;
}

// ---------------------------------------------------------------- statements

whirl_statement *find_statement(const finder *of, const char *what) {
    whirl_findings *all = of->findings;
    void *items = all->statements;
    if (!find_room(all, &items, all->statement_count, sizeof *all->statements)) return &find_lost(of)->statement;
    all->statements = items;
    whirl_statement *own = &all->statements[all->statement_count++];
    *own = (whirl_statement){.what = what, .table = find_text(all, "%s", of->table->name), .station = "", .clause = ""};
    return own;
}

whirl_statement *find_judgement(const finder *of, const char *what, const char *clause, whirl_judgement judgement) {
    whirl_statement *own = find_statement(of, what);
    own->clause = clause;
    own->judgement = judgement;
    phrase_text(of, &own->judged, "%s", whirl_judgement_name(judgement));
    return own;
}

whirl_phrase *find_at(const finder *of, size_t point, const char *what) {
    whirl_statement *own = find_statement(of, what);
    statement_value(of, own, point);
    return &own->found;
}

/// Returns a new piece of a phrase. Room for pieces doubles when it is full.
static whirl_piece *phrase_piece(const finder *of, whirl_phrase *phrase) {
    const size_t count = phrase->count;
    if ((count & (count - 1)) == 0) {
        whirl_piece *larger = find_take(of->findings, (count ? 2 * count : 1) * sizeof *larger);
        if (!larger) return &find_lost(of)->piece;
        if (count > 0) memcpy(larger, phrase->pieces, count * sizeof *larger);
        phrase->pieces = larger;
    }
    return &phrase->pieces[phrase->count++];
}

void phrase_text(const finder *of, whirl_phrase *phrase, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    *phrase_piece(of, phrase) = (whirl_piece){.text = find_copy(of->findings, format, arguments)};
    va_end(arguments);
}

/// Turns -0 into 0.
static double unsigned_zero(double number) {
    return number == 0.0 ? 0.0 : number;
}

void phrase_unit(const finder *of, whirl_phrase *phrase, const whirl_unit *unit, int digits, double value) {
    *phrase_piece(of, phrase) = (whirl_piece){.value = unsigned_zero(value),
                                              .unit = find_text(of->findings, "%s", unit->name),
                                              .size = unit->size,
                                              .digits = digits};
}

void phrase_number(const finder *of, whirl_phrase *phrase, whirl_quantity quantity, int digits, double value) {
    phrase_unit(of, phrase, &of->units->of[quantity], digits, value);
    if (quantity == WHIRL_QUANTITY_TEMPERATURE) phrase->pieces[phrase->count - 1].zero = of->units->zero;
}

void phrase_value(const finder *of, whirl_phrase *phrase, int digits, double value) {
    const whirl_unit unit = whirl_shown_parameter(of->units, of->table->parameter);
    phrase_unit(of, phrase, &unit, digits, value);
}

void statement_value(const finder *of, whirl_statement *statement, size_t point) {
    if (*of->table->parameter) phrase_value(of, &statement->at, 6, of->table->values[point]);
}

// ---------------------------------------------------------------- sheets

whirl_sheet *find_sheet(const finder *of, const char *name, const char *title) {
    whirl_findings *all = of->findings;
    void *items = all->sheets;
    if (!find_room(all, &items, all->sheet_count, sizeof *all->sheets)) return &find_lost(of)->sheet;
    all->sheets = items;
    whirl_sheet *own = &all->sheets[all->sheet_count++];
    *own = (whirl_sheet){.name = name, .title = title, .table = find_text(all, "%s", of->table->name), .about = ""};
    return own;
}

static void sheet_drop(whirl_sheet *sheet) {
    free(sheet->column);
    free(sheet->cells);
}

void find_sheet_end(const finder *of) {
    whirl_findings *all = of->findings;
    if (!all->failed && all->sheet_count > 0 && all->sheets[all->sheet_count - 1].rows == 0)
        sheet_drop(&all->sheets[--all->sheet_count]);
}

static void sheet_add_column(const finder *of, whirl_sheet *sheet, whirl_column column) {
    void *items = sheet->column;
    if (!find_room(of->findings, &items, sheet->columns, sizeof *sheet->column)) return;
    sheet->column = items;
    sheet->column[sheet->columns++] = column;
}

static void sheet_add_numbers(const finder *of, whirl_sheet *sheet, const char *key, const char *heading,
                              const whirl_unit *unit, int digits, const char *between) {
    sheet_add_column(of, sheet,
                     (whirl_column){.key = key,
                                    .heading = heading,
                                    .unit = find_text(of->findings, "%s", unit->name),
                                    .size = unit->size,
                                    .digits = digits,
                                    .between = between});
}

void sheet_column(const finder *of, whirl_sheet *sheet, const char *key, const char *heading, whirl_quantity quantity,
                  int digits) {
    sheet_add_numbers(of, sheet, key, heading, &of->units->of[quantity], digits, NULL);
    if (quantity == WHIRL_QUANTITY_TEMPERATURE && !of->findings->failed)
        sheet->column[sheet->columns - 1].zero = of->units->zero;
}

void sheet_units(const finder *of, whirl_sheet *sheet, const char *key, const char *heading, const whirl_unit *unit,
                 int digits) {
    sheet_add_numbers(of, sheet, key, heading, unit, digits, NULL);
}

void sheet_coefficients(const finder *of, whirl_sheet *sheet, const char *const *headings) {
    static const char *const keys[] = {"kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"};
    for (size_t i = 0; i < 8; i++)
        sheet_column(of, sheet, keys[i], headings ? headings[i] : keys[i],
                     i < 4 ? WHIRL_QUANTITY_STIFFNESS : WHIRL_QUANTITY_DAMPING, 4);
}

void sheet_list_units(const finder *of, whirl_sheet *sheet, const char *key, const char *heading,
                      const whirl_unit *unit, int digits, const char *between) {
    sheet_add_numbers(of, sheet, key, heading, unit, digits, between);
}

void sheet_list(const finder *of, whirl_sheet *sheet, const char *key, const char *heading, whirl_quantity quantity,
                int digits, const char *between) {
    sheet_list_units(of, sheet, key, heading, &of->units->of[quantity], digits, between);
}

void sheet_texts(const finder *of, whirl_sheet *sheet, const char *key, const char *heading) {
    (void)of;
    sheet_add_column(of, sheet, (whirl_column){.key = key, .heading = heading, .unit = "", .size = 1.0});
}

void sheet_values(const finder *of, whirl_sheet *sheet, const char *heading, int digits) {
    if (!*of->table->parameter) return;
    const whirl_unit unit = whirl_shown_parameter(of->units, of->table->parameter);
    const char *const own =
        find_text(of->findings, "%s", of->table->parameter); // a copy: the view may be freed before the findings
    char words[WHIRL_NAME_SIZE];
    snprintf(words, sizeof words, "%s", heading);
    for (char *at = words; (at = strchr(at, '_')) != NULL;) *at = ' ';
    sheet_add_numbers(of, sheet, *heading ? heading : own,
                      *heading ? find_text(of->findings, "%s %s", words, own) : own, &unit, digits, NULL);
}

/// Returns true if two cells show the same: equal texts, and numbers that differ only by rounding.
static bool cell_same(const whirl_cell *a, const whirl_cell *b) {
    const double rounding = 1e-9;
    if (strcmp(a->text ? a->text : "", b->text ? b->text : "") != 0 || a->count != b->count) return false;
    for (size_t i = 0; i < a->count; i++) {
        const double one = a->numbers ? a->numbers[i] : a->number, other = b->numbers ? b->numbers[i] : b->number;
        if (!(fabs(one - other) <= rounding * fmax(fabs(one), fabs(other)))) return false;
    }
    return true;
}

void sheet_once(const finder *of, whirl_sheet *sheet) {
    const size_t half = sheet->rows / 2, columns = sheet->columns;
    if (of->findings->failed || !*of->table->parameter || half == 0 || sheet->rows != 2 * half) return;
    for (size_t i = 0; i < half * columns; i++)
        if (i % columns > 0 && !cell_same(&sheet->cells[i], &sheet->cells[half * columns + i])) return;
    if (cell_same(&sheet->cells[0], &sheet->cells[half * columns])) return; // the rows are of one point
    sheet->rows = half;
    for (size_t row = 0; row < half; row++) sheet->cells[row * columns] = (whirl_cell){.count = 0};
    sheet->about = find_text(of->findings, "%s%sThe same at the first and the last value of %s.", sheet->about,
                             *sheet->about ? " " : "", of->table->parameter);
}

static whirl_cell *sheet_cell(const finder *of, whirl_sheet *sheet) {
    if (of->findings->failed || sheet->given == sheet->columns) return &find_lost(of)->cell;
    return &sheet->cells[(sheet->rows - 1) * sheet->columns + sheet->given++];
}

void sheet_row(const finder *of, whirl_sheet *sheet) {
    whirl_findings *all = of->findings;
    const size_t cells = sheet->rows * sheet->columns, more = cells + sheet->columns;
    if (all->failed) return;
    whirl_cell *larger = realloc(sheet->cells, more * sizeof *larger);
    all->failed = !larger;
    if (!larger) return;
    memset(larger + cells, 0, sheet->columns * sizeof *larger);
    sheet->cells = larger;
    sheet->rows++;
    sheet->given = 0;
}

void cell_number(const finder *of, whirl_sheet *sheet, double number) {
    *sheet_cell(of, sheet) =
        isfinite(number) ? (whirl_cell){.count = 1, .number = unsigned_zero(number)} : (whirl_cell){.count = 0};
}

void cell_numbers(const finder *of, whirl_sheet *sheet, size_t count, const double *numbers) {
    double *copy = count > 0 ? find_take(of->findings, count * sizeof *copy) : NULL;
    whirl_cell *cell = sheet_cell(of, sheet);
    if (!copy) return;
    for (size_t i = 0; i < count; i++) copy[i] = unsigned_zero(numbers[i]);
    *cell = (whirl_cell){.count = count, .number = *copy, .numbers = copy};
}

void cell_text(const finder *of, whirl_sheet *sheet, const char *text) {
    *sheet_cell(of, sheet) = (whirl_cell){.text = text};
}

void cell_station(const finder *of, whirl_sheet *sheet, size_t station) {
    cell_text(of, sheet, find_text(of->findings, "%s", of->result->stations[station].name));
}

void cell_colour(const finder *of, whirl_sheet *sheet, const char *colour) {
    if (!of->findings->failed) sheet->cells[(sheet->rows - 1) * sheet->columns + sheet->given - 1].colour = colour;
}

void cell_value(const finder *of, whirl_sheet *sheet, size_t point) {
    if (*of->table->parameter) cell_number(of, sheet, of->table->values[point]);
}

whirl_findings *find_begin(void) {
    whirl_findings *all = calloc(1, sizeof *all);
    find_memory *memory = calloc(1, sizeof *memory);
    if (!all || !memory) {
        free(all);
        free(memory);
        return NULL;
    }
    all->memory = memory;
    return all;
}

whirl_status find_made(whirl_findings *made, whirl_findings **findings) {
    const bool well = made && !made->failed;
    *findings = well ? made : NULL;
    if (well) return whirl_ok();
    whirl_findings_free(made);
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for what was found");
}

void whirl_findings_free(whirl_findings *findings) {
    if (!findings) return;
    for (size_t i = 0; i < findings->sheet_count; i++) sheet_drop(&findings->sheets[i]);
    find_memory *memory = findings->memory;
    arena_free(&memory->arena);
    free(memory);
    free(findings->statements);
    free(findings->sheets);
    free(findings);
}
