/// Memory as bytes and back: one description of what belongs to a state serves measuring, writing and reading it.
#ifndef ANALYZE_ARCHIVE_H
#define ANALYZE_ARCHIVE_H

#include <stdbool.h>
#include <stddef.h>

typedef enum archive_way { ARCHIVE_MEASURE, ARCHIVE_WRITE, ARCHIVE_READ } archive_way;

typedef struct archive {
    archive_way way;
    unsigned char *bytes; ///< [size] written or read; NULL while measuring
    size_t size, at;
    bool sound; ///< false when what is read does not fit
} archive;

/// Goes on over `size` bytes of memory.
void archive_part(archive *a, void *memory, size_t size);

/// ... over a number that must be the same when it is read.
void archive_same(archive *a, double number);

/// ... over a count, at most `most` when it is read.
void archive_count(archive *a, size_t *count, size_t most);

#endif
