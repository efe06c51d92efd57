// Shares of a study: which of several runs computes which points.
#include <stdlib.h>

#include "batch_slots.h"
#include "kinds.h"
#include "pass.h"
#include "refined_map.h"
#include "share.h"
#include "study_run.h"
#include "whirl/engine/study.h"

/// Returns the number of points of a batch that stay together.
static size_t piece_of(const whirl_batch *batch) {
    const study_kind *kind = study_kind_of(batch);
    const size_t piece = kind->piece_of ? kind->piece_of(batch) : kind->piece;
    if (batch->carry != WHIRL_CARRY_NONE) return batch->count;
    return piece > 0 ? piece : batch_slots(batch);
}

bool whirl_share_has(const whirl_study *study, const whirl_share *share, size_t batch, size_t slot) {
    const whirl_batch *own = &study->batches[batch % study->batch_count];
    if (own->refine > 0) return refined_share_has(own, share, slot);
    return share->count == 0 || slot / piece_of(own) % share->count + 1 == share->number;
}

/// Returns true if a point must still be computed or confirmed; carried points count together.
static bool is_open(const study_run *run, const pass *p, size_t slot) {
    const whirl_dealer *dealer = run->dealer;
    const whirl_batch *batch = &run->study->batches[p->batch];
    const pass again = {.batch = p->batch, .confirming = true};
    if (dealer->open(dealer->context, pass_number(run, p), slot)) return true;
    return batch->carry != WHIRL_CARRY_NONE && batch->confirm &&
           dealer->open(dealer->context, pass_number(run, &again), slot);
}

/// Returns true if a part of a point's piece may be dealt to this run.
static bool is_dealt(const study_run *run, const pass *p, size_t slot) {
    const whirl_batch *batch = &run->study->batches[p->batch];
    if (batch_is_found(batch)) return run->dealer->gather != NULL;
    const size_t piece = p->confirming ? 1 : piece_of(batch), first = piece > 1 ? slot / piece * piece : slot;
    const size_t all = batch_slots(batch), end = first + piece < all ? first + piece : all;
    bool open = false;
    for (size_t i = first; i < end && !open; i++) open = is_open(run, p, i);
    return open;
}

static bool is_own(const study_run *run, const pass *p, size_t slot) {
    return run->dealer ? is_dealt(run, p, slot) : whirl_share_has(run->study, &run->share, p->batch, slot);
}

whirl_status share_pass(const study_run *run, pass *p) {
    const size_t length = pass_carried(p, &run->study->batches[p->batch]), all = p->count / length;
    size_t count = 0;
    if (run->study->batches[p->batch].refine > 0) return refined_pass(run, p);
    if (run->share.count == 0 && !run->dealer) return whirl_ok();
    p->slots = calloc(all + 1, sizeof *p->slots);
    if (!p->slots) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", p->count);
    for (size_t i = 0; i < all; i++)
        if (is_own(run, p, i * length)) p->slots[count++] = i * length;
    p->count = count * length;
    const whirl_batch *batch = &run->study->batches[p->batch];
    const bool follows = p->confirming && batch->carry != WHIRL_CARRY_NONE;
    p->dealt = run->dealer && !follows && !batch_is_found(batch);
    return whirl_ok();
}

void share_confirmed(const study_run *run, pass *p) {
    size_t count = 0;
    if (!run->dealer || p->dealt) return;
    for (size_t i = 0; i < p->count; i++)
        if (run->result->tables[p->batch].done[p->slots[i]]) p->slots[count++] = p->slots[i];
    p->count = count;
}
