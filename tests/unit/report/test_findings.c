// Findings: phrases, sheets and how they are written, from findings that are made by hand.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "findings_build.h"
#include "findings_render.h"
#include "number_shown.h"
#include "sample.h"
#include "shown_kinds.h"
#include "whirl/engine/result.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

/// Findings without any in them, of the sweep of the sample.
typedef struct made {
    whirl_result *result;
    whirl_shown_units units;
    whirl_findings *findings;
    finder of;
} made;

static made made_in(const char *units) {
    made own = {.result = sample_result()};
    assert_int_equal(whirl_result_shown_units(own.result, units, &own.units).code, WHIRL_OK);
    const size_t tables = own.result->table_count;
    own.result->table_count = 0; // in which nothing is found
    assert_int_equal(findings_of(own.result, &own.units, NULL, &own.findings).code, WHIRL_OK);
    own.result->table_count = tables;
    own.of = (finder){.findings = own.findings, .result = own.result, .table = own.result->tables};
    return own;
}

static void made_free(made *own) {
    whirl_findings_free(own->findings);
    whirl_result_free(own->result);
}

/// Returns the written sheet; freed by the caller.
static char *written(const whirl_sheet *sheet, whirl_sheet_form form) {
    char *text;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    assert_non_null(stream);
    assert_int_equal(whirl_sheet_write(sheet, form, stream).code, WHIRL_OK);
    assert_int_equal(fclose(stream), 0);
    return text;
}

static void assert_written(const whirl_sheet *sheet, whirl_sheet_form form, const char *expected) {
    char *text = written(sheet, form);
    assert_string_equal(text, expected);
    free(text);
}

/// Numbers of phrases stay numbers in SI, and are shown in their units.
static void phrases(void **state) {
    (void)state;
    made own = made_in("um, rpm");
    own.of.units = &own.units;
    whirl_statement *statement = find_judgement(&own.of, "vibration", "API 617", WHIRL_FAILS);
    statement->station = "disc";
    phrase_value(&own.of, &statement->at, 6, 0.25);
    phrase_text(&own.of, &statement->asked, "at most ");
    phrase_number(&own.of, &statement->asked, WHIRL_QUANTITY_SPAN, 4, 25.4e-6);
    phrase_number(&own.of, &statement->found, WHIRL_QUANTITY_SPEED, 5, 100.0 * acos(-1.0));
    phrase_text(&own.of, &statement->found, " and ");
    phrase_number(&own.of, &statement->found, WHIRL_QUANTITY_NUMBER, 4, -0.0);
    phrase_text(&own.of, &statement->judged, ", %d of %d", 1, 2);
    char text[STATEMENT_SIZE];
    statement_text(statement, text, sizeof text);
    assert_string_equal(text, "at 0.25: vibration at disc, asked for at most 25.4 \u00b5m p-p: 3000 rpm and 0: "
                              "fails, 1 of 2");
    assert_true(statement->asked.pieces[1].value == 25.4e-6 && !statement->asked.pieces[1].text);
    whirl_phrase_text(&statement->found, text, 6); // what does not fit is cut
    assert_string_equal(text, "3000 ");
    assert_string_equal(whirl_judgement_name(WHIRL_NOT_KNOWN), "not known");
    // A phrase keeps all of its pieces, however many they are.
    whirl_phrase *const longest = &statement->found;
    enum { MANY = 300 };
    for (int i = 0; i < MANY; i++) phrase_number(&own.of, longest, WHIRL_QUANTITY_NUMBER, 6, (double)i);
    assert_false(own.findings->failed);
    assert_int_equal(longest->count, 3 + MANY);
    assert_true(longest->pieces[0].value == 100.0 * acos(-1.0));
    for (int i = 0; i < MANY; i++) assert_true(longest->pieces[3 + i].value == (double)i);
    made_free(&own);
}

/// Makes a sheet with four columns: a text, a number, an empty one, and one with several numbers a cell.
static whirl_sheet *sheet_of(made *own, const char *name) {
    own->of.units = &own->units;
    whirl_sheet *sheet = find_sheet(&own->of, name, "Made by hand");
    sheet_texts(&own->of, sheet, "what", "what");
    sheet_column(&own->of, sheet, "force", "force", WHIRL_QUANTITY_FORCE, 4);
    sheet_column(&own->of, sheet, "never", "never", WHIRL_QUANTITY_NUMBER, 4);
    sheet_list(&own->of, sheet, "pads", "pads", WHIRL_QUANTITY_FORCE, 3, ", ");
    return sheet;
}

static void sheet_fill(const made *own, whirl_sheet *sheet, const char *what, double force) {
    const double pads[] = {1.5, -0.0};
    sheet_row(&own->of, sheet);
    cell_text(&own->of, sheet, what);
    cell_number(&own->of, sheet, force);
    cell_number(&own->of, sheet, (double)NAN);
    cell_numbers(&own->of, sheet, force > 0.0 ? 2 : 0, pads);
}

/// Text and LaTeX leave empty columns out; CSV has all of them, with all digits. No zero has a sign.
static void empty_columns(void **state) {
    (void)state;
    made own = made_in("");
    whirl_sheet *sheet = sheet_of(&own, "sheet");
    sheet_fill(&own, sheet, "a", 1000.0 / 3.0);
    sheet_fill(&own, sheet, "b+-b", -0.0);
    assert_false(own.findings->failed);
    assert_false(signbit(sheet->cells[4 + 1].number));
    assert_written(sheet, WHIRL_SHEET_TEXT,
                   "  Made by hand:\n    what  force (N)  pads (N)\n    a         333.3  1.5, 0\n    b+-b          0  "
                   "\n");
    assert_written(sheet, WHIRL_SHEET_CSV,
                   "what,force (N),never,pads (N)\r\na,333.33333333333331,,\"1.5, 0\"\r\nb+-b,0,,\r\n");
    assert_written(sheet, WHIRL_SHEET_LATEX,
                   "\\begin{tabular}{lrl}\n\\toprule\nwhat & force (N) & pads (N) \\\\\n\\midrule\n"
                   "a & 333.3 & 1.5, 0 \\\\\nb$\\pm$b & 0 &  \\\\\n\\bottomrule\n\\end{tabular}\n");
    // A sheet without rows is none.
    find_sheet(&own.of, "none", "Nothing");
    find_sheet_end(&own.of);
    assert_int_equal(own.findings->sheet_count, 1);
    made_free(&own);
}

/// Rows of two points that are the same but for rounding are listed once, without the value of the parameter; others
/// stay.
static void rows_once(void **state) {
    (void)state;
    for (int same = 0; same < 2; same++) {
        made own = made_in("");
        own.of.units = &own.units;
        whirl_sheet *sheet = find_sheet(&own.of, "loads", "Loads");
        sheet->about = "Loads.";
        sheet_values(&own.of, sheet, "", 6);
        sheet_texts(&own.of, sheet, "station", "station");
        sheet_column(&own.of, sheet, "load", "load", WHIRL_QUANTITY_FORCE, 4);
        for (size_t point = 0; point < 2; point++)
            for (size_t station = 0; station < 2; station++) {
                const double far = point == 1 && station == 1 ? (same ? 1e-12 : 1e-6) : 0.0;
                sheet_row(&own.of, sheet);
                cell_value(&own.of, sheet, point);
                cell_text(&own.of, sheet, station ? "b" : "a");
                cell_number(&own.of, sheet, 100.0 * (1.0 + far));
            }
        sheet_once(&own.of, sheet);
        assert_false(own.findings->failed);
        assert_int_equal(sheet->rows, same ? 2 : 4);
        assert_int_equal(sheet->cells[0].count, same ? 0 : 1);
        assert_int_equal(strncmp(sheet->about, "Loads. The same at the first", 28) == 0, same);
        made_free(&own);
    }
}

/// Numbers of up to seven digits before the point are plain.
static void numbers(void **state) {
    static const struct {
        double number;
        int digits;
        const char *expected;
    } cases[] = {{140280.0, 4, "140300"},
                 {12960.0, 4, "12960"},
                 {4152.50247, 5, "4152.5"},
                 {2e7, 4, "2e+07"},
                 {0.00123456, 3, "0.00123"}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[32];
        number_shown(cases[i].number, cases[i].digits, text, sizeof text);
        assert_string_equal(text, cases[i].expected);
    }
}

/// Fields of CSV after RFC 4180; letters that mean something to LaTeX.
static void letters(void **state) {
    (void)state;
    made own = made_in("");
    own.of.units = &own.units;
    whirl_sheet *sheet = find_sheet(&own.of, "letters", "Letters");
    sheet_texts(&own.of, sheet, "a", "a, \"b\"");
    sheet_texts(&own.of, sheet, "b", "50 %");
    sheet_row(&own.of, sheet);
    cell_text(&own.of, sheet, "two\nlines");
    cell_text(&own.of, sheet, "\\ {a_b} ~ ^ \u00b5m & # $ \u03c9");
    assert_written(sheet, WHIRL_SHEET_CSV,
                   "\"a, \"\"b\"\"\",50 %\r\n\"two\nlines\",\\ {a_b} ~ ^ \u00b5m & # $ \u03c9\r\n");
    char *text = written(sheet, WHIRL_SHEET_LATEX);
    assert_non_null(strstr(text, "a, \"b\" & 50 \\% \\\\\n"));
    assert_non_null(
        strstr(text, "& \\textbackslash{} \\{a\\_b\\} \\textasciitilde{} \\^{} $\\mu$m \\& \\# \\$ \u03c9 \\\\"));
    free(text);
    made_free(&own);
}

/// A sheet of few rows that is wider than a terminal is written with headings at the left; one of more rows is not.
static void transposed(void **state) {
    (void)state;
    made own = made_in("");
    own.of.units = &own.units;
    whirl_sheet *sheet = find_sheet(&own.of, "wide", "Wide");
    for (size_t c = 0; c < 9; c++)
        sheet_column(&own.of, sheet, "key", c % 2 ? "a heading of twenty letters" : "\u03c9", WHIRL_QUANTITY_NUMBER, 4);
    for (size_t row = 0; row < 3; row++) {
        sheet_row(&own.of, sheet);
        for (size_t c = 0; c < 9; c++) cell_number(&own.of, sheet, (double)(10 * row + c));
    }
    char *text = written(sheet, WHIRL_SHEET_TEXT);
    assert_non_null(strstr(text, "  Wide:\n    \u03c9                            0  10  20\n"
                                 "    a heading of twenty letters  1  11  21\n"));
    free(text);
    sheet_row(&own.of, sheet);
    text = written(sheet, WHIRL_SHEET_TEXT);
    assert_non_null(strstr(text, "  Wide:\n     \u03c9  a heading of twenty letters   \u03c9"));
    free(text);
    // Of many rows the first ones and the last.
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    assert_true(stream && sheet_write_text(stream, sheet, 2));
    assert_int_equal(fclose(stream), 0);
    assert_non_null(strstr(text, "  Wide (the first and the last of 4 rows):\n"));
    free(text);
    made_free(&own);
}

/// A name that several tables have is shown with that of the table.
static void sheets_of_one_name(void **state) {
    (void)state;
    made own = made_in("");
    for (size_t table = 0; table < 2; table++) {
        own.of.table = &own.result->tables[table];
        sheet_fill(&own, sheet_of(&own, "peaks"), "a", 1.0);
    }
    sheet_fill(&own, sheet_of(&own, "levels"), "a", 1.0);
    const whirl_sheet *sheet;
    char name[80];
    whirl_status status = whirl_findings_sheet(own.findings, "peaks", &sheet);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_null(sheet);
    assert_string_equal(status.message, "2 tables have a sheet 'peaks', expected one of them: sweep/peaks");
    for (size_t i = 0; i < 3; i++) {
        whirl_sheet_name(own.findings, &own.findings->sheets[i], name, sizeof name);
        assert_string_equal(name, ((const char *[]){"sweep/peaks", "detail/peaks", "levels"})[i]);
        assert_int_equal(whirl_findings_sheet(own.findings, name, &sheet).code, WHIRL_OK);
        assert_ptr_equal(sheet, &own.findings->sheets[i]);
    }
    assert_int_equal(whirl_findings_sheet(own.findings, "detail/levels", &sheet).code, WHIRL_OK);
    status = whirl_findings_sheet(own.findings, "sweep/levels", &sheet);
    assert_string_equal(status.message, "there is no sheet 'sweep/levels', did you mean levels?");
    status = whirl_findings_sheet(own.findings, "peak", &sheet);
    assert_string_equal(status.message, "there is no sheet 'peak', did you mean peaks?");
    made_free(&own);
}

/// After a failure of memory nothing is added or written.
static void after_a_failure_of_memory(void **state) {
    (void)state;
    made own = made_in("");
    whirl_sheet *sheet = sheet_of(&own, "sheet");
    sheet_fill(&own, sheet, "a", 1.0);
    own.findings->failed = true;
    sheet_fill(&own, sheet, "b", 2.0);
    assert_int_equal(sheet->rows, 1);
    assert_string_equal(sheet->cells[0].text, "a");
    sheet_fill(&own, sheet_of(&own, "other"), "c", 3.0);
    phrase_text(&own.of, &find_judgement(&own.of, "what", "", WHIRL_HOLDS)->found, "%s", "found");
    assert_string_equal(find_text(own.findings, "%d", 3), "");
    assert_int_equal(own.findings->sheet_count, 1);
    assert_int_equal(own.findings->statement_count, 0);
    made_free(&own);
}

/// NIST SP 811 (2008), appendix B.8: factors to seven figures.
static void customary_units(void **state) {
    (void)state;
    static const struct {
        whirl_quantity quantity;
        double si, shown;
        const char *unit;
    } rows[] = {{WHIRL_QUANTITY_FORCE, 4.448222, 1.0, "lbf"},
                {WHIRL_QUANTITY_MASS, 0.4535924, 1.0, "lbm"},
                {WHIRL_QUANTITY_STIFFNESS, 1.751268e2, 1.0, "lbf/in"},
                {WHIRL_QUANTITY_CROSS, 1.751268e2, 1.0, "lbf/in"},
                {WHIRL_QUANTITY_DAMPING, 1.751268e2, 1.0, "lbf s/in"},
                {WHIRL_QUANTITY_MOMENT, 1.129848e-1, 1.0, "lbf in"},
                {WHIRL_QUANTITY_INERTIA, 2.926397e-4, 1.0, "lbm in2"},
                {WHIRL_QUANTITY_UNBALANCE, 2.834952e-2 * 2.54e-2, 1.0, "oz in"},
                {WHIRL_QUANTITY_DENSITY, 1.601846e1, 1.0, "lbm/ft3"},
                {WHIRL_QUANTITY_POSITION, 2.54e-2, 1.0, "in"},
                {WHIRL_QUANTITY_DIAMETER, 2.54e-2, 1.0, "in"},
                {WHIRL_QUANTITY_LENGTH, 2.54e-5, 1.0, "mil"},
                {WHIRL_QUANTITY_SIZE, 2.54e-5, 2.0, "mil p-p"}, // SI is zero to peak
                {WHIRL_QUANTITY_SPAN, 2.54e-5, 1.0, "mil p-p"},
                {WHIRL_QUANTITY_SPEED, 1.047198e-1, 1.0, "rpm"},
                {WHIRL_QUANTITY_FREQUENCY, 1.047198e-1, 1.0, "cpm"}};
    made own = made_in("US");
    own.of.units = &own.units;
    whirl_sheet *sheet = find_sheet(&own.of, "units", "Units");
    const size_t count = sizeof rows / sizeof *rows;
    for (size_t c = 0; c < count; c++) sheet_column(&own.of, sheet, "key", "heading", rows[c].quantity, 6);
    sheet_row(&own.of, sheet);
    for (size_t c = 0; c < count; c++) cell_number(&own.of, sheet, rows[c].si);
    for (size_t c = 0; c < count; c++) {
        const whirl_column *column = &sheet->column[c];
        assert_string_equal(column->unit, rows[c].unit);
        const double half_of_the_seventh_figure = 5e-7;
        assert_true(fabs(sheet->cells[c].number / column->size / rows[c].shown - 1.0) < half_of_the_seventh_figure);
    }
    made_free(&own);
}

// ---------------------------------------------------------------- lines of spectra

enum { UP = 12, WAYS = 2 * UP };

/// Returns the value of a point of a sweep from 1 to 12, or from 12 to 1; the way back has the values in the same
/// order.
static double value_at(size_t point, bool falls) {
    return (double)(falls ? UP - point % UP : point % UP + 1);
}

/// Makes a sweep from 1 to 12 and back (falls: from 12 to 1 and back). Its largest line is 0.3 at 1X; `beside` has
/// order and amplitude (0: none) of a second line at every point.
static made swept(double (*beside)[2], whirl_regime regime, bool falls, whirl_table *table) {
    made own = made_in("");
    *table = (whirl_table){.count = 0};
    sample_table(own.result, table, "ways", WAYS, false);
    for (size_t i = 0; i < WAYS; i++) {
        const double lines[][2] = {{1.0, 0.3}, {beside[i][1] > 0.0 ? beside[i][0] : 0.0, beside[i][1]}, {0.0, 0.0}};
        table->values[i] = value_at(i, falls);
        table->branch[i] = i < UP ? 1 : -1;
        sample_verdict(table, i, regime, 2, 1);
        sample_lines(table, i, lines);
    }
    own.of.table = table;
    return own;
}

static void swept_free(made *own, whirl_table *table) {
    free(table->values);
    free(table->branch);
    free(table->blocks);
    made_free(own);
}

static const whirl_sheet *lines_sheet(made *own, const char *name) {
    for (size_t i = 0; i < own->findings->sheet_count; i++)
        if (strcmp(own->findings->sheets[i].name, name) == 0) return &own->findings->sheets[i];
    return NULL;
}

static bool is_reported(const made *own, const char *expected) {
    for (size_t i = 0; i < own->findings->statement_count; i++) {
        char text[STATEMENT_SIZE];
        statement_text(&own->findings->statements[i], text, sizeof text);
        if (strcmp(text, expected) == 0) return true;
    }
    return false;
}

/// A line that exists from 8 on the way up and down to 5 on the way back, with one amplitude, jumps with a hysteresis
/// of 3. Its order of a half is locked on both ways.
static void lines_jump(void **state) {
    (void)state;
    for (int falls = 0; falls < 2; falls++) {
        double beside[WAYS][2] = {{0.0}};
        whirl_table table;
        for (size_t i = 0; i < WAYS; i++) {
            const bool up = (i < UP) != falls;
            beside[i][0] = 0.5;
            beside[i][1] = value_at(i, falls) >= (up ? 8.0 : 5.0) ? 0.2 : 0.0;
        }
        made own = swept(beside, WHIRL_PERIODIC, falls, &table);
        own.of.units = &own.units;
        find_lines(&own.of);
        const whirl_sheet *edges = lines_sheet(&own, "line-edges"), *locking = lines_sheet(&own, "locking");
        assert_non_null(edges);
        assert_int_equal(edges->rows, 1);
        assert_true(edges->cells[2].number == 8.0 && edges->cells[6].number == 5.0 && edges->cells[10].number == 3.0);
        assert_string_equal(edges->cells[3].text, "at once");
        assert_string_equal(edges->cells[7].text, "at once");
        assert_true(is_reported(
            &own, "line of order 0.5: begins at once at 8 on the way up; ends at once at 5 on the way down: "
                  "hysteresis of 3"));
        assert_non_null(locking);
        assert_int_equal(locking->rows, 2);
        assert_string_equal(locking->cells[0].text, "1/2");
        assert_true(falls || (locking->cells[1].number == 8.0 && locking->cells[2].number == 12.0));
        assert_true(locking->cells[4].number == (falls ? 8.0 : 5.0));
        swept_free(&own, &table);
    }
}

/// A line that grows as a root of the parameter from 5.5 on, on both ways, neither jumps nor has a hysteresis, and an
/// order that drifts past a half is locked nowhere; nor is a half of motions that are quasi-periodic.
static void lines_grow(void **state) {
    (void)state;
    double beside[WAYS][2] = {{0.0}};
    whirl_table table;
    for (size_t i = 0; i < WAYS; i++) {
        const double value = value_at(i, false);
        beside[i][0] = 0.46 + 0.005 * value;
        beside[i][1] = value > 5.5 ? 0.08 * sqrt(value - 5.5) : 0.0;
    }
    made own = swept(beside, WHIRL_PERIODIC, false, &table);
    own.of.units = &own.units;
    find_lines(&own.of);
    const whirl_sheet *edges = lines_sheet(&own, "line-edges");
    assert_non_null(edges);
    assert_int_equal(edges->rows, 1);
    assert_true(edges->cells[2].number == 6.0 && edges->cells[6].number == 6.0 && edges->cells[10].number == 0.0);
    assert_string_equal(edges->cells[3].text, "gradually");
    assert_string_equal(edges->cells[7].text, "gradually");
    assert_null(lines_sheet(&own, "locking"));
    assert_int_equal(own.findings->statement_count, 1); // the largest line alone
    swept_free(&own, &table);
    for (size_t i = 0; i < WAYS; i++) beside[i][0] = 0.5;
    own = swept(beside, WHIRL_QUASI_PERIODIC, false, &table);
    own.of.units = &own.units;
    find_lines(&own.of);
    assert_null(lines_sheet(&own, "locking"));
    swept_free(&own, &table);
}

enum { DUFFING = 60 };
static const double duffing_force = 0.15, duffing_damping = 0.15, duffing_from = -0.2, duffing_step = 0.0305;

/// Returns a^2 of the Duffing oscillator at a detuning s: a^2 ((s - a^2)^2 + damping^2) = force^2 (Nayfeh and Mook,
/// Nonlinear Oscillations, 4.1), the root nearest to `before`.
static double duffing_square(double s, double before) {
    enum { STEPS = 20000 };
    double best = HUGE_VAL, last = 0.0;
    for (int i = 0; i <= STEPS; i++) {
        const double y = 1.1 * i / STEPS;
        const double value =
            y * ((s - y) * (s - y) + duffing_damping * duffing_damping) - duffing_force * duffing_force;
        if (i > 0 && (value > 0.0) != (last > 0.0) && fabs(y - before) < fabs(best - before)) best = y;
        last = value;
    }
    return best;
}

/// Returns the discriminant of that cubic in a^2; its zeros are the folds of the response, where it jumps.
static double duffing_discriminant(double s) {
    const double b = -2.0 * s, c = s * s + duffing_damping * duffing_damping, d = -duffing_force * duffing_force;
    return 18.0 * b * c * d - 4.0 * b * b * b * d + b * b * c * c - 4.0 * c * c * c - 27.0 * d * d;
}

/// A line of half the speed that responds as a Duffing oscillator jumps at the folds of its cubic: once on the way up
/// and once on the way down, wherever the sweep begins.
static void lines_jump_at_folds(void **state) {
    (void)state;
    double folds[2];
    size_t found = 0;
    for (double s = 0.1; s < 1.6 && found < 2; s += 1e-5)
        if ((duffing_discriminant(s) > 0.0) != (duffing_discriminant(s + 1e-5) > 0.0)) folds[found++] = s;
    assert_int_equal(found, 2);
    for (int falls = 0; falls < 2; falls++) {
        made own = made_in("");
        whirl_table table = {.count = 0};
        sample_table(own.result, &table, "ways", (size_t)2 * DUFFING, false);
        for (int way = 0; way < 2; way++) {
            double square = 0.0;
            for (int k = 0; k < DUFFING; k++) {
                // The second way is travelled from its last row to its first.
                const int place = way ? DUFFING - 1 - k : k;
                const double s = duffing_from + duffing_step * (falls ? DUFFING - 1 - place : place);
                const size_t row = (size_t)(way * DUFFING + place);
                square = duffing_square(s, square);
                const double lines[][2] = {{1.0, 0.3}, {0.5, 0.28 * sqrt(square)}, {0.0, 0.0}};
                table.values[row] = s;
                table.branch[row] = way ? -1 : 1;
                sample_verdict(&table, row, WHIRL_PERIODIC, 2, 1);
                sample_lines(&table, row, lines);
            }
        }
        own.of.table = &table;
        own.of.units = &own.units;
        find_lines(&own.of);
        const whirl_sheet *jumps = lines_sheet(&own, "line-jumps");
        assert_non_null(jumps);
        assert_int_equal(jumps->rows, 1);
        assert_true(jumps->cells[0].number == 0.5);
        // Down from the upper branch after the upper fold, up to it below the lower one.
        assert_true(jumps->cells[1].number < folds[1] && folds[1] < jumps->cells[2].number);
        assert_true(jumps->cells[3].number > 2.0 * jumps->cells[4].number);
        assert_true(jumps->cells[6].number < folds[0] && folds[0] < jumps->cells[5].number);
        assert_true(jumps->cells[8].number > 1.5 * jumps->cells[7].number);
        assert_true(fabs(jumps->cells[9].number - (folds[1] - folds[0])) < duffing_step);
        assert_null(lines_sheet(&own, "line-edges"));
        swept_free(&own, &table);
    }
}

/// The strongest line goes to another order between rows 4 and 5 on the way up, 2 and 3 on the way down: a jump with a
/// hysteresis of two steps. Two lines that are there at all rows and only change ranks do not jump.
static void lines_jump_to_another_order(void **state) {
    enum { ROWS = 10 };
    static const size_t from[2] = {4, 2};
    (void)state;
    for (int ranks = 0; ranks < 2; ranks++) {
        made own = made_in("");
        whirl_table table = {.count = 0};
        sample_table(own.result, &table, "orders", (size_t)2 * ROWS, false);
        for (size_t row = 0; row < (size_t)2 * ROWS; row++) {
            const size_t way = row / ROWS, place = row % ROWS;
            const bool high = place > from[way];
            const double jumping[][2] = {{1.0, 0.3}, {high ? 0.57 : 0.45, high ? 0.33 : 0.1}, {0.0, 0.0}};
            const double ranking[][2] = {
                {1.0, 0.3}, {0.57, 0.2 + 0.01 * (double)place}, {0.45, 0.3 - 0.01 * (double)place}, {0.0, 0.0}};
            table.values[row] = (double)place;
            table.branch[row] = way ? -1 : 1;
            sample_verdict(&table, row, WHIRL_UNDETERMINED, 0, 0);
            sample_lines(&table, row, ranks ? ranking : jumping);
        }
        own.of.table = &table;
        own.of.units = &own.units;
        find_lines(&own.of);
        const whirl_sheet *jumps = lines_sheet(&own, "line-jumps");
        if (ranks) {
            assert_null(jumps);
        } else {
            static const double cells[] = {0.45, 4.0, 5.0, 0.1, 0.33, 3.0, 2.0, 0.33, 0.1, 2.0, 0.57};
            assert_non_null(jumps);
            assert_int_equal(jumps->rows, 1);
            for (size_t c = 0; c < sizeof cells / sizeof *cells; c++)
                if (c != 3 && c != 4 && c != 7 && c != 8) // sizes are in lengths of the result
                    assert_true(fabs(jumps->cells[c].number - cells[c]) < 1e-12);
            assert_true(fabs(jumps->cells[4].number / jumps->cells[3].number - 3.3) < 1e-12);
            assert_true(fabs(jumps->cells[7].number / jumps->cells[8].number - 3.3) < 1e-12);
        }
        swept_free(&own, &table);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(phrases),
        cmocka_unit_test(empty_columns),
        cmocka_unit_test(rows_once),
        cmocka_unit_test(numbers),
        cmocka_unit_test(letters),
        cmocka_unit_test(transposed),
        cmocka_unit_test(sheets_of_one_name),
        cmocka_unit_test(after_a_failure_of_memory),
        cmocka_unit_test(customary_units),
        cmocka_unit_test(lines_jump),
        cmocka_unit_test(lines_grow),
        cmocka_unit_test(lines_jump_at_folds),
        cmocka_unit_test(lines_jump_to_another_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
