#include "support_check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

double half_unit(const char *digits) {
    const char *point = strchr(digits, '.');
    return 0.5 * pow(10.0, point ? -(double)strlen(point + 1) : 0.0);
}

static void compare(const char *id, const char *what, const char *expected, double value, double obtained,
                    double tolerance) {
    const double difference = fabs(obtained - value);
    printf("%s | %s | %s | %.15g | %.2g | %.2g\n", id, what, expected, obtained, difference, tolerance);
    fflush(stdout);
    // Printed digits and the subtraction are rounded themselves.
    if (!(difference <= tolerance + 4e-16 * fabs(value)))
        fail_msg("%s, %s: expected %s, obtained %.15g, difference %.3g above %.3g", id, what, expected, obtained,
                 difference, tolerance);
}

void check_digits(const char *id, const char *what, const char *expected, double obtained) {
    compare(id, what, expected, strtod(expected, NULL), obtained, half_unit(expected));
}

void check_within(const char *id, const char *what, double expected, double obtained, double tolerance) {
    compare(id, what, words("%.15g", expected), expected, obtained, tolerance);
}

void note_within(const char *id, const char *what, double expected, double obtained, double tolerance) {
    const double difference = fabs(obtained - expected);
    printf("%s | %s | %.15g | %.15g | %.2g | %.2g%s\n", id, what, expected, obtained, difference, tolerance,
           difference <= tolerance ? "" : " (outside)");
    fflush(stdout);
}

void check_text(const char *id, const char *what, const char *expected, const char *obtained) {
    printf("%s | %s | %s | %s | - | exact\n", id, what, expected, obtained);
    fflush(stdout);
    assert_string_equal(expected, obtained);
}

void check_holds(const char *id, const char *statement, bool holds) {
    check_text(id, statement, "yes", holds ? "yes" : "no");
}

void require_ok(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s: %s", whirl_code_text(status.code), status.message);
}

const char *words(const char *format, ...) {
    static char buffers[8][128];
    static unsigned turn;
    char *buffer = buffers[turn++ % 8];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(buffer, sizeof buffers[0], format, arguments);
    va_end(arguments);
    return buffer;
}
