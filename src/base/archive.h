/// Serialization: one description of a state's parts serves measuring, writing and reading.
#ifndef BASE_ARCHIVE_H
#define BASE_ARCHIVE_H

#include <stdbool.h>
#include <stddef.h>

typedef enum archive_way { ARCHIVE_MEASURE, ARCHIVE_WRITE, ARCHIVE_READ } archive_way;

typedef struct archive {
    archive_way way;
    unsigned char *bytes; ///< [size] written or read; NULL while measuring
    size_t size, at;
    bool sound; ///< false if the data read do not fit
} archive;

/// Measures, writes or reads `size` bytes of memory, as a->way says.
void archive_part(archive *a, void *memory, size_t size);

/// Does the same with a number; reading a different number clears a->sound.
void archive_same(archive *a, double number);

/// Does the same with a count; reading more than `most` clears a->sound.
void archive_count(archive *a, size_t *count, size_t most);

#endif
