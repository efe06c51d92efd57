// Whether a file holds the few structures of HDF5 that whirl writes, and those only.
//
// HDF5 1.10 crashes on many a file whose metadata are damaged while their checksums are right, as they are in a file
// that was made to harm (tests/fuzz/fuzz_result.c finds such within seconds). So the file is looked through before HDF5
// sees it: every object header, every message in it, and the places of all that is stored. What whirl does not write is
// refused, whatever it may mean: other kinds of types, links and storage, heaps and trees.
//
// Numbers of sections are those of the HDF5 File Format Specification 3.0.
#ifndef STORE_PLAIN_H
#define STORE_PLAIN_H

#include "bytes.h"
#include "whirl/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define PLAIN_NOWHERE UINT64_MAX ///< the address of what is not there

/// A part of a file, read from its beginning on. Reading past the end gives zeros and is noted in `short_of`.
typedef struct plain_part {
    const unsigned char *at;
    size_t left;
    bool short_of;
} plain_part;

uint64_t plain_number(plain_part *part, int bytes); ///< little endian, of 1 to 8 bytes
void plain_skip(plain_part *part, size_t bytes);

/// What the messages of one object say.
typedef struct plain_object {
    unsigned found;           ///< a bit for each type of message that may stand once
    size_t type_size, rank;   ///< of a dataset's elements, and its dimensions
    size_t chunk_rank, chunk; ///< dimensions of its chunks, and bytes of an element by these
    int reason;               ///< errno of a read that failed
} plain_object;

/// What a message leads to.
typedef struct plain_lead {
    enum { PLAIN_NONE, PLAIN_CONTINUATION, PLAIN_OBJECT } kind;
    uint64_t address, length;
} plain_lead;

/// Checks a message (IV.A.2) of `type` and notes what it says. False for one that whirl does not write.
bool plain_message(const byte_source *source, unsigned type, plain_part message, plain_object *object,
                   plain_lead *lead);

/// Do the messages of an object go together, as those of a group or of a dataset?
bool plain_object_whole(const plain_object *object);

/// Checks the whole file; its superblock must have been seen to be one of version 3 with addresses of 8 bytes.
/// WHIRL_IO_ERROR where it cannot be read.
whirl_status plain_check(const byte_source *source);

#endif
