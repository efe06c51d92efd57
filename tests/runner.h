/// The files of tests that a program is made of; the build writes the table (cmake/testing.cmake).
#ifndef TESTS_RUNNER_H
#define TESTS_RUNNER_H

#include <stddef.h>

typedef struct {
    const char *name;
    int (*run)(void); ///< 0, or how many of its tests failed
} test_file;

extern const test_file test_files[];
extern const size_t test_file_count;

#endif
