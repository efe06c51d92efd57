// Recording a motion alone: what is gathered while the integrator runs.
#include <stdlib.h>
#include <string.h>

#include "record_block.h"
#include "record_lanes.h"
#include "settling.h"
#include "twin.h"
#include "watcher.h"
#include "whirl/ensemble.h"

typedef struct recording {
    const whirl_record_options *options;
    const whirl_monitor *monitor;
    whirl_integrator *integrator;
    whirl_record *record;
    instant_watcher watcher;
    trajectory_twin twin;
    settling *settling; ///< NULL when every transient runs to its end
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
        r->record->revolutions += 1.0;
        if (r->record->motion != WHIRL_BOUNDED) return whirl_ok();
        if (r->monitor && !r->monitor->revolution_done(r->monitor->context))
            return whirl_fail(WHIRL_STOPPED, "stopped after revolution %d of %d", revolution + 1, last);
        if (r->settling && settling_note(r->settling, r->x)) revolution = record_skip(r->options, revolution + 1) - 1;
    }
    watch_close(&r->watcher);
    memcpy(r->record->end, r->x, r->record->dimension * sizeof *r->x);
    return whirl_ok();
}

/// By the integrator's interface, which takes every system and method.
static whirl_status record_alone(const whirl_system *system, const whirl_integrate_options *integrate,
                                 const whirl_record_options *options, const double *start, const whirl_monitor *monitor,
                                 whirl_record **out) {
    recording r = {.options = options, .monitor = monitor};
    whirl_status status = whirl_integrator_new(system, integrate, &r.integrator);
    if (status.code != WHIRL_OK) return status;
    r.x = malloc(2 * system->dimension * sizeof *r.x);
    r.record = record_new(system, integrate, options);
    if (options->settle) r.settling = settling_new(system->dimension);
    if (r.x && r.record && (r.settling || !options->settle)) {
        memcpy(r.x, start, system->dimension * sizeof *r.x);
        r.twin =
            (trajectory_twin){.dimension = system->dimension, .x = options->growth ? r.x + system->dimension : NULL};
        watch_open(&r.watcher, system, integrate, r.record);
        status = run(&r);
    } else {
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory to record %d revolutions", options->record);
    }
    whirl_integrator_free(r.integrator);
    settling_free(r.settling);
    free(r.x);
    if (status.code == WHIRL_OK)
        *out = r.record;
    else
        whirl_record_free(r.record);
    return status;
}

/// A source of one motion, whose record is kept.
typedef struct single_task {
    whirl_task task;
    bool taken;
    whirl_record **out;
} single_task;

static bool single_next(void *context, whirl_task *task) {
    single_task *single = context;
    if (single->taken) return false;
    single->taken = true;
    *task = single->task;
    return true;
}

static whirl_status single_done(void *context, const whirl_task *task, whirl_record *record) {
    (void)task;
    *((single_task *)context)->out = record;
    return whirl_ok();
}

static void single_abandon(void *context, const whirl_task *task) {
    (void)context, (void)task;
}

whirl_status whirl_record_motion(const whirl_system *system, const whirl_integrate_options *integrate,
                                 const whirl_record_options *options, const double *start, const whirl_monitor *monitor,
                                 whirl_record **out) {
    *out = NULL;
    const whirl_status status = record_check(options);
    if (status.code != WHIRL_OK) return status;
    if (!whirl_ensemble_takes(system, integrate)) return record_alone(system, integrate, options, start, monitor, out);
    single_task single = {.task = {system, start, NULL}, .out = out};
    const whirl_task_source source = {single_next, single_done, single_abandon, &single};
    return record_in_lanes(system, integrate, options, &source, 2, monitor);
}

static whirl_status record_in_turn(const whirl_integrate_options *integrate, const whirl_record_options *options,
                                   const whirl_task_source *source, const whirl_monitor *monitor) {
    whirl_task task;
    while (source->next(source->context, &task)) {
        whirl_record *record = NULL;
        whirl_status status = record_alone(task.system, integrate, options, task.start, monitor, &record);
        if (status.code == WHIRL_OK)
            status = source->done(source->context, &task, record);
        else
            source->abandon(source->context, &task);
        if (status.code != WHIRL_OK) return status;
    }
    return whirl_ok();
}

whirl_status whirl_record_motions(const whirl_system *system, const whirl_integrate_options *integrate,
                                  const whirl_record_options *options, const whirl_task_source *source,
                                  const whirl_monitor *monitor) {
    const whirl_status status = record_check(options);
    if (status.code != WHIRL_OK) return status;
    if (whirl_ensemble_takes(system, integrate)) return record_in_lanes(system, integrate, options, source, 0, monitor);
    return record_in_turn(integrate, options, source, monitor);
}
