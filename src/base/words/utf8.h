/// UTF-8, as far as readers and reports need it.
#ifndef BASE_UTF8_H
#define BASE_UTF8_H

#include <stdbool.h>
#include <stddef.h>

/// Skips the byte order mark (Unicode 15, 23.8; YAML 1.2, 5.2) that editors of Windows write before a text in UTF-8:
/// returns the text after it and shortens `length`.
const char *utf8_skip_mark(const char *text, size_t *length);

/// Returns the size of the character at the start of `text`, 1 to 4 bytes, of which `left` may be read (at least one);
/// 0 if it is not valid: overlong forms, surrogates and truncated characters are invalid.
size_t utf8_length(const char *text, size_t left);

/// The same for a text that ends with a zero byte.
static inline size_t utf8_length_of_text(const char *text) {
    return utf8_length(text, 4);
}

/// Returns the most bytes, up to `most`, after which a longer text can be cut without cutting a character.
static inline size_t utf8_cut(const char *text, size_t most) {
    while (most > 0 && ((unsigned char)text[most] & 0xC0U) == 0x80U) most--;
    return most;
}

/// Returns the code point of a valid character of `length` bytes.
unsigned utf8_character(const char *text, size_t length);

/// Returns true if a valid character of `length` bytes is safe to show. Unsafe are control characters (below U+0020,
/// U+007F to U+009F), which terminals obey; those that change the direction of a line (Unicode's Bidi_Control), so that
/// it reads otherwise than written; and U+2028 and U+2029, which end lines.
bool utf8_is_plain(const char *text, size_t length);

#endif
