#include "utf8.h"

size_t utf8_length(const char *text) {
    const unsigned char *byte = (const unsigned char *)text;
    const unsigned char lead = byte[0];
    if (lead < 0x80) return 1;
    const size_t length = lead >= 0xC2 && lead < 0xE0 ? 2 : lead >= 0xE0 && lead < 0xF0 ? 3 : lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
    for (size_t i = 1; i < length; i++)
        if ((byte[i] & 0xC0) != 0x80) return 0;
    if (lead == 0xE0 && byte[1] < 0xA0) return 0; // overlong
    if (lead == 0xED && byte[1] > 0x9F) return 0; // surrogates
    if (lead == 0xF0 && byte[1] < 0x90) return 0; // overlong
    if (lead == 0xF4 && byte[1] > 0x8F) return 0; // beyond U+10FFFF
    return length;
}
