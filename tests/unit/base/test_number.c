// Numbers as text: no digit too many, no bit lost.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "number_text.h"

static void short_decimals_stay_short(void **state) {
    static const struct {
        double value;
        const char *text;
    } pairs[] = {
        {0.1, "0.1"},
        {0.3, "0.3"},
        {-2.5, "-2.5"},
        {650, "650"},
        {0.0002, "0.0002"},
        {1e-9, "1e-09"},
        {1e22, "1e+22"},
        {0.0, "0"},
        {-0.0, "-0"},
        {0.1 + 0.2, "0.30000000000000004"},
        {1.0 / 3.0, "0.3333333333333333"},
        {123456.789, "123456.789"},
    };
    char text[NUMBER_SIZE];
    (void)state;
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        number_text(pairs[i].value, text);
        assert_string_equal(text, pairs[i].text);
    }
}

/// Doubles of random bits (a linear congruential generator by Knuth, MMIX) and the ends of the range come back.
static void every_double_comes_back(void **state) {
    const double ends[] = {5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, -4.9406564584124654e-320};
    uint64_t bits = 1;
    char text[NUMBER_SIZE];
    (void)state;
    for (size_t i = 0; i < 100000; i++) {
        double value;
        bits = bits * 6364136223846793005u + 1442695040888963407u;
        memcpy(&value, &bits, sizeof value);
        if (i < sizeof ends / sizeof *ends) value = ends[i];
        if (!isfinite(value)) continue;
        number_text(value, text);
        const double back = strtod(text, NULL);
        assert_memory_equal(&back, &value, sizeof value);
    }
}

/// Returns the number of significant digits of a written number, without zeros at its ends.
static size_t significant_digits(const char *text) {
    size_t count = 0, zeros = 0;
    for (; *text && *text != 'e'; text++) {
        if (*text < '0' || *text > '9' || (*text == '0' && count == 0)) continue;
        zeros = *text == '0' ? zeros + 1 : 0;
        count++;
    }
    return count - zeros;
}

/// A number that was written with up to 15 digits is written with the same digits.
static void decimals_of_15_digits_need_no_more(void **state) {
    uint64_t bits = 7;
    char text[NUMBER_SIZE], given[NUMBER_SIZE];
    (void)state;
    for (int i = 0; i < 20000; i++) {
        bits = bits * 6364136223846793005u + 1442695040888963407u;
        const int digits = 1 + (int)(bits >> 33) % 15;
        snprintf(given, sizeof given, "%.*e", digits - 1, (double)(bits >> 11) * pow(10, i % 40 - 30));
        number_text(strtod(given, NULL), text);
        assert_true(significant_digits(text) <= (size_t)digits);
        assert_true(strtod(text, NULL) == strtod(given, NULL));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(short_decimals_stay_short),
        cmocka_unit_test(every_double_comes_back),
        cmocka_unit_test(decimals_of_15_digits_need_no_more),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
