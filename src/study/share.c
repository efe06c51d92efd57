// Shares of a study: which of several runs computes which points.
#include <stdlib.h>

#include "passes.h"
#include "resting.h"

/// Points of a batch that stay together.
static size_t piece_of(const whirl_batch *batch) {
    if (whirl_analysis_is_traced(batch->analyses)) return batch_slots(batch);
    if (batch->carry != WHIRL_CARRY_NONE) return batch->count;
    return whirl_analysis_is_resting(batch->analyses) ? RESTING_PIECE : 1;
}

bool whirl_share_has(const whirl_study *study, const whirl_share *share, size_t batch, size_t slot) {
    const whirl_batch *own = &study->batches[batch % study->batch_count];
    return share->count == 0 || slot / piece_of(own) % share->count + 1 == share->number;
}

whirl_status share_pass(const study_run *run, pass *p) {
    const size_t length = pass_chain_length(p, &run->study->batches[p->batch]), all = p->count / length;
    size_t chains = 0;
    if (run->share.count == 0) return whirl_ok();
    p->slots = calloc(all + 1, sizeof *p->slots);
    if (!p->slots) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", p->count);
    for (size_t i = 0; i < all; i++)
        if (whirl_share_has(run->study, &run->share, p->batch, i * length)) p->slots[chains++] = i * length;
    p->count = chains * length;
    return whirl_ok();
}
