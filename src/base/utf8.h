/// UTF-8, as far as readers and reports need it.
#ifndef BASE_UTF8_H
#define BASE_UTF8_H

#include <stddef.h>

/// Bytes of the character at the start of `text` (1 to 4), of which `left` bytes may be read (at least one); 0 where
/// there is no valid one: overlong forms, surrogates and cut characters are not valid.
size_t utf8_length(const char *text, size_t left);

/// The same for a text that ends with a zero byte.
static inline size_t utf8_length_of_text(const char *text) {
    return utf8_length(text, 4);
}

#endif
