#include "journal_scan.h"
#include "crc32c.h"

#include <string.h>

enum { WINDOW = 1 << 16 };

/// A range of the bytes that is in memory.
typedef struct window {
    const byte_source *bytes;
    uint64_t start;
    size_t length;
    int error; ///< error of a read; the window is empty afterwards
    unsigned char data[WINDOW];
} window;

/// Returns the bytes from `offset` on, at least `least` of them; NULL after an error. `least` is at most WINDOW, and
/// these bytes are within the file.
static const unsigned char *window_at(window *w, uint64_t offset, size_t least) {
    if (w->error) return NULL;
    if (offset < w->start || offset + least > w->start + w->length) {
        const uint64_t left = w->bytes->size - offset;
        w->start = offset;
        w->length = left < WINDOW ? (size_t)left : WINDOW;
        w->error = w->bytes->read(w->bytes->context, offset, w->data, w->length);
        if (w->error) return NULL;
    }
    return w->data + (offset - w->start);
}

/// Returns the number of bytes in memory from `offset` on, after window_at.
static size_t window_left(const window *w, uint64_t offset) {
    return w->length - (size_t)(offset - w->start);
}

/// Finds the next frame magic from `offset` on; returns the size of the bytes if there is none.
static uint64_t find_magic(window *w, uint64_t offset) {
    const uint64_t size = w->bytes->size;
    while (offset + sizeof journal_magic <= size) {
        const unsigned char *here = window_at(w, offset, sizeof journal_magic);
        if (!here) return size;
        const size_t places = window_left(w, offset) - sizeof journal_magic + 1;
        const unsigned char *first = memchr(here, journal_magic[0], places);
        if (first && memcmp(first, journal_magic, sizeof journal_magic) == 0) return offset + (uint64_t)(first - here);
        offset += first ? (uint64_t)(first - here) + 1 : places;
    }
    return size;
}

/// Returns true if the checksum of the frame at `offset` is right. The frame must be within the bytes.
static bool payload_is_sound(window *w, uint64_t offset, uint64_t size) {
    uint32_t sum = 0;
    uint64_t left = JOURNAL_HEAD + size;
    for (; left > 0;) {
        const unsigned char *here = window_at(w, offset, 1);
        if (!here) return false;
        size_t length = window_left(w, offset);
        if (length > left) length = (size_t)left;
        sum = crc32c(sum, here, length);
        offset += length;
        left -= length;
    }
    const unsigned char *tail = window_at(w, offset, JOURNAL_TAIL);
    return tail && frame_checksum(tail) == sum;
}

int journal_search(const byte_source *bytes, uint64_t from, journal_found found, void *context, journal_scan *scan) {
    window w = {.bytes = bytes};
    uint64_t offset = from;
    bool astray = false; // the offset is not at the beginning of a frame
    *scan = (journal_scan){.end = from};
    while (offset < bytes->size && !w.error) {
        const uint64_t left = bytes->size - offset;
        frame_head head;
        const unsigned char *here = left >= JOURNAL_HEAD ? window_at(&w, offset, JOURNAL_HEAD) : NULL;
        if (!here || !frame_head_get(here, &head)) {
            // The rest may be the beginning of a frame, unless another valid frame follows.
            astray = true;
            offset = find_magic(&w, offset + 1);
            continue;
        }
        // The head's checksum is right, so its length is valid.
        if (left < JOURNAL_HEAD + JOURNAL_TAIL || head.size > left - JOURNAL_HEAD - JOURNAL_TAIL) break;
        scan->damaged += astray;
        astray = false;
        const uint64_t next = offset + JOURNAL_HEAD + head.size + JOURNAL_TAIL;
        if (payload_is_sound(&w, offset, head.size)) {
            if (found) found(context, &head, offset + JOURNAL_HEAD);
            scan->frames++;
            scan->end = next;
        } else {
            scan->damaged++;
        }
        offset = next;
    }
    scan->torn = offset < bytes->size || astray;
    return w.error;
}
