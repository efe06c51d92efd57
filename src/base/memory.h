/// Memory: what is freed together, what has run out, large arrays.
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

#include <errno.h>
#include <stdbool.h>
#include <stddef.h>

// ---------------------------------------------------------------- room
// Large arrays that need not be in memory all at once: nameless files, of which the system keeps in memory what is in
// use and what it has room for. They lie in the folder that TMPDIR names, else in /var/tmp. Where there is no room for
// such a file an array is in memory after all.

/// The arrays of one owner that lie in files; NULL while there is none.
typedef struct whirl_room whirl_room;

enum {
    ROOM_MIN = 1 << 20,  ///< bytes from which on an array that is gone through in order is worth a file
    ROOM_OFTEN = 1 << 12 ///< items after which room_pass has the room rest
};

/// An array of zeros in a file; NULL where there is none to be had.
void *room_map(whirl_room **room, size_t count, size_t size);

/// The same, or where it has fewer bytes than `least`, or a file is not to be had, one from malloc that is no part of
/// the room. NULL without memory.
void *room_take(whirl_room **room, size_t count, size_t size, size_t least);

/// Frees an array, which may be the room's or from malloc, or NULL.
void room_drop(whirl_room **room, void *array);

/// Leaves to the files what is in memory; the arrays are as they were.
void room_rest(const whirl_room *room);

/// To be called for every item, by its index, where arrays are gone through in order: little of them is then in memory.
static inline void room_pass(const whirl_room *room, size_t index) {
    if (room && index % ROOM_OFTEN == 0) room_rest(room);
}

/// Frees all arrays of the room.
void room_free(whirl_room *room);

// ---------------------------------------------------------------- arena
// Memory that is freed as a whole.

typedef struct memory_arena {
    struct arena_chunk *chunks; ///< newest first
    whirl_room *room;           ///< of what is large
} memory_arena;

/// `size` zeroed bytes, aligned for any object; NULL when memory ran out. Lives until arena_free.
void *arena_take(memory_arena *arena, size_t size);

/// A copy of `length` bytes with a final zero, or NULL.
char *arena_text(memory_arena *arena, const char *text, size_t length);

void arena_free(memory_arena *arena);

// ---------------------------------------------------------------- exhausted
// Whether memory ran out in what was called. Libraries beneath us (HDF5, UDUNITS-2, muParser) say so in ways of their
// own, take it for another mistake, or pass over it; but malloc sets errno whoever calls it, and nobody sets it back
// to 0.

/// To be called before; gives what errno was.
static inline int exhausted_watch(void) {
    const int before = errno;
    errno = 0;
    return before;
}

/// ... and after. Where it is true, whatever came of the calls is not to be believed, success included. Else errno is
/// what it was before, so that watches may lie within each other.
static inline bool exhausted(int before) {
    if (errno == ENOMEM) return true;
    errno = before;
    return false;
}

#endif
