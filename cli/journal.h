/// The journal of a run, beside the result, and those that it takes points from.
#ifndef CLI_JOURNAL_H
#define CLI_JOURNAL_H

#include "whirl/engine.h"
#include "whirl/engine/study.h"

#include <stdbool.h>
#include <stddef.h>

// ---------------------------------------------------------------- journal_names
// Names of the journals of a result: RESULT.h5.journal of a whole run, RESULT.h5.journal.shard-2-of-7 of a share of
// it, RESULT.h5.journal.rank-2-of-7 of one of several processes that compute it together, but for the first.

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

/// What a run asks of its journal.
typedef struct journal_wish {
    const char *output;
    journal_owner owner;
    bool resume; ///< go on from what is there
    bool merge;  ///< ... from journals only, of shards that may still be at work
    bool force;  ///< there may be a result already
    bool quiet;  ///< what is good news is left out
    size_t other_count;
    const char *const *others; ///< [other_count] journals that are not beside the result
} journal_wish;

typedef struct run_journal {
    char path[JOURNAL_NAME_SIZE];
    whirl_journal *journal; ///< NULL: there is none
    whirl_study study;      ///< of which the journal has a share
    const journal_wish *wish;
    journal_names taken; ///< journals of the same result, all of whose points it has
} run_journal;

/// Begins the journal of a result, or goes on from those that are there. Gives the exit status, after complaining of
/// what stands in the way. To be ended by one of those below.
///
/// There may be nothing left to do: then `finished` is the result that is there, complete, and there is no journal.
int open_journal(const journal_wish *wish, const whirl_case *object, run_journal *journal, whirl_result **finished);

/// The same for a rank but the first one, when the first has opened the journal of the whole: `there` are the journals
/// that there were before any rank began its own.
int open_rank_journal(const journal_wish *wish, const whirl_case *object, const journal_names *there,
                      run_journal *journal);

/// Closes the journal of a rank whose study is not begun, for another one could not open its own; what was made for it
/// goes.
void abandon_journal(run_journal *journal);

/// Closes a rank's journal; gives the exit status.
int close_rank_journal(run_journal *journal);

/// Takes what the other ones of so many ranks have kept, when they have closed their journals.
whirl_status take_rank_journals(run_journal *journal, int ranks);

/// Closes the journal of a run that ended early, and says what of it is kept.
void leave_journal(run_journal *journal);

/// The same for a shard that is done.
int close_shard(run_journal *journal);

/// Removes the journal, and those that it took points from, when the result is safe.
void remove_journal(run_journal *journal);

#endif
