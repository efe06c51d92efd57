// Tables of pads as files in the user's cache folder.
#include "pad_table_file.h"
#include "pad_table.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "build.h"
#include "input.h"

enum { PATH_LENGTH = 1024 };

/// Header of a file, which precedes the coefficients.
typedef struct file_head {
    char magic[8], sources[64];
    int32_t law, turbulence;
    double arc, ratio, reynolds;
    uint64_t count, checksum;
} file_head;

uint64_t pad_table_checksum(const pad_table *table) {
    uint64_t sum = 14695981039346656037u;
    for (size_t i = 0; i < PAD_COEFFICIENTS; i++) {
        uint64_t word;
        memcpy(&word, &table->coefficients[i], sizeof word);
        sum = (sum ^ word) * 1099511628211u;
        sum ^= sum >> 29;
    }
    return sum;
}

/// Finds the user's cache folder. Returns false if there is none.
static bool cache_folder(char folder[PATH_LENGTH]) {
    const char *cache = getenv("XDG_CACHE_HOME"), *home = getenv("HOME");
    int length = -1;
    if (cache && *cache == '/')
        length = snprintf(folder, PATH_LENGTH, "%s/whirl", cache);
    else if (home && *home == '/')
        length = snprintf(folder, PATH_LENGTH, "%s/.cache/whirl", home);
    return length > 0 && length < PATH_LENGTH;
}

/// Writes the file name of a table. Returns false without a folder. Builds of other sources use other files.
static bool file_of(const pad_table_key *key, char path[PATH_LENGTH]) {
    char folder[PATH_LENGTH];
    if (!cache_folder(folder)) return false;
    uint64_t of[3];
    memcpy(&of[0], &key->arc, sizeof of[0]);
    memcpy(&of[1], &key->ratio, sizeof of[1]);
    memcpy(&of[2], &key->reynolds, sizeof of[2]);
    const int length = snprintf(path, PATH_LENGTH, "%s/pad-%.8s-%d-%d-%016llx-%016llx-%016llx", folder,
                                build_film_sources(), (int)key->law, (int)key->turbulence, (unsigned long long)of[0],
                                (unsigned long long)of[1], (unsigned long long)of[2]);
    return length > 0 && length < PATH_LENGTH;
}

static file_head head_of(const pad_table_key *key, const pad_table *table) {
    file_head head = {.law = (int32_t)key->law,
                      .turbulence = (int32_t)key->turbulence,
                      .arc = key->arc,
                      .ratio = key->ratio,
                      .reynolds = key->reynolds,
                      .count = PAD_COEFFICIENTS,
                      .checksum = pad_table_checksum(table)};
    memcpy(head.magic, "whirlpad", sizeof head.magic);
    memcpy(head.sources, build_film_sources(), strnlen(build_film_sources(), sizeof head.sources));
    return head;
}

static bool same_head(const file_head *one, const file_head *other) {
    return memcmp(one->magic, other->magic, sizeof one->magic) == 0 &&
           memcmp(one->sources, other->sources, sizeof one->sources) == 0 && one->law == other->law &&
           one->turbulence == other->turbulence && one->arc == other->arc && one->ratio == other->ratio &&
           one->reynolds == other->reynolds && one->count == other->count && one->checksum == other->checksum;
}

static const size_t file_size = sizeof(file_head) + PAD_COEFFICIENTS * sizeof(double);

bool pad_table_file_is_there(const pad_table_key *key) {
    char path[PATH_LENGTH];
    struct stat file;
    return file_of(key, path) && stat(path, &file) == 0 && S_ISREG(file.st_mode) && file.st_size == (off_t)file_size;
}

static bool read_all(int in, void *to, size_t size) {
    for (char *at = to; size > 0;) {
        const ssize_t got = read(in, at, size);
        if (got <= 0) return false;
        at += got;
        size -= (size_t)got;
    }
    return true;
}

whirl_status pad_table_file_read(const pad_table_key *key, pad_table *table, bool *found) {
    char path[PATH_LENGTH];
    file_head head;
    *found = false;
    input_file file;
    if (!file_of(key, path) || !input_open(path, &file)) return whirl_ok();
    const int in = file.descriptor;
    bool good = file.size == file_size && read_all(in, &head, sizeof head) &&
                read_all(in, table->coefficients, sizeof table->coefficients);
    if (good) {
        const file_head own = head_of(key, table);
        good = same_head(&head, &own);
        (void)futimens(in, NULL); // marks the file as used
    }
    close(in);
    return good ? pad_table_confirm(table, key, found) : whirl_ok();
}

static void make_folders(char *folder) {
    for (char *at = strchr(folder + 1, '/'); at; at = strchr(at + 1, '/')) {
        *at = '\0';
        (void)mkdir(folder, 0700);
        *at = '/';
    }
    (void)mkdir(folder, 0700);
}

/// Removes the least recently used table if there are more than PAD_TABLE_FILES.
static void remove_oldest(const char *folder) {
    char oldest[256] = "";
    struct stat file, least = {.st_mtime = 0};
    size_t count = 0;
    DIR *list = opendir(folder);
    for (const struct dirent *entry; list && (entry = readdir(list)) != NULL;) {
        if (strncmp(entry->d_name, "pad-", 4) != 0 || strlen(entry->d_name) >= sizeof oldest) continue;
        if (fstatat(dirfd(list), entry->d_name, &file, AT_SYMLINK_NOFOLLOW) != 0) continue;
        if (count++ > 0 && file.st_mtime >= least.st_mtime) continue;
        least = file;
        strcpy(oldest, entry->d_name);
    }
    if (count > PAD_TABLE_FILES) (void)unlinkat(dirfd(list), oldest, 0);
    if (list) closedir(list);
}

void pad_table_file_write(const pad_table_key *key, const pad_table *table) {
    char path[PATH_LENGTH], folder[PATH_LENGTH], part[PATH_LENGTH + 32];
    if (!file_of(key, path) || !cache_folder(folder)) return;
    make_folders(folder);
    snprintf(part, sizeof part, "%s.%ld", path, (long)getpid());
    FILE *out = fopen(part, "wbx");
    if (!out) return;
    const file_head head = head_of(key, table);
    bool good = fwrite(&head, sizeof head, 1, out) == 1 &&
                fwrite(table->coefficients, sizeof(double), head.count, out) == head.count;
    good = fclose(out) == 0 && good;
    if (!good || rename(part, path) != 0) (void)remove(part);
    remove_oldest(folder);
}
