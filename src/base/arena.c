#include "arena.h"
#include "mapped.h"

#include <stdalign.h>
#include <stdlib.h>
#include <string.h>

enum { CHUNK_SIZE = 16384 };

typedef struct arena_chunk {
    struct arena_chunk *next;
    size_t used, size;
    alignas(max_align_t) char bytes[];
} arena_chunk;

static arena_chunk *add_chunk(memory_arena *arena, size_t size) {
    if (size < CHUNK_SIZE) size = CHUNK_SIZE;
    if (size > (size_t)-1 - sizeof(arena_chunk)) return NULL;
    arena_chunk *chunk = calloc(1, sizeof *chunk + size);
    if (!chunk) return NULL;
    chunk->size = size;
    chunk->next = arena->chunks;
    arena->chunks = chunk;
    return chunk;
}

void *arena_take(memory_arena *arena, size_t size) {
    const size_t unit = alignof(max_align_t);
    if (size > (size_t)-1 - unit) return NULL;
    size = (size + unit - 1) / unit * unit;
    void *large = size >= MAPPED_MIN ? mapped_make(&arena->mapped, size, 1) : NULL;
    if (large) return large;
    arena_chunk *chunk = arena->chunks;
    if (!chunk || chunk->size - chunk->used < size) chunk = add_chunk(arena, size);
    if (!chunk) return NULL;
    void *memory = chunk->bytes + chunk->used;
    chunk->used += size;
    return memory;
}

char *arena_text(memory_arena *arena, const char *text, size_t length) {
    char *copy = arena_take(arena, length + 1);
    if (copy && length > 0) memcpy(copy, text, length);
    return copy;
}

void arena_free(memory_arena *arena) {
    for (arena_chunk *chunk = arena->chunks; chunk;) {
        arena_chunk *next = chunk->next;
        free(chunk);
        chunk = next;
    }
    arena->chunks = NULL;
    mapped_free(arena->mapped);
    arena->mapped = NULL;
}
