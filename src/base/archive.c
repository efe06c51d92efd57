#include "archive.h"

#include <string.h>

void archive_part(archive *a, void *memory, size_t size) {
    if (a->way != ARCHIVE_MEASURE) {
        if (!a->sound || size > a->size - a->at) {
            a->sound = false;
            return;
        }
        if (a->way == ARCHIVE_WRITE)
            memcpy(a->bytes + a->at, memory, size);
        else
            memcpy(memory, a->bytes + a->at, size);
    }
    a->at += size;
}

void archive_same(archive *a, double number) {
    double there = number;
    archive_part(a, &there, sizeof there);
    if (there != number) a->sound = false;
}

void archive_count(archive *a, size_t *count, size_t most) {
    archive_part(a, count, sizeof *count);
    if (*count <= most) return;
    a->sound = false;
    *count = 0;
}
