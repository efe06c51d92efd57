/// Deals the pieces of a pass to threads and, if several runs share the points, to other runs. A piece is a row of
/// points, each carried from the one before, or a few neighbouring points at rest.
#ifndef STUDY_DEAL_H
#define STUDY_DEAL_H

#include <stdbool.h>
#include <stddef.h>

#include "pass.h"
#include "study_run.h"
#include "whirl/engine/study.h"

typedef struct deal {
    const whirl_dealer *dealer; ///< NULL: all pieces are this run's
    size_t number;              ///< pass_number of the pass
    size_t count;               ///< pieces
    size_t next, end;           ///< range of the pieces that this run has claimed and no thread has begun
    size_t dealt;               ///< all pieces before this index were dealt to some run
    int threads;                ///< threads of all runs
} deal;

/// Makes the deal of a pass with `count` pieces.
deal deal_begin(const study_run *run, const pass *p, size_t count);

/// Returns the number of pieces that no thread is known to have begun.
static inline size_t deal_left(const deal *d) {
    return d->end - d->next + d->count - d->dealt;
}

/// Takes the next piece; false if none is left. Called by one thread at a time.
bool deal_take(deal *d, size_t *piece);

#endif
