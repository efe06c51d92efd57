// Watched quantities are in one list (whirl/engine/watched.h). Every line of it is found in the fields of a point, with
// the record's numbers, and so in result files, journals, CSV, JSON, reports and the explorer's page.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>
#include <jansson.h>

#include "read_all.h"
#include "whirl/engine.h"

static const char text[] = "whirl: 1\n"
                           "rotor:\n"
                           "  speed: 100 rad/s\n"
                           "  length_scale: 0.1 mm\n"
                           "  stations:\n"
                           "    disc: {mass: 10 kg, damping: 200 N.s/m, eccentricity: 0.1 mm}\n"
                           "    seat: {mass: 5 kg, damping: 300 N.s/m}\n"
                           "  elements:\n"
                           "    - shaft: {between: [disc, seat], k1: 0.2 MN/m}\n"
                           "    - spring: {between: [seat, ground], stiffness: 0.3 MN/m}\n"
                           "    - rub: {at: disc, gap: 0.11 mm, stiffness: 1 MN/m, friction: 0.1, radius: 60 mm}\n"
                           "    - rub: {at: seat, gap: 0.055 mm, stiffness: 1 MN/m, friction: 0.1, radius: 70 mm}\n"
                           "    - gravity: 2 m/s2\n"
                           "study:\n"
                           "  response: {}\n"
                           "  integrate: {method: rk4, steps_per_revolution: 256, transient: 3, record: 5}\n"
                           "  analyze: [orbit, rub]\n";

typedef struct watched {
    const char *field, *unit, *meaning;
    whirl_extent extent;
    size_t columns;
    size_t array; ///< its place in a record
} watched;

#define LINE(array, extent, columns, fold, square, name, unit, meaning)                                                \
    {name, unit, meaning, extent, columns, offsetof(whirl_record, array)},
static const watched list[] = {WHIRL_WATCHED(LINE)};
#define FOR_LIST for (const watched *w = list; w < list + sizeof list / sizeof *list; w++)

typedef struct fixture {
    char folder[32];
    whirl_case *object;
    whirl_result *result;
    const whirl_table *table;
} fixture;

static void must(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

static int setup(void **state) {
    fixture *f = calloc(1, sizeof *f);
    assert_non_null(f);
    snprintf(f->folder, sizeof f->folder, "/tmp/whirl-watched-XXXXXX");
    if (!mkdtemp(f->folder) || chdir(f->folder) != 0) return -1;
    must(whirl_case_parse(text, strlen(text), "case", NULL, &f->object));
    must(whirl_case_run(f->object, &(whirl_run_options){0}, &f->result));
    f->table = &f->result->tables[0];
    *state = f;
    return 0;
}

static int teardown(void **state) {
    fixture *f = *state;
    char command[64];
    whirl_result_free(f->result);
    whirl_case_free(f->object);
    snprintf(command, sizeof command, "rm -r %s", f->folder);
    const int failed = chdir("/") != 0 || system(command) != 0;
    free(f);
    return failed;
}

static size_t many(const fixture *f, const watched *w) {
    return w->extent == WHIRL_PER_STATION ? f->result->station_count : f->result->contact_count;
}

static const char *name_of(const fixture *f, const watched *w, size_t which) {
    return w->extent == WHIRL_PER_STATION ? f->result->stations[which].name : f->result->contacts[which];
}

/// Checks that another result has the same numbers, to the bit.
static void expect_all(const fixture *f, const whirl_result *other) {
    FOR_LIST for (size_t which = 0; which < many(f, w); which++) {
        const double *one = whirl_table_field(f->table, 0, w->field, which);
        const double *two = whirl_table_field(&other->tables[0], 0, w->field, which);
        if (!one || !two) fail_msg("%s is missing", w->field);
        assert_memory_equal(one, two, w->columns * sizeof *one);
    }
}

/// A motion that touches has no watched number that is 0 or equal to another by chance.
static void fields_have_what_records_have(void **state) {
    const fixture *f = *state;
    whirl_study study;
    whirl_machine machine;
    whirl_record *record;
    must(whirl_case_study(f->object, &study));
    const whirl_batch *batch = &study.batches[0];
    must(study.machine(study.family, batch, (double)NAN, &machine));
    must(whirl_record_motion(machine.system, &batch->integrate, &batch->record, machine.start, NULL, &record));
    FOR_LIST {
        const whirl_field *field = whirl_layout_field(&f->table->layout, w->field);
        if (!field) fail_msg("no field %s", w->field);
        assert_string_equal(field->unit, w->unit);
        assert_string_equal(field->meaning, w->meaning);
        assert_true(field->extent == w->extent && field->rows == 1 && field->columns == w->columns);
        const double *array = *(double **)((char *)record + w->array);
        for (size_t i = 0; i < many(f, w) * w->columns; i++) {
            const double *numbers = whirl_table_field(f->table, 0, w->field, i / w->columns);
            assert_true(isfinite(array[i]) && array[i] != 0.0);
            assert_true(numbers[i % w->columns] == array[i]);
            for (size_t k = 0; k < i; k++) assert_true(array[k] != array[i] || strcmp(w->unit, "1") == 0);
        }
    }
    whirl_record_free(record);
    machine.release(machine.owner);
}

static void files_and_journals_keep_all(void **state) {
    const fixture *f = *state;
    whirl_result *read, *outline, *again;
    whirl_journal *journal;
    must(whirl_result_write(f->result, "r.h5"));
    must(whirl_result_read("r.h5", &read));
    expect_all(f, read);
    whirl_result_free(read);

    must(whirl_case_outline(f->object, &outline));
    must(whirl_journal_begin("r.journal", outline, &journal));
    must(whirl_case_run(f->object, &(whirl_run_options){.store = whirl_journal_store(journal)}, &again));
    whirl_result_free(again);
    must(whirl_journal_close(journal));
    must(whirl_journal_resume("r.journal", outline, &journal));
    assert_int_equal(whirl_journal_points(journal), 1);
    must(whirl_case_run(f->object, &(whirl_run_options){.store = whirl_journal_store(journal)}, &again));
    expect_all(f, again);
    whirl_result_free(again);
    must(whirl_journal_remove(journal));
    whirl_result_free(outline);
}

/// Returns the cell of a line under the heading that begins with the text and continues with a unit; NaN if there is
/// none.
static double cell_under(const char *lines, const char *heading) {
    const char *line = strchr(lines, '\n') + 1, *head = lines;
    while (head < line - 1) {
        const size_t size = strcspn(head, ",\r"), length = strlen(heading);
        if (size > length && strncmp(head, heading, length) == 0 && strncmp(head + length, " [", 2) == 0)
            return strtod(line, NULL);
        head += size + 1;
        line += strcspn(line, ",\r") + 1;
    }
    return (double)NAN;
}

static void csv_has_all(void **state) {
    const fixture *f = *state;
    must(whirl_result_export_csv(f->result, "csv"));
    char *lines = read_all("csv/response.csv");
    FOR_LIST for (size_t i = 0; i < many(f, w) * w->columns; i++) {
        const size_t which = i / w->columns, column = i % w->columns;
        const char *const columns[] = {" x", " y"};
        char heading[2 * WHIRL_NAME_SIZE];
        snprintf(heading, sizeof heading, "%s %s%s", w->field, name_of(f, w, which),
                 w->columns > 1 ? columns[column] : "");
        if (cell_under(lines, heading) != whirl_table_field(f->table, 0, w->field, which)[column])
            fail_msg("not under '%s'", heading);
    }
    free(lines);
}

static void json_has_all(void **state) {
    const fixture *f = *state;
    FILE *stream = tmpfile();
    assert_non_null(stream);
    must(whirl_result_write_json(f->result, stream));
    rewind(stream);
    json_t *document = json_loadf(stream, 0, NULL);
    const json_t *point = json_array_get(json_object_get(document, "points"), 0);
    FOR_LIST for (size_t which = 0; which < many(f, w); which++) {
        const json_t *all = w->extent == WHIRL_PER_STATION ? json_object_get(point, "stations")
                                                           : json_object_get(json_object_get(point, "rub"), "contacts");
        const json_t *value = json_object_get(json_object_get(all, name_of(f, w, which)), strchr(w->field, '/') + 1);
        const double *numbers = whirl_table_field(f->table, 0, w->field, which);
        const double factor = strcmp(w->unit, "force") == 0 ? f->result->force_scale : 1.0;
        if (!value) fail_msg("%s is missing", w->field);
        for (size_t c = 0; c < w->columns; c++)
            assert_true(json_number_value(w->columns > 1 ? json_array_get(value, c) : value) == factor * numbers[c]);
    }
    json_decref(document);
    fclose(stream);
}

static void pages_have_all(void **state) {
    const fixture *f = *state;
    const whirl_report_options options = {.gnuplot = "true", .explorer = "template"};
    const char *const name = "made";
    FILE *template = fopen("template", "w");
    assert_non_null(template);
    fputs("@WHIRL-RUNS@", template);
    fclose(template);
    whirl_report_write((const whirl_result *const *)&f->result, &name, 1, "out", &options);
    char *report = read_all("out/report.html"), *explorer = read_all("out/explorer.html");
    FOR_LIST {
        char part[3 * WHIRL_NAME_SIZE];
        snprintf(part, sizeof part, "title=\"%s\">%s", w->meaning, strchr(w->field, '/') + 1);
        for (char *at = strchr(part, '>'); (at = strchr(at, '_')) != NULL;) *at = ' ';
        if (!strstr(report, part)) fail_msg("the report has no '%s'", part);
        snprintf(part, sizeof part, "\"name\":\"%s\",\"unit\":\"%s\",\"meaning\":\"%s\"", w->field, w->unit,
                 w->meaning);
        if (!strstr(explorer, part)) fail_msg("the explorer has no '%s'", part);
    }
    free(report);
    free(explorer);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fields_have_what_records_have),
        cmocka_unit_test(files_and_journals_keep_all),
        cmocka_unit_test(csv_has_all),
        cmocka_unit_test(json_has_all),
        cmocka_unit_test(pages_have_all),
    };
    return cmocka_run_group_tests_name("watched", tests, setup, teardown);
}
