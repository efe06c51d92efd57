// Refinement: computes doubtful points again as their verdicts advise, up to a budget. What is done next follows from
// the blocks alone, so that threads, journals and interruptions change no bit.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "follow.h"
#include "pass.h"
#include "passes.h"
#include "refine.h"
#include "refine_fields.h"
#include "study_run.h"
#include "whirl/engine/study.h"

// ---------------------------------------------------------------- points in doubt

/// A point that may be computed again.
typedef struct candidate {
    size_t slot;
    pass next; ///< a pass over this point alone
    double cost;
} candidate;

static double *refine_block_of(const study_run *run, size_t batch, size_t slot) {
    const whirl_table *table = &run->result->tables[batch];
    return table->blocks + slot * table->layout.size;
}

/// Rounds a factor up to a power of two, so that many points share the same options and run together.
static double rounded_up(double factor) {
    return exp2(ceil(log2(fmax(factor, 2.0)) - 1e-9));
}

/// Returns the pass by which the point was last computed.
static pass last_pass(const study_run *run, size_t batch, size_t slot, int round) {
    const whirl_batch *own = &run->study->batches[batch];
    const double *numbers = refine_noted(&run->result->tables[batch].layout, refine_block_of(run, batch, slot));
    pass p = {.batch = batch, .round = round, .integrate = own->integrate, .record = own->record};
    if (numbers[REFINE_ROUNDS] > 0.0) refine_recall(numbers, &p);
    return p;
}

static int refine_sign(double difference) {
    return (difference > 0.0) - (difference < 0.0);
}

/// Orders passes by batch and by the options that refinement changes: -1, 0 if these are equal, 1.
static int compare_options(const pass *a, const pass *b) {
    refined_option option;
    if (a->batch != b->batch) return a->batch < b->batch ? -1 : 1;
    for (size_t i = 0; refine_option(i, &option); i++) {
        const double own = whirl_member_number(option.member, (const char *)a + option.offset);
        const double other = whirl_member_number(option.member, (const char *)b + option.offset);
        if (own != other) return refine_sign(own - other);
    }
    return 0;
}

/// Returns true if the point is doubtful and an advice can be followed.
static bool is_candidate(const study_run *run, size_t batch, size_t slot, int round, candidate *found) {
    const whirl_batch *own = &run->study->batches[batch];
    const whirl_table *table = &run->result->tables[batch];
    if (!whirl_layout_has_verdict(&table->layout) || !whirl_table_done(table, slot)) return false;
    whirl_verdict verdict = whirl_table_verdict(table, slot);
    const bool doubtful = verdict.regime == WHIRL_UNDETERMINED || verdict.confidence == WHIRL_LOW || verdict.settles;
    if (!doubtful) return false;
    if (verdict.advice.remedy == WHIRL_NO_REMEDY) return false;
    if (refine_noted(&table->layout, refine_block_of(run, batch, slot))[REFINE_ROUNDS] == round) return false;
    const pass last = last_pass(run, batch, slot, round);
    *found = (candidate){.slot = slot, .next = last};
    // The samples of a waveform stay the same, whatever the steps.
    found->next.record.samples_per_revolution = whirl_record_samples(&own->record, own->integrate.steps_per_revolution);
    verdict.advice.factor = rounded_up(verdict.advice.factor);
    whirl_advice_apply(verdict.advice, &found->next.integrate, &found->next.record);
    if (compare_options(&last, &found->next) == 0) return false;
    const pass again = pass_confirming(&found->next);
    found->cost = pass_revolutions(run, &found->next) + (own->confirm ? pass_revolutions(run, &again) : 0.0);
    return true;
}

static int refine_by_place(const candidate *a, const candidate *b) {
    if (a->next.batch != b->next.batch) return a->next.batch < b->next.batch ? -1 : 1;
    return a->slot < b->slot ? -1 : a->slot > b->slot;
}

static int by_cost(const void *left, const void *right) {
    const candidate *a = left, *b = right;
    return a->cost != b->cost ? refine_sign(a->cost - b->cost) : refine_by_place(a, b);
}

static int by_options(const void *left, const void *right) {
    const candidate *a = left, *b = right;
    const int order = compare_options(&a->next, &b->next);
    return order != 0 ? order : refine_by_place(a, b);
}

// ---------------------------------------------------------------- a round

/// Plan of a round.
typedef struct plan {
    size_t count; ///< points
    candidate *points;
    size_t *slots; ///< [count] in the order of the passes
    size_t pass_count;
    pass *passes, *again; ///< [pass_count] the points, and those of them that are confirmed
    size_t again_count;
    double cost;
    double *before; ///< the points' earlier blocks; NULL unless the budget is a time
} plan;

static void plan_free(plan *p) {
    free(p->points);
    free(p->slots);
    free(p->passes);
    free(p->before);
}

static size_t count_points(const whirl_result *result) {
    size_t count = 0;
    for (size_t i = 0; i < result->table_count; i++) count += result->tables[i].count;
    return count;
}

/// Chooses the cheapest points, as far as the budget allows.
static void refine_choose(const study_run *run, int round, double budget, plan *p) {
    size_t count = 0;
    for (size_t batch = 0; batch < run->study->batch_count; batch++)
        for (size_t slot = 0; slot < run->result->tables[batch].count; slot++)
            count += is_candidate(run, batch, slot, round, &p->points[count]);
    qsort(p->points, count, sizeof *p->points, by_cost);
    while (p->count < count && p->cost + p->points[p->count].cost <= budget) p->cost += p->points[p->count++].cost;
    qsort(p->points, p->count, sizeof *p->points, by_options);
}

static void refine_group(const study_run *run, plan *p) {
    for (size_t i = 0; i < p->count; i++) {
        pass *last = p->pass_count ? &p->passes[p->pass_count - 1] : NULL;
        p->slots[i] = p->points[i].slot;
        if (!last || compare_options(last, &p->points[i].next) != 0) {
            last = &p->passes[p->pass_count++];
            *last = p->points[i].next;
            last->slots = &p->slots[i];
        }
        last->count++;
    }
    for (size_t i = 0; i < p->pass_count; i++)
        if (run->study->batches[p->passes[i].batch].confirm)
            p->again[p->again_count++] = pass_confirming(&p->passes[i]);
}

static whirl_status plan_round(const study_run *run, int round, double budget, plan *p) {
    const size_t most = count_points(run->result);
    *p = (plan){.points = calloc(most + 1, sizeof *p->points)};
    if (!p->points) return whirl_fail(WHIRL_NO_MEMORY, "no memory to refine %zu points", most);
    refine_choose(run, round, budget, p);
    p->slots = calloc(p->count + 1, sizeof *p->slots);
    p->passes = calloc(2 * p->count + 1, sizeof *p->passes);
    if (!p->slots || !p->passes) return whirl_fail(WHIRL_NO_MEMORY, "no memory to refine %zu points", p->count);
    p->again = p->passes + p->count;
    refine_group(run, p);
    return whirl_ok();
}

/// Returns the cost of the cheapest doubtful point, 0 without one.
static double cheapest_cost(const study_run *run, int round) {
    double least = 0.0;
    candidate found;
    for (size_t batch = 0; batch < run->study->batch_count; batch++)
        for (size_t slot = 0; slot < run->result->tables[batch].count; slot++)
            if (is_candidate(run, batch, slot, round, &found) && (least == 0.0 || found.cost < least))
                least = found.cost;
    return least;
}

// ---------------------------------------------------------------- points that were not done in time

static size_t block_size(const study_run *run, const candidate *point) {
    return run->result->tables[point->next.batch].layout.size;
}

static whirl_status refine_remember(const study_run *run, plan *p) {
    size_t size = 0;
    for (size_t i = 0; i < p->count; i++) size += block_size(run, &p->points[i]);
    p->before = malloc((size + 1) * sizeof *p->before);
    if (!p->before) return whirl_fail(WHIRL_NO_MEMORY, "no memory to refine %zu points", p->count);
    double *to = p->before;
    for (size_t i = 0; i < p->count; i++) {
        const candidate *point = &p->points[i];
        memcpy(to, refine_block_of(run, point->next.batch, point->slot), block_size(run, point) * sizeof *to);
        to += block_size(run, point);
    }
    return whirl_ok();
}

/// Restores points that were not computed, or not confirmed.
static void take_back(const study_run *run, const plan *p, int round) {
    const double *from = p->before;
    for (size_t i = 0; i < p->count; i++) {
        const candidate *point = &p->points[i];
        const whirl_table *table = &run->result->tables[point->next.batch];
        double *block = refine_block_of(run, point->next.batch, point->slot);
        const bool confirmed =
            !run->study->batches[point->next.batch].confirm || whirl_block_verdict(&table->layout, block).confirmed;
        if (refine_noted(&table->layout, block)[REFINE_ROUNDS] != round || !confirmed)
            memcpy(block, from, block_size(run, point) * sizeof *block);
        from += block_size(run, point);
    }
}

static double spent_on(const study_run *run, const plan *p) {
    double sum = 0.0;
    for (size_t i = 0; i < p->count; i++) {
        const candidate *point = &p->points[i];
        sum += refine_spent(&run->result->tables[point->next.batch].layout,
                            refine_block_of(run, point->next.batch, point->slot));
    }
    return sum;
}

/// Computes the points, then confirms those that need it. When time runs out the rest is left as it is.
static whirl_status refine_work(study_run *run, const plan *p) {
    whirl_status status = passes_work(run, p->passes, p->pass_count);
    if (status.code == WHIRL_OK) status = passes_outcome(run);
    if (status.code != WHIRL_OK || p->again_count == 0 || pass_time_is_over(run)) return status;
    for (size_t i = 0; i < p->again_count; i++) run->tracker.progress.points_total += p->again[i].count;
    status = passes_work(run, p->again, p->again_count);
    return status.code == WHIRL_OK ? passes_outcome(run) : status;
}

/// Computes the cheapest points that the budget allows. *done is how many there were.
static whirl_status refine_some(study_run *run, int round, double *budget, size_t *done) {
    plan p;
    whirl_status status = plan_round(run, round, *budget, &p);
    *done = status.code == WHIRL_OK ? p.count : 0;
    if (*done > 0) {
        const double before = spent_on(run, &p);
        tracker_round(&run->tracker, round, p.count, p.cost);
        if (run->deadline > 0.0) status = refine_remember(run, &p);
        if (status.code == WHIRL_OK) status = refine_work(run, &p);
        if (p.before && status.code == WHIRL_OK) take_back(run, &p, round);
        *budget -= spent_on(run, &p) - before;
    }
    plan_free(&p);
    return status;
}

// ---------------------------------------------------------------- budgets of time

/// Returns the revolutions per second computed in the last stage; 0 if there were none.
static double pace_of(const study_run *run) {
    const whirl_progress *progress = &run->tracker.progress;
    const double seconds = clock_seconds() - run->tracker.started;
    return seconds > 0.0 ? fmax(progress->revolutions_done - progress->revolutions_recalled, 0.0) / seconds : 0.0;
}

/// Returns the budget of the next portion: the work of an eighth of the remaining time at the pace of the portion
/// before, so that little is under way when time runs out; or one point, if that fits the remaining time. 0: no
/// portion.
static double next_portion(const study_run *run, int round) {
    const double pace = pace_of(run), left = pace * (run->deadline - clock_seconds()),
                 least = cheapest_cost(run, round);
    if (pace > 0.0 && least > left) return 0.0;
    return fmax(least, 0.125 * left);
}

static whirl_status refine_in_time(study_run *run, int round, size_t *done) {
    whirl_status status = whirl_ok();
    size_t portion = 1;
    *done = 0;
    while (status.code == WHIRL_OK && portion > 0 && !pass_time_is_over(run)) {
        double budget = next_portion(run, round);
        status = refine_some(run, round, &budget, &portion);
        *done += portion;
    }
    return status;
}

/// Spends half of the remaining budget (NULL: time) on chaos that may end. Chaos that has ended is doubtful in the next
/// round.
static whirl_status follow_some(study_run *run, int round, double *budget, size_t *done) {
    size_t followed;
    const double pace = pace_of(run), half = 0.5 * (budget ? *budget : pace * (run->deadline - clock_seconds()));
    double left = half;
    const whirl_status status = follow_points(run, round, &left, &followed);
    if (budget) *budget -= half - left;
    *done += followed;
    return status;
}

whirl_status refine_points(study_run *run) {
    const whirl_budget *allowed = &run->study->refine;
    double budget = allowed->revolutions;
    whirl_status status = whirl_ok();
    size_t done = 1;
    const bool timed = allowed->seconds > 0.0;
    if (timed) run->deadline = clock_seconds() + allowed->seconds;
    for (int round = 1; round <= WHIRL_MAX_ROUNDS && done > 0 && status.code == WHIRL_OK; round++) {
        status = timed ? refine_in_time(run, round, &done) : refine_some(run, round, &budget, &done);
        if (status.code == WHIRL_OK) status = follow_some(run, round, timed ? NULL : &budget, &done);
    }
    return status;
}
