#include "utf8.h"

#include <string.h>

#include "whirl/status.h"

const char *utf8_skip_mark(const char *text, size_t *length) {
    static const char mark[] = "\xEF\xBB\xBF";
    if (*length < sizeof mark - 1 || memcmp(text, mark, sizeof mark - 1) != 0) return text;
    *length -= sizeof mark - 1;
    return text + sizeof mark - 1;
}

size_t utf8_length(const char *text, size_t left) {
    const unsigned char *byte = (const unsigned char *)text;
    const unsigned char lead = byte[0];
    if (lead < 0x80) return 1;
    if (lead < 0xC2 || lead > 0xF4) return 0;
    const size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (left < length) return 0;
    // The second byte excludes overlong forms, surrogates and what is beyond U+10FFFF.
    const unsigned char low = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
    const unsigned char high = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
    if (byte[1] < low || byte[1] > high) return 0;
    for (size_t i = 2; i < length; i++)
        if ((byte[i] & 0xC0) != 0x80) return 0;
    return length;
}

unsigned utf8_character(const char *text, size_t length) {
    static const unsigned char lead[5] = {0, 0x7F, 0x1F, 0x0F, 0x07};
    unsigned number = (unsigned char)text[0] & lead[length];
    for (size_t i = 1; i < length; i++) number = number << 6 | ((unsigned char)text[i] & 0x3Fu);
    return number;
}

bool utf8_is_plain(const char *text, size_t length) {
    static const unsigned ranges[][2] = {
        {0, 0x1F},        {0x7F, 0x9F}, {0x061C, 0x061C}, // Arabic letter mark
        {0x200E, 0x200F},                                 // marks of direction
        {0x2028, 0x202E},                                 // ends of lines, embeddings and overrides
        {0x2066, 0x2069},                                 // isolates
    };
    const unsigned number = utf8_character(text, length);
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++)
        if (number >= ranges[i][0] && number <= ranges[i][1]) return false;
    return true;
}

void whirl_make_plain(char *text) {
    char *to = text;
    while (*text) {
        const size_t length = utf8_length_of_text(text);
        const bool plain = length > 0 && utf8_is_plain(text, length);
        if (!plain) *to++ = '?';
        for (size_t i = 0; plain && i < length; i++) *to++ = text[i];
        text += length ? length : 1;
    }
    *to = '\0';
}
