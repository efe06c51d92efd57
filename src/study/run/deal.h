/// The pieces of a pass (chains, neighbours at rest) as threads take them, and other runs where points are dealt out.
#ifndef STUDY_DEAL_H
#define STUDY_DEAL_H

#include "passes.h"

typedef struct deal {
    const whirl_dealer *dealer; ///< NULL: all pieces are this run's
    size_t number;              ///< of the pass (pass_number)
    size_t count;               ///< pieces
    size_t next, end;           ///< those that this run has and that no thread has begun
    size_t dealt;               ///< all before this one are with some run
    int threads;                ///< that all of them are for
} deal;

/// Of a pass of so many pieces.
deal deal_begin(const study_run *run, const pass *p, size_t count);

/// Pieces that no thread has begun, as far as is known.
static inline size_t deal_left(const deal *d) {
    return d->end - d->next + d->count - d->dealt;
}

/// Takes the next piece; false where none is left. Called by one thread at a time.
bool deal_take(deal *d, size_t *piece);

#endif
