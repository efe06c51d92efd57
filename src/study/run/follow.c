// Follows chaos that may be transient. No finite record proves that chaos lasts: transients of hundreds and thousands
// of revolutions are common near the ends of an attractor's range. Chaotic points with a neighbour of another regime,
// or without neighbours, are therefore continued from their last states in perturbed copies. Stored blocks alone decide
// which points are followed, so a resumed run follows the same ones.
#include <math.h>
#include <stdlib.h>

#include "follow.h"
#include "pass.h"
#include "passes.h"
#include "study_run.h"
#include "whirl/engine/study.h"

/// Revolutions of a copy divided by those of the point; doubled in every round of refinement.
static const int first_length = 3;

/// Neighbours on either side that are compared, and the fewest points of a batch whose neighbours count.
enum { REACH = 2, MIN_NEIGHBOURS = 16 };

/// Returns true for a chaotic point that may be followed: with a confidence above low, or with a coexisting attractor
/// as long as no copy has ended.
static bool is_chaotic(const whirl_table *table, size_t slot) {
    const whirl_verdict v = whirl_table_verdict(table, slot);
    const bool ended = v.followed > 0.0 && v.later_regime != WHIRL_CHAOTIC && v.later_regime != WHIRL_UNDETERMINED;
    return v.regime == WHIRL_CHAOTIC && (v.confidence > WHIRL_LOW || (v.coexisting != 0 && !ended));
}

/// Returns true if the sweep shows an end of chaos near the point.
static bool is_near_an_end(const whirl_batch *batch, const whirl_table *table, size_t slot) {
    if (batch->count < MIN_NEIGHBOURS) return true;
    const size_t first = slot / batch->count * batch->count, place = slot - first;
    const size_t low = place > REACH ? place - REACH : 0;
    for (size_t i = low; i <= place + REACH && i < batch->count; i++)
        if (whirl_table_done(table, first + i) && !is_chaotic(table, first + i)) return true;
    return false;
}

/// Makes the pass of one copy of a batch's points in this round.
static pass copy_pass(const study_run *run, size_t batch, int round, int copy) {
    const whirl_batch *own = &run->study->batches[batch];
    pass p = {.batch = batch, .round = round, .copy = copy, .integrate = own->integrate, .record = own->record};
    const double all = (double)own->record.transient + own->record.record;
    p.record.watch = whirl_record_watch(&own->record);
    p.record.transient = (int)fmin(all * first_length * exp2(round), 1e9) - own->record.record;
    p.record.settle = true;
    p.record.waveform = p.record.spectra = false;
    p.record.waveform_revolutions = 0;
    p.record.growth = WHIRL_GROWTH_LARGEST;
    return p;
}

/// Returns true for a clearly chaotic point near an end of chaos whose copies have not settled and whose last state is
/// stored.
static bool is_due(const study_run *run, size_t batch, size_t slot) {
    const whirl_table *table = &run->result->tables[batch];
    const whirl_verdict verdict = whirl_table_verdict(table, slot);
    const bool clear = is_chaotic(table, slot) && verdict.agreement == WHIRL_HIGH;
    const double *end = run->ends[batch] ? run->ends[batch] + slot * run->dimension : NULL;
    return clear && end && !isnan(end[0]) && is_near_an_end(&run->study->batches[batch], table, slot);
}

/// Plans passes over the copies of a batch's due points, as far as the budget allows.
static size_t plan_batch(const study_run *run, size_t batch, int round, double *budget, size_t *slots, pass *passes) {
    pass first = copy_pass(run, batch, round, 1);
    const double cost = FOLLOW_COPIES * pass_revolutions(run, &first);
    size_t count = 0;
    for (size_t slot = 0; slot < run->result->tables[batch].count && *budget >= cost; slot++) {
        if (!is_due(run, batch, slot)) continue;
        slots[count++] = slot;
        *budget -= cost;
    }
    for (int copy = 1; copy <= FOLLOW_COPIES && count > 0; copy++) {
        pass *p = &passes[copy - 1];
        *p = copy_pass(run, batch, round, copy);
        p->slots = slots;
        p->count = count;
    }
    return count;
}

whirl_status follow_points(study_run *run, int round, double *budget, size_t *done) {
    const whirl_result *result = run->result;
    size_t most = 0, used = 0, pass_count = 0;
    pass passes[WHIRL_MAX_BATCHES * FOLLOW_COPIES];
    *done = 0;
    // Plan the passes of all batches within the budget.
    for (size_t i = 0; i < result->table_count; i++) most += result->tables[i].count;
    size_t *slots = calloc(most + 1, sizeof *slots);
    if (!slots) return whirl_fail(WHIRL_NO_MEMORY, "no memory to follow %zu points", most);
    double revolutions = *budget;
    for (size_t batch = 0; batch < run->study->batch_count; batch++) {
        if (round == 0 && !run->study->batches[batch].confirm) continue;
        const size_t count = plan_batch(run, batch, round, budget, slots + used, passes + pass_count);
        used += count;
        pass_count += count > 0 ? FOLLOW_COPIES : 0;
    }
    revolutions -= *budget;
    // Run these passes.
    whirl_status status = whirl_ok();
    if (used > 0) {
        tracker_follow(&run->tracker, round, used * FOLLOW_COPIES, revolutions);
        status = passes_work(run, passes, pass_count);
        if (status.code == WHIRL_OK) status = passes_outcome(run);
    }
    *done = used;
    free(slots);
    return status;
}
