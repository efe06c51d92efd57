/// Parts of HDF5 files that are read from their beginning on, and the files' signature, with the library or without it.
#ifndef STORE_PLAIN_PART_H
#define STORE_PLAIN_PART_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// The bytes with which a superblock begins (HDF5 File Format Specification 3.0, II.A).
static const unsigned char h5_signature[8] = {0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};

#define PLAIN_NOWHERE UINT64_MAX ///< address of a missing object

/// A part of a file that is read from its beginning on. Reading past the end gives zeros and sets `short_of`.
typedef struct plain_part {
    const unsigned char *at;
    size_t left;
    bool short_of;
} plain_part;

uint64_t plain_number(plain_part *part, int bytes); ///< reads a little-endian number of 1 to 8 bytes
void plain_skip(plain_part *part, size_t bytes);

#endif
