/// Memory: arenas, exhaustion, large arrays.
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

#include <errno.h>
#include <stdbool.h>
#include <stddef.h>

// ---------------------------------------------------------------- room
// Large arrays that need not be in memory all at once: nameless files, cached by the system as far as memory allows.
// They are in the folder that TMPDIR names, else in /var/tmp. If such a file cannot be made, an array is in memory
// instead.

/// The file-backed arrays of one owner; NULL while there is none.
typedef struct whirl_room whirl_room;

enum {
    ROOM_MIN = 1 << 20,  ///< least size in bytes of a sequentially used array that is worth a file
    ROOM_OFTEN = 1 << 12 ///< items after which room_pass evicts pages
};

/// Makes an array of zeros in a file; NULL if that is impossible.
void *room_map(whirl_room **room, size_t count, size_t size);

/// Makes an array in a file or, if it is smaller than `least` or a file is impossible, by malloc outside of the room.
/// NULL without memory.
void *room_take(whirl_room **room, size_t count, size_t size, size_t least);

/// Frees an array from the room or from malloc, or NULL.
void room_drop(whirl_room **room, void *array);

/// Evicts the arrays' pages to the files; their contents stay the same.
void room_rest(const whirl_room *room);

/// Evicts pages now and then while arrays are traversed in order. Called for every item with its index.
static inline void room_pass(const whirl_room *room, size_t index) {
    if (room && index % ROOM_OFTEN == 0) room_rest(room);
}

/// Frees all arrays of the room.
void room_free(whirl_room *room);

// ---------------------------------------------------------------- arena
// Memory that is freed as a whole.

typedef struct memory_arena {
    struct arena_chunk *chunks; ///< newest first
    whirl_room *room;           ///< large blocks
} memory_arena;

/// Returns `size` zeroed bytes, aligned for any object; NULL without memory. They live until arena_free.
void *arena_take(memory_arena *arena, size_t size);

/// Returns a copy of `length` bytes with a final zero, or NULL.
char *arena_text(memory_arena *arena, const char *text, size_t length);

void arena_free(memory_arena *arena);

// ---------------------------------------------------------------- exhausted
// Detection of exhausted memory in libraries (HDF5, UDUNITS-2, muParser), which report it in ways of their own, take it
// for another mistake, or ignore it. malloc sets errno in all of them, and nobody resets it to 0.

/// Begins a watch before a call; returns the former errno.
static inline int exhausted_watch(void) {
    const int before = errno;
    errno = 0;
    return before;
}

/// Ends a watch after the call. True: memory ran out, and no result of the calls is valid, even success. False: errno
/// is restored, so that watches can be nested.
static inline bool exhausted(int before) {
    if (errno == ENOMEM) return true;
    errno = before;
    return false;
}

#endif
