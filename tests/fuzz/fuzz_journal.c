// Any bytes as a journal: no crash, every frame that is found lies within them and is sound, and the search ends.
#include <errno.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "crc32c.h"
#include "identity.h"
#include "journal_scan.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition) {
    if (!condition) abort();
}

typedef struct input {
    const uint8_t *data;
    size_t size, frames;
    uint64_t last; ///< where the last frame began
} input;

static int read_input(void *context, uint64_t offset, void *to, size_t size) {
    const input *in = context;
    require(offset <= in->size && size <= in->size - offset);
    memcpy(to, in->data + offset, size);
    return 0;
}

static void found(void *context, const frame_head *head, uint64_t offset) {
    input *in = context;
    require(offset >= JOURNAL_HEAD && offset <= in->size);
    require(head->size <= in->size - offset && in->size - offset - head->size >= JOURNAL_TAIL);
    require(in->frames == 0 || offset > in->last);
    const uint8_t *frame = in->data + (offset - JOURNAL_HEAD);
    require(crc32c(0, frame, JOURNAL_HEAD + (size_t)head->size) == frame_checksum(frame + JOURNAL_HEAD + head->size));
    in->last = offset;
    in->frames++;
}

/// Compares the bytes as two identities, one after the other.
static void compare_texts(const uint8_t *data, size_t size) {
    char difference[200];
    char *text = malloc(size + 2);
    require(text != NULL);
    memcpy(text, data, size);
    text[size / 2] = '\0';
    text[size] = '\0';
    const char *second = size / 2 < size ? text + size / 2 + 1 : text;
    const int differ = identity_difference(text, second, difference, sizeof difference);
    require(differ == (strcmp(text, second) != 0));
    require(!differ || memchr(difference, '\0', sizeof difference) != NULL);
    free(text);
}

static void put_checksum(uint8_t *at, uint32_t sum) {
    for (int i = 0; i < 4; ++i) at[i] = (uint8_t)(sum >> 8 * i);
}

/// Corrects the checksums wherever the magic number is, which random mutations would never do: then the reader uses the
/// lengths.
static void mend(uint8_t *data, size_t size) {
    for (size_t i = 0; i + JOURNAL_HEAD <= size; ++i) {
        frame_head head;
        if (memcmp(data + i, journal_magic, sizeof journal_magic) != 0) continue;
        put_checksum(data + i + JOURNAL_HEAD - 4, crc32c(0, data + i, JOURNAL_HEAD - 4));
        require(frame_head_get(data + i, &head));
        if (head.size > size || i + JOURNAL_HEAD + head.size + JOURNAL_TAIL > size) continue;
        const size_t length = JOURNAL_HEAD + (size_t)head.size;
        put_checksum(data + i + length, crc32c(0, data + i, length));
    }
}

static void search(const uint8_t *data, size_t size) {
    // The first byte says where the search begins.
    input in = {.data = data, .size = size};
    const byte_source bytes = {read_input, &in, size};
    const uint64_t from = size > 0 && data[0] < size ? data[0] : 0;
    journal_scan scan;
    require(journal_search(&bytes, from, found, &in, &scan) == 0);
    require(scan.frames == in.frames && scan.end >= from && scan.end <= (size > from ? size : from));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    uint64_t length;
    uint8_t *mended = malloc(size + 1);
    require(mended != NULL);
    memcpy(mended, data, size);
    mend(mended, size);
    search(data, size);
    search(mended, size);
    free(mended);
    if (size >= JOURNAL_LEAD && header_lead(data, &length) && length <= size && header_size((size_t)length) <= size)
        header_is_sound(data, (size_t)length);
    compare_texts(data, size);
    return 0;
}
