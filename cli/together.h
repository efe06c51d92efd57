/// One study, computed by several ranks: the first one deals out the points, gathers the other ranks' journals, and
/// makes the result.
#ifndef CLI_TOGETHER_H
#define CLI_TOGETHER_H

#include <stdint.h>

#include "journal.h"
#include "progress.h"

/// Numbers that ranks exchange: the first two as soon as they change, the others from time to time.
enum {
    SHARED_STOP,   ///< the signal that came to a rank, or 0
    SHARED_FAILED, ///< above 0: a rank has failed
    SHARED_POINTS,
    SHARED_CONFIRMED,
    SHARED_REVOLUTIONS,
    SHARED_RECALLED, ///< revolutions of points taken from journals
    SHARED_NUMBERS
};

/// State of a rank that computes its part of a study.
typedef struct together {
    run_journal *journal;
    progress_view *view; ///< on the first rank; NULL: no progress is shown
    whirl_dealer dealer;
    size_t batch_count;
    int threads; ///< threads of this rank
    size_t slots[2 * WHIRL_MAX_BATCHES];
    unsigned char *known[2 * WHIRL_MAX_BATCHES]; ///< [slots] for each batch, then for each confirmation: 1 if the point
                                                 ///< was known before the run
    unsigned char *all_known;                    ///< memory of `known`
    double known_share;                          ///< part of the points that was known
    int64_t dealt[2 * WHIRL_MAX_BATCHES]; ///< points of each pass that were dealt out when this rank last claimed some
    whirl_progress own, shown;            ///< progress of this rank, and of all ranks
    int64_t reported[SHARED_NUMBERS];     ///< numbers of this rank that it has added to the shared ones
    bool gathered;
    bool failed; ///< another rank failed; that rank reports it
} together;

/// Opens the journals of all ranks, as open_journal does for one process. Returns the worst exit status. Only the first
/// rank gets `finished`; *all_done is set on every rank if nothing is left to compute.
int open_together(const journal_wish *wish, const whirl_case *object, run_journal *journal, whirl_result **finished,
                  bool *all_done);

/// Prepares a rank; free it with together_free, also after a failure. Returns the worst exit status of all ranks.
int together_begin(together *t, const whirl_case *object, run_journal *journal, int threads, progress_view *view);
void together_free(together *t);

/// Sets the options of a study's run by which ranks share its points.
void together_join(together *t, whirl_run_options *how);

/// Reports to the other ranks that this rank has failed or, if it is not the first one, is done and has closed its
/// journal.
void together_leave(int outcome);

/// Passes on signals while waiting for other ranks.
void together_look(void);

#endif
