/// Large arrays that need not be in memory all at once: nameless files, of which the system keeps in memory what is in
/// use and what it has room for. They lie in the folder that TMPDIR names, else in /var/tmp. Where there is no room for
/// such a file an array is in memory after all.
#ifndef BASE_ROOM_H
#define BASE_ROOM_H

#include <stdbool.h>
#include <stddef.h>

/// The arrays of one owner that lie in files; NULL while there is none.
typedef struct whirl_room whirl_room;

enum {
    ROOM_LEAST = 1 << 20, ///< bytes from which on an array that is gone through in order is worth a file
    ROOM_OFTEN = 1 << 12  ///< items after which room_pass has the room rest
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

#endif
