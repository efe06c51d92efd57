/// Names of the journals of a result: RESULT.h5.journal of a whole run, RESULT.h5.journal.shard-2-of-7 of a share of
/// it, RESULT.h5.journal.rank-2-of-7 of one of several processes that compute it together, but for the first.
#ifndef CLI_JOURNAL_NAMES_H
#define CLI_JOURNAL_NAMES_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/study.h"

enum { JOURNAL_NAME_SIZE = 4096 };

/// Reads a share as it is written, "2/7" or "2-of-7" by what stands between; false where it is none.
bool read_share(const char *text, const char *between, whirl_share *share);

/// Whose points a journal has: a whole run's (all zero), a share's, or what was dealt to a rank, 1 to count - 1.
typedef struct journal_owner {
    whirl_share share;
    bool is_rank;
} journal_owner;

/// The name of a journal; false, with a complaint, where it is too long.
bool name_journal(const char *output, journal_owner owner, char path[JOURNAL_NAME_SIZE]);

/// A journal that is there.
typedef struct journal_name {
    char *path;
    journal_owner owner;
} journal_name;

/// Journals of a result that are there, in the order of their names; freed by free_journal_names.
typedef struct journal_names {
    journal_name *items;
    size_t count;
} journal_names;

journal_names find_journals(const char *output);

/// Adds one that is not there yet; what there is no memory for is left out.
void add_journal_name(journal_names *names, const char *path, journal_owner owner);
void free_journal_names(journal_names *names);

#endif
