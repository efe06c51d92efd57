// Method "auto": chooses the method for the points of a batch.
#include <stdio.h>
#include <string.h>

#include "whirl/engine/study.h"

/// Adds the cost of one point's machine.
static whirl_status choose_probe(const whirl_study *study, const whirl_batch *batch, size_t point,
                                 whirl_method_cost *sum) {
    whirl_machine machine;
    whirl_method_cost cost;
    whirl_status status = whirl_study_machine(study, batch, point, &machine);
    if (status.code != WHIRL_OK) return status;
    status = whirl_method_probe(machine.system, &batch->integrate, machine.start, &cost);
    if (status.code == WHIRL_OK && cost.dop853 > 0.0) {
        sum->dop853 += cost.dop853;
        sum->rodas5p += cost.rodas5p;
    }
    if (machine.release) machine.release(machine.owner);
    return status;
}

static whirl_status choose(const whirl_study *study, whirl_batch *batch) {
    // A single record has the method of its whole data set.
    whirl_batch all = *batch;
    all.record.dataset.only = 0;
    if (batch->dataset) all.count = whirl_dataset_records(&all.record.dataset);
    const size_t at[] = {0, all.count / 2, all.count - 1}; // three points, no two of them equal in a sound study
    whirl_method_cost sum = {0.0, 0.0};
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < sizeof at / sizeof *at && status.code == WHIRL_OK; i++)
        if (i == 0 || at[i] != at[i - 1]) status = choose_probe(study, &all, at[i], &sum);
    if (status.code != WHIRL_OK) return status;
    snprintf(batch->integrate.method, sizeof batch->integrate.method, "%s",
             sum.rodas5p < sum.dop853 ? "rodas5p" : "dop853");
    batch->integrate.chosen = true;
    return status;
}

whirl_status whirl_study_choose_methods(whirl_study *study) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < study->batch_count && i < WHIRL_MAX_BATCHES && status.code == WHIRL_OK; i++) {
        whirl_batch *batch = &study->batches[i];
        // Machines at rest are not integrated. For rotating coefficients dop853 computes the monodromy matrix.
        if (!whirl_analysis_kind(batch->analyses)->settles)
            snprintf(batch->integrate.method, sizeof batch->integrate.method, "dop853");
        else if (strcmp(batch->integrate.method, "auto") == 0 && batch->count > 0 && study->machine)
            status = choose(study, batch);
    }
    return status;
}
