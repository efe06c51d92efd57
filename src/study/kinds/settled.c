#include "settled.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit_options.h"
#include "turns.h"
#include "whirl/engine/linear.h"

whirl_orbit_options whirl_batch_orbits(const whirl_batch *batch) {
    const whirl_trace_options *trace = &batch->record.trace;
    whirl_orbit_options options = orbit_options_by(batch->integrate.method, trace->rtol);
    options.segments = trace->segments;
    return options;
}

whirl_branch_options settled_options(const whirl_batch *batch, size_t most_points) {
    const whirl_trace_options *trace = &batch->record.trace;
    whirl_branch_options options = whirl_branch_default(batch->bounds[0], batch->bounds[1]);
    options.orbit = whirl_batch_orbits(batch);
    options.most_step = trace->step;
    options.step = fmin(options.step, trace->step);
    options.least_step = fmin(options.least_step, options.step);
    options.most_points = most_points;
    options.stop = batch->stop;
    return options;
}

// ---------------------------------------------------------------- the section of a motion

/// Records the motion after the transient, long enough to detect periods.
static whirl_status settled_follow(const whirl_machine *machine, const whirl_batch *batch, whirl_record **record) {
    enum { MIN_RECORD = 16 };
    whirl_record_options options = whirl_record_default();
    options.transient = batch->record.transient;
    options.record = options.watch = batch->record.record > MIN_RECORD ? batch->record.record : MIN_RECORD;
    options.waveform_revolutions = 0;
    whirl_system alone = *machine->system;
    alone.lanes = NULL; // a single motion would not fill them
    const whirl_status status = whirl_record_motion(&alone, &batch->integrate, &options, machine->start, NULL, record);
    if (status.code != WHIRL_OK || (*record)->motion == WHIRL_BOUNDED) return status;
    const double bounded = (*record)->diverged_at - 1.0;
    whirl_record_free(*record);
    *record = NULL;
    return whirl_fail(WHIRL_BAD_INPUT, "the motion leaves its bounds after %.0f revolutions", bounded);
}

/// Returns the largest difference of states that are `apart` revolutions apart.
static double return_distance(const whirl_record *r, size_t apart) {
    double largest = 0.0;
    for (size_t n = apart; n < r->section_count; n++) {
        const double *now = r->section + n * r->dimension, *before = now - apart * r->dimension;
        for (size_t i = 0; i < r->dimension; i++)
            largest = fmax(largest, fabs(short_way(r->angles, i, now[i] - before[i])));
    }
    return largest;
}

/// Returns the revolutions after which the motion returns to a thousandth of its size; 1 if it does not within
/// `longest`.
static size_t period_of(const whirl_record *r, size_t longest) {
    double size = 0.0;
    for (size_t i = 0; i < r->section_count * r->dimension; i++) size = fmax(size, fabs(r->section[i]));
    for (size_t k = 1; k <= longest && 2 * k < r->section_count; k++)
        if (return_distance(r, k) <= 1e-3 * size) return k;
    return 1;
}

/// Replaces the last state by the mean of the section, except for angles that turn.
static void settled_average(whirl_record *r) {
    for (size_t i = 0; i < r->dimension; i++) {
        double mean = 0.0;
        for (size_t n = 0; n < r->section_count; n++)
            mean += r->section[n * r->dimension + i] / (double)r->section_count;
        if (!turns_on(r->turns, i)) r->end[i] = mean;
    }
}

/// Searches from the motion's last state. If the motion does not settle on a periodic orbit, searches from the mean of
/// its section, which is near the unstable orbit that it left.
static whirl_status settled_from_motion(const whirl_machine *machine, const whirl_batch *batch,
                                        const whirl_orbit_options *options, whirl_orbit **orbit) {
    const whirl_trace_options *trace = &batch->record.trace;
    whirl_record *record;
    whirl_status status = settled_follow(machine, batch, &record);
    if (status.code != WHIRL_OK) return status;
    const size_t k = trace->revolutions > 0 ? (size_t)trace->revolutions : period_of(record, (size_t)trace->longest);
    status = whirl_orbit_find(machine->system, record->end, k, options, orbit);
    if (status.code == WHIRL_BAD_INPUT && k == 1) {
        settled_average(record);
        status = whirl_orbit_find(machine->system, record->end, 1, options, orbit);
    }
    whirl_record_free(record);
    return status;
}

/// Searches by Newton's method from the initial state, or from the first harmonic of the machine's linear response
/// about its equilibrium. Finds unstable orbits, too.
static whirl_status settled_from_start(const whirl_machine *machine, const whirl_batch *batch,
                                       const whirl_orbit_options *options, whirl_orbit **orbit) {
    const whirl_trace_options *trace = &batch->record.trace;
    const whirl_system *system = machine->system;
    const size_t n = system->dimension, revolutions = trace->revolutions > 0 ? (size_t)trace->revolutions : 1;
    double *start = calloc(3 * n + 1, sizeof *start), *response = start ? start + n : NULL;
    if (!start) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the start of a branch");
    memcpy(start, machine->start, n * sizeof *start);
    whirl_status status = whirl_ok();
    if (strcmp(trace->begin, "linear") == 0) {
        status = whirl_forced_response(system, machine->start, start, response);
        for (size_t i = 0; i < n; i++) start[i] += response[2 * i];
    }
    if (status.code == WHIRL_OK) status = whirl_orbit_find(system, start, revolutions, options, orbit);
    free(start);
    return status;
}

whirl_status settled_orbit(const whirl_study *study, const whirl_batch *batch, double value, whirl_orbit **orbit) {
    const whirl_branch_options options = settled_options(batch, 1);
    whirl_machine machine;
    *orbit = NULL;
    whirl_status status = study->machine(study->family, batch, value, &machine);
    if (status.code != WHIRL_OK) return status;
    // Find the first orbit as the options ask.
    const whirl_trace_options *trace = &batch->record.trace;
    const bool settles = !trace->rest && strcmp(trace->begin, "settled") == 0;
    if (trace->rest)
        status = whirl_orbit_rest(machine.system, machine.start, &options.orbit, orbit);
    else if (settles)
        status = settled_from_motion(&machine, batch, &options.orbit, orbit);
    else
        status = settled_from_start(&machine, batch, &options.orbit, orbit);
    if (machine.release) machine.release(machine.owner);
    // Explain what can be tried instead.
    if (status.code != WHIRL_BAD_INPUT) return status;
    if (settles)
        return whirl_fail(
            status.code,
            "no branch begins at %s = %.10g: %.200s; begin: linear, or begin: start with an initial state "
            "near it, looks for an unstable orbit",
            batch->parameter, value, status.message);
    return whirl_fail(status.code, "no branch begins at %s = %.10g: %.300s", batch->parameter, value, status.message);
}
