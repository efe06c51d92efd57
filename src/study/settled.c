#include "settled.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

whirl_branch_options settled_options(const whirl_batch *batch, size_t most_points) {
    const whirl_trace_options *trace = &batch->record.trace;
    whirl_branch_options options = whirl_branch_default(batch->bounds[0], batch->bounds[1]);
    whirl_integrate_options *integrate = &options.orbit.integrate;
    if (strcmp(batch->integrate.method, "rodas5p") == 0) strcpy(integrate->method, "rodas5p");
    integrate->atol *= trace->rtol / integrate->rtol;
    integrate->rtol = trace->rtol;
    options.orbit.segments = trace->segments;
    options.orbit.tolerance = fmax(options.orbit.tolerance, 10.0 * trace->rtol);
    options.most_step = trace->step;
    options.step = fmin(options.step, trace->step);
    options.least_step = fmin(options.least_step, options.step);
    options.most_points = most_points;
    return options;
}

// ---------------------------------------------------------------- the section of a motion

/// The last states of a motion, once a revolution.
typedef struct section {
    size_t count, dimension;
    const double *turns; ///< of the system: what turns on and on does not come back
    double *states;      ///< [count][dimension]
} section;

static whirl_status follow(const whirl_machine *machine, const whirl_batch *batch, section *z) {
    const size_t d = z->dimension;
    const size_t passed = (size_t)batch->record.transient;
    whirl_integrator *integrator = NULL;
    whirl_status status = whirl_integrator_new(machine->system, &batch->integrate, &integrator);
    double *x = z->states + (z->count - 1) * d;
    if (status.code == WHIRL_OK) memcpy(x, machine->start, d * sizeof *x);
    for (size_t n = 0; n < passed + z->count && status.code == WHIRL_OK; n++) {
        if (whirl_integrator_revolve(integrator, x, NULL, NULL) != WHIRL_BOUNDED)
            status = whirl_fail(WHIRL_BAD_INPUT, "the motion leaves its bounds after %zu revolutions", n);
        if (n >= passed) memcpy(z->states + (n - passed) * d, x, d * sizeof *x);
    }
    whirl_integrator_free(integrator);
    return status;
}

/// By how much states so many revolutions apart differ, at most.
static double return_distance(const section *z, size_t apart) {
    double largest = 0.0;
    for (size_t n = 0; n + apart < z->count; n++)
        for (size_t i = 0; i < z->dimension; i++)
            if (!z->turns || z->turns[i] == 0.0)
                largest =
                    fmax(largest, fabs(z->states[(n + apart) * z->dimension + i] - z->states[n * z->dimension + i]));
    return largest;
}

/// Revolutions after which the motion comes back, to a thousandth of its size; 1 where it does not within `longest`.
static size_t period_of(const section *z, size_t longest) {
    double size = 0.0;
    for (size_t i = 0; i < z->count * z->dimension; i++)
        if (!z->turns || z->turns[i % z->dimension] == 0.0) size = fmax(size, fabs(z->states[i]));
    for (size_t k = 1; k <= longest && 2 * k < z->count; k++)
        if (return_distance(z, k) <= 1e-3 * size) return k;
    return 1;
}

static void average(const section *z, double *mean) {
    memset(mean, 0, z->dimension * sizeof *mean);
    for (size_t n = 0; n < z->count; n++)
        for (size_t i = 0; i < z->dimension; i++) mean[i] += z->states[n * z->dimension + i] / (double)z->count;
}

/// From the motion's last state; and where it does not settle on a periodic orbit, from the mean of its section, in the
/// middle of which the orbit lies that it left.
static whirl_status find_orbit(const whirl_machine *machine, const whirl_batch *batch, section *z,
                               const whirl_orbit_options *options, whirl_orbit **orbit) {
    const whirl_trace_options *trace = &batch->record.trace;
    const size_t k = trace->revolutions > 0 ? (size_t)trace->revolutions : period_of(z, (size_t)trace->longest);
    whirl_status status =
        whirl_orbit_find(machine->system, z->states + (z->count - 1) * z->dimension, k, options, orbit);
    if (status.code != WHIRL_BAD_INPUT || k > 1) return status;
    average(z, z->states);
    return whirl_orbit_find(machine->system, z->states, 1, options, orbit);
}

static whirl_status settle(const whirl_machine *machine, const whirl_batch *batch, const whirl_orbit_options *options,
                           whirl_orbit **orbit) {
    enum { LEAST = 16 };
    const size_t record = (size_t)batch->record.record;
    section z = {.count = record > LEAST ? record : LEAST,
                 .dimension = machine->system->dimension,
                 .turns = machine->system->turns};
    z.states = calloc(z.count * z.dimension + 1, sizeof *z.states);
    if (!z.states) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the section of a motion");
    whirl_status status = follow(machine, batch, &z);
    if (status.code == WHIRL_OK) status = find_orbit(machine, batch, &z, options, orbit);
    free(z.states);
    return status;
}

whirl_status settled_orbit(const whirl_study *study, const whirl_batch *batch, double value, whirl_orbit **orbit) {
    const whirl_branch_options options = settled_options(batch, 1);
    whirl_machine machine;
    *orbit = NULL;
    whirl_status status = study->machine(study->family, batch, value, &machine);
    if (status.code != WHIRL_OK) return status;
    status = batch->record.trace.rest ? whirl_orbit_rest(machine.system, machine.start, &options.orbit, orbit)
                                      : settle(&machine, batch, &options.orbit, orbit);
    if (machine.release) machine.release(machine.owner);
    if (status.code != WHIRL_BAD_INPUT) return status;
    return whirl_fail(status.code, "no branch begins at %s = %.10g: %.300s", batch->parameter, value, status.message);
}
