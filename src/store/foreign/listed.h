/// Measured files whose arrays are listed when they are opened: MAT files before version 7.3, and universal files.
///
/// Damaged files must not harm, so they are read here: every size and count is checked before it is used, and a file is
/// read through buffers of fixed size. MAT files: "MAT-File Format" of MathWorks, R2023b (levels 4 and 5). Universal
/// files: dataset 58 of the Structural Dynamics Research Laboratory, University of Cincinnati.
#ifndef STORE_LISTED_H
#define STORE_LISTED_H

#include "foreign.h"

enum { LISTED_PATH = 256, LISTED_MAX_NAMES = 10000 };

/// An array of a file.
typedef struct listed_array {
    char *name; ///< "run/x", owned
    arrays_item item;
    // MAT files: an element of the file, which may be compressed, and the place of the numbers in it.
    uint64_t element, element_size, at;
    bool deflated;
    foreign_type type;
    // Universal files: a record from 0, and what of it.
    size_t record;
    enum { LISTED_ORDINATE, LISTED_IMAGINARY, LISTED_AMPLITUDE, LISTED_LAG, LISTED_ABSCISSA } part;
} listed_array;

/// Bytes of a file or of a compressed element of it, read one after another (mat_stream.c).
typedef struct mat_stream mat_stream;

/// A record of a universal file (universal.c).
typedef struct universal_record universal_record;

/// The arrays of a file.
typedef struct listed_table {
    enum { LISTED_NONE, LISTED_MAT, LISTED_UNIVERSAL } kind;
    size_t count, capacity;
    listed_array *arrays;
    mat_stream *stream; ///< MAT: where numbers were read last
    size_t record_count;
    universal_record *records;
} listed_table;

void listed_free(listed_table *table);

/// Adds an array of this name, with a factor of 1. NULL without memory, or if there are too many (which is noted).
listed_array *listed_add(foreign_file *file, listed_table *table, const char *name);

/// Returns true if the source begins as a MAT file of level 4 or 5 does.
bool mat_is_file(const byte_source *source);

/// Returns true if the source begins as a universal file does.
bool universal_is_file(const byte_source *source);

/// List the arrays of a file. Return false after a failure.
bool mat_list(foreign_file *file, listed_table *table);
bool universal_list(foreign_file *file, listed_table *table);

/// Find an array by its name. Return false if there is none.
bool mat_find(const listed_table *table, const char *name, listed_array *out);
bool universal_find(const listed_table *table, const char *name, listed_array *out);

/// Read the numbers of a part of an array, the last dimension fastest. Return false after a failure.
bool mat_values(foreign_file *file, listed_table *table, const listed_array *array, const size_t *first,
                const size_t *count, double *out);
bool universal_values(foreign_file *file, const listed_table *table, const listed_array *array, const size_t *first,
                      const size_t *count, double *out);

// ---------------------------------------------------------------- streams (mat_stream.c)

/// Begins a stream of `size` bytes from an address of the file, which `deflated` has compressed; replaces an earlier
/// one. Returns false after a failure.
bool mat_stream_open(foreign_file *file, mat_stream **stream, uint64_t address, uint64_t size, bool deflated);
void mat_stream_close(mat_stream *stream);

/// Returns the number of bytes taken and skipped.
uint64_t mat_stream_at(const mat_stream *stream);

/// Returns true if it reads this element of the file.
bool mat_stream_is(const mat_stream *stream, uint64_t address, bool deflated);

/// Take or skip the next bytes. Return false after a failure.
bool mat_stream_take(foreign_file *file, mat_stream *stream, void *to, size_t size);
bool mat_stream_skip(foreign_file *file, mat_stream *stream, uint64_t size);

/// Reads a compressed stream to its end, where its checksum is. Returns false after a failure.
bool mat_stream_finish(foreign_file *file, mat_stream *stream);

#endif
