// Versions that a program may require.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdbool.h>
#include <stdio.h>

#include "whirl/version.h"

enum { MAJOR = WHIRL_VERSION_MAJOR, MINOR = WHIRL_VERSION_MINOR, PATCH = WHIRL_VERSION_PATCH };

/// Returns a version as one number; versions were published in the order of these numbers.
static long place(int major, int minor, int patch) {
    return (major * 1000L + minor) * 1000L + patch;
}

static void earlier_versions_are_served(void **state) {
    (void)state;
    for (int major = 0; major <= MAJOR + 2; major++)
        for (int minor = 0; minor <= MINOR + 2; minor++)
            for (int patch = 0; patch <= PATCH + 2; patch++) {
                const whirl_status status = whirl_version_check(major, minor, patch);
                const bool served = place(MAJOR, MINOR, PATCH) >= place(major, minor, patch);
                assert_int_equal(status.code, served ? WHIRL_OK : WHIRL_BAD_INPUT);
                assert_int_equal(WHIRL_VERSION_AT_LEAST(major, minor, patch), served);
            }
}

static void later_versions_are_refused_in_a_sentence(void **state) {
    char expected[200];
    (void)state;
    snprintf(expected, sizeof expected, "the library is whirl %d.%d.%d, expected %d.0.0 or a later version", MAJOR,
             MINOR, PATCH, MAJOR + 1);
    assert_string_equal(whirl_version_check(MAJOR + 1, 0, 0).message, expected);
    assert_string_equal(whirl_version(), WHIRL_VERSION);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(earlier_versions_are_served),
        cmocka_unit_test(later_versions_are_refused_in_a_sentence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
