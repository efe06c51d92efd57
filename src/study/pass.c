// What a pass is and costs.
#include "passes.h"

#include "clock.h"

double pass_weight(const study_run *run, const pass *p) {
    return (double)p->integrate.steps_per_revolution / run->study->batches[p->batch].integrate.steps_per_revolution;
}

double pass_revolutions(const study_run *run, const pass *p) {
    return pass_weight(run, p) * ((double)p->record.transient + p->record.record);
}

pass pass_confirming(const pass *points) {
    pass again = *points;
    again.confirming = true;
    again.integrate = whirl_integrate_tighter(&points->integrate, confirm_factor);
    again.record.waveform = again.record.spectra = false;
    again.record.waveform_revolutions = 0;
    again.record.growth = WHIRL_GROWTH_LARGEST; // whatever the points follow
    return again;
}

bool pass_time_is_over(const study_run *run) {
    return run->deadline > 0.0 && clock_seconds() > run->deadline;
}
