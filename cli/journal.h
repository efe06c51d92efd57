/// The journal of a run, beside the result, and those that it takes points from.
#ifndef CLI_JOURNAL_H
#define CLI_JOURNAL_H

#include "journal_names.h"
#include "whirl/engine.h"

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
