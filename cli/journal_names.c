#include "journal_names.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"

bool name_journal(const char *output, whirl_share share, char path[JOURNAL_NAME_SIZE]) {
    char ending[64] = "";
    if (share.count > 0) snprintf(ending, sizeof ending, ".shard-%zu-of-%zu", share.number, share.count);
    if (snprintf(path, JOURNAL_NAME_SIZE, "%s.journal%s", output, ending) < JOURNAL_NAME_SIZE) return true;
    complain("the name of the result is too long");
    return false;
}

/// A whole number of few digits; the text goes on behind it. 0 where there is none.
static size_t read_number(const char **text) {
    enum { MOST_DIGITS = 9 };
    const size_t digits = strspn(*text, "0123456789");
    const size_t number = digits <= MOST_DIGITS ? strtoul(*text, NULL, 10) : 0;
    *text += digits;
    return digits > 0 ? number : 0;
}

bool read_share(const char *text, const char *between, whirl_share *share) {
    share->number = read_number(&text);
    const bool divided = strncmp(text, between, strlen(between)) == 0;
    if (divided) text += strlen(between);
    share->count = divided ? read_number(&text) : 0;
    return *text == '\0' && share->number >= 1 && share->number <= share->count;
}

/// Reads what stands behind "RESULT.h5.journal"; false where that is no end of a journal's name.
static bool read_ending(const char *ending, whirl_share *share) {
    static const char shard[] = ".shard-";
    *share = (whirl_share){0};
    if (*ending == '\0') return true;
    return strncmp(ending, shard, strlen(shard)) == 0 && read_share(ending + strlen(shard), "-of-", share);
}

static char *join(const char *folder, const char *name) {
    const size_t size = strlen(folder) + strlen(name) + 1;
    char *path = malloc(size);
    if (path) snprintf(path, size, "%s%s", folder, name);
    return path;
}

static void add(journal_names *names, const char *folder, const char *name, whirl_share share) {
    journal_name *items = realloc(names->items, (names->count + 1) * sizeof *items);
    if (!items) return;
    names->items = items;
    items[names->count] = (journal_name){.share = share};
    items[names->count].path = join(folder, name);
    if (items[names->count].path) names->count++;
}

static int by_path(const void *left, const void *right) {
    const journal_name *a = left, *b = right;
    return strcmp(a->path, b->path);
}

journal_names find_journals(const char *output) {
    char folder[JOURNAL_NAME_SIZE], pattern[JOURNAL_NAME_SIZE];
    journal_names names = {0};
    const char *slash = strrchr(output, '/');
    const int length = slash ? (int)(slash - output) + 1 : 0;
    snprintf(folder, sizeof folder, "%.*s", length, output);
    snprintf(pattern, sizeof pattern, "%s.journal", output + length);
    DIR *list = opendir(length ? folder : ".");
    for (const struct dirent *entry; list && (entry = readdir(list)) != NULL;) {
        whirl_share share;
        if (strncmp(entry->d_name, pattern, strlen(pattern)) == 0 &&
            read_ending(entry->d_name + strlen(pattern), &share))
            add(&names, folder, entry->d_name, share);
    }
    if (list) closedir(list);
    if (names.count > 1) qsort(names.items, names.count, sizeof *names.items, by_path);
    return names;
}

void free_journal_names(journal_names *names) {
    for (size_t i = 0; i < names->count; i++) free(names->items[i].path);
    free(names->items);
    *names = (journal_names){0};
}
