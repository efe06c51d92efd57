#include "document.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include "number_text.h"
#include "utf8.h"
#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

enum { TEXT_SIZE = 1024 };

json_t *document_number(double value) {
    return isfinite(value) ? json_real(value) : json_null();
}

/// Copies a text that need not be valid UTF-8, with question marks for invalid bytes and control characters.
static const char *make_valid(const char *from, char valid[TEXT_SIZE]) {
    size_t length = 0;
    while (*from && length + 4 < TEXT_SIZE) {
        const size_t bytes = utf8_length_of_text(from);
        const bool plain = bytes > 0 && utf8_is_plain(from, bytes);
        if (!plain) valid[length++] = '?';
        for (size_t i = 0; plain && i < bytes; ++i) valid[length++] = from[i];
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

static json_t *member_value(const whirl_member *member, const void *from) {
    const double number = whirl_member_number(member, from);
    return member->type == WHIRL_MEMBER_WORD     ? document_text((const char *)from + member->offset)
           : member->type == WHIRL_MEMBER_FLAG   ? json_boolean(number != 0.0)
           : member->type == WHIRL_MEMBER_NUMBER ? document_number(number)
                                                 : json_integer((json_int_t)number);
}

void document_put_members(bool *well, json_t *object, const whirl_member *member, const void *from) {
    for (; member->part; ++member)
        if (member->name) document_put(well, object, member->name, member_value(member, from));
}

/// Writes a real number with a point or exponent: 2.0, not 2.
static bool write_real(double value, FILE *stream) {
    char text[NUMBER_SIZE];
    number_text(value, text);
    return fprintf(stream, "%s%s", text, strpbrk(text, ".e") ? "" : ".0") > 0;
}

static bool write_value(json_t *value, FILE *stream);

static bool write_array(json_t *array, FILE *stream) {
    bool done = fputc('[', stream) != EOF;
    for (size_t i = 0; i < json_array_size(array) && done; ++i)
        done = fputs(i ? ", " : "", stream) != EOF && write_value(json_array_get(array, i), stream);
    return done && fputc(']', stream) != EOF;
}

static bool write_object(json_t *object, FILE *stream) {
    const char *key, *separator = "";
    json_t *value;
    bool done = fputc('{', stream) != EOF;
    json_object_foreach(object, key, value) {
        done = done && fputs(separator, stream) != EOF && document_write(true, json_string(key), stream) &&
               fputs(": ", stream) != EOF && write_value(value, stream);
        separator = ", ";
    }
    return done && fputc('}', stream) != EOF;
}

/// Writes a value as Jansson does, but real numbers with only as many digits as they need. All documents are made in
/// this program, so that the depth of recursion is bounded.
static bool write_value(json_t *value, FILE *stream) {
    switch (json_typeof(value)) {
    case JSON_OBJECT:
        return write_object(value, stream);
    case JSON_ARRAY:
        return write_array(value, stream);
    case JSON_REAL:
        return write_real(json_real_value(value), stream);
    default:
        return json_dumpf(value, stream, JSON_ENCODE_ANY) == 0;
    }
}

bool document_write(bool well, json_t *value, FILE *stream) {
    const bool done = well && value && write_value(value, stream);
    json_decref(value);
    return done;
}

whirl_status document_finish(bool well, json_t *object, FILE *stream) {
    errno = 0;
    well = document_write(well, object, stream);
    fputc('\n', stream);
    if (fflush(stream) != 0 || ferror(stream))
        return whirl_fail(WHIRL_IO_ERROR, "cannot write JSON: %s", strerror(errno ? errno : EIO));
    return well ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory to write JSON");
}
