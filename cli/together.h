/// One study, computed by several ranks: the first one deals out the points, gathers what the others have kept in
/// journals of their own, and makes the result.
#ifndef CLI_TOGETHER_H
#define CLI_TOGETHER_H

#include <stdint.h>

#include "console.h"
#include "journal.h"

/// What ranks tell one another; the first two, too, when they come about.
enum {
    SHARED_STOP,   ///< the signal that came to one of them, or 0
    SHARED_FAILED, ///< one of them has failed
    SHARED_POINTS,
    SHARED_CONFIRMED,
    SHARED_REVOLUTIONS,
    SHARED_RECALLED, ///< revolutions
    SHARED_NUMBERS
};

/// A rank at its part.
typedef struct together {
    run_journal *journal;
    progress_view *view; ///< of the first rank; NULL: nothing is shown
    whirl_dealer dealer;
    size_t batch_count;
    int threads; ///< of this rank
    size_t slots[2 * WHIRL_MAX_BATCHES];
    unsigned char *known[2 * WHIRL_MAX_BATCHES]; ///< [slots] points and confirmations that there were before
    unsigned char *all_known;                    ///< the memory of these
    double known_share;                          ///< of the points
    int64_t dealt[2 * WHIRL_MAX_BATCHES];        ///< pieces, when this rank last took some
    whirl_progress own, shown;                   ///< of this rank, of all ranks
    int64_t told[SHARED_NUMBERS];                ///< what all know of this one, as the numbers that they see
    bool gathered;
    bool failed; ///< another rank did, and tells it
} together;

/// Opens the journals of all ranks, as open_journal does that of one; gives the worst outcome. `finished` is the first
/// rank's; *all_done tells every rank that there is nothing to do.
int open_together(const journal_wish *wish, const whirl_case *object, run_journal *journal, whirl_result **finished,
                  bool *all_done);

/// Makes ready what a rank needs; freed by together_free, also where it fails. Gives the worst outcome of all ranks.
int together_begin(together *t, const whirl_case *object, run_journal *journal, int threads, progress_view *view);
void together_free(together *t);

/// Adds this to how a study is run.
void together_join(together *t, whirl_run_options *how);

/// A rank has failed; or is done, with its journal closed, which is not the first.
void together_leave(int outcome);

/// What is done now and then while others are waited for: signals are passed on.
void together_look(void);

#endif
