/// An arena: many small blocks of memory that are freed together.
#ifndef BASE_ARENA_H
#define BASE_ARENA_H

#include <stddef.h>

#include "mapped.h"

typedef struct memory_arena {
    struct arena_chunk *chunks; ///< newest first
    whirl_mapped *mapped;       ///< large blocks
} memory_arena;

/// Returns `size` zeroed bytes, aligned for any object; NULL without memory. They live until arena_free.
void *arena_take(memory_arena *arena, size_t size);

/// Returns a copy of `length` bytes with a final zero, or NULL.
char *arena_text(memory_arena *arena, const char *text, size_t length);

void arena_free(memory_arena *arena);

#endif
