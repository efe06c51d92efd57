#include "journal.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"

/// Text between "RESULT.h5.journal" and the numbers, of a shard and of a rank.
static const char *const endings[] = {".shard-", ".rank-"};

bool name_journal(const char *output, journal_owner owner, char path[JOURNAL_NAME_SIZE]) {
    char ending[64] = "";
    if (owner.share.count > 0)
        snprintf(ending, sizeof ending, "%s%zu-of-%zu", endings[owner.is_rank], owner.share.number, owner.share.count);
    if (snprintf(path, JOURNAL_NAME_SIZE, "%s.journal%s", output, ending) < JOURNAL_NAME_SIZE) return true;
    complain("the name of the result is too long");
    return false;
}

/// Reads a whole number of at most MAX_DIGITS digits and moves past its digits. Returns 0 if there is none.
static size_t read_number(const char **text) {
    enum { MAX_DIGITS = 9 };
    const size_t digits = strspn(*text, "0123456789");
    const size_t number = digits <= MAX_DIGITS ? strtoul(*text, NULL, 10) : 0;
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

/// Reads the end of a name, after "RESULT.h5.journal". Returns false if it is not that of a journal.
static bool read_ending(const char *ending, journal_owner *owner) {
    *owner = (journal_owner){.is_rank = false};
    if (*ending == '\0') return true;
    owner->is_rank = strncmp(ending, endings[true], strlen(endings[true])) == 0;
    const char *word = endings[owner->is_rank];
    return strncmp(ending, word, strlen(word)) == 0 && read_share(ending + strlen(word), "-of-", &owner->share);
}

void add_journal_name(journal_names *names, const char *path, journal_owner owner) {
    for (size_t i = 0; i < names->count; i++)
        if (strcmp(names->items[i].path, path) == 0) return;
    journal_name *items = realloc(names->items, (names->count + 1) * sizeof *items);
    if (!items) return;
    names->items = items;
    items[names->count] = (journal_name){.path = strdup(path), .owner = owner};
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
        journal_owner owner;
        char path[2 * JOURNAL_NAME_SIZE];
        if (strncmp(entry->d_name, pattern, strlen(pattern)) != 0 ||
            !read_ending(entry->d_name + strlen(pattern), &owner))
            continue;
        snprintf(path, sizeof path, "%s%s", folder, entry->d_name);
        add_journal_name(&names, path, owner);
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
