/// The tests of a layer as one program:  PROGRAM [NAME[:TEST]...]
/// Each file of tests is a main of its own, which the build renames; without a name their names are printed. With TEST
/// that one of its tests runs alone.
#include "runner.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static int run(const char *wanted) {
    const char *test = strchr(wanted, ':');
    const size_t length = test ? (size_t)(test - wanted) : strlen(wanted);
    cmocka_set_test_filter(test ? test + 1 : NULL);
    for (size_t i = 0; i < test_file_count; i++)
        if (strlen(test_files[i].name) == length && strncmp(test_files[i].name, wanted, length) == 0)
            return test_files[i].run();
    fprintf(stderr, "there is no file of tests '%s'\n", wanted);
    return 2;
}

int main(int count, char **arguments) {
    int failures = 0;
    if (count == 1)
        for (size_t i = 0; i < test_file_count; i++) puts(test_files[i].name);
    for (int i = 1; i < count; i++) failures += run(arguments[i]);
    return failures > 255 ? 255 : failures;
}
