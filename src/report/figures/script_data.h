// Data inside an HTML page: JSON whose text can end no script element, and arrays of numbers as base64.
#ifndef REPORT_SCRIPT_DATA_H
#define REPORT_SCRIPT_DATA_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "whirl/engine/descriptor.h"

/// Writes a JSON string, quotes included. '<', '>' and '&' are escaped, so that no text is ever markup; bytes that are
/// not UTF-8 become U+FFFD.
void script_text(FILE *stream, const char *text);

/// Writes a number with the digits that give the same double back, null for NaN and infinities.
void script_number(FILE *stream, double value);

/// Writes ',"NAME":VALUE' for every member of a struct that has a name.
void script_members(FILE *stream, const whirl_member *member, const void *from);

/// A stream of bytes written as base64 (RFC 4648); starts as {stream}.
typedef struct base64 {
    FILE *stream;
    uint32_t bits;
    unsigned count; ///< bytes held in `bits`, 0 to 2
} base64;

void base64_byte(base64 *to, uint8_t byte);
void base64_float32(base64 *to, double value); ///< little-endian; NaN stays NaN
void base64_float64(base64 *to, double value); ///< little-endian
void base64_end(base64 *to);                   ///< writes what is held, with padding

#endif
