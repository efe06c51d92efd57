/// Memory that is freed as a whole.
#ifndef CASE_ARENA_H
#define CASE_ARENA_H

#include <stddef.h>

typedef struct case_arena {
    struct arena_chunk *chunks; ///< newest first
} case_arena;

/// `size` zeroed bytes, aligned for any object; NULL when memory ran out. Lives until arena_free.
void *arena_take(case_arena *arena, size_t size);

/// A copy of `length` bytes with a final zero, or NULL.
char *arena_text(case_arena *arena, const char *text, size_t length);

void arena_free(case_arena *arena);

#endif
