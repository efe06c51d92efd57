// CSV files, read back by a reader of RFC 4180 written here.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "synthetic.h"

#include <sys/stat.h>
#include <unistd.h>

enum { MAX_CELLS = 256, CELL_SIZE = 400 };

/// The export of the synthetic result in a new folder two levels down.
typedef struct fixture {
    char root[64], middle[80], folder[96];
    whirl_result *made;
} fixture;

static int setup(void **state) {
    fixture *f = synthetic_take(1, sizeof *f);
    strcpy(f->root, "/tmp/whirl-csv-XXXXXX");
    if (!mkdtemp(f->root)) return -1;
    snprintf(f->middle, sizeof f->middle, "%s/a", f->root);
    snprintf(f->folder, sizeof f->folder, "%s/b", f->middle);
    f->made = synthetic_result();
    *state = f;
    return 0;
}

static const char *const files[] = {"parameters",           "options",           "sweep",  "sweep-poincare-section",
                                    "sweep-spectrum-lines", "detail-made-array", "detail", "detail-made-column",
                                    "detail-made-nothing"};

static void path_of(const fixture *f, const char *name, char path[200]) {
    snprintf(path, 200, "%s/%s.csv", f->folder, name);
}

static int teardown(void **state) {
    fixture *f = *state;
    char path[200];
    for (size_t i = 0; i < sizeof files / sizeof *files; ++i) {
        path_of(f, files[i], path);
        unlink(path);
    }
    // A folder that is not empty stays: then there was a file that is not listed above.
    rmdir(f->folder), rmdir(f->middle);
    const int left = rmdir(f->root);
    whirl_result_free(f->made);
    free(f);
    return left;
}

typedef struct cells {
    size_t count;
    char text[MAX_CELLS][CELL_SIZE];
} cells;

/// Reads a record: cells between commas, quotes doubled inside quotes, a record ended by CR LF. False at the end.
static bool read_record(FILE *stream, cells *record) {
    int c = fgetc(stream);
    if (c == EOF) return false;
    record->count = 0;
    for (;;) {
        char *cell = record->text[record->count++];
        size_t length = 0;
        const bool quoted = c == '"';
        if (quoted) c = fgetc(stream);
        for (;; c = fgetc(stream)) {
            assert_int_not_equal(c, EOF);
            if (quoted && c == '"') {
                c = fgetc(stream);
                if (c != '"') break;
            } else if (!quoted && (c == ',' || c == '\r')) {
                break;
            }
            assert_true(length + 1 < CELL_SIZE);
            cell[length++] = (char)c;
        }
        cell[length] = '\0';
        if (c == '\r') break;
        assert_int_equal(c, ',');
        assert_true(record->count < MAX_CELLS);
        c = fgetc(stream);
    }
    assert_int_equal(fgetc(stream), '\n');
    return true;
}

static FILE *open_export(const fixture *f, const char *name, cells *heading) {
    char path[200];
    path_of(f, name, path);
    FILE *stream = fopen(path, "rb");
    if (!stream) fail_msg("%s is missing", path);
    assert_true(read_record(stream, heading));
    return stream;
}

static void assert_number(const char *text, double expected) {
    char *end;
    const double value = strtod(text, &end);
    assert_true(end != text && *end == '\0');
    if (isnan(expected))
        assert_true(isnan(value));
    else
        assert_memory_equal(&value, &expected, sizeof value);
}

/// Points and rows count from 1.
static size_t index_of(const char *text) {
    char *end;
    const long number = strtol(text, &end, 10);
    assert_true(number >= 1 && *end == '\0');
    return (size_t)number - 1;
}

static void export_all(fixture *f) {
    const whirl_status status = whirl_result_export_csv(f->made, f->folder);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

static void points_have_a_line_each(void **state) {
    fixture *f = *state;
    const whirl_table *table = &f->made->tables[0];
    static cells heading, record;
    export_all(f);
    FILE *stream = open_export(f, "sweep", &heading);
    assert_string_equal(heading.text[0], "point");
    assert_string_equal(heading.text[1], "r_k [1]");
    assert_string_equal(heading.text[2], "branch");
    assert_string_equal(heading.text[3], "verdict");
    static const char *const verdicts[] = {"P-2", "chaotic", "diverged at revolution 17"};
    for (size_t point = 0; point < table->count; ++point) {
        assert_true(read_record(stream, &record));
        assert_int_equal(record.count, heading.count);
        assert_number(record.text[1], table->values[point]);
        assert_number(record.text[2], table->branch[point]);
        assert_string_equal(record.text[3], verdicts[point]);
    }
    assert_false(read_record(stream, &record));
    fclose(stream);
}

/// The cell under a heading is the number of that field, station and column, to the last bit.
static void numbers_stand_under_their_headings(void **state) {
    static const struct {
        const char *heading, *field;
        size_t which, column;
    } columns[] = {
        {"lyapunov/error [1/revolution]", "lyapunov/error", 0, 0},
        {"orbit/max_radius journal [0.2 mm 0-p]", "orbit/max_radius", 1, 0},
        {"orbit/mean disc y [0.2 mm]", "orbit/mean", 0, 1},
        {"orbit/eccentricity journal [1]", "orbit/eccentricity", 1, 0},
        {"rub/max_force rub at disc [4225 N]", "rub/max_force", 0, 0},
    };
    fixture *f = *state;
    const whirl_table *table = &f->made->tables[0];
    static cells heading, record;
    export_all(f);
    for (size_t i = 0; i < sizeof columns / sizeof *columns; ++i) {
        FILE *stream = open_export(f, "sweep", &heading);
        size_t at = 0;
        while (at < heading.count && strcmp(heading.text[at], columns[i].heading) != 0) ++at;
        if (at == heading.count) fail_msg("no column '%s'", columns[i].heading);
        for (size_t point = 0; read_record(stream, &record); ++point)
            assert_number(record.text[at],
                          whirl_table_field(table, point, columns[i].field, columns[i].which)[columns[i].column]);
        fclose(stream);
    }
}

static void rows_have_files_of_their_own(void **state) {
    fixture *f = *state;
    const whirl_table *table = &f->made->tables[0];
    static cells heading, record;
    static const char *const expected[] = {"point",
                                           "r_k [1]",
                                           "branch",
                                           "station",
                                           "row",
                                           "x [0.2 mm]",
                                           "y [0.2 mm]",
                                           "vx [0.2 mm per radian]",
                                           "vy [0.2 mm per radian]"};
    // One row of the second station at the second point is missing altogether.
    const whirl_field *section = whirl_layout_field(&table->layout, "poincare/section");
    double *missing = table->blocks + table->layout.size + section->offset + (size_t)(SYNTHETIC_RECORD + 2) * 4;
    for (int i = 0; i < 4; ++i) missing[i] = NAN;
    export_all(f);
    FILE *stream = open_export(f, "sweep-poincare-section", &heading);
    assert_int_equal(heading.count, 9);
    for (size_t i = 0; i < heading.count; ++i) assert_string_equal(heading.text[i], expected[i]);
    size_t lines = 0;
    for (; read_record(stream, &record); ++lines) {
        const size_t point = index_of(record.text[0]), row = index_of(record.text[4]);
        const size_t station = strcmp(record.text[3], "journal") == 0;
        const double *numbers = whirl_table_field(table, point, "poincare/section", station) + 4 * row;
        assert_ptr_not_equal(numbers, missing);
        for (size_t c = 0; c < 4; ++c) assert_number(record.text[5 + c], numbers[c]);
    }
    assert_int_equal(lines, SYNTHETIC_POINTS * SYNTHETIC_STATIONS * SYNTHETIC_RECORD - 1);
    fclose(stream);
    stream = open_export(f, "sweep-spectrum-lines", &heading);
    assert_string_equal(heading.text[5], "order [1]");
    assert_string_equal(heading.text[8], "forward [0.2 mm 0-p]");
    fclose(stream);
}

static void texts_are_quoted(void **state) {
    fixture *f = *state;
    static cells record;
    strcpy(f->made->parameters[1].text, "650 \"rad/s\", or\nso");
    export_all(f);
    FILE *stream = open_export(f, "parameters", &record);
    assert_true(read_record(stream, &record) && read_record(stream, &record));
    assert_string_equal(record.text[0], "omega");
    assert_number(record.text[1], 650.0);
    assert_string_equal(record.text[2], "rad/s");
    assert_string_equal(record.text[3], f->made->parameters[1].text);
    fclose(stream);
}

static void says_where_no_folder_can_be(void **state) {
    fixture *f = *state;
    char path[200];
    export_all(f);
    path_of(f, "sweep", path);
    const whirl_status status = whirl_result_export_csv(f->made, path);
    assert_int_equal(status.code, WHIRL_IO_ERROR);
    assert_non_null(strstr(status.message, "there is a file of that name"));
}

/// A line for every option of every table, with the value that the run had.
static void options_have_a_line_each(void **state) {
    fixture *f = *state;
    cells record;
    size_t count = 0, expected = 0;
    for (const whirl_member *m = whirl_integrate_members(); m->part; ++m) expected += m->name != NULL;
    for (const whirl_member *m = whirl_record_members(); m->part; ++m) expected += m->name != NULL;
    assert_int_equal(whirl_result_export_csv(f->made, f->folder).code, WHIRL_OK);
    FILE *stream = open_export(f, "options", &record);
    assert_string_equal(record.text[1], "option");
    for (; read_record(stream, &record); ++count) {
        const whirl_table *table = whirl_result_table(f->made, record.text[0]);
        const whirl_member *integrate = whirl_member_find(whirl_integrate_members(), record.text[1]);
        const whirl_member *found = integrate ? integrate : whirl_member_find(whirl_record_members(), record.text[1]);
        const void *options = integrate ? (const void *)&table->integrate : (const void *)&table->record;
        assert_int_equal(record.count, 4);
        assert_non_null(found);
        const double number = whirl_member_number(found, options);
        if (found->type == WHIRL_MEMBER_WORD)
            assert_string_equal(record.text[2], (const char *)options + found->offset);
        else if (found->type == WHIRL_MEMBER_FLAG)
            assert_string_equal(record.text[2], number != 0.0 ? "true" : "false");
        else
            assert_true(strtod(record.text[2], NULL) == number);
    }
    fclose(stream);
    assert_int_equal(count, expected * f->made->table_count);
}

int main(void) {
#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, setup, teardown)
    const struct CMUnitTest tests[] = {
        IN_FOLDER(points_have_a_line_each),      IN_FOLDER(numbers_stand_under_their_headings),
        IN_FOLDER(rows_have_files_of_their_own), IN_FOLDER(texts_are_quoted),
        IN_FOLDER(options_have_a_line_each),     IN_FOLDER(says_where_no_folder_can_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
