#include "underway.h"
#include "atomic_file.h"
#include "bytes.h"

#include <dirent.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "crc32c.h"
#include "journal_scan.h"

enum { PATH_SIZE = ATOMIC_PATH_SIZE, REVOLUTIONS = 8 };

/// A saved state: its point and its place in a file.
typedef struct entry {
    const char *journal;            ///< path of the journal next to which it is
    size_t file, batch, slot, size; ///< file: number of its file; size: bytes of the state
    uint64_t offset;                ///< offset of its payload
    double revolutions;
} entry;

struct underway {
    char path[PATH_SIZE]; ///< path of the journal
    uint64_t identity;
    char **others; ///< [other_count] paths of other journals
    size_t other_count;
    size_t first; ///< number of this run's first file; lower ones belong to an earlier run
    size_t count, capacity;
    entry *entries;
};

static bool name_of(const char *journal, size_t file, char name[PATH_SIZE]) {
    return snprintf(name, PATH_SIZE, "%s-%zu", journal, file) < PATH_SIZE;
}

// ---------------------------------------------------------------- files of an earlier run

/// A file of states, JOURNAL-NUMBER.
typedef struct state_file {
    const char *journal, *folder, *name, *number;
} state_file;

typedef void (*file_fn)(underway *u, const state_file *file);

/// Calls `visit` for every state file of a journal.
static void each_file(underway *u, const char *journal, file_fn visit) {
    char folder[PATH_SIZE], pattern[PATH_SIZE + 1];
    const char *slash = strrchr(journal, '/');
    const int length = slash ? (int)(slash - journal) + 1 : 0;
    snprintf(folder, sizeof folder, "%.*s", length ? length : 2, length ? journal : "./");
    snprintf(pattern, sizeof pattern, "%s-", journal + length);
    DIR *list = opendir(folder);
    for (const struct dirent *one; list && (one = readdir(list)) != NULL;) {
        const state_file file = {journal, folder, one->d_name, one->d_name + strlen(pattern)};
        if (strncmp(one->d_name, pattern, strlen(pattern)) == 0) visit(u, &file);
    }
    if (list) closedir(list);
}

static void remove_file(underway *u, const state_file *file) {
    char path[2 * PATH_SIZE];
    (void)u;
    // The number is "3", or "3.tmp-1234" for a file that a killed write left.
    if (strspn(file->number, "0123456789.tmp-") != strlen(file->number)) return;
    snprintf(path, sizeof path, "%s%s", file->folder, file->name);
    unlink(path);
}

static void add_entry(underway *u, const entry *one) {
    if (u->count == u->capacity) {
        const size_t capacity = u->capacity ? 2 * u->capacity : 64;
        entry *entries = realloc(u->entries, capacity * sizeof *entries);
        if (!entries) return;
        u->entries = entries;
        u->capacity = capacity;
    }
    u->entries[u->count++] = *one;
}

/// A file that is searched for states.
typedef struct search {
    underway *states;
    const byte_source *source;
    const char *journal;
    size_t file;
} search;

static void note_state(void *context, const frame_head *head, uint64_t offset) {
    const search *s = context;
    unsigned char number[REVOLUTIONS];
    entry one = {s->journal, s->file, head->batch, (size_t)head->slot, (size_t)head->size - REVOLUTIONS, offset, 0.0};
    if (head->identity != s->states->identity || head->size < REVOLUTIONS) return;
    if (s->source->read(s->source->context, offset, number, sizeof number) != 0) return;
    frame_numbers(number, &one.revolutions, 1);
    add_entry(s->states, &one);
}

/// Reads the number of a file. Returns false if it has none.
static bool number_of(const state_file *file, size_t *number) {
    char *end;
    *number = strtoul(file->number, &end, 10);
    return *end == '\0' && end != file->number && *number < ULONG_MAX / 2;
}

static void search_file(underway *u, const state_file *file) {
    char path[2 * PATH_SIZE];
    size_t number;
    byte_file from;
    journal_scan scan;
    if (!number_of(file, &number)) return;
    snprintf(path, sizeof path, "%s%s", file->folder, file->name);
    if (strlen(path) >= PATH_SIZE || bytes_open(&from, path).code != WHIRL_OK) return;
    search s = {u, &from.source, file->journal, number};
    journal_search(&from.source, 0, note_state, &s, &scan);
    bytes_close(&from);
}

static void search_own_file(underway *u, const state_file *file) {
    size_t number;
    if (!number_of(file, &number)) {
        remove_file(u, file);
        return;
    }
    if (number >= u->first) u->first = number + 1;
    search_file(u, file);
}

// ---------------------------------------------------------------- opening and closing

underway *underway_open(const char *path, uint64_t identity, bool resume) {
    underway *u = calloc(1, sizeof *u);
    if (!u) return NULL;
    snprintf(u->path, sizeof u->path, "%s", path);
    u->identity = identity;
    each_file(u, u->path, resume ? search_own_file : remove_file);
    return u;
}

void underway_take(underway *u, const char *path) {
    char **others = u ? realloc(u->others, (u->other_count + 1) * sizeof *others) : NULL;
    if (!others) return;
    u->others = others;
    others[u->other_count] = malloc(strlen(path) + 1);
    if (!others[u->other_count]) return;
    strcpy(others[u->other_count], path);
    each_file(u, others[u->other_count++], search_file);
}

static void count_file(underway *u, const state_file *file) {
    size_t number;
    u->count += number_of(file, &number);
}

bool underway_any(const char *path) {
    underway files = {.count = 0};
    each_file(&files, path, count_file);
    return files.count > 0;
}

void underway_close(underway *u) {
    if (!u) return;
    for (size_t i = 0; i < u->other_count; ++i) free(u->others[i]);
    free(u->others);
    free(u->entries);
    free(u);
}

void underway_remove(underway *u) {
    if (u) each_file(u, u->path, remove_file);
    underway_close(u);
}

// ---------------------------------------------------------------- saving

static void write_state(FILE *stream, uint64_t identity, const whirl_point_state *state) {
    unsigned char head[JOURNAL_HEAD], number[REVOLUTIONS], tail[JOURNAL_TAIL];
    const frame_head what = {
        .identity = identity, .slot = state->slot, .size = REVOLUTIONS + state->size, .batch = (uint32_t)state->batch};
    frame_head_put(head, &what);
    frame_numbers_put(number, &state->revolutions, 1);
    uint32_t sum = crc32c(0, head, sizeof head);
    sum = crc32c(sum, number, sizeof number);
    sum = crc32c(sum, state->bytes, state->size);
    frame_checksum_put(tail, sum);
    fwrite(head, 1, sizeof head, stream);
    fwrite(number, 1, sizeof number, stream);
    fwrite(state->bytes, 1, state->size, stream);
    fwrite(tail, 1, sizeof tail, stream);
}

void underway_save(underway *u, size_t worker, const whirl_point_state *kept, size_t count) {
    char name[PATH_SIZE];
    atomic_file out;
    // After a failure the states that were saved before remain.
    if (!u || !name_of(u->path, u->first + worker, name) || atomic_file_open(&out, name).code != WHIRL_OK) return;
    for (size_t i = 0; i < count; ++i) write_state(out.stream, u->identity, &kept[i]);
    (void)atomic_file_commit(&out);
}

// ---------------------------------------------------------------- taking up

static const entry *furthest(const underway *u, size_t batch, size_t slot) {
    const entry *found = NULL;
    for (const entry *one = u->entries; one && one < u->entries + u->count; ++one)
        if (one->batch == batch && one->slot == slot && (!found || one->revolutions > found->revolutions)) found = one;
    return found;
}

void *underway_saved(const underway *u, size_t batch, size_t slot, double *revolutions, size_t *size) {
    const entry *one = u ? furthest(u, batch, slot) : NULL;
    char name[PATH_SIZE];
    byte_file from;
    if (!one || !name_of(one->journal, one->file, name) || bytes_open(&from, name).code != WHIRL_OK) return NULL;
    const uint64_t end = one->offset + REVOLUTIONS + one->size;
    unsigned char *bytes = end <= from.source.size ? malloc(one->size + 1) : NULL;
    if (bytes && from.source.read(&from, one->offset + REVOLUTIONS, bytes, one->size) != 0) {
        free(bytes);
        bytes = NULL;
    }
    bytes_close(&from);
    *size = one->size;
    *revolutions = one->revolutions;
    return bytes;
}
