/// The cases that `whirl new` writes.
#ifndef CLI_STARTERS_H
#define CLI_STARTERS_H

#include <stddef.h>

typedef struct starter {
    const char *name;
    const char *meaning; ///< one line
    const char *text;    ///< text of the case
} starter;

/// Returns the starter at an index, NULL past the last.
const starter *starter_at(size_t index);

#endif
