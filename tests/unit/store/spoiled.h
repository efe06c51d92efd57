/// Reads files that may be damaged: every array is found and read, or refused with a sentence.
#ifndef TEST_STORE_SPOILED_H
#define TEST_STORE_SPOILED_H

#include "whirl/internal/arrays.h"

#include <stdlib.h>
#include <string.h>

/// Reads some numbers of an array.
static inline whirl_status spoiled_read_some(void *context, const char *name, const arrays_item *item) {
    enum { MOST = 4096 };
    static double numbers[MOST];
    size_t first[ARRAYS_MAX_RANK] = {0}, count[ARRAYS_MAX_RANK] = {0}, all = 1;
    for (int i = 0; i < item->rank; i++) {
        count[i] = item->sizes[i] < 20 ? item->sizes[i] : 20;
        all *= count[i];
    }
    arrays_item found;
    const whirl_status there = arrays_find(context, name, &found);
    assert_true((there.code == WHIRL_OK || *there.message) && strlen(found.unit) < ARRAYS_TEXT);
    assert_true(strlen(item->unit) < ARRAYS_TEXT);
    if (all > MOST) return whirl_ok();
    const whirl_status status = arrays_read(context, name, first, count, numbers);
    assert_true(status.code == WHIRL_OK || *status.message);
    return whirl_ok();
}

/// Reads a copy of just this size, so that sanitizers see what is read beyond its end.
static inline void spoiled_read(const unsigned char *bytes, size_t size, const char *name) {
    arrays_file *file;
    unsigned char *copy = malloc(size > 0 ? size : 1);
    assert_non_null(copy);
    memcpy(copy, bytes, size);
    const whirl_status status = arrays_open_bytes(copy, size, name, &file);
    assert_true(status.code == WHIRL_OK || *status.message);
    if (status.code == WHIRL_OK) arrays_visit(file, spoiled_read_some, file);
    arrays_close(file);
    free(copy);
}

/// Changes one to four bytes of a file, to random ones or to 255, as the number of the mutant says. `random` is the
/// state of the generator (xorshift, Marsaglia 2003).
static inline void spoiled_mutate(unsigned char *bytes, size_t size, int mutant, uint64_t *random) {
    for (int k = 0; k <= mutant % 4; k++) {
        *random ^= *random << 13U, *random ^= *random >> 7U, *random ^= *random << 17U;
        bytes[*random % size] = (unsigned char)(mutant % 3 ? *random >> 40U : 0xff);
    }
}

#endif
