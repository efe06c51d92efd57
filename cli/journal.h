/// The journal of a run: RESULT.h5.journal, beside the result.
#ifndef CLI_JOURNAL_H
#define CLI_JOURNAL_H

#include "whirl/whirl.h"

/// Begins the journal of a result, or goes on from the one that is there when `resume`. Gives the exit status, after
/// complaining of what stands in the way; `quiet` leaves out what is good news. Only with `force` may there be a result
/// already.
///
/// There may be nothing left to do: then `finished` is the result that is there, complete, and there is no journal.
int open_journal(const char *output, const whirl_case *object, bool resume, bool force, bool quiet,
                 whirl_journal **journal, whirl_result **finished);

/// Closes the journal of a run that ended early, and says what of it is kept.
void leave_journal(const char *output, whirl_journal *journal);

#endif
