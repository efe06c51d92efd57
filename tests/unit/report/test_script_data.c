// Data inside pages: texts that could end a script element, and base64 against the vectors of RFC 4648.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "figure_build.h"

/// A stream in memory, whose content is read back as text.
typedef struct sheet {
    FILE *stream;
    char *text;
    size_t size;
} sheet;

static void sheet_open(sheet *made) {
    *made = (sheet){0};
    made->stream = open_memstream(&made->text, &made->size);
    assert_non_null(made->stream);
}

static void sheet_expect(sheet *made, const char *expected) {
    fclose(made->stream);
    assert_string_equal(made->text, expected);
    free(made->text);
}

static void expect_text(const char *text, const char *expected) {
    sheet made;
    sheet_open(&made);
    script_text(made.stream, text);
    sheet_expect(&made, expected);
}

static void texts_cannot_be_markup(void **state) {
    (void)state;
    expect_text("plain", "\"plain\"");
    expect_text("</script>", "\"\\u003c/script\\u003e\"");
    expect_text("<!--&", "\"\\u003c!--\\u0026\"");
    expect_text("\"\\\n\t\x7F", "\"\\u0022\\u005c\\u000a\\u0009\\u007f\"");
    expect_text("\xC2\xB5m", "\"\xC2\xB5m\"");
    expect_text("a\xFF\xC0\xAF", "\"a\\ufffd\\ufffd\\ufffd\"");
}

static void numbers_are_json(void **state) {
    (void)state;
    static const struct {
        double value;
        const char *text;
    } cases[] = {{0.1, "0.1"},
                 {0.1 + 0.2, "0.30000000000000004"},
                 {-2.0, "-2"},
                 {(double)NAN, "null"},
                 {(double)INFINITY, "null"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        sheet made;
        sheet_open(&made);
        script_number(made.stream, cases[i].value);
        sheet_expect(&made, cases[i].text);
    }
}

static void base64_as_in_the_standard(void **state) {
    (void)state;
    static const char *const vectors[][2] = {{"", ""},
                                             {"f", "Zg=="},
                                             {"fo", "Zm8="},
                                             {"foo", "Zm9v"},
                                             {"foob", "Zm9vYg=="},
                                             {"fooba", "Zm9vYmE="},
                                             {"foobar", "Zm9vYmFy"}};
    for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++) {
        sheet made;
        sheet_open(&made);
        base64 to = {.stream = made.stream};
        for (const char *byte = vectors[i][0]; *byte; byte++) base64_byte(&to, (uint8_t)*byte);
        base64_end(&to);
        sheet_expect(&made, vectors[i][1]);
    }
}

static void floats_are_little_endian(void **state) {
    (void)state;
    sheet made;
    sheet_open(&made);
    base64 to = {.stream = made.stream};
    base64_float32(&to, 1.0);  // 00 00 80 3f
    base64_float64(&to, -2.0); // 00 .. 00 c0
    base64_end(&to);
    sheet_expect(&made, "AACAPwAAAAAAAADA");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texts_cannot_be_markup),
        cmocka_unit_test(numbers_are_json),
        cmocka_unit_test(base64_as_in_the_standard),
        cmocka_unit_test(floats_are_little_endian),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
