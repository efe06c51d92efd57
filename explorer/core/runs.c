// Computes run-ups over the time as the study does.
#include "core.h"

#include "resting_point.h"

/// Number of spectra of a run whose case has none, largest number of orbits, and largest number of their instants.
enum { USUAL_SPECTRA = 100, MAX_ORBITS = 1000, MAX_INSTANTS = 1 << 19 };

#if defined(__EMSCRIPTEN__)
EM_JS(void, run_passed, (double time), {
    if (Module['passed']) Module['passed'](time);
});
#else
static void run_passed(double time) {
    (void)time;
}
#endif

static void run_watch(void *watcher, double time, double share) {
    (void)watcher, (void)share;
    run_passed(time);
}

EXPORTED void explorer_plan_run(plan *p) {
    whirl_runup_options *run = &p->batch.record.runup;
    run->orbits = run->rows < MAX_ORBITS ? run->rows : MAX_ORBITS;
    if (run->orbits > MAX_INSTANTS / run->samples) run->orbits = MAX_INSTANTS / run->samples;
    if (run->spectra == 0) run->spectra = USUAL_SPECTRA;
    run->waveform = 0;
    run->stationary = 0;
}

EXPORTED double explorer_run_duration(const plan *p) {
    return whirl_runup_duration(&p->batch.record.runup);
}

EXPORTED int explorer_run(const plan *p, double value, double *block) {
    whirl_machine machine;
    const resting_place at = {&p->study, &p->batch, value};
    whirl_status status = p->study.machine(p->study.family, &p->batch, value, &machine);
    if (status.code == WHIRL_OK) {
        whirl_resting point = resting_point_of(&at, &machine);
        point.passed = run_watch;
        status = whirl_analyze_resting(&point, &p->batch.record, p->batch.analyses, &p->layout, block);
        machine.release(machine.owner);
    }
    return explorer_good(&status);
}
