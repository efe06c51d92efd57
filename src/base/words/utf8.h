/// UTF-8, as far as readers and reports need it.
#ifndef BASE_UTF8_H
#define BASE_UTF8_H

#include <stdbool.h>
#include <stddef.h>

/// Bytes of the character at the start of `text` (1 to 4), of which `left` bytes may be read (at least one); 0 where
/// there is no valid one: overlong forms, surrogates and cut characters are not valid.
size_t utf8_length(const char *text, size_t left);

/// The same for a text that ends with a zero byte.
static inline size_t utf8_length_of_text(const char *text) {
    return utf8_length(text, 4);
}

/// The number of a valid character of `length` bytes.
unsigned utf8_character(const char *text, size_t length);

/// Whether a valid character of `length` bytes is safe to show. Not so are control characters (below U+0020, U+007F to
/// U+009F), which terminals obey; those that turn the direction of a line (Unicode's Bidi_Control), so that it reads
/// otherwise than it stands; and U+2028 and U+2029, which end lines.
bool utf8_is_plain(const char *text, size_t length);

#endif
