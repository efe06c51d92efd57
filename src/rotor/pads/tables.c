#include "tables.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lock.h"

/// Of the file: another number where nodes or the solution change.
enum { FORMAT = 1, PATH_LENGTH = 1024 };

/// What a table is of.
typedef struct table_key {
    double arc, ratio;
    int law;
} table_key;

static lock guard = LOCK_OPEN;
static const pad_table *tables[MAX_PAD_TABLES];
static table_key keys[MAX_PAD_TABLES];
static size_t table_count;

const pad_table *pad_table_of(double number) {
    return tables[(size_t)number];
}

// ---------------------------------------------------------------- files

/// What stands before the coefficients.
typedef struct file_head {
    char magic[8];
    int32_t format, law;
    double arc, ratio;
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
static bool file_of(const table_key *key, char path[PATH_LENGTH]) {
    char folder[PATH_LENGTH];
    if (!cache_folder(folder)) return false;
    uint64_t of[2];
    memcpy(&of[0], &key->arc, sizeof of[0]);
    memcpy(&of[1], &key->ratio, sizeof of[1]);
    const int length = snprintf(path, PATH_LENGTH, "%s/pad-%d-%d-%016llx-%016llx", folder, FORMAT, key->law,
                                (unsigned long long)of[0], (unsigned long long)of[1]);
    return length > 0 && length < PATH_LENGTH;
}

static file_head head_of(const table_key *key, const pad_table *table) {
    const size_t count = pad_table_size(table);
    file_head head = {.format = FORMAT,
                      .law = key->law,
                      .arc = key->arc,
                      .ratio = key->ratio,
                      .count = count,
                      .checksum = checksum(table->coefficients, count)};
    memcpy(head.magic, "whirlpad", sizeof head.magic);
    return head;
}

/// A table from its file; NULL where there is none, or it is damaged or another one.
static pad_table *read_table(const table_key *key) {
    char path[PATH_LENGTH];
    file_head head, own;
    if (!file_of(key, path)) return NULL;
    FILE *in = fopen(path, "rb");
    pad_table *table = in ? pad_table_empty(key->arc) : NULL;
    bool good = table && fread(&head, sizeof head, 1, in) == 1 &&
                fread(table->coefficients, sizeof(double), pad_table_size(table), in) == pad_table_size(table);
    if (good) {
        own = head_of(key, table);
        good = memcmp(&head, &own, sizeof head) == 0;
    }
    if (in) fclose(in);
    if (good) return table;
    pad_table_free(table);
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
static void write_table(const table_key *key, const pad_table *table) {
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

static whirl_status add_table(const table_key *key) {
    if (table_count == MAX_PAD_TABLES)
        return whirl_fail(WHIRL_BAD_INPUT, "there are more than %d different pads, by arc and length over diameter",
                          MAX_PAD_TABLES);
    pad_table *table = read_table(key);
    if (!table) {
        const whirl_status status = pad_table_new(key->arc, key->ratio, (cavitation)key->law, &table);
        if (status.code != WHIRL_OK) return status;
        write_table(key, table);
    }
    keys[table_count] = *key;
    tables[table_count++] = table;
    return whirl_ok();
}

whirl_status pad_table_find(double arc, double ratio, cavitation law, double *number) {
    const table_key key = {arc, ratio, (int)law};
    whirl_status status = whirl_ok();
    size_t i = 0;
    lock_take(&guard);
    while (i < table_count && (keys[i].arc != arc || keys[i].ratio != ratio || keys[i].law != key.law)) i++;
    if (i == table_count) status = add_table(&key);
    lock_leave(&guard);
    *number = (double)i;
    return status;
}
