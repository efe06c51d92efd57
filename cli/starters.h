/// The cases that `whirl new` writes.
#ifndef CLI_STARTERS_H
#define CLI_STARTERS_H

#include <stddef.h>

typedef struct starter {
    const char *name;
    const char *meaning; ///< one line
    const char *text;    ///< of the case
} starter;

/// The starter at an index, NULL behind the last.
const starter *starter_at(size_t index);

#endif
