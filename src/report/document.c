#include "document.h"

#include <math.h>

#include "utf8.h"

// 17 digits give the same double back.
enum { DUMP_FLAGS = JSON_REAL_PRECISION(17) | JSON_ENCODE_ANY, TEXT_SIZE = 1024 };

json_t *document_number(double value) {
    return isfinite(value) ? json_real(value) : json_null();
}

// Text from a file may be anything.
static const char *make_valid(const char *from, char valid[TEXT_SIZE]) {
    size_t length = 0;
    while (*from && length + 4 < TEXT_SIZE) {
        const size_t bytes = utf8_length_of_text(from);
        if (bytes == 0) valid[length++] = '?';
        for (size_t i = 0; i < bytes; ++i) valid[length++] = from[i];
        from += bytes > 0 ? bytes : 1;
    }
    valid[length] = '\0';
    return valid;
}

json_t *document_text(const char *text) {
    char valid[TEXT_SIZE];
    return json_string(make_valid(text, valid));
}

void document_put(bool *well, json_t *object, const char *key, json_t *value) {
    char valid[TEXT_SIZE];
    if (json_object_set_new(object, make_valid(key, valid), value) != 0) *well = false;
}

void document_append(bool *well, json_t *array, json_t *value) {
    if (json_array_append_new(array, value) != 0) *well = false;
}

bool document_write(bool well, json_t *value, FILE *stream) {
    const bool done = well && value && json_dumpf(value, stream, DUMP_FLAGS) == 0;
    json_decref(value);
    return done;
}
