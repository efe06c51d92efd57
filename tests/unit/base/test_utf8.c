// Characters of UTF-8, and which of them are shown. Numbers are those of the Unicode Standard.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdbool.h>
#include <string.h>

#include "utf8.h"
#include "whirl/status.h"

/// Encodes a character by RFC 3629, section 3; returns the number of bytes.
static size_t encode(unsigned number, char *text) {
    if (number < 0x80) return text[0] = (char)number, 1;
    const size_t length = number < 0x800 ? 2 : number < 0x10000 ? 3 : 4;
    static const unsigned lead[] = {0, 0, 0xC0, 0xE0, 0xF0};
    for (size_t i = length - 1; i > 0; i--, number >>= 6) text[i] = (char)(0x80 | (number & 0x3F));
    text[0] = (char)(lead[length] | number);
    return length;
}

/// Returns true for the property Bidi_Control (PropList.txt) and the categories Cc, Zl and Zp.
static bool steers(unsigned number) {
    static const unsigned marks[] = {0x061C, 0x200E, 0x200F, 0x202A, 0x202B, 0x202C, 0x202D,
                                     0x202E, 0x2066, 0x2067, 0x2068, 0x2069, 0x2028, 0x2029};
    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++)
        if (number == marks[i]) return true;
    return number < 0x20 || (number >= 0x7F && number <= 0x9F);
}

static void every_character_has_its_length(void **state) {
    (void)state;
    for (unsigned number = 0; number <= 0x10FFFF; number++) {
        char text[8] = "";
        const size_t length = encode(number, text);
        if (number >= 0xD800 && number <= 0xDFFF) {
            assert_int_equal(utf8_length(text, length), 0);
            continue;
        }
        assert_int_equal(utf8_length(text, length), length);
        assert_int_equal(utf8_character(text, length), number);
        assert_int_equal(utf8_is_plain(text, length), !steers(number));
    }
}

static void lines_are_made_plain(void **state) {
    static const char *const lines[][2] = {
        {"", ""},
        {"Poincar\xC3\xA9, \xD7\xA9\xD7\x9C", "Poincar\xC3\xA9, \xD7\xA9\xD7\x9C"},
        {"\x1b[2J\r\n\x07", "?[2J???"},
        {"\xC2\x9B"
         "1m\xE2\x80\xAE"
         "a\xF0\x9F\x98\x80",
         "?1m?a\xF0\x9F\x98\x80"},
        {"cut \xE2\x80", "cut ??"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char line[64];
        strcpy(line, lines[i][0]);
        whirl_make_plain(line);
        assert_string_equal(line, lines[i][1]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_character_has_its_length),
        cmocka_unit_test(lines_are_made_plain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
