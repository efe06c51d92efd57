#include "figure_build.h"

#include <math.h>
#include <string.h>

#include "number_text.h"
#include "utf8.h"
#include "whirl/engine/descriptor.h"

/// Writes a character as \uXXXX; all characters to be escaped have at most four digits.
static void escape(FILE *stream, unsigned character) {
    fprintf(stream, "\\u%04x", character);
}

void script_text(FILE *stream, const char *text) {
    fputc('"', stream);
    while (*text) {
        const size_t length = utf8_length_of_text(text);
        if (length == 0)
            fputs("\\ufffd", stream);
        else if (!utf8_is_plain(text, length) || (length == 1 && strchr("\"\\<>&", *text)))
            escape(stream, utf8_character(text, length));
        else
            fwrite(text, 1, length, stream);
        text += length ? length : 1;
    }
    fputc('"', stream);
}

void script_number(FILE *stream, double value) {
    char text[NUMBER_SIZE] = "null";
    if (isfinite(value)) number_text(value, text);
    fputs(text, stream);
}

void script_key(FILE *stream, char before, const char *key) {
    fputc(before, stream);
    script_text(stream, key);
    fputc(':', stream);
}

void script_text_member(FILE *stream, char before, const char *key, const char *text) {
    script_key(stream, before, key);
    script_text(stream, text);
}

void script_number_member(FILE *stream, char before, const char *key, double value) {
    script_key(stream, before, key);
    script_number(stream, value);
}

void script_members(FILE *stream, const whirl_member *member, const void *from) {
    char text[WHIRL_NAME_SIZE];
    for (; member->part; member++) {
        if (!member->name) continue;
        fprintf(stream, ",\"%s\":", member->name);
        whirl_member_text(member, from, text);
        if (member->type == WHIRL_MEMBER_WORD)
            script_text(stream, text);
        else
            fputs(isfinite(whirl_member_number(member, from)) ? text : "null", stream);
    }
}

static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

void base64_byte(base64 *to, uint8_t byte) {
    to->bits = to->bits << 8 | byte;
    if (++to->count < 3) return;
    const char four[4] = {digits[to->bits >> 18 & 63], digits[to->bits >> 12 & 63], digits[to->bits >> 6 & 63],
                          digits[to->bits & 63]};
    fwrite(four, 1, sizeof four, to->stream);
    to->bits = 0;
    to->count = 0;
}

void base64_float32(base64 *to, double value) {
    const float narrow = (float)value;
    uint32_t bits;
    memcpy(&bits, &narrow, sizeof bits);
    for (unsigned shift = 0; shift < 32; shift += 8) base64_byte(to, (uint8_t)(bits >> shift));
}

void base64_float64(base64 *to, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    for (unsigned shift = 0; shift < 64; shift += 8) base64_byte(to, (uint8_t)(bits >> shift));
}

void base64_end(base64 *to) {
    const unsigned held = to->count;
    if (held == 0) return;
    for (unsigned i = held; i < 3; i++) to->bits <<= 8;
    const char four[4] = {digits[to->bits >> 18 & 63], digits[to->bits >> 12 & 63],
                          held == 2 ? digits[to->bits >> 6 & 63] : '=', '='};
    fwrite(four, 1, sizeof four, to->stream);
    to->bits = 0;
    to->count = 0;
}
