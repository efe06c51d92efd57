/// Studies of one sweep, and running them. Include after cmocka.h.
#ifndef STUDY_SWEEP_STUDY_H
#define STUDY_SWEEP_STUDY_H

#include <stdio.h>

#include "whirl/engine/study.h"

/// Makes a study with one batch, the "sweep" of `parameter` over the values (borrowed), by RK4 with `steps` steps per
/// revolution, without waveforms. Callers set other options in batches[0].
static inline whirl_study sweep_study(const char *parameter, const double *values, size_t count, int steps) {
    whirl_study study = {.batch_count = 1};
    whirl_batch *batch = &study.batches[0];
    *batch = (whirl_batch){.name = "sweep", .count = count, .values = values};
    snprintf(batch->parameter, sizeof batch->parameter, "%s", parameter);
    batch->integrate = whirl_integrate_default();
    batch->integrate.steps_per_revolution = steps;
    batch->record = whirl_record_default();
    batch->record.waveform = false;
    return study;
}

/// Runs the study; the result belongs to the caller.
static inline whirl_result *run(const whirl_study *study, int threads) {
    whirl_result *result;
    const whirl_status status = whirl_study_run(study, &(whirl_run_options){.threads = threads}, &result);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    return result;
}

#endif
