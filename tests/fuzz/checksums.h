// Finds the checksums of the metadata of an HDF5 file, and corrects them after a change.
#ifndef FUZZ_CHECKSUMS_H
#define FUZZ_CHECKSUMS_H

#include <stddef.h>
#include <stdint.h>

enum { CHECKSUM_MAX = 4096 };

/// `length` bytes from `start` on, followed by their checksum.
typedef struct checksum {
    size_t start, length;
} checksum;

typedef struct checksum_list {
    size_t file_size, count, capacity;
    checksum *items;
} checksum_list;

/// The checksums of a sound file. They are looked for once in the first sound file of each size; other files of that
/// size, changed in place, have theirs at the same places. NULL where there are none. Valid until the program ends.
const checksum_list *checksums_of(const uint8_t *bytes, size_t size);

/// Writes all checksums anew.
void checksums_mend(const checksum_list *sums, uint8_t *bytes);

#endif
