#include "support_runs.h"

whirl_status run_point_machine(const void *context, double speed, const double *spools, whirl_machine *machine) {
    const run_point *at = context;
    whirl_batch batch = at->study->batches[0];
    batch.variant = WHIRL_AS_GIVEN;
    batch.speed = speed;
    batch.stop = at->stop;
    batch.spool_count = spools ? WHIRL_MAX_SPOOLS : 0;
    for (size_t k = 0; k < batch.spool_count; k++) batch.spool_speeds[k] = spools[k];
    batch.spools_vary = true;
    batch.happened_count = at->count;
    for (size_t i = 0; i < at->count; i++) batch.happened[i] = at->events[i];
    return at->study->machine(at->study->family, &batch, at->value, machine);
}
