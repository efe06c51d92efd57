#include "journal_header.h"
#include "identity.h"
#include "journal_file.h"

#include <stdlib.h>
#include <string.h>

#include "journal_frame.h"

whirl_status journal_header_write(const journal_file *file, const journal_identity *identity) {
    const size_t size = header_size(identity->size);
    unsigned char *header = malloc(size);
    if (!header) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a journal");
    header_put(header, identity->text, identity->size);
    int reason = journal_file_write(file, 0, header, size);
    free(header);
    if (!reason) reason = journal_file_sync(file);
    if (reason) return journal_file_failed(file, "write", reason);
    journal_file_sync_name(file);
    return whirl_ok();
}

/// Reads a header whose identity has `size` bytes, and compares the identity.
static whirl_status compare(const journal_file *file, const journal_identity *identity, size_t size,
                            header_state *state) {
    // A zero byte after the header makes the identity a text.
    unsigned char *header = calloc(1, header_size(size) + 1);
    if (!header) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a journal");
    const int reason = journal_file_read(file, 0, header, header_size(size));
    whirl_status status = reason ? journal_file_failed(file, "read", reason) : whirl_ok();
    if (!reason && header_is_sound(header, size)) {
        char difference[WHIRL_MESSAGE_SIZE];
        header[JOURNAL_LEAD + size] = '\0';
        *state = HEADER_OURS;
        if (identity_difference((const char *)header + JOURNAL_LEAD, identity->text, difference, sizeof difference))
            status = whirl_fail(WHIRL_BAD_INPUT, "%.100s is of another study: %.280s", file->path, difference);
    }
    free(header);
    return status;
}

static bool is_cut(const journal_file *file, const journal_identity *identity, uint64_t file_size) {
    const size_t size = header_size(identity->size);
    unsigned char *ours = malloc(2 * size);
    bool same = false;
    if (ours && file_size <= size) {
        header_put(ours, identity->text, identity->size);
        same = journal_file_read(file, 0, ours + size, (size_t)file_size) == 0 &&
               memcmp(ours, ours + size, (size_t)file_size) == 0;
    }
    free(ours);
    return same;
}

/// Finds the size of the identity that the lead of a header announces. Returns false if the lead is damaged, or the
/// file too short for that size.
static bool header_announced(const unsigned char *lead, uint64_t file_size, uint64_t *size) {
    return file_size >= JOURNAL_LEAD && header_lead(lead, size) && *size <= file_size - JOURNAL_LEAD &&
           header_size((size_t)*size) <= file_size;
}

whirl_status journal_header_look(const journal_file *file, const journal_identity *identity, uint64_t file_size,
                                 header_state *state) {
    unsigned char lead[JOURNAL_LEAD] = {0};
    uint64_t size = 0;
    const size_t there = file_size < JOURNAL_LEAD ? (size_t)file_size : JOURNAL_LEAD;
    const int reason = journal_file_read(file, 0, lead, there);
    if (reason) return journal_file_failed(file, "read", reason);
    *state = is_cut(file, identity, file_size) ? HEADER_CUT : HEADER_DAMAGED;
    if (*state == HEADER_CUT || !header_announced(lead, file_size, &size)) return whirl_ok();
    return compare(file, identity, (size_t)size, state);
}

uint64_t journal_header_end(const journal_file *file, uint64_t file_size) {
    unsigned char lead[JOURNAL_LEAD];
    uint64_t size = 0;
    if (file_size < JOURNAL_LEAD || journal_file_read(file, 0, lead, JOURNAL_LEAD) != 0) return 0;
    if (!header_announced(lead, file_size, &size)) return 0;
    unsigned char *header = malloc(header_size((size_t)size));
    const bool sound = header && journal_file_read(file, 0, header, header_size((size_t)size)) == 0 &&
                       header_is_sound(header, (size_t)size);
    free(header);
    return sound ? header_size((size_t)size) : 0;
}

whirl_status journal_header_missing(const journal_file *file) {
    return whirl_fail(WHIRL_BAD_INPUT, "%.200s is no journal of this study, or its beginning is damaged", file->path);
}
