// Journals: see whirl/engine/journal.h and journal_frame.h.
#include "whirl/engine/journal.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "bytes.h"
#include "clock.h"
#include "crc32c.h"
#include "identity.h"
#include "journal_file.h"
#include "journal_frame.h"
#include "journal_header.h"
#include "journal_scan.h"
#include "mapped.h"
#include "underway.h"

enum { MAX_BATCHES = 128 };

/// Seconds after which finished points are synced to the disk, at the next look between revolutions.
static const double sync_interval = 5.0;

/// File offsets of the payloads of a batch's points in one pass; 0: the journal lacks the point.
typedef struct batch_index {
    size_t count;
    uint64_t *offset; ///< [count], NULL if the pass has no points yet; in the journal's page cache
} batch_index;

struct whirl_journal {
    journal_file file;
    whirl_point_store store;
    journal_identity identity;
    whirl_journal_part part;
    uint64_t hash;
    uint64_t end;           ///< end of the last valid frame
    unsigned char *pending; ///< frames that could not be written yet
    size_t pending_size, pending_points;
    bool dirty;         ///< frames were written and not synced
    double synced;      ///< time of the last sync, clock_seconds()
    size_t batch_count; ///< batches of the study; those of later passes have the following indices (whirl_point_store)
    size_t points;      ///< points of the first pass
    batch_index batches[MAX_BATCHES];
    whirl_mapped *mapped;
    size_t looks; ///< number of looks at the index, for mapped_evict_often
    whirl_journal_found found;
    underway *states; ///< states of unfinished points; NULL: none are kept
};

static uint64_t start_of(const whirl_journal *journal) {
    return header_size(journal->identity.size);
}

// ---------------------------------------------------------------- making and freeing

static void free_journal(whirl_journal *journal) {
    if (!journal) return;
    journal_file_close(&journal->file);
    for (size_t i = 0; i < MAX_BATCHES; ++i) mapped_drop(&journal->mapped, journal->batches[i].offset);
    underway_close(journal->states);
    free(journal->pending);
    free(journal->identity.text);
    free(journal);
}

static batch_index new_index(whirl_journal *journal, size_t count) {
    return (batch_index){count, mapped_take(&journal->mapped, count, sizeof(uint64_t), MAPPED_MIN)};
}

static whirl_status make_index(whirl_journal *journal, const whirl_result *outline) {
    for (size_t i = 0; i < outline->table_count; ++i) {
        journal->batches[i] = new_index(journal, outline->tables[i].count);
        if (!journal->batches[i].offset) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a journal");
    }
    journal->batch_count = outline->table_count;
    return whirl_ok();
}

/// Finds the index entry for a frame's offset; NULL for a point outside the study, or without memory.
static uint64_t *place_of(whirl_journal *journal, uint64_t batch, uint64_t slot) {
    if (batch >= MAX_BATCHES || journal->batch_count == 0) return NULL;
    batch_index *index = &journal->batches[batch];
    const size_t count = journal->batches[batch % journal->batch_count].count;
    if (slot >= count) return NULL;
    if (!index->offset) *index = new_index(journal, count);
    mapped_evict_often(journal->mapped, journal->looks++);
    return index->offset ? &index->offset[slot] : NULL;
}

static whirl_status keep(void *context, size_t batch, size_t slot, const double *block, size_t size, const double *end,
                         size_t dimension);
static bool recall(void *context, size_t batch, size_t slot, double *block, size_t size, double *end, size_t dimension);
static whirl_status tend(void *context);

static void save(void *context, size_t worker, const whirl_point_state *states, size_t count) {
    underway_save(((const whirl_journal *)context)->states, worker, states, count);
}

static void *saved(void *context, size_t batch, size_t slot, double *revolutions, size_t *size) {
    return underway_saved(((const whirl_journal *)context)->states, batch, slot, revolutions, size);
}

static whirl_status new_journal(const whirl_result *outline, const whirl_journal_part *part, whirl_journal **out) {
    if (outline->table_count > MAX_BATCHES)
        return whirl_fail(WHIRL_BAD_INPUT, "a journal has at most %d tables, not %zu", MAX_BATCHES,
                          outline->table_count);
    whirl_journal *journal = *out = calloc(1, sizeof *journal);
    if (!journal) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a journal");
    journal->file.descriptor = -1;
    if (part) journal->part = *part;
    journal->store = (whirl_point_store){keep, recall, tend, journal, save, saved};
    journal->synced = clock_seconds();
    whirl_status status = identity_text(outline, true, &journal->identity.text, &journal->identity.size);
    if (status.code == WHIRL_OK) status = make_index(journal, outline);
    if (status.code == WHIRL_OK) journal->hash = journal_hash(journal->identity.text, journal->identity.size);
    return status;
}

/// Returns true if the journal covers a point, in any pass.
static bool is_for(const whirl_journal *journal, size_t batch, size_t slot) {
    const whirl_journal_part *part = &journal->part;
    return !part->has || part->has(part->context, batch, slot);
}

/// Returns true if a point will certainly be computed: the corners of a refined map's first squares will; starts from
/// neighbours may not.
static bool is_sure(const whirl_table *table, size_t slot) {
    const size_t row = table->row, w = table->refine;
    if (whirl_table_from_neighbour(table, slot)) return false;
    return w == 0 || (slot % row % w == 0 && slot / row % w == 0);
}

/// Reserves disk space for all points that are sure; the state of a rotor has four numbers a station.
static whirl_status reserve(const whirl_journal *journal, const whirl_result *outline) {
    uint64_t size = start_of(journal);
    for (size_t i = 0; i < outline->table_count; ++i) {
        const whirl_table *table = &outline->tables[i];
        const size_t frame = frame_size(table->layout.size, 4 * outline->station_count);
        for (size_t slot = 0; slot < table->count; ++slot)
            size += is_sure(table, slot) && is_for(journal, i, slot) ? frame : 0;
    }
    if (size < journal->end) size = journal->end;
    const int reason = journal_file_reserve(&journal->file, size);
    if (!reason) return whirl_ok();
    return whirl_fail(WHIRL_IO_ERROR, "no room for the points of the run, %.3g MB, in %.250s: %s", (double)size / 1e6,
                      journal->file.path, strerror(reason));
}

whirl_status whirl_journal_begin_part(const char *path, const whirl_result *outline, const whirl_journal_part *part,
                                      whirl_journal **out) {
    whirl_journal *journal = NULL;
    *out = NULL;
    whirl_status status = new_journal(outline, part, &journal);
    if (status.code == WHIRL_OK) status = journal_file_create(&journal->file, path);
    const bool made = status.code == WHIRL_OK;
    if (made) status = reserve(journal, outline);
    if (status.code == WHIRL_OK) status = journal_header_write(&journal->file, &journal->identity);
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

whirl_status whirl_journal_begin(const char *path, const whirl_result *outline, whirl_journal **out) {
    return whirl_journal_begin_part(path, outline, NULL, out);
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
    return journal_header_write(&journal->file, &journal->identity);
}

/// Finds the points of the journal, and cuts the file after the last one.
static whirl_status take_up(whirl_journal *journal) {
    uint64_t size = 0;
    header_state state = HEADER_DAMAGED;
    int reason = journal_file_size(&journal->file, &size);
    if (reason) return journal_file_failed(&journal->file, "read", reason);
    whirl_status status = journal_header_look(&journal->file, &journal->identity, size, &state);
    if (status.code != WHIRL_OK) return status;
    if (state == HEADER_CUT) return begin_again(journal);
    status = find_points(journal, size);
    if (status.code != WHIRL_OK) return status;
    if (state != HEADER_OURS) {
        // Frames have the hash of their study: if there is one, a damaged header can be written again.
        if (journal->points == 0) return journal_header_missing(&journal->file);
        journal->found.damaged++;
        status = journal_header_write(&journal->file, &journal->identity);
        if (status.code != WHIRL_OK) return status;
    }
    reason = journal_file_cut(&journal->file, journal->end);
    return reason ? journal_file_failed(&journal->file, "write", reason) : whirl_ok();
}

whirl_status whirl_journal_resume_part(const char *path, const whirl_result *outline, const whirl_journal_part *part,
                                       whirl_journal **out) {
    whirl_journal *journal = NULL;
    *out = NULL;
    whirl_status status = new_journal(outline, part, &journal);
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

whirl_status whirl_journal_resume(const char *path, const whirl_result *outline, whirl_journal **out) {
    return whirl_journal_resume_part(path, outline, NULL, out);
}

whirl_journal_found whirl_journal_look(const whirl_journal *journal) {
    return journal->found;
}

bool whirl_journal_has(const whirl_journal *journal, size_t batch, size_t slot) {
    const batch_index *index = batch < MAX_BATCHES ? &journal->batches[batch] : NULL;
    return index && slot < index->count && index->offset && index->offset[slot] != 0;
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

/// Writes pending frames at the end of the file. After a failure the next try begins at the same place.
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

/// Makes room for one more frame after the pending ones; NULL without memory.
static unsigned char *room_for(whirl_journal *journal, size_t frame) {
    unsigned char *grown = realloc(journal->pending, journal->pending_size + frame);
    if (!grown) return NULL;
    journal->pending = grown;
    return grown + journal->pending_size;
}

static whirl_status keep(void *context, size_t batch, size_t slot, const double *block, size_t size, const double *end,
                         size_t dimension) {
    whirl_journal *journal = context;
    if (!place_of(journal, batch, slot))
        return whirl_fail(WHIRL_BAD_INPUT, "the journal has no place for point %zu of batch %zu", slot, batch);
    const size_t frame = frame_size(size, dimension);
    unsigned char *to = room_for(journal, frame);
    if (!to) return whirl_fail(WHIRL_NO_MEMORY, "no memory to keep a point");
    const frame_head head = {
        .identity = journal->hash, .slot = slot, .size = frame - JOURNAL_HEAD - JOURNAL_TAIL, .batch = (uint32_t)batch};
    frame_put(to, &head, block, size, end, dimension);
    journal->pending_size += frame;
    journal->pending_points += batch < journal->batch_count;
    return write_pending(journal);
}

// ---------------------------------------------------------------- recalling

/// Returns true if the frame is that of the point. This is checked again, since the file may have changed after the
/// search.
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

const whirl_point_store *whirl_journal_store(whirl_journal *journal) {
    return &journal->store;
}

// ---------------------------------------------------------------- taking from other journals

/// Another journal that is searched for points.
typedef struct other_journal {
    whirl_journal *journal;
    const journal_file *file;
    size_t frames; ///< frames of the same study
    whirl_status status;
} other_journal;

static void take_frame(void *context, const frame_head *head, uint64_t offset) {
    other_journal *other = context;
    whirl_journal *journal = other->journal;
    if (head->identity != journal->hash || other->status.code != WHIRL_OK) return;
    const uint64_t *place = place_of(journal, head->batch, head->slot);
    other->frames++;
    if (!place || *place != 0 || !is_for(journal, head->batch, (size_t)head->slot)) return;
    const size_t size = JOURNAL_HEAD + (size_t)head->size + JOURNAL_TAIL;
    unsigned char *to = room_for(journal, size);
    if (!to) {
        other->status = whirl_fail(WHIRL_NO_MEMORY, "no memory to take a point");
        return;
    }
    const int reason = journal_file_read(other->file, offset - JOURNAL_HEAD, to, size);
    if (reason) {
        other->status = journal_file_failed(other->file, "read", reason);
        return;
    }
    journal->pending_size += size;
    journal->pending_points += head->batch < journal->batch_count;
    other->status = write_pending(journal);
}

static whirl_status take_points(whirl_journal *journal, journal_file *file) {
    other_journal other = {.journal = journal, .file = file};
    header_state state = HEADER_DAMAGED;
    journal_scan scan;
    byte_source bytes = {read_file, file, 0};
    int reason = journal_file_size(file, &bytes.size);
    if (reason) return journal_file_failed(file, "read", reason);
    const whirl_status status = journal_header_look(file, &journal->identity, bytes.size, &state);
    if (status.code != WHIRL_OK || state == HEADER_CUT) return status;
    reason = journal_search(&bytes, start_of(journal), take_frame, &other, &scan);
    if (reason) return journal_file_failed(file, "read", reason);
    journal->found.damaged += scan.damaged + (state != HEADER_OURS);
    journal->found.torn = journal->found.torn || scan.torn;
    return state != HEADER_OURS && other.frames == 0 ? journal_header_missing(file) : other.status;
}

whirl_status whirl_journal_take(whirl_journal *journal, const char *path) {
    journal_file file;
    whirl_status status = journal_file_peek(&file, path);
    if (status.code != WHIRL_OK) return status;
    status = take_points(journal, &file);
    journal_file_close(&file);
    journal->found.points = journal->points;
    if (status.code == WHIRL_OK) underway_take(journal->states, path);
    return status;
}

// ---------------------------------------------------------------- ending

whirl_status whirl_journal_close(whirl_journal *journal) {
    whirl_status status = write_pending(journal);
    if (journal->pending_size > 0) {
        const size_t lost = journal->pending_points;
        status = whirl_fail(status.code, "%zu finished point%s could not be kept, and must be computed again: %.300s",
                            lost, lost == 1 ? "" : "s", status.message);
        // Cut off the part of a frame that was written; readers would skip it, too.
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

bool whirl_journal_in_use(const char *path) {
    journal_file file;
    const bool there = journal_file_peek(&file, path).code == WHIRL_OK;
    const bool used = there && !journal_file_is_free(&file);
    if (there) journal_file_close(&file);
    return used;
}

bool whirl_journal_vacant(const char *path) {
    journal_file file;
    uint64_t size = 0;
    journal_scan scan = {.frames = 1};
    if (journal_file_peek(&file, path).code != WHIRL_OK) return false;
    if (journal_file_is_free(&file) && journal_file_size(&file, &size) == 0) {
        const byte_source bytes = {read_file, &file, size};
        const uint64_t from = journal_header_end(&file, size);
        if (from == 0 || journal_search(&bytes, from, NULL, NULL, &scan) != 0) scan.frames = 1;
    }
    journal_file_close(&file);
    return scan.frames == 0 && scan.damaged == 0 && !underway_any(path);
}

whirl_status whirl_journal_discard(const char *path) {
    journal_file file;
    const whirl_status status = journal_file_open(&file, path);
    if (status.code != WHIRL_OK) return status;
    const int reason = journal_file_remove(&file);
    underway_remove(underway_open(path, 0, false));
    journal_file_close(&file);
    return reason ? journal_file_failed(&file, "remove", reason) : whirl_ok();
}
