// Properties and costs of passes.
#include <math.h>
#include <stdlib.h>

#include "clock.h"
#include "deal.h"
#include "pass.h"
#include "study_run.h"

/// Displacement of a perturbed copy over the size of the state.
static const double displacement = 1e-6;

double pass_weight(const study_run *run, const pass *p) {
    return (double)p->integrate.steps_per_revolution / run->study->batches[p->batch].integrate.steps_per_revolution;
}

double pass_revolutions(const study_run *run, const pass *p) {
    const double cost = whirl_analysis_kind(run->study->batches[p->batch].analyses)->cost;
    if (cost > 0.0) return cost;
    return pass_weight(run, p) * ((double)p->record.transient + p->record.record);
}

pass pass_confirming(const pass *points) {
    pass again = *points;
    again.confirming = true;
    again.integrate = whirl_integrate_tighter(&points->integrate, confirm_factor);
    again.record.waveform = again.record.spectra = false;
    again.record.waveform_revolutions = 0;
    if (again.record.growth < WHIRL_GROWTH_LARGEST) again.record.growth = WHIRL_GROWTH_LARGEST;
    return again;
}

size_t pass_number(const study_run *run, const pass *p) {
    const size_t kinds = 2 + FOLLOW_COPIES, kind = p->copy > 0 ? 1 + (size_t)p->copy : p->confirming;
    return p->batch + run->study->batch_count * (kinds * (size_t)p->round + kind);
}

size_t pass_origin(const study_run *run, size_t batch, size_t slot) {
    const size_t *origins = run->origins[batch];
    return origins && origins[slot] > 0 ? origins[slot] - 1 : slot;
}

bool pass_time_is_over(const study_run *run) {
    return run->deadline > 0.0 && clock_seconds() > run->deadline;
}

double *pass_copy_start(const study_run *run, const pass *p, size_t slot) {
    const size_t d = run->dimension;
    const double *end = run->ends[p->batch] + slot * d;
    double *start = malloc(d * sizeof *start), size = 0.0;
    if (!start) return NULL;
    for (size_t i = 0; i < d; i++) size = fmax(size, fabs(end[i]));
    // Take another direction for every copy and round, the same in every run.
    for (size_t i = 0; i < d; i++) {
        const double turn =
            fmod((double)((i + 1) * (size_t)(FOLLOW_COPIES * p->round + p->copy)) * 0.6180339887498949, 1.0);
        start[i] = end[i] + displacement * size * (2.0 * turn - 1.0);
    }
    return start;
}

// ---------------------------------------------------------------- deal

deal deal_begin(const study_run *run, const pass *p, size_t count) {
    if (!p->dealt) return (deal){.count = count, .end = count, .dealt = count, .threads = run->threads};
    const int threads = run->dealer->threads;
    return (deal){.dealer = run->dealer,
                  .number = pass_number(run, p),
                  .count = count,
                  .threads = threads > run->threads ? threads : run->threads};
}

/// Claims more pieces for this run.
static void pass_claim(deal *d) {
    size_t first = 0;
    const size_t taken = d->dealer->claim(d->dealer->context, d->number, d->count, &first);
    d->next = first;
    d->end = first + taken;
    d->dealt = taken > 0 ? d->end : d->count;
}

bool deal_take(deal *d, size_t *piece) {
    if (d->next == d->end && d->dealt < d->count) pass_claim(d);
    if (d->next == d->end) return false;
    *piece = d->next++;
    return true;
}
