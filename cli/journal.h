/// The journal of a run, next to its result, and other journals from which the run takes points.
#ifndef CLI_JOURNAL_H
#define CLI_JOURNAL_H

#include "whirl/engine.h"
#include "whirl/engine/study.h"

#include <stdbool.h>
#include <stddef.h>

// ---------------------------------------------------------------- journal_names
// Names of the journals of a result: RESULT.h5.journal for a whole run, RESULT.h5.journal.shard-2-of-7 for a shard,
// RESULT.h5.journal.rank-2-of-7 for a rank of whirl-mpi other than the first, whose journal is that of the whole run.

enum { JOURNAL_NAME_SIZE = 4096 };

/// Reads a share such as "2/7" or "2-of-7"; between: "/" or "-of-". Returns false for other texts.
bool read_share(const char *text, const char *between, whirl_share *share);

/// Owner of a journal: a whole run (all zero), a share, or a rank, whose number is 1 to count - 1.
typedef struct journal_owner {
    whirl_share share;
    bool is_rank;
} journal_owner;

/// Writes the name of a journal. Returns false, after reporting it, if it is too long.
bool name_journal(const char *output, journal_owner owner, char path[JOURNAL_NAME_SIZE]);

/// An existing journal.
typedef struct journal_name {
    char *path;
    journal_owner owner;
} journal_name;

/// Existing journals of a result, in the order of their names; freed by free_journal_names.
typedef struct journal_names {
    journal_name *items;
    size_t count;
} journal_names;

journal_names find_journals(const char *output);

/// add_journal_name: adds a name that is not yet in the list; without memory it is left out.
void add_journal_name(journal_names *names, const char *path, journal_owner owner);
void free_journal_names(journal_names *names);

/// Settings of a run's journal.
typedef struct journal_wish {
    const char *output;
    journal_owner owner;
    bool resume; ///< continue from existing journals
    bool merge;  ///< use only the points of journals, of shards that may still be running
    bool force;  ///< an existing result may be replaced
    bool quiet;  ///< report errors only
    size_t other_count;
    const char *const *others; ///< [other_count] journals elsewhere than next to the result
} journal_wish;

typedef struct run_journal {
    char path[JOURNAL_NAME_SIZE];
    whirl_journal *journal; ///< NULL: the run has no journal
    whirl_study study;      ///< study of the journal
    const journal_wish *wish;
    journal_names taken; ///< journals of the same result whose points were all taken
} run_journal;

/// Begins the journal of a result, or continues from existing ones. Returns the exit status, after reporting obstacles.
/// End it with one of the functions below.
///
/// If nothing is left to do, `finished` is the existing complete result, and there is no journal.
int open_journal(const journal_wish *wish, const whirl_case *object, run_journal *journal, whirl_result **finished);

/// Like open_journal, for other ranks than the first one, after the first has opened the journal of the run. `there`
/// are the journals that existed before any rank began its own.
int open_rank_journal(const journal_wish *wish, const whirl_case *object, const journal_names *there,
                      run_journal *journal);

/// Closes the journal of a rank whose study did not begin because another rank failed; removes new files.
void abandon_journal(run_journal *journal);

/// Closes a rank's journal. Returns the exit status, after reporting a failure.
int close_rank_journal(run_journal *journal);

/// Takes the points of the other ranks' journals, which must be closed.
whirl_status take_rank_journals(run_journal *journal, int ranks);

/// Closes the journal of a run that ended early, and reports which points are kept.
void leave_journal(run_journal *journal);

/// Closes the journal of a complete shard, and reports how many points it has. Returns the exit status.
int close_shard(run_journal *journal);

/// Removes the journal, and those from which it took points, after the result is safe.
void remove_journal(run_journal *journal);

#endif
