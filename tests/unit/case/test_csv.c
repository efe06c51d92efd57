// Tables of numbers in text files: what is read, and what is refused with its place.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/internal/csv.h"

enum { LONGEST = 95 };

static whirl_status read_text(const char *text, csv_table *table) {
    return csv_read("a.csv", text, strlen(text), 4, table);
}

/// Writes "a [s],<heading>\n1,<number>\n" with a heading and a number of so many bytes.
static void write_table(char *text, size_t size, int heading, int number) {
    char name[200], digits[200] = "0.";
    memset(name, 'n', sizeof name);
    memset(digits + 2, '0', sizeof digits - 2);
    memcpy(digits + number - 4, "7e70", 4);
    snprintf(text, size, "a [s],%.*s\n1,%.*s\n", heading, name, number, digits);
}

/// Names and numbers of 95 bytes are read as they are written: 89 zeros stand before the digit 7.
static void long_cells_are_read_whole(void **state) {
    char text[600];
    csv_table table;
    (void)state;
    write_table(text, sizeof text, LONGEST, LONGEST);
    assert_int_equal(read_text(text, &table).code, WHIRL_OK);
    assert_int_equal(strlen(table.columns[1].name), LONGEST);
    const double expected = 7e-90 * 1e70;
    assert_true(csv_numbers(&table, 1)[0] > 0.999999 * expected && csv_numbers(&table, 1)[0] < 1.000001 * expected);
    csv_free(&table);
}

/// A cell that is too long is refused with its place and its length: if it were cut, it would be another name or
/// number.
static void longer_cells_are_refused(void **state) {
    char text[600];
    csv_table table;
    whirl_status status;
    (void)state;
    write_table(text, sizeof text, LONGEST + 1, 10);
    status = read_text(text, &table);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message,
                        "a.csv:1:7: the cell has 96 bytes ('nnnnnnnnnnnnnnnnnnnn...'), expected at most 95");
    csv_free(&table);
    write_table(text, sizeof text, 10, LONGEST + 5);
    status = read_text(text, &table);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message,
                        "a.csv:2:3: the cell has 100 bytes ('0.000000000000000000...'), expected at most 95");
    csv_free(&table);
}

/// A character is never cut: a long name of two-byte characters is shown up to the last whole one, and so is a title.
static void characters_stay_whole(void **state) {
    char text[1000], start[] = "#x";
    csv_table table;
    (void)state;
    snprintf(text, sizeof text, "s [s],n");
    for (int i = 0; i < 50; i++) strcat(text, "\xc3\xa4");
    strcat(text, "\n");
    const whirl_status status = read_text(text, &table);
    assert_string_equal(status.message,
                        "a.csv:1:7: the cell has 101 bytes ('n\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4"
                        "\xc3\xa4\xc3\xa4\xc3\xa4...'), expected at most 95");
    csv_free(&table);
    snprintf(text, sizeof text, "%s", start);
    for (int i = 0; i < 200; i++) strcat(text, "\xc3\xa4");
    strcat(text, "\ns [s]\n1\n");
    assert_int_equal(read_text(text, &table).code, WHIRL_OK);
    assert_int_equal(strlen(table.title), 1 + 2 * 125 + 3);
    assert_string_equal(table.title + 1 + 2 * 124, "\xc3\xa4...");
    csv_free(&table);
}

/// A zero byte ends no number.
static void zero_bytes_are_refused(void **state) {
    static const char text[] = "s [s]\n1\0002\n";
    csv_table table;
    (void)state;
    const whirl_status status = csv_read("a.csv", text, sizeof text - 1, 4, &table);
    assert_string_equal(status.message, "a.csv:2:1: '1' is no number");
    csv_free(&table);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(long_cells_are_read_whole),
        cmocka_unit_test(longer_cells_are_refused),
        cmocka_unit_test(characters_stay_whole),
        cmocka_unit_test(zero_bytes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
