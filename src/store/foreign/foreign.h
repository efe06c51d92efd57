/// Files in HDF5's format that other programs wrote.
///
/// HDF5 1.10 crashes on many damaged files (h5file.h). Measured files come from anywhere, so they are read here without
/// the library: every address, size and count is checked before it is used. Numbers of sections are those of the HDF5
/// File Format Specification 3.0.
#ifndef STORE_FOREIGN_H
#define STORE_FOREIGN_H

#include "bytes.h"
#include "plain_part.h"
#include "whirl/internal/arrays.h"
#include "whirl/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    FOREIGN_MAX_BLOCK = 1 << 26, ///< largest block of metadata, bytes
    FOREIGN_MAX_VISITS = 1 << 20 ///< blocks of metadata that one search may read: damaged files can have cycles
};

/// A file while it is read.
typedef struct foreign_file {
    const byte_source *source;
    uint64_t base, root; ///< address from which all others count; that of the root group's header
    size_t visits;       ///< blocks of metadata that may still be read
    whirl_status status; ///< first failure
} foreign_file;

/// Notes a failure, unless there is one; returns false.
bool foreign_fail(foreign_file *file, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Notes that memory ran out; returns false.
bool foreign_no_memory(foreign_file *file);

/// Finds the address *at of a superblock: 0, or behind a block of the user's of 512, 1024, ... up to `most` bytes; the
/// size of the source if there is none. Returns 0, or the errno of a read.
int foreign_find_superblock(const byte_source *source, uint64_t most, uint64_t *at);

/// Opens a file at its superblock (II.A). Returns false after a failure.
bool foreign_open(foreign_file *file, const byte_source *source);

/// Returns true if these bytes lie in the file.
bool foreign_inside(const foreign_file *file, uint64_t address, uint64_t length);

/// Reads bytes of numbers at an address. Returns false after a failure.
bool foreign_read(foreign_file *file, uint64_t address, void *to, size_t size);

/// Reads a block of metadata, which begins with `signature` (NULL: with anything), to be freed; NULL after a failure.
unsigned char *foreign_block(foreign_file *file, uint64_t address, uint64_t size, const char *signature);

// ---------------------------------------------------------------- objects (foreign_objects.c)

/// Types of messages, IV.A.2.
enum {
    FOREIGN_DATASPACE = 0x01,
    FOREIGN_LINK_INFO = 0x02,
    FOREIGN_DATATYPE = 0x03,
    FOREIGN_LINK = 0x06,
    FOREIGN_LAYOUT = 0x08,
    FOREIGN_FILTERS = 0x0b,
    FOREIGN_ATTRIBUTE = 0x0c,
    FOREIGN_CONTINUATION = 0x10,
    FOREIGN_SYMBOL_TABLE = 0x11,
    FOREIGN_ATTRIBUTE_INFO = 0x15
};

/// A message of an object's header; its content is in the object's parts.
typedef struct foreign_message {
    unsigned type, flags;
    plain_part content;
} foreign_message;

/// The header of a group or dataset.
typedef struct foreign_object {
    size_t count, capacity, part_count;
    foreign_message *messages; ///< [capacity]
    unsigned char **parts;     ///< [part_count] blocks that hold the messages
} foreign_object;

/// Reads the header of an object, to be freed, also after a failure (false).
bool foreign_object_read(foreign_file *file, uint64_t address, foreign_object *out);
void foreign_object_free(foreign_object *object);

/// Returns the first message of a type; NULL without one.
const foreign_message *foreign_object_find(const foreign_object *object, unsigned type);

/// Takes a link or an attribute of an object. Returns false to end the search, which is no failure.
typedef bool (*foreign_link_taker)(void *context, const char *name, size_t length, uint64_t address);
typedef bool (*foreign_message_taker)(void *context, plain_part message);

/// Hands over the links of a group that lead to objects in this file. Returns false after a failure.
bool foreign_links(foreign_file *file, const foreign_object *group, foreign_link_taker take, void *context);

/// Hands over the messages of an object's attributes. Returns false after a failure.
bool foreign_attributes(foreign_file *file, const foreign_object *object, foreign_message_taker take, void *context);

// ---------------------------------------------------------------- trees (foreign_trees.c)

/// Takes a record of a tree. Returns false to end the search.
typedef bool (*foreign_record_taker)(void *context, plain_part record);

/// Hands over all records of a tree of version 2 (III.A.2). Returns false after a failure.
bool foreign_tree(foreign_file *file, uint64_t address, foreign_record_taker take, void *context);

/// A heap of links or attributes (III.G), whose objects are in blocks of rising size.
typedef struct foreign_heap {
    uint64_t start, direct,
        root;                   ///< size of the first block; largest size of a block with objects; address of the root
    unsigned width, rows, bits; ///< blocks of a row; rows of the root, 0: the root is a block; bits of an offset
    unsigned length_bytes;      ///< bytes of an object's length
    bool filtered;
} foreign_heap;

bool foreign_heap_read(foreign_file *file, uint64_t address, foreign_heap *heap);

/// Reads the object with an id, to be freed; NULL after a failure.
unsigned char *foreign_heap_object(foreign_file *file, const foreign_heap *heap, plain_part id, size_t *size);

// ---------------------------------------------------------------- arrays (foreign_array.c, foreign_chunks.c)

enum { FOREIGN_MAX_RANK = ARRAYS_MAX_RANK, FOREIGN_MAX_FILTERS = 8 };

/// A type of values.
typedef struct foreign_type {
    enum { FOREIGN_WHOLE, FOREIGN_REAL, FOREIGN_TEXT, FOREIGN_LONG_TEXT, FOREIGN_OTHER } kind;
    size_t size;           ///< bytes of a value
    bool big, is_signed;   ///< bytes begin with the largest place; whole numbers may be negative
    const char *described; ///< in messages: "texts"
} foreign_type;

typedef struct foreign_filter {
    unsigned id, size; ///< size: of an element, for shuffled bytes
} foreign_filter;

/// Shape, type and place of the values of a dataset.
typedef struct foreign_array {
    foreign_type type;
    int rank;
    uint64_t sizes[FOREIGN_MAX_RANK], most[FOREIGN_MAX_RANK]; ///< most: those up to which it may grow; UINT64_MAX: any
    enum { FOREIGN_COMPACT, FOREIGN_CONTIGUOUS, FOREIGN_CHUNKED } layout;
    plain_part compact;
    uint64_t address, size; ///< of contiguous values, or of a single chunk; address of the index of chunks
    enum { FOREIGN_TREE_1, FOREIGN_SINGLE, FOREIGN_IMPLICIT, FOREIGN_FIXED, FOREIGN_EXTENSIBLE, FOREIGN_TREE_2 } index;
    uint64_t chunk[FOREIGN_MAX_RANK]; ///< sizes of a chunk
    size_t chunk_bytes;
    bool whole_edges;     ///< chunks that reach beyond the array are not filtered
    bool single_filtered; ///< the single chunk has `size` bytes
    unsigned mask;        ///< filters that the single chunk has not passed
    size_t filter_count;
    foreign_filter filters[FOREIGN_MAX_FILTERS];
} foreign_array;

/// Reads a type (IV.A.2.d); one that is not known is FOREIGN_OTHER. Returns false after a failure.
bool foreign_type_read(foreign_file *file, plain_part part, foreign_type *out);

/// Returns a number of a type from its bytes.
double foreign_number(const foreign_type *type, const unsigned char *at);

/// Reads a dataspace (IV.A.2.b): rank, sizes, and the sizes up to which they may grow. Returns false after a failure.
bool foreign_space_read(foreign_file *file, plain_part part, foreign_array *out);

/// Understands the messages of a dataset. The object must live as long as the array. Returns false after a failure.
bool foreign_array_read(foreign_file *file, const foreign_object *object, foreign_array *out);

/// Reads the numbers of a part of an array. Returns false after a failure.
bool foreign_values(foreign_file *file, const foreign_array *array, const size_t *first, const size_t *count,
                    double *out);

/// The place of a chunk.
typedef struct foreign_chunk {
    uint64_t address, size;
    unsigned mask; ///< filters that it has not passed
} foreign_chunk;

/// Finds a chunk by its place in the grid of chunks. Returns false after a failure, or if it was never written.
bool foreign_chunk_find(foreign_file *file, const foreign_array *array, const uint64_t *place, foreign_chunk *out);

/// Undoes the filters of a chunk of `size` bytes: returns its array->chunk_bytes bytes, to be freed. Frees the bytes it
/// is given. NULL after a failure.
unsigned char *foreign_unfilter(foreign_file *file, const foreign_array *array, unsigned mask, unsigned char *bytes,
                                size_t size);

#endif
