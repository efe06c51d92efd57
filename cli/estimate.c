#include "estimate.h"

#include <math.h>
#include <string.h>
#include <time.h>

#include "limit.h"
#include "whirl/engine/ensemble.h"

/// Returns the processor time of this process in seconds.
static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time); // independent of other processes
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/// Keeps a status that says that memory ran out; other failures only leave the estimate out.
static void note_memory(whirl_status *status, whirl_status made) {
    if (made.code == WHIRL_NO_MEMORY) *status = made;
}

/// Measures the seconds that one revolution of `lanes` copies of a machine takes, side by side in lanes; NaN if
/// unknown, infinite above MAX_SECONDS seconds.
static double time_lanes(const whirl_machine *machine, const whirl_integrate_options *how, size_t lanes,
                         whirl_status *status) {
    enum { MAX_REVOLUTIONS = 50, MAX_SECONDS = 5 };
    const double enough = 0.02;
    const whirl_stop *over = limit_begin(MAX_SECONDS);
    const whirl_system limited = limit_system(machine->system, over);
    whirl_ensemble *ensemble;
    // Make lanes, and load copies of the machine.
    const whirl_status made = whirl_ensemble_takes(&limited, how)
                                  ? whirl_ensemble_new(&limited, how, lanes, &ensemble)
                                  : whirl_ensemble_alone(&limited, how, lanes, 0, &ensemble);
    note_memory(status, made);
    if (made.code != WHIRL_OK) {
        limit_end();
        return (double)NAN;
    }
    for (size_t i = 0; i < lanes; i++) {
        const whirl_status loaded = whirl_ensemble_load(ensemble, i, machine->system, machine->start);
        note_memory(status, loaded);
        if (loaded.code != WHIRL_OK) lanes = i;
    }
    // Repeat revolutions until the measured time is long enough.
    const double begun = now();
    double passed = 0.0;
    int done = 0;
    while (lanes > 0 && done < MAX_REVOLUTIONS && passed < enough && !*over) {
        whirl_ensemble_revolve(ensemble, lanes, NULL);
        passed = now() - begun;
        done++;
    }
    whirl_ensemble_free(ensemble);
    limit_end();
    if (*over) return (double)INFINITY;
    return done > 0 ? passed / done : (double)NAN;
}

/// Estimates the seconds in which all of `motions` motions make one revolution on `cores` cores, in the usual number of
/// lanes. Slow machines are not measured in lanes, from which large machines gain less.
static double time_motions(const whirl_machine *machine, const whirl_integrate_options *how, double motions, int cores,
                           whirl_status *status) {
    const double usual = 32.0, long_one = 0.01, threads = fmin(motions, cores);
    const double lanes = fmin(ceil(motions / threads), usual);
    const double one = time_lanes(machine, how, 1, status);
    const double all = lanes > 1.0 && one < long_one ? time_lanes(machine, how, (size_t)lanes, status) : one * lanes;
    return all * motions / (lanes * threads);
}

/// Estimates the seconds that the modes of all points take on `cores` cores: from a run of the middle point or, for
/// large machines, from the cube of the number of states. NaN below a second.
static whirl_status time_modes(const whirl_study *study, const whirl_batch *batch, int cores, double *seconds) {
    const double most_timed = 150.0, threads = fmin((double)batch->count, cores);
    // Make a study of the middle point alone.
    const size_t middle = batch->count / 2;
    whirl_study one = *study;
    whirl_batch *own = &one.batches[0];
    whirl_machine machine;
    *own = *batch;
    one.batch_count = 1;
    if (batch->values) own->values = batch->values + middle;
    if (batch->second_values) own->second_values = batch->second_values + middle;
    if (batch->third_values) own->third_values = batch->third_values + middle;
    own->count = 1;
    own->row = own->plane = 0;
    own->outline = true;
    // Measure it unless the machine is large.
    whirl_status status = whirl_study_machine(&one, own, 0, &machine);
    if (status.code != WHIRL_OK) return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
    const double states = (double)machine.system->dimension;
    if (machine.release) machine.release(machine.owner);
    own->outline = false;
    double each = 2e-8 * states * states * states; // measured on 650 to 970 states
    if (states <= most_timed) {
        const double begun = now();
        whirl_result *result = NULL;
        status = whirl_study_run(&one, &(whirl_run_options){.threads = 1}, &result);
        each = now() - begun;
        whirl_result_free(result);
    }
    if (each * (double)batch->count / threads >= 1.0) *seconds = each * (double)batch->count / threads;
    return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}

whirl_status estimate_seconds(const whirl_study *study, const whirl_batch *batch, int cores, double *seconds) {
    const double points = (double)batch->count, starts = batch->starts > 1 ? (double)batch->starts : 1.0;
    const bool both = batch->carry == WHIRL_CARRY_BOTH, carried = batch->carry != WHIRL_CARRY_NONE;
    const double motions = points * starts * (both ? 2.0 : 1.0), chains = carried ? motions / points : motions;
    const double whole = (double)batch->record.transient + batch->record.record;
    // A perturbed copy that measures growth is integrated, too, while a motion is watched.
    const bool copied = batch->record.growth == WHIRL_GROWTH_LARGEST;
    const double revolutions = whole + (copied ? (double)whirl_record_watch(&batch->record) : 0.0);
    whirl_machine machine;
    *seconds = (double)NAN;
    if (whirl_analysis_has(batch->analyses, "modes")) return time_modes(study, batch, cores, seconds);
    if (!whirl_analysis_kind(batch->analyses)->moves) return whirl_ok();
    whirl_status status = whirl_study_machine(study, batch, batch->count / 2, &machine);
    if (status.code != WHIRL_OK) return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
    // Larger machines are not measured: a single revolution may take minutes.
    const size_t most_timed = 300;
    const bool timed = machine.system->dimension <= most_timed;
    if (timed)
        *seconds = time_motions(&machine, &batch->integrate, chains, cores, &status) * motions / chains * revolutions;
    if (timed && batch->confirm) {
        // Confirmation takes twice the steps, or tolerances 16 times smaller with a method of order 8 or 5.
        const double order = strcmp(batch->integrate.method, "rodas5p") == 0 ? 5.0 : 8.0;
        const double weight = whirl_method_is_adaptive(batch->integrate.method) ? pow(16.0, 1.0 / order) : 2.0;
        *seconds += weight * revolutions * time_motions(&machine, &batch->integrate, motions, cores, &status);
    }
    if (machine.release) machine.release(machine.owner);
    return status;
}
