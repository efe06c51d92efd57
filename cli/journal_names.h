/// Names of the journals of a result: RESULT.h5.journal of a whole run, RESULT.h5.journal.shard-2-of-7 of a share of
/// it.
#ifndef CLI_JOURNAL_NAMES_H
#define CLI_JOURNAL_NAMES_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/study.h"

enum { JOURNAL_NAME_SIZE = 4096 };

/// Reads a share as it is written, "2/7" or "2-of-7" by what stands between; false where it is none.
bool read_share(const char *text, const char *between, whirl_share *share);

/// The name of the journal of a share, or of the whole; false, with a complaint, where it is too long.
bool name_journal(const char *output, whirl_share share, char path[JOURNAL_NAME_SIZE]);

/// A journal that is there.
typedef struct journal_name {
    char *path;
    whirl_share share;
} journal_name;

/// Journals of a result that are there, in the order of their names; freed by free_journal_names.
typedef struct journal_names {
    journal_name *items;
    size_t count;
} journal_names;

journal_names find_journals(const char *output);
void free_journal_names(journal_names *names);

#endif
