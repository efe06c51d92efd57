/// Whole files as strings, for tests that include cmocka.h.
#ifndef TEST_READ_ALL_H
#define TEST_READ_ALL_H

#include <stdio.h>
#include <stdlib.h>

/// Returns the file as a string, freed by the caller.
static inline char *read_all(const char *path) {
    FILE *stream = fopen(path, "rb");
    if (!stream) fail_msg("%s is not there", path);
    fseek(stream, 0, SEEK_END);
    const size_t size = (size_t)ftell(stream);
    rewind(stream);
    char *text = calloc(size + 1, 1);
    assert_non_null(text);
    assert_int_equal(fread(text, 1, size, stream), size);
    assert_int_equal(fclose(stream), 0);
    return text;
}

#endif
