// Filters of chunks: deflate, shuffled bytes, checksums, LZF (foreign.h).
#include "foreign.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

/// Undoes deflate. Returns the bytes, to be freed; NULL after a failure.
static unsigned char *filter_inflate(foreign_file *file, size_t most, const unsigned char *bytes, size_t *size) {
    uLongf length = (uLongf)most;
    unsigned char *out = malloc(most);
    if (!out) foreign_no_memory(file);
    const int outcome = out ? uncompress(out, &length, bytes, (uLong)*size) : Z_MEM_ERROR;
    if (outcome == Z_OK) {
        *size = length;
        return out;
    }
    free(out);
    if (outcome == Z_MEM_ERROR) foreign_no_memory(file);
    foreign_fail(file, "is damaged: what it has compressed cannot be read");
    return NULL;
}

/// Undoes LZF (Lehmann's liblzf): runs of bytes, and copies of bytes before.
static unsigned char *filter_lzf(foreign_file *file, size_t most, const unsigned char *bytes, size_t *size) {
    unsigned char *out = calloc(most, 1);
    size_t at = 0, done = 0;
    bool good = out != NULL;
    if (!out) foreign_no_memory(file);
    while (good && at < *size) {
        const size_t control = bytes[at++];
        if (control < 32) {
            const size_t run = control + 1;
            good = run <= *size - at && run <= most - done;
            if (good) memcpy(out + done, bytes + at, run);
            at += good ? run : 0;
            done += good ? run : 0;
            continue;
        }
        size_t run = control >> 5U;
        if (run == 7) run += at < *size ? bytes[at++] : 0;
        good = at < *size;
        const size_t back = good ? ((control & 31U) << 8U | bytes[at++]) + 1 : 0;
        good = good && back <= done && run + 2 <= most - done;
        for (size_t i = 0; good && i < run + 2; i++, done++) out[done] = out[done - back];
    }
    if (good) {
        *size = done;
        return out;
    }
    free(out);
    foreign_fail(file, "is damaged: what it has compressed cannot be read");
    return NULL;
}

/// Puts shuffled bytes back: the first bytes of all values come first, then the second ones.
static unsigned char *filter_unshuffle(foreign_file *file, size_t each, const unsigned char *bytes, size_t size) {
    unsigned char *out = malloc(size + 1);
    if (!out) {
        foreign_no_memory(file);
        return NULL;
    }
    const size_t count = each > 0 ? size / each : 0;
    for (size_t k = 0; k < each && count > 0; k++)
        for (size_t i = 0; i < count; i++) out[i * each + k] = bytes[k * count + i];
    if (size > count * each) memcpy(out + count * each, bytes + count * each, size - count * each);
    return out;
}

/// Returns Fletcher's checksum of 32 bits as HDF5 computes it: of words whose first byte is the larger one.
static uint32_t fletcher(const unsigned char *bytes, size_t size) {
    enum { WORDS = 360 };
    uint32_t one = 0, two = 0;
    for (size_t left = size / 2; left > 0;) {
        const size_t some = left < WORDS ? left : WORDS;
        for (size_t i = 0; i < some; i++, bytes += 2) {
            one += (uint32_t)bytes[0] << 8U | bytes[1];
            two += one;
        }
        one = (one & 0xffffU) + (one >> 16U);
        two = (two & 0xffffU) + (two >> 16U);
        left -= some;
    }
    if (size % 2 > 0) {
        one += (uint32_t)*bytes << 8U;
        two += one;
        one = (one & 0xffffU) + (one >> 16U);
        two = (two & 0xffffU) + (two >> 16U);
    }
    one = (one & 0xffffU) + (one >> 16U);
    two = (two & 0xffffU) + (two >> 16U);
    return two << 16U | one;
}

static bool filter_check(foreign_file *file, const unsigned char *bytes, size_t *size) {
    if (*size < 4) return foreign_fail(file, "is damaged");
    plain_part sum = {bytes + *size - 4, 4, false};
    *size -= 4;
    return plain_number(&sum, 4) == fletcher(bytes, *size) || foreign_fail(file, "is damaged: a checksum is wrong");
}

unsigned char *foreign_unfilter(foreign_file *file, const foreign_array *array, unsigned mask, unsigned char *bytes,
                                size_t size) {
    enum { DEFLATE = 1, SHUFFLE = 2, FLETCHER = 3, LZF = 32000, ROOM = 64 };
    static const struct {
        unsigned id;
        const char *name;
    } others[] = {{4, "szip"},      {5, "nbit"},    {6, "scaleoffset"}, {307, "bzip2"},
                  {32001, "Blosc"}, {32004, "LZ4"}, {32013, "zfp"},     {32015, "Zstandard"}};
    for (size_t i = array->filter_count; i-- > 0 && bytes;) {
        const foreign_filter *own = &array->filters[i];
        unsigned char *next = bytes;
        if (mask >> i & 1U) continue;
        if (own->id == DEFLATE) {
            next = filter_inflate(file, array->chunk_bytes + ROOM, bytes, &size);
        } else if (own->id == LZF) {
            next = filter_lzf(file, array->chunk_bytes + ROOM, bytes, &size);
        } else if (own->id == SHUFFLE) {
            next = filter_unshuffle(file, own->size > 0 ? own->size : array->type.size, bytes, size);
        } else if (own->id == FLETCHER) {
            if (!filter_check(file, bytes, &size)) next = NULL;
        } else {
            const char *name = "a filter";
            for (size_t k = 0; k < sizeof others / sizeof *others; k++)
                if (others[k].id == own->id) name = others[k].name;
            foreign_fail(file, "is compressed by %s (%u), expected gzip, LZF or nothing", name, own->id);
            next = NULL;
        }
        if (next != bytes) free(bytes);
        bytes = next;
    }
    if (!bytes || size == array->chunk_bytes) return bytes;
    free(bytes);
    foreign_fail(file, "is damaged");
    return NULL;
}
