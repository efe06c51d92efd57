#include "pad_tables.h"

#include <math.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lock.h"

/// Of the file: another number where nodes or the solution change.
enum { FORMAT = 4, PATH_LENGTH = 1024 };

static lock guard = LOCK_OPEN;
static _Atomic(const pad_table *) tables[MAX_PAD_TABLES];
static pad_table_key keys[MAX_PAD_TABLES];
static size_t table_count;

// ---------------------------------------------------------------- files

/// What stands before the coefficients.
typedef struct file_head {
    char magic[8];
    int32_t format, law, turbulence, unused;
    double arc, ratio, reynolds;
    uint64_t count, checksum;
} file_head;

/// Fowler, Noll, Vo 1991 over words of 64 bits.
static uint64_t checksum(const double *at, size_t count) {
    uint64_t sum = 14695981039346656037u;
    for (size_t i = 0; i < count; i++) {
        uint64_t word;
        memcpy(&word, &at[i], sizeof word);
        sum = (sum ^ word) * 1099511628211u;
        sum ^= sum >> 29;
    }
    return sum;
}

/// The user's cache folder; false where there is none.
static bool cache_folder(char folder[PATH_LENGTH]) {
    const char *cache = getenv("XDG_CACHE_HOME"), *home = getenv("HOME");
    int length = -1;
    if (cache && *cache == '/')
        length = snprintf(folder, PATH_LENGTH, "%s/whirl", cache);
    else if (home && *home == '/')
        length = snprintf(folder, PATH_LENGTH, "%s/.cache/whirl", home);
    return length > 0 && length < PATH_LENGTH;
}

/// The file of a table; false without a folder.
static bool file_of(const pad_table_key *key, char path[PATH_LENGTH]) {
    char folder[PATH_LENGTH];
    if (!cache_folder(folder)) return false;
    uint64_t of[3];
    memcpy(&of[0], &key->arc, sizeof of[0]);
    memcpy(&of[1], &key->ratio, sizeof of[1]);
    memcpy(&of[2], &key->reynolds, sizeof of[2]);
    const int length =
        snprintf(path, PATH_LENGTH, "%s/pad-%d-%d-%d-%016llx-%016llx-%016llx", folder, FORMAT, (int)key->law,
                 (int)key->turbulence, (unsigned long long)of[0], (unsigned long long)of[1], (unsigned long long)of[2]);
    return length > 0 && length < PATH_LENGTH;
}

static file_head head_of(const pad_table_key *key, const pad_table *table) {
    file_head head = {.format = FORMAT,
                      .law = (int32_t)key->law,
                      .turbulence = (int32_t)key->turbulence,
                      .arc = key->arc,
                      .ratio = key->ratio,
                      .reynolds = key->reynolds,
                      .count = PAD_COEFFICIENTS,
                      .checksum = checksum(table->coefficients, PAD_COEFFICIENTS)};
    memcpy(head.magic, "whirlpad", sizeof head.magic);
    return head;
}

static bool same_head(const file_head *one, const file_head *other) {
    return memcmp(one->magic, other->magic, sizeof one->magic) == 0 && one->format == other->format &&
           one->law == other->law && one->turbulence == other->turbulence && one->arc == other->arc &&
           one->ratio == other->ratio && one->reynolds == other->reynolds && one->count == other->count &&
           one->checksum == other->checksum;
}

/// A table from its file; NULL where there is none, or it is damaged or another one.
static pad_table *read_table(const pad_table_key *key) {
    char path[PATH_LENGTH];
    file_head head, own;
    if (!file_of(key, path)) return NULL;
    FILE *in = fopen(path, "rb");
    pad_table *table = in ? pad_table_empty() : NULL;
    bool good = table && fread(&head, sizeof head, 1, in) == 1 &&
                fread(table->coefficients, sizeof(double), PAD_COEFFICIENTS, in) == PAD_COEFFICIENTS;
    if (good) {
        own = head_of(key, table);
        good = same_head(&head, &own);
    }
    if (in) fclose(in);
    if (good) return table;
    free(table);
    return NULL;
}

static void make_folders(char *folder) {
    for (char *at = strchr(folder + 1, '/'); at; at = strchr(at + 1, '/')) {
        *at = '\0';
        (void)mkdir(folder, 0700);
        *at = '/';
    }
    (void)mkdir(folder, 0700);
}

/// Leaves a table for other runs, in one step; where that fails they make it again.
static void write_table(const pad_table_key *key, const pad_table *table) {
    char path[PATH_LENGTH], folder[PATH_LENGTH], part[PATH_LENGTH + 32];
    if (!file_of(key, path) || !cache_folder(folder)) return;
    make_folders(folder);
    snprintf(part, sizeof part, "%s.%ld", path, (long)getpid());
    FILE *out = fopen(part, "wb");
    if (!out) return;
    const file_head head = head_of(key, table);
    bool good = fwrite(&head, sizeof head, 1, out) == 1 &&
                fwrite(table->coefficients, sizeof(double), head.count, out) == head.count;
    good = fclose(out) == 0 && good;
    if (!good || rename(part, path) != 0) (void)remove(part);
}

// ---------------------------------------------------------------- all tables

static bool same(const pad_table_key *one, const pad_table_key *other) {
    return one->arc == other->arc && one->ratio == other->ratio && one->law == other->law &&
           one->turbulence == other->turbulence && one->reynolds == other->reynolds && one->lead == other->lead;
}

whirl_status pad_table_number(const pad_table_key *key, double *number) {
    size_t i = 0;
    lock_take(&guard);
    while (i < table_count && !same(&keys[i], key)) i++;
    if (i == table_count && i < MAX_PAD_TABLES) keys[table_count++] = *key;
    lock_leave(&guard);
    *number = (double)i;
    return i < MAX_PAD_TABLES
               ? whirl_ok()
               : whirl_fail(WHIRL_BAD_INPUT,
                            "there are more than %d different pads, by arc, length over diameter and Reynolds number",
                            MAX_PAD_TABLES);
}

pad_table_key pad_table_key_of(double number) {
    lock_take(&guard);
    const pad_table_key key = keys[(size_t)number];
    lock_leave(&guard);
    return key;
}

/// One of not-a-numbers.
static const pad_table *no_table(void) {
    static pad_table table;
    for (size_t i = 0; i < PAD_ROWS && !isnan(table.rows[i]); i++) table.rows[i] = NAN;
    return &table;
}

static bool is_finite(const pad_table *table) {
    size_t i = 0;
    while (i < PAD_COEFFICIENTS && isfinite(table->coefficients[i])) i++;
    return i == PAD_COEFFICIENTS;
}

/// One that is not finite is told as diverged, and not kept.
static const pad_table *make_table(const pad_table_key *key) {
    pad_table *table = read_table(key);
    if (!table) {
        if (pad_table_new(key, &table).code != WHIRL_OK) return no_table();
        if (is_finite(table)) write_table(key, table);
    }
    pad_table_rows(table);
    pad_table_lean(table, key->lead);
    return table;
}

const pad_table *pad_table_of(double number) {
    const size_t i = (size_t)number;
    const pad_table *table = atomic_load_explicit(&tables[i], memory_order_acquire);
    if (table) return table;
    lock_take(&guard);
    table = atomic_load_explicit(&tables[i], memory_order_relaxed);
    if (!table) {
        table = make_table(&keys[i]);
        atomic_store_explicit(&tables[i], table, memory_order_release);
    }
    lock_leave(&guard);
    return table;
}
