/// One study, computed by several ranks: the first one deals out the points, gathers the other ranks' journals, and
/// makes the result.
#ifndef CLI_TOGETHER_H
#define CLI_TOGETHER_H

#include <stdint.h>

#include "journal.h"
#include "progress.h"

/// Numbers that ranks exchange; the first two at once when they change.
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
    progress_view *view; ///< on the first rank; NULL: nothing is shown
    whirl_dealer dealer;
    size_t batch_count;
    int threads; ///< threads of this rank
    size_t slots[2 * WHIRL_MAX_BATCHES];
    unsigned char *known[2 * WHIRL_MAX_BATCHES]; ///< [slots] points and confirmations that there were before
    unsigned char *all_known;                    ///< the memory of these
    double known_share;                          ///< known part of the points
    int64_t dealt[2 * WHIRL_MAX_BATCHES];        ///< pieces, when this rank last took some
    whirl_progress own, shown;                   ///< progress of this rank, and of all ranks
    int64_t reported[SHARED_NUMBERS];            ///< numbers of this rank that the others know
    bool gathered;
    bool failed; ///< another rank failed, and reports it
} together;

/// Opens the journals of all ranks, as open_journal does for one; returns the worst outcome. `finished` is the first
/// rank's; *all_done tells every rank whether there is nothing to do.
int open_together(const journal_wish *wish, const whirl_case *object, run_journal *journal, whirl_result **finished,
                  bool *all_done);

/// Prepares a rank; free it with together_free, also after a failure. Returns the worst outcome of all ranks.
int together_begin(together *t, const whirl_case *object, run_journal *journal, int threads, progress_view *view);
void together_free(together *t);

/// Adds this to how a study is run.
void together_join(together *t, whirl_run_options *how);

/// A rank has failed; or is done, with its journal closed, which is not the first.
void together_leave(int outcome);

/// Passes on signals while waiting for other ranks.
void together_look(void);

#endif
