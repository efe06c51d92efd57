// Facts about the build and the host.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "whirl/engine/result.h"
#include "whirl/version.h"

#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>

static const char *fact(const whirl_result *result, const char *name) {
    for (size_t i = 0; i < result->fact_count; ++i)
        if (strcmp(result->facts[i].name, name) == 0) return result->facts[i].value;
    return "";
}

static void says_what_ran_where(void **state) {
    (void)state;
    static const char *const names[] = {"version",    "revision",  "sources", "compiler", "flags",
                                        "build type", "libraries", "host",    "system",   "processor"};
    whirl_result *result = calloc(1, sizeof *result);
    struct utsname system;
    assert_int_equal(uname(&system), 0);
    assert_int_equal(whirl_result_add_provenance(result).code, WHIRL_OK);
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i)
        if (!*fact(result, names[i])) fail_msg("the %s is missing", names[i]);
    assert_string_equal(fact(result, "version"), WHIRL_VERSION);
    assert_int_equal(strspn(fact(result, "sources"), "0123456789abcdef"), 64);
    assert_string_equal(fact(result, "host"), system.nodename);
    assert_non_null(strstr(fact(result, "system"), system.release));
    // Once more changes nothing.
    const size_t count = result->fact_count;
    assert_int_equal(whirl_result_add_provenance(result).code, WHIRL_OK);
    assert_int_equal(result->fact_count, count);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(says_what_ran_where)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
