// Journals: see whirl/journal.h and journal_frame.h.
#include "whirl/journal.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "crc32c.h"
#include "identity.h"
#include "journal_file.h"
#include "journal_frame.h"
#include "journal_scan.h"
#include "underway.h"

enum { MOST_BATCHES = 128 };

/// Most seconds that a finished point waits for the disk, but for the time of a revolution.
static const double sync_interval = 5.0;

/// Where the payloads of the points of a pass over a batch lie in the file; 0: not there.
typedef struct batch_index {
    size_t count;
    uint64_t *offset; ///< [count], NULL where the pass has none yet
} batch_index;

struct whirl_journal {
    journal_file file;
    whirl_keeper keeper;
    char *identity;
    size_t identity_size;
    uint64_t hash;
    uint64_t end;           ///< of the last sound frame
    unsigned char *pending; ///< frames that could not be written yet
    size_t pending_size, pending_points;
    bool dirty; ///< written, not synced
    double synced;
    size_t batch_count; ///< of the study; passes beyond the first have indices of their own (whirl_keeper)
    size_t points;      ///< of the first pass
    batch_index batches[MOST_BATCHES];
    whirl_journal_found found;
    underway *states; ///< of points under way; NULL: none are kept
};

static uint64_t start_of(const whirl_journal *journal) {
    return header_size(journal->identity_size);
}

// ---------------------------------------------------------------- making and freeing

static void free_journal(whirl_journal *journal) {
    if (!journal) return;
    journal_file_close(&journal->file);
    for (size_t i = 0; i < MOST_BATCHES; ++i) free(journal->batches[i].offset);
    underway_close(journal->states);
    free(journal->pending);
    free(journal->identity);
    free(journal);
}

static whirl_status make_index(whirl_journal *journal, const whirl_result *outline) {
    for (size_t i = 0; i < outline->table_count; ++i) {
        const size_t count = outline->tables[i].count;
        journal->batches[i] = (batch_index){count, calloc(count ? count : 1, sizeof(uint64_t))};
        if (!journal->batches[i].offset) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a journal");
    }
    journal->batch_count = outline->table_count;
    return whirl_ok();
}

/// Where a frame's offset is noted; NULL for a point that the study has not, or where there is no memory.
static uint64_t *place_of(whirl_journal *journal, uint64_t batch, uint64_t slot) {
    if (batch >= MOST_BATCHES || journal->batch_count == 0) return NULL;
    batch_index *index = &journal->batches[batch];
    const size_t count = journal->batches[batch % journal->batch_count].count;
    if (slot >= count) return NULL;
    if (!index->offset) *index = (batch_index){count, calloc(count, sizeof(uint64_t))};
    return index->offset ? &index->offset[slot] : NULL;
}

static whirl_status keep(void *context, size_t batch, size_t slot, const double *block, size_t size, const double *end,
                         size_t dimension);
static bool recall(void *context, size_t batch, size_t slot, double *block, size_t size, double *end, size_t dimension);
static whirl_status tend(void *context);

static void save(void *context, size_t worker, const whirl_kept_state *states, size_t count) {
    underway_save(((const whirl_journal *)context)->states, worker, states, count);
}

static void *saved(void *context, size_t batch, size_t slot, double *revolutions, size_t *size) {
    return underway_saved(((const whirl_journal *)context)->states, batch, slot, revolutions, size);
}

static whirl_status new_journal(const whirl_result *outline, whirl_journal **out) {
    if (outline->table_count > MOST_BATCHES)
        return whirl_fail(WHIRL_BAD_INPUT, "a journal has at most %d tables, not %zu", MOST_BATCHES,
                          outline->table_count);
    whirl_journal *journal = *out = calloc(1, sizeof *journal);
    if (!journal) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a journal");
    journal->file.descriptor = -1;
    journal->keeper = (whirl_keeper){keep, recall, tend, journal, save, saved};
    journal->synced = clock_seconds();
    whirl_status status = identity_text(outline, true, &journal->identity, &journal->identity_size);
    if (status.code == WHIRL_OK) status = make_index(journal, outline);
    if (status.code == WHIRL_OK) journal->hash = journal_hash(journal->identity, journal->identity_size);
    return status;
}

static whirl_status write_header(whirl_journal *journal) {
    const size_t size = (size_t)start_of(journal);
    unsigned char *header = malloc(size);
    if (!header) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a journal");
    header_put(header, journal->identity, journal->identity_size);
    int reason = journal_file_write(&journal->file, 0, header, size);
    free(header);
    if (!reason) reason = journal_file_sync(&journal->file);
    if (reason) return journal_file_failed(&journal->file, "write", reason);
    journal_file_sync_name(&journal->file);
    return whirl_ok();
}

/// Room for all points; the state of a rotor has four numbers a station.
static whirl_status reserve(const whirl_journal *journal, const whirl_result *outline) {
    uint64_t size = start_of(journal);
    for (size_t i = 0; i < outline->table_count; ++i)
        size += outline->tables[i].count * frame_size(outline->tables[i].layout.size, 4 * outline->station_count);
    if (size < journal->end) size = journal->end;
    const int reason = journal_file_reserve(&journal->file, size);
    if (!reason) return whirl_ok();
    return whirl_fail(WHIRL_IO_ERROR, "no room for the points of the run, %.3g MB, in %.250s: %s", (double)size / 1e6,
                      journal->file.path, strerror(reason));
}

whirl_status whirl_journal_begin(const char *path, const whirl_result *outline, whirl_journal **out) {
    whirl_journal *journal = NULL;
    *out = NULL;
    whirl_status status = new_journal(outline, &journal);
    if (status.code == WHIRL_OK) status = journal_file_create(&journal->file, path);
    const bool made = status.code == WHIRL_OK;
    if (made) status = reserve(journal, outline);
    if (status.code == WHIRL_OK) status = write_header(journal);
    if (status.code == WHIRL_OK) {
        journal->end = start_of(journal);
        journal->states = underway_open(path, journal->hash, false);
        *out = journal;
        return status;
    }
    if (made) journal_file_remove(&journal->file);
    free_journal(journal);
    return status;
}

// ---------------------------------------------------------------- going on

static int read_file(void *context, uint64_t offset, void *to, size_t size) {
    return journal_file_read(context, offset, to, size);
}

static void note_frame(void *context, const frame_head *head, uint64_t offset) {
    whirl_journal *journal = context;
    uint64_t *place = head->identity == journal->hash ? place_of(journal, head->batch, head->slot) : NULL;
    if (!place) return;
    journal->points += *place == 0 && head->batch < journal->batch_count;
    *place = offset;
}

/// What the file begins with.
typedef enum header_state { HEADER_OURS, HEADER_OTHER, HEADER_CUT, HEADER_DAMAGED } header_state;

/// Reads the header of `size` bytes of identity and compares.
static whirl_status compare_header(const whirl_journal *journal, size_t size, header_state *state, char *difference,
                                   size_t difference_size) {
    // With a 0 behind, so that the identity is a text whatever it is.
    unsigned char *header = calloc(1, header_size(size) + 1);
    if (!header) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a journal");
    const int reason = journal_file_read(&journal->file, 0, header, header_size(size));
    *state = HEADER_DAMAGED;
    if (!reason && header_is_sound(header, size)) {
        header[JOURNAL_LEAD + size] = '\0';
        const bool differs =
            identity_difference((const char *)header + JOURNAL_LEAD, journal->identity, difference, difference_size);
        *state = differs ? HEADER_OTHER : HEADER_OURS;
    }
    free(header);
    return reason ? journal_file_failed(&journal->file, "read", reason) : whirl_ok();
}

static whirl_status look_at_header(const whirl_journal *journal, uint64_t file_size, header_state *state,
                                   char *difference, size_t difference_size) {
    unsigned char lead[JOURNAL_LEAD] = {0};
    uint64_t size = 0;
    const size_t there = file_size < JOURNAL_LEAD ? (size_t)file_size : JOURNAL_LEAD;
    const int reason = journal_file_read(&journal->file, 0, lead, there);
    if (reason) return journal_file_failed(&journal->file, "read", reason);
    *state = file_size < start_of(journal) ? HEADER_CUT : HEADER_DAMAGED;
    if (there < JOURNAL_LEAD || !header_lead(lead, &size)) return whirl_ok();
    if (size > file_size - JOURNAL_LEAD || header_size((size_t)size) > file_size) return whirl_ok();
    return compare_header(journal, (size_t)size, state, difference, difference_size);
}

/// Whether the file is nothing but the beginning of our header: a run was killed while it made the journal.
static bool is_cut_header(const whirl_journal *journal, uint64_t file_size) {
    const size_t size = (size_t)start_of(journal);
    unsigned char *ours = malloc(2 * size);
    bool same = false;
    if (ours && file_size <= size) {
        header_put(ours, journal->identity, journal->identity_size);
        same = journal_file_read(&journal->file, 0, ours + size, (size_t)file_size) == 0 &&
               memcmp(ours, ours + size, (size_t)file_size) == 0;
    }
    free(ours);
    return same;
}

static whirl_status find_points(whirl_journal *journal, uint64_t file_size) {
    const byte_source bytes = {read_file, &journal->file, file_size};
    journal_scan scan;
    const uint64_t from = start_of(journal) < file_size ? start_of(journal) : file_size;
    const int reason = journal_search(&bytes, from, note_frame, journal, &scan);
    if (reason) return journal_file_failed(&journal->file, "read", reason);
    journal->end = scan.end;
    journal->found = (whirl_journal_found){.points = journal->points, .damaged = scan.damaged, .torn = scan.torn};
    return whirl_ok();
}

static whirl_status begin_again(whirl_journal *journal) {
    const int reason = journal_file_cut(&journal->file, 0);
    if (reason) return journal_file_failed(&journal->file, "write", reason);
    journal->end = start_of(journal);
    return write_header(journal);
}

/// Finds the points and makes the file end with the last of them.
static whirl_status take_up(whirl_journal *journal) {
    uint64_t size = 0;
    header_state state = HEADER_DAMAGED;
    char difference[WHIRL_MESSAGE_SIZE] = "";
    int reason = journal_file_size(&journal->file, &size);
    if (reason) return journal_file_failed(&journal->file, "read", reason);
    whirl_status status = look_at_header(journal, size, &state, difference, sizeof difference);
    if (status.code != WHIRL_OK) return status;
    if (state == HEADER_OTHER)
        return whirl_fail(WHIRL_BAD_INPUT, "%.100s is of another study: %.280s", journal->file.path, difference);
    if (is_cut_header(journal, size)) return begin_again(journal);
    status = find_points(journal, size);
    if (status.code != WHIRL_OK) return status;
    if (state != HEADER_OURS) {
        // A frame names its study, so that a header is not missed.
        if (journal->points == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "%.200s is no journal of this study, or its beginning is damaged",
                              journal->file.path);
        journal->found.damaged++;
        status = write_header(journal);
        if (status.code != WHIRL_OK) return status;
    }
    reason = journal_file_cut(&journal->file, journal->end);
    return reason ? journal_file_failed(&journal->file, "write", reason) : whirl_ok();
}

whirl_status whirl_journal_resume(const char *path, const whirl_result *outline, whirl_journal **out) {
    whirl_journal *journal = NULL;
    *out = NULL;
    whirl_status status = new_journal(outline, &journal);
    if (status.code == WHIRL_OK) status = journal_file_open(&journal->file, path);
    if (status.code == WHIRL_OK) status = take_up(journal);
    if (status.code == WHIRL_OK) status = reserve(journal, outline);
    if (status.code == WHIRL_OK) {
        journal->states = underway_open(path, journal->hash, true);
        *out = journal;
    } else {
        free_journal(journal);
    }
    return status;
}

whirl_journal_found whirl_journal_look(const whirl_journal *journal) {
    return journal->found;
}

size_t whirl_journal_points(const whirl_journal *journal) {
    return journal->points;
}

// ---------------------------------------------------------------- keeping

static whirl_status sync_now(whirl_journal *journal) {
    if (!journal->dirty) return whirl_ok();
    const int reason = journal_file_sync(&journal->file);
    if (reason) return journal_file_failed(&journal->file, "sync", reason);
    journal->dirty = false;
    journal->synced = clock_seconds();
    return whirl_ok();
}

static whirl_status tend(void *context) {
    whirl_journal *journal = context;
    return clock_seconds() - journal->synced < sync_interval ? whirl_ok() : sync_now(journal);
}

/// Writes what is pending at the end of the file. What part of it a failure leaves there is written over by the next
/// try.
static whirl_status write_pending(whirl_journal *journal) {
    if (journal->pending_size == 0) return whirl_ok();
    const int reason = journal_file_write(&journal->file, journal->end, journal->pending, journal->pending_size);
    if (reason) return journal_file_failed(&journal->file, "write", reason);
    frame_head head;
    for (size_t at = 0; at < journal->pending_size && frame_head_get(journal->pending + at, &head);
         at += JOURNAL_HEAD + (size_t)head.size + JOURNAL_TAIL)
        note_frame(journal, &head, journal->end + at + JOURNAL_HEAD);
    journal->end += journal->pending_size;
    journal->pending_size = journal->pending_points = 0;
    journal->dirty = true;
    return tend(journal);
}

static whirl_status keep(void *context, size_t batch, size_t slot, const double *block, size_t size, const double *end,
                         size_t dimension) {
    whirl_journal *journal = context;
    if (!place_of(journal, batch, slot))
        return whirl_fail(WHIRL_BAD_INPUT, "the journal has no place for point %zu of batch %zu", slot, batch);
    const size_t frame = frame_size(size, dimension);
    unsigned char *grown = realloc(journal->pending, journal->pending_size + frame);
    if (!grown) return whirl_fail(WHIRL_NO_MEMORY, "no memory to keep a point");
    journal->pending = grown;
    const frame_head head = {
        .identity = journal->hash, .slot = slot, .size = frame - JOURNAL_HEAD - JOURNAL_TAIL, .batch = (uint32_t)batch};
    frame_put(grown + journal->pending_size, &head, block, size, end, dimension);
    journal->pending_size += frame;
    journal->pending_points += batch < journal->batch_count;
    return write_pending(journal);
}

// ---------------------------------------------------------------- recalling

/// The frame is checked once more: the file may have changed since it was searched.
static bool is_frame_of(const whirl_journal *journal, const unsigned char *frame, size_t length, size_t batch,
                        size_t slot) {
    frame_head head;
    return frame_head_get(frame, &head) && head.identity == journal->hash && head.batch == batch && head.slot == slot &&
           head.size == length - JOURNAL_HEAD - JOURNAL_TAIL &&
           frame_checksum(frame + length - JOURNAL_TAIL) == crc32c(0, frame, length - JOURNAL_TAIL);
}

static bool recall(void *context, size_t batch, size_t slot, double *block, size_t size, double *end,
                   size_t dimension) {
    whirl_journal *journal = context;
    const uint64_t *place = place_of(journal, batch, slot);
    const uint64_t offset = place ? *place : 0;
    const size_t length = frame_size(size, dimension);
    if (offset == 0 || offset - JOURNAL_HEAD + length > journal->end) return false;
    unsigned char *frame = malloc(length);
    const bool known = frame && journal_file_read(&journal->file, offset - JOURNAL_HEAD, frame, length) == 0 &&
                       is_frame_of(journal, frame, length, batch, slot);
    if (known) {
        frame_numbers(frame + JOURNAL_HEAD, block, size);
        frame_numbers(frame + JOURNAL_HEAD + size * sizeof(double), end, dimension);
    }
    free(frame);
    return known;
}

const whirl_keeper *whirl_journal_keeper(whirl_journal *journal) {
    return &journal->keeper;
}

// ---------------------------------------------------------------- ending

whirl_status whirl_journal_close(whirl_journal *journal) {
    whirl_status status = write_pending(journal);
    if (journal->pending_size > 0) {
        const size_t lost = journal->pending_points;
        status = whirl_fail(status.code, "%zu finished point%s could not be kept, and must be computed again: %.300s",
                            lost, lost == 1 ? "" : "s", status.message);
        // Without the part of a frame that is there; the reader would pass over it too.
        journal_file_cut(&journal->file, journal->end);
    }
    const whirl_status synced = sync_now(journal);
    free_journal(journal);
    return status.code == WHIRL_OK ? synced : status;
}

whirl_status whirl_journal_remove(whirl_journal *journal) {
    const int reason = journal_file_remove(&journal->file);
    underway_remove(journal->states);
    journal->states = NULL;
    const whirl_status status = reason ? journal_file_failed(&journal->file, "remove", reason) : whirl_ok();
    free_journal(journal);
    return status;
}
