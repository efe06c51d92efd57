// Method "auto": which method the points of a batch go by.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "whirl/ensemble.h"
#include "whirl/study.h"

/// Work of a right-hand side in lanes over that of one alone; work of cvode-bdf beside its right-hand sides, linear
/// algebra above all, over theirs.
static const double lane_share = 0.25, overhead = 2.0;

/// Adds what the machine of one value costs.
static whirl_status probe(const whirl_study *study, const whirl_batch *batch, double value, whirl_method_cost *sum) {
    whirl_machine machine;
    whirl_method_cost cost;
    whirl_status status = study->machine(study->family, batch, value, &machine);
    if (status.code != WHIRL_OK) return status;
    status = whirl_method_probe(machine.system, &batch->integrate, machine.start, &cost);
    if (status.code == WHIRL_OK && cost.dop853 > 0.0) {
        const bool lanes = batch->count > 1 && whirl_ensemble_takes(machine.system, &batch->integrate);
        sum->dop853 += cost.dop853 * (lanes ? lane_share : 1.0);
        sum->bdf += cost.bdf * (1.0 + overhead);
    }
    if (machine.release) machine.release(machine.owner);
    return status;
}

static whirl_status choose(const whirl_study *study, whirl_batch *batch) {
    const size_t at[] = {0, batch->count / 2, batch->count - 1}; // where the study is sound: none of them twice
    whirl_method_cost sum = {0.0, 0.0};
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < sizeof at / sizeof *at && status.code == WHIRL_OK; i++)
        if (i == 0 || at[i] != at[i - 1])
            status = probe(study, batch, batch->values ? batch->values[at[i]] : (double)NAN, &sum);
    if (status.code != WHIRL_OK) return status;
    const bool stiff = sum.bdf < sum.dop853 && batch->record.growth != WHIRL_GROWTH_ALL;
    snprintf(batch->integrate.method, sizeof batch->integrate.method, "%s", stiff ? "cvode-bdf" : "dop853");
    batch->integrate.chosen = true;
    return status;
}

whirl_status whirl_study_choose_methods(whirl_study *study) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < study->batch_count && i < WHIRL_MAX_BATCHES && status.code == WHIRL_OK; i++) {
        whirl_batch *batch = &study->batches[i];
        if (strcmp(batch->integrate.method, "auto") == 0 && batch->count > 0 && study->machine)
            status = choose(study, batch);
    }
    return status;
}
