// The journal of a run: a critical section gives it to one thread at a time.
#include "run_journal.h"
#include "whirl/engine/study.h"

#include <errno.h>
#include <math.h>

bool run_journal_read(const whirl_point_store *journal, const journal_entry *e) {
    bool known = false;
    if (!journal) return false;
#pragma omp critical(whirl_journal)
    known = journal->recall(journal->context, e->batch, e->slot, e->block, e->size, e->end, e->dimension);
    return known;
}

whirl_status run_journal_write(const whirl_point_store *journal, const journal_entry *e) {
    whirl_status status = whirl_ok();
    // If memory ran out in this thread, the block may be wrong.
    if (errno == ENOMEM) return whirl_fail(WHIRL_NO_MEMORY, "no memory to compute a point");
    if (!journal) return status;
#pragma omp critical(whirl_journal)
    status = journal->keep(journal->context, e->batch, e->slot, e->block, e->size, e->end, e->dimension);
    return status;
}

whirl_status run_journal_sync(const whirl_point_store *journal) {
    whirl_status status = whirl_ok();
    if (!journal || !journal->tend) return status;
#pragma omp critical(whirl_journal)
    status = journal->tend(journal->context);
    return status;
}

double save_next(double begun, double now) {
    return now + fmax(save_interval, 20.0 * (now - begun));
}

void run_journal_save(const whirl_point_store *journal, size_t worker, const whirl_point_state *states, size_t count) {
    if (!journal || !journal->save || count == 0 || errno == ENOMEM) return;
#pragma omp critical(whirl_journal)
    journal->save(journal->context, worker, states, count);
}

void *run_journal_state(const whirl_point_store *journal, size_t batch, size_t slot, double *revolutions,
                        size_t *size) {
    void *bytes = NULL;
    if (!journal || !journal->saved) return NULL;
#pragma omp critical(whirl_journal)
    bytes = journal->saved(journal->context, batch, slot, revolutions, size);
    return bytes;
}
