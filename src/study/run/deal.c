#include "deal.h"

deal deal_begin(const study_run *run, const pass *p, size_t count) {
    if (!p->dealt) return (deal){.count = count, .end = count, .dealt = count, .threads = run->threads};
    const int threads = run->dealer->threads;
    return (deal){.dealer = run->dealer,
                  .number = pass_number(run, p),
                  .count = count,
                  .threads = threads > run->threads ? threads : run->threads};
}

/// Has more pieces dealt to this run.
static void claim(deal *d) {
    size_t first = 0;
    const size_t taken = d->dealer->claim(d->dealer->context, d->number, d->count, &first);
    d->next = first;
    d->end = first + taken;
    d->dealt = taken > 0 ? d->end : d->count;
}

bool deal_take(deal *d, size_t *piece) {
    if (d->next == d->end && d->dealt < d->count) claim(d);
    if (d->next == d->end) return false;
    *piece = d->next++;
    return true;
}
