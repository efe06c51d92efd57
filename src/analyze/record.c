// Recording a motion: what is gathered while the integrator runs.
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "twin.h"
#include "watcher.h"
#include "whirl/analyze.h"

whirl_record_options whirl_record_default(void) {
    return (whirl_record_options){.transient = 1100,
                                  .record = 100,
                                  .samples_per_revolution = 64,
                                  .highest_order = 5.0,
                                  .waveform = true,
                                  .growth = true};
}

int whirl_record_watch(const whirl_record_options *options) {
    return options->watch > 0 ? options->watch : options->record + options->transient / 2;
}

int whirl_record_samples(const whirl_record_options *options, int steps_per_revolution) {
    int samples =
        options->samples_per_revolution < steps_per_revolution ? options->samples_per_revolution : steps_per_revolution;
    while (steps_per_revolution % samples != 0) samples++;
    return samples;
}

static whirl_status check(const whirl_record_options *options) {
    if (options->transient < 0 || options->record < 1 || options->transient > INT_MAX - options->record)
        return whirl_fail(WHIRL_BAD_INPUT, "transient is %d and record %d revolutions, expected at least 0 and 1",
                          options->transient, options->record);
    const int watch = whirl_record_watch(options);
    if (watch < options->record || watch > options->transient + options->record)
        return whirl_fail(WHIRL_BAD_INPUT, "watch is %d revolutions, expected record (%d) to transient + record (%d)",
                          watch, options->record, options->transient + options->record);
    if (options->waveform_revolutions < 0 || options->waveform_revolutions > options->record)
        return whirl_fail(WHIRL_BAD_INPUT, "waveform is %d revolutions, expected 0 to record (%d)",
                          options->waveform_revolutions, options->record);
    if (options->samples_per_revolution < 1)
        return whirl_fail(WHIRL_BAD_INPUT, "samples_per_revolution is %d, expected at least 1",
                          options->samples_per_revolution);
    return whirl_ok();
}

/// Numbers of every part of a record; the order of the parts is fixed in `lay_out`.
typedef struct sizes {
    size_t section, growth, waveform, dimension, probes, contacts;
} sizes;

static sizes measure(const whirl_system *system, const whirl_integrate_options *integrate,
                     const whirl_record_options *options) {
    const size_t watch = (size_t)whirl_record_watch(options);
    const size_t samples = (size_t)whirl_record_samples(options, integrate->steps_per_revolution);
    return (sizes){.section = watch * system->dimension,
                   .growth = options->growth ? watch : 0,
                   .waveform = options->waveform ? 2 * system->probe_count * (size_t)options->record * samples : 0,
                   .dimension = system->dimension,
                   .probes = system->probe_count,
                   .contacts = system->contact_count};
}

static double *cut(double **block, size_t count) {
    double *part = *block;
    *block += count;
    return part;
}

static void lay_out(whirl_record *record, double *block, const sizes *size) {
    record->section = cut(&block, size->section);
    record->growth = cut(&block, size->growth);
    record->waveform = cut(&block, size->waveform);
    record->low = cut(&block, size->dimension);
    record->high = cut(&block, size->dimension);
    record->end = cut(&block, size->dimension);
    record->max_radius = cut(&block, size->probes);
    record->min_radius = cut(&block, size->probes);
    record->mean = cut(&block, 2 * size->probes);
    record->backward = cut(&block, size->probes);
    record->contact_share = cut(&block, size->contacts);
    record->contact_number = cut(&block, size->contacts);
    record->contact_force = cut(&block, size->contacts);
}

static whirl_record *allocate(const whirl_system *system, const whirl_integrate_options *integrate,
                              const whirl_record_options *options) {
    const sizes size = measure(system, integrate, options);
    const size_t numbers =
        size.section + size.growth + size.waveform + 3 * size.dimension + 5 * size.probes + 3 * size.contacts;
    whirl_record *record = calloc(1, sizeof *record + numbers * sizeof(double));
    if (!record) return NULL;
    lay_out(record, (double *)(record + 1), &size);
    record->dimension = system->dimension;
    record->probe_count = system->probe_count;
    record->contact_count = system->contact_count;
    record->probes = system->probes;
    record->period = system->period;
    record->record_count = (size_t)options->record;
    if (options->waveform)
        record->samples_per_revolution = (size_t)whirl_record_samples(options, integrate->steps_per_revolution);
    return record;
}

void whirl_record_free(whirl_record *record) {
    free(record);
}

typedef struct recording {
    const whirl_record_options *options;
    const whirl_monitor *monitor;
    whirl_integrator *integrator;
    whirl_record *record;
    instant_watcher watcher;
    trajectory_twin twin;
    double *x;
} recording;

/// One revolution of the motion, and of its twin while that is followed.
static void revolve(recording *r, int revolution) {
    const whirl_record_options *options = r->options;
    whirl_record *record = r->record;
    const int last = options->transient + options->record;
    const bool watched = revolution >= last - whirl_record_watch(options);
    const bool recorded = revolution >= options->transient;
    const bool followed = watched && r->twin.x;
    if (followed && record->section_count == 0) twin_begin(&r->twin, r->x);
    if (revolution == options->transient) watch_note_contacts(&r->watcher, r->x);
    record->motion = whirl_integrator_revolve(r->integrator, r->x, recorded ? watch_instant : NULL, &r->watcher);
    if (record->motion != WHIRL_BOUNDED) {
        record->diverged_at = revolution + 1;
        return;
    }
    if (followed) {
        const bool bounded = whirl_integrator_revolve(r->integrator, r->twin.x, NULL, NULL) == WHIRL_BOUNDED;
        record->growth[record->growth_count++] = twin_growth(&r->twin, r->x, bounded);
    }
    if (watched)
        memcpy(record->section + record->section_count++ * record->dimension, r->x, record->dimension * sizeof *r->x);
}

static whirl_status run(recording *r) {
    const int last = r->options->transient + r->options->record;
    for (int revolution = 0; revolution < last; revolution++) {
        revolve(r, revolution);
        if (r->record->motion != WHIRL_BOUNDED) return whirl_ok();
        if (r->monitor && !r->monitor->revolution_done(r->monitor->context))
            return whirl_fail(WHIRL_STOPPED, "stopped after revolution %d of %d", revolution + 1, last);
    }
    watch_close(&r->watcher);
    memcpy(r->record->end, r->x, r->record->dimension * sizeof *r->x);
    return whirl_ok();
}

whirl_status whirl_record_motion(const whirl_system *system, const whirl_integrate_options *integrate,
                                 const whirl_record_options *options, const double *start, const whirl_monitor *monitor,
                                 whirl_record **out) {
    *out = NULL;
    whirl_status status = check(options);
    if (status.code != WHIRL_OK) return status;
    recording r = {.options = options, .monitor = monitor};
    status = whirl_integrator_new(system, integrate, &r.integrator);
    if (status.code != WHIRL_OK) return status;
    r.x = malloc(2 * system->dimension * sizeof *r.x);
    r.record = allocate(system, integrate, options);
    if (r.x && r.record) {
        memcpy(r.x, start, system->dimension * sizeof *r.x);
        r.twin =
            (trajectory_twin){.dimension = system->dimension, .x = options->growth ? r.x + system->dimension : NULL};
        watch_open(&r.watcher, system, integrate, r.record);
        status = run(&r);
    } else {
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory to record %d revolutions", options->record);
    }
    whirl_integrator_free(r.integrator);
    free(r.x);
    if (status.code == WHIRL_OK)
        *out = r.record;
    else
        whirl_record_free(r.record);
    return status;
}
