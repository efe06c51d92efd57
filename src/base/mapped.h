/// Large arrays that need not be in memory all at once: nameless files, cached by the system as far as memory allows.
/// They are in the folder that TMPDIR names, else in /var/tmp. If such a file cannot be made, the array is in memory
/// instead.
#ifndef BASE_MAPPED_H
#define BASE_MAPPED_H

#include <stddef.h>

/// The file-backed arrays of one owner; NULL while there is none.
typedef struct whirl_mapped whirl_mapped;

enum {
    MAPPED_MIN = 1 << 20,  ///< least size in bytes of a sequentially used array that is worth a file
    MAPPED_OFTEN = 1 << 12 ///< items after which mapped_evict_often evicts pages
};

/// Makes an array of zeros in a file; NULL if that is impossible.
void *mapped_make(whirl_mapped **mapped, size_t count, size_t size);

/// Makes an array in a file or, if it is smaller than `least` or a file is impossible, by malloc.
/// NULL without memory.
void *mapped_take(whirl_mapped **mapped, size_t count, size_t size, size_t least);

/// Frees an array of either kind, or NULL.
void mapped_drop(whirl_mapped **mapped, void *array);

/// Evicts the arrays' pages to the files; their contents stay the same.
void mapped_evict(const whirl_mapped *mapped);

/// Evicts pages now and then while arrays are traversed in order. Called for every item with its index.
static inline void mapped_evict_often(const whirl_mapped *mapped, size_t index) {
    if (mapped && index % MAPPED_OFTEN == 0) mapped_evict(mapped);
}

/// Frees all arrays in files.
void mapped_free(whirl_mapped *mapped);

#endif
