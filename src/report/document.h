/// Makes and writes JSON documents.
#ifndef REPORT_DOCUMENT_H
#define REPORT_DOCUMENT_H

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

/// Returns a JSON number; null for NaN and infinity, which JSON lacks.
json_t *document_number(double value);

/// Returns a JSON text; bytes that are not UTF-8 become question marks.
json_t *document_text(const char *text);

/// Add a value to a container, which then owns it; `well` becomes false without memory.
void document_put(bool *well, json_t *object, const char *key, json_t *value);
void document_append(bool *well, json_t *array, json_t *value);

/// Puts all members of a struct that have a name into an object.
void document_put_members(bool *well, json_t *object, const whirl_member *member, const void *from);

/// Writes a value, with digits that restore the same doubles, and frees it. Returns false on failure.
bool document_write(bool well, json_t *value, FILE *stream);

/// Writes an object as a whole document, with a line break at its end, and frees it. Fails with WHIRL_IO_ERROR if the
/// stream does, or with WHIRL_NO_MEMORY.
whirl_status document_finish(bool well, json_t *object, FILE *stream);

#endif
