/// Parts of a JSON document.
#ifndef REPORT_DOCUMENT_H
#define REPORT_DOCUMENT_H

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#include "whirl/engine/descriptor.h"

/// A number; null for what is missing or infinite, which JSON has no number for.
json_t *document_number(double value);

/// A text; what is not UTF-8 in it becomes question marks.
json_t *document_text(const char *text);

/// Put a value, which they take over, into a container; `well` becomes false where memory ran out.
void document_put(bool *well, json_t *object, const char *key, json_t *value);
void document_append(bool *well, json_t *array, json_t *value);

/// Puts all members of a struct that have a name.
void document_put_members(bool *well, json_t *object, const whirl_member *member, const void *from);

/// Writes a value, with the digits that give the same doubles back, and lets go of it. False where it fails.
bool document_write(bool well, json_t *value, FILE *stream);

#endif
