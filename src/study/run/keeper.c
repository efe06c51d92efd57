// Access to the journal of a run (its keeper), by one thread at a time.
#include "passes.h"

#include <errno.h>

bool keeper_recall(const whirl_keeper *keeper, const kept_point *p) {
    bool known = false;
    if (!keeper) return false;
#pragma omp critical(whirl_keeper)
    known = keeper->recall(keeper->context, p->batch, p->slot, p->block, p->size, p->end, p->dimension);
    return known;
}

whirl_status keeper_keep(const whirl_keeper *keeper, const kept_point *p) {
    whirl_status status = whirl_ok();
    // Memory that ran out in this thread may have changed its points.
    if (errno == ENOMEM) return whirl_fail(WHIRL_NO_MEMORY, "no memory to compute a point");
    if (!keeper) return status;
#pragma omp critical(whirl_keeper)
    status = keeper->keep(keeper->context, p->batch, p->slot, p->block, p->size, p->end, p->dimension);
    return status;
}

whirl_status keeper_tend(const whirl_keeper *keeper) {
    whirl_status status = whirl_ok();
    if (!keeper || !keeper->tend) return status;
#pragma omp critical(whirl_keeper)
    status = keeper->tend(keeper->context);
    return status;
}

void keeper_save(const whirl_keeper *keeper, size_t worker, const whirl_kept_state *states, size_t count) {
    if (!keeper || !keeper->save || count == 0 || errno == ENOMEM) return;
#pragma omp critical(whirl_keeper)
    keeper->save(keeper->context, worker, states, count);
}

void *keeper_saved(const whirl_keeper *keeper, size_t batch, size_t slot, double *revolutions, size_t *size) {
    void *bytes = NULL;
    if (!keeper || !keeper->saved) return NULL;
#pragma omp critical(whirl_keeper)
    bytes = keeper->saved(keeper->context, batch, slot, revolutions, size);
    return bytes;
}
