// UTF-8, as far as a report needs it.
#ifndef REPORT_UTF8_H
#define REPORT_UTF8_H

#include <stddef.h>

/// Bytes of the character at the start of `text` (1 to 4), or 0 where there is no valid one (overlong forms,
/// surrogates and cut characters are not valid). The text ends with '\0'.
size_t utf8_length(const char *text);

#endif
