// The explorer's page: large tables are thinned evenly, everything else is there.
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

#include "whirl/engine/report.h"

#include "../read_all.h"

/// One point more than fit, with a section of more rows than fit: every second point stays, and the last 2^20/count
/// rows.
enum { POINTS = 65537, ROWS = 40, COLUMNS = 2, KEPT = 32769, KEPT_ROWS = 31 };

static whirl_result *large_result(void) {
    whirl_result *result = calloc(1, sizeof *result);
    whirl_table *table = calloc(1, sizeof *table);
    assert_true(result && table);
    *table = (whirl_table){.name = "sweep", .role = WHIRL_ROLE_SURVEY, .parameter = "a", .count = POINTS};
    table->layout = (whirl_layout){.field_count = 1, .size = (size_t)ROWS * COLUMNS};
    table->layout.fields[0] = (whirl_field){.name = "poincare/section",
                                            .unit = "length",
                                            .meaning = "x, y",
                                            .extent = WHIRL_PER_STATION,
                                            .rows = ROWS,
                                            .columns = COLUMNS,
                                            .repeat = 1};
    table->values = calloc(POINTS, sizeof *table->values);
    table->branch = calloc(POINTS, sizeof *table->branch);
    table->blocks = calloc((size_t)POINTS * ROWS * COLUMNS, sizeof *table->blocks);
    assert_true(table->values && table->branch && table->blocks);
    result->case_text = calloc(1, 1);
    result->tables = table;
    result->table_count = 1;
    return result;
}

/// Returns the number of bytes that the base64 text after `key` encodes.
static size_t decoded_size(const char *text, const char *key) {
    const char *at = strstr(text, key);
    assert_non_null(at);
    at += strlen(key);
    const size_t length = strcspn(at, "\"=");
    return length * 3 / 4;
}

/// Returns the explorer of a result, by a template of its mark alone; to be freed.
static char *page_of(const whirl_result *result) {
    char folder[] = "/tmp/whirl-explorer-XXXXXX", path[64];
    const char *const names[] = {"large"};
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/template", folder);
    FILE *template = fopen(path, "w");
    assert_non_null(template);
    fputs("@WHIRL-RUNS@", template);
    fclose(template);
    assert_int_equal(whirl_explorer_write(path, &result, names, 1, folder).code, WHIRL_OK);
    unlink(path);
    snprintf(path, sizeof path, "%s/explorer.html", folder);
    char *page = read_all(path);
    unlink(path);
    rmdir(folder);
    return page;
}

static void large_tables_are_thinned(void **state) {
    (void)state;
    whirl_result *result = large_result();
    char *page = page_of(result);
    assert_non_null(strstr(page, "\"points\":65537,\"count\":32769"));
    assert_non_null(strstr(page, "\"repeat\":1,\"rows\":31,\"columns\":2"));
    assert_int_equal(decoded_size(page, "\"values\":\""), KEPT * sizeof(double));
    assert_int_equal(decoded_size(page, "\"data\":\""), (size_t)KEPT * KEPT_ROWS * COLUMNS * sizeof(float));
    free(page);
    whirl_result_free(result);
}

/// Makes a map of `columns` and `rows`, with a regime and an arbitrary number in every cell.
static whirl_result *map_of(size_t columns, size_t rows) {
    static const char *const names[] = {"map/second", "regime/code", "made/number"};
    whirl_result *result = calloc(1, sizeof *result);
    whirl_table *table = calloc(1, sizeof *table);
    assert_true(result && table);
    const size_t count = columns * rows, size = sizeof names / sizeof *names;
    *table = (whirl_table){
        .name = "map", .role = WHIRL_ROLE_MAP, .parameter = "a", .second = "b", .row = columns, .count = count};
    table->layout = (whirl_layout){.field_count = size, .size = size};
    for (size_t f = 0; f < size; f++) {
        table->layout.fields[f] = (whirl_field){
            .unit = "1", .meaning = "", .extent = WHIRL_PER_POINT, .rows = 1, .columns = 1, .repeat = 1, .offset = f};
        snprintf(table->layout.fields[f].name, WHIRL_NAME_SIZE, "%s", names[f]);
    }
    table->values = calloc(count, sizeof *table->values);
    table->branch = calloc(count, sizeof *table->branch);
    table->blocks = calloc(count * size, sizeof *table->blocks);
    assert_true(table->values && table->branch && table->blocks);
    for (size_t i = 0; i < count; i++) table->values[i] = (double)(i % columns);
    for (size_t i = 0; i < count; i++) table->blocks[i * size] = (double)(i / columns);
    result->case_text = calloc(1, 1);
    result->tables = table;
    result->table_count = 1;
    return result;
}

/// Small maps have all numbers. Maps up to a million cells have all cells with the most used numbers, still larger ones
/// every second column and row.
static void maps_are_leaner_and_then_thinned(void **state) {
    static const struct {
        size_t columns, rows, stride;
        bool lean;
    } maps[] = {{128, 128, 1, false}, {129, 128, 1, true}, {1024, 1024, 1, true}, {1025, 1024, 2, true}};
    (void)state;
    for (size_t i = 0; i < sizeof maps / sizeof *maps; i++) {
        whirl_result *result = map_of(maps[i].columns, maps[i].rows);
        char *page = page_of(result), there[64];
        const size_t columns = (maps[i].columns - 1) / maps[i].stride + 1,
                     rows = (maps[i].rows - 1) / maps[i].stride + 1;
        snprintf(there, sizeof there, "\"columns\":%zu,\"rows\":%zu,\"x\":\"", columns, rows);
        assert_non_null(strstr(page, there));
        assert_int_equal(decoded_size(page, "\"x\":\""), columns * sizeof(double));
        assert_int_equal(decoded_size(page, "\"y\":\""), rows * sizeof(double));
        assert_null(strstr(page, "\"cells\""));
        const char *regimes = strstr(page, "\"regime/code\"");
        assert_non_null(regimes);
        assert_int_equal(decoded_size(regimes, "\"data\":\""), columns * rows * sizeof(float));
        assert_int_equal(strstr(page, "\"made/number\"") == NULL, maps[i].lean);
        free(page);
        whirl_result_free(result);
    }
}

/// A map with missing points lists the cells of its points.
static void maps_with_holes_list_their_cells(void **state) {
    (void)state;
    whirl_result *result = map_of(3, 2);
    result->tables[0].done = calloc(6, 1);
    assert_non_null(result->tables[0].done);
    memset(result->tables[0].done, 1, 6);
    result->tables[0].done[2] = result->tables[0].done[4] = 0;
    char *page = page_of(result);
    assert_non_null(strstr(page, "\"points\":6,\"count\":4"));
    assert_non_null(strstr(page, "\"cells\":[0,1,3,5]"));
    free(page);
    whirl_result_free(result);
}

/// A refined map with one undivided square, cut off above: its corners are in the page, in a grid of all cells.
static void refined_maps_list_their_squares(void **state) {
    static const size_t corners[] = {0, 4, 10, 14};
    (void)state;
    whirl_result *result = map_of(5, 3);
    whirl_table *table = &result->tables[0];
    strcpy(table->layout.fields[2].name, "map/width");
    table->refine = 4;
    table->grid = 15;
    table->count = 4;
    table->slots = calloc(4, sizeof *table->slots);
    assert_non_null(table->slots);
    for (size_t i = 0; i < 4; i++) {
        table->slots[i] = corners[i];
        table->values[i] = (double)(corners[i] % 5);
        table->blocks[3 * i] = (double)(corners[i] / 5);
        table->blocks[3 * i + 2] = i == 0 ? 4 : 1;
    }
    char *page = page_of(result);
    assert_non_null(strstr(page, "\"columns\":5,\"rows\":3,\"x\":\""));
    assert_int_equal(decoded_size(page, "\"y\":\""), 3 * sizeof(double));
    assert_non_null(strstr(page, "\"cells\":[0,4,10,14],\"widths\":[4,1,1,1]}"));
    free(page);
    whirl_result_free(result);
}

/// With one point too many every second point stays, and all points that were located between them.
static void critical_speeds_are_never_thinned(void **state) {
    (void)state;
    enum { NUMBERS = 600 };
    const size_t left_out = 1;
    const size_t most = ((size_t)1 << 22) / (NUMBERS + 1) + 1, count = most + 1;
    whirl_result *result = calloc(1, sizeof *result);
    whirl_table *table = calloc(1, sizeof *table);
    assert_true(result && table);
    *table = (whirl_table){.name = "modes", .parameter = "a", .count = count};
    whirl_analysis_add(&table->analyses, "modes");
    table->layout = (whirl_layout){.field_count = 1, .size = NUMBERS};
    table->layout.fields[0] = (whirl_field){.name = "modes/critical",
                                            .unit = "1",
                                            .meaning = "kind, value, speed, frequency, damping, direction",
                                            .extent = WHIRL_PER_POINT,
                                            .rows = NUMBERS / 6,
                                            .columns = 6,
                                            .repeat = 1};
    table->values = calloc(count, sizeof *table->values);
    table->branch = calloc(count, sizeof *table->branch);
    table->done = calloc(count, 1);
    table->blocks = calloc(count * NUMBERS, sizeof *table->blocks);
    assert_true(table->values && table->branch && table->done && table->blocks);
    for (size_t i = 0; i < count * NUMBERS; i++) table->blocks[i] = (double)NAN;
    const double located[] = {1, 0.1234567890123, 2, 3, 0.5, -1};
    memcpy(table->blocks + left_out * NUMBERS, located, sizeof located);
    memset(table->done, 1, count);
    result->case_text = calloc(1, 1);
    result->tables = table;
    result->table_count = 1;

    char *page = page_of(result), expected[96];
    snprintf(expected, sizeof expected, "\"points\":%zu,\"count\":%zu", count, (count - 1) / 2 + 1);
    assert_non_null(strstr(page, expected));
    assert_non_null(strstr(page, "\"critical\":[[1,0.1234567890123,2,3,0.5,-1]]"));
    free(page);
    whirl_result_free(result);
}

/// Makes a result of branches of `count` orbits of one revolution in 64 segments of 256 coordinates. All numbers of
/// orbit p are p; the last orbit is not done.
static whirl_result *many_orbits(size_t count) {
    enum { SEGMENTS = 64, DIMENSION = 256, NODES = SEGMENTS * DIMENSION };
    static const whirl_system system = {.dimension = DIMENSION};
    const whirl_integrate_options integrate = whirl_integrate_default();
    whirl_result *result = calloc(1, sizeof *result);
    whirl_table *table = calloc(1, sizeof *table);
    assert_true(result && table);
    *table = (whirl_table){.name = "branch",
                           .role = WHIRL_ROLE_BRANCHES,
                           .parameter = "a",
                           .count = count,
                           .record = whirl_record_default()};
    table->record.trace.segments = SEGMENTS;
    table->record.trace.longest = 1;
    whirl_analysis_add(&table->analyses, "trace");
    assert_int_equal(whirl_layout_new(&system, &integrate, &table->record, table->analyses, &table->layout).code,
                     WHIRL_OK);
    table->values = calloc(count, sizeof *table->values);
    table->branch = calloc(count, sizeof *table->branch);
    table->done = calloc(count, 1);
    table->blocks = calloc(count * table->layout.size, sizeof *table->blocks);
    assert_true(table->values && table->branch && table->done && table->blocks);
    for (size_t p = 0; p < count; p++) {
        double *block = table->blocks + p * table->layout.size;
        block[whirl_layout_field(&table->layout, "trace/revolutions")->offset] = 1.0;
        block[whirl_layout_field(&table->layout, "trace/period")->offset] = 0.5;
        double *nodes = block + whirl_layout_field(&table->layout, "trace/nodes")->offset;
        for (size_t i = 0; i < NODES; i++) nodes[i] = (double)p;
        table->done[p] = p + 1 < count;
    }
    result->case_text = calloc(1, 1);
    result->tables = table;
    result->table_count = 1;
    return result;
}

// A million numbers are there at most: of every second orbit here, each with its period, and none of what is not done.
static void orbits_are_thinned(void **state) {
    (void)state;
    enum { NUMBERS = 64 * 256 };
    for (size_t count = 64; count <= 67; count += 3) {
        whirl_result *result = many_orbits(count);
        char *page = page_of(result);
        const size_t kept = count == 64 ? 63 : 33; // 0, 2, ..., 64; 66 is not done
        assert_non_null(strstr(page, count == 64 ? "\"orbit_stride\":1" : "\"orbit_stride\":2"));
        assert_int_equal(decoded_size(page, "\"orbits\":\""), kept * (1 + NUMBERS) * sizeof(double));
        free(page);
        whirl_result_free(result);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(large_tables_are_thinned),         cmocka_unit_test(critical_speeds_are_never_thinned),
        cmocka_unit_test(maps_are_leaner_and_then_thinned), cmocka_unit_test(maps_with_holes_list_their_cells),
        cmocka_unit_test(refined_maps_list_their_squares),  cmocka_unit_test(orbits_are_thinned)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
