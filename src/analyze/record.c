// Recording a motion alone: what is gathered while the integrator runs.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "observer.h"
#include "record_block.h"
#include "record_lanes.h"
#include "settling.h"
#include "steps.h"
#include "twin.h"
#include "whirl/ensemble.h"

/// A motion that is recorded by the integrator's interface, which takes every system and method.
typedef struct recording {
    whirl_task task;
    const whirl_record_options *options;
    whirl_integrator *integrator;
    whirl_record *record;
    observer observer; ///< of the record
    trajectory_twin twin;
    size_t followed;      ///< disturbances that go along by the system's Jacobian: none, one or as many as there are
                          ///< coordinates
    double *disturbances; ///< [followed][dimension]
    settling *settling;   ///< NULL when every transient runs to its end
    int revolution;       ///< the next one
    double *x;
} recording;

/// How many disturbances go along: a second trajectory shows the largest growth, but by methods whose steps change
/// abruptly, or of systems with kinks.
static size_t count_followed(const whirl_system *system, const whirl_integrate_options *integrate,
                             const whirl_record_options *options) {
    const whirl_method *own;
    if (options->growth == WHIRL_GROWTH_ALL) return system->dimension;
    if (options->growth == WHIRL_GROWTH_NONE || !system->tangent) return 0;
    if (whirl_method_find(integrate->method, &own).code != WHIRL_OK) return 0;
    return own->follows_one || (system->kinked && own->follows) ? 1 : 0;
}

/// One revolution of the motion with its disturbances.
static whirl_motion carry_disturbances(recording *r, whirl_observe_fn observe) {
    whirl_record *record = r->record;
    const size_t count = record->growth_count;
    if (count == 0) record_place_disturbances(record, r->followed, r->disturbances);
    whirl_disturbances set = {.count = r->followed, .vectors = r->disturbances, .growth = &record->growth[count]};
    if (record->growths) set.growth = record->growths + count * record->dimension;
    const whirl_motion motion = whirl_integrator_carry(r->integrator, r->x, &set, observe, &r->observer);
    record->growth[count] = set.growth[0];
    if (record->growths) record->volume[count] = set.volume;
    record->growth_count = count + 1;
    return motion;
}

/// One revolution of the motion, and of its twin or its disturbances while they are followed.
static void revolve(recording *r) {
    const int revolution = r->revolution++;
    const whirl_record_options *options = r->options;
    whirl_record *record = r->record;
    const int last = options->transient + options->record;
    const bool watched = revolution >= last - whirl_record_watch(options);
    const bool recorded = revolution >= options->transient;
    const bool followed = watched && r->twin.x;
    if (followed && record->section_count == 0) twin_begin(&r->twin, r->x);
    memcpy(record->end, r->x, record->dimension * sizeof *r->x);
    if (revolution == options->transient) observer_note_contacts(&r->observer, r->x);
    const whirl_observe_fn observe = recorded ? observer_instant : NULL;
    record->motion = watched && r->disturbances ? carry_disturbances(r, observe)
                                                : whirl_integrator_revolve(r->integrator, r->x, observe, &r->observer);
    if (record->motion != WHIRL_BOUNDED) {
        record->diverged_at = r->revolution;
        return;
    }
    if (followed) {
        const bool bounded = whirl_integrator_revolve(r->integrator, r->twin.x, NULL, NULL) == WHIRL_BOUNDED;
        record->growth[record->growth_count++] = twin_growth(&r->twin, r->x, bounded);
    }
    if (watched)
        memcpy(record->section + record->section_count++ * record->dimension, r->x, record->dimension * sizeof *r->x);
}

/// Revolves once; true when the motion is over.
static bool carry_on(recording *r) {
    revolve(r);
    r->record->revolutions += 1.0;
    if (r->record->motion != WHIRL_BOUNDED) return true;
    if (r->settling && settling_note(r->settling, r->x)) r->revolution = record_skip(r->options, r->revolution);
    if (r->revolution < r->options->transient + r->options->record) return false;
    observer_close(&r->observer);
    memcpy(r->record->end, r->x, r->record->dimension * sizeof *r->x);
    return true;
}

static void recording_free(recording *r) {
    if (!r) return;
    whirl_integrator_free(r->integrator);
    settling_free(r->settling);
    whirl_record_free(r->record);
    free(r->disturbances);
    free(r->x);
    free(r);
}

static whirl_status recording_new(const whirl_task *task, const whirl_integrate_options *integrate,
                                  const whirl_record_options *options, recording **out) {
    const whirl_system *system = task->system;
    recording *r = calloc(1, sizeof *r);
    *out = NULL;
    if (!r) return whirl_fail(WHIRL_NO_MEMORY, "no memory to record %d revolutions", options->record);
    r->task = *task;
    r->options = options;
    const size_t n = system->dimension;
    const bool along = (r->followed = count_followed(system, integrate, options)) > 0;
    whirl_status status = whirl_integrator_new(system, integrate, &r->integrator);
    if (status.code == WHIRL_OK && along) status = whirl_integrator_follow(r->integrator, r->followed);
    if (status.code == WHIRL_OK) {
        if (along) r->disturbances = calloc(r->followed * n, sizeof *r->disturbances);
        r->x = calloc(2 * n, sizeof *r->x);
        r->record = record_new(system, integrate, options);
        if (options->settle) r->settling = settling_new(system->dimension, system->turns);
        if (!r->x || !r->record || (options->settle && !r->settling) || (along && !r->disturbances))
            status = whirl_fail(WHIRL_NO_MEMORY, "no memory to record %d revolutions", options->record);
    }
    if (status.code != WHIRL_OK) {
        recording_free(r);
        return status;
    }
    memcpy(r->x, task->start, system->dimension * sizeof *r->x);
    r->twin = twin_of(integrate, n, system->turns, options->growth == WHIRL_GROWTH_LARGEST && !along ? r->x + n : NULL);
    observer_open(&r->observer, system, integrate, r->record);
    *out = r;
    return whirl_ok();
}

/// All that the motion is between two revolutions: integrators remember nothing.
static void recording_archive(recording *r, const whirl_integrate_options *integrate, archive *a) {
    observer *o = &r->observer;
    record_archive(r->record, integrate, r->options, a);
    archive_part(a, &r->revolution, sizeof r->revolution);
    archive_part(a, &r->twin.distance, sizeof r->twin.distance);
    const size_t n = r->record->dimension;
    archive_part(a, r->x, 2 * n * sizeof *r->x);
    if (r->disturbances) archive_part(a, r->disturbances, r->followed * n * sizeof *r->disturbances);
    archive_part(a, &o->instants, sizeof o->instants);
    archive_part(a, o->touching, sizeof o->touching);
    if (r->settling) settling_archive(r->settling, a);
}

// ---------------------------------------------------------------- recorders

struct whirl_recorder {
    const whirl_integrate_options *integrate;
    const whirl_record_options *options;
    const whirl_task_source *source;
    lanes_recorder *lanes; ///< NULL: motions are recorded one after the other, namely
    recording *alone;      ///< the one under way, or NULL
};

/// Whether motions and what is followed of them have lanes: there a twin shows the largest growth.
static bool go_in_lanes(const whirl_system *system, const whirl_integrate_options *integrate,
                        const whirl_record_options *options) {
    if (!whirl_ensemble_takes(system, integrate)) return false;
    if (options->growth == WHIRL_GROWTH_ALL) return whirl_variational_takes(system, integrate);
    return options->growth == WHIRL_GROWTH_NONE || !system->kinked || !whirl_method_is_adaptive(integrate->method);
}

whirl_status whirl_recorder_new(const whirl_system *system, const whirl_integrate_options *integrate,
                                const whirl_record_options *options, const whirl_task_source *source, size_t lanes,
                                whirl_recorder **out) {
    *out = NULL;
    whirl_status status = whirl_record_check(system, integrate, options);
    if (status.code != WHIRL_OK) return status;
    whirl_recorder *made = calloc(1, sizeof *made);
    if (!made) return whirl_fail(WHIRL_NO_MEMORY, "no memory to record motions");
    *made = (whirl_recorder){.integrate = integrate, .options = options, .source = source};
    if (go_in_lanes(system, integrate, options))
        status = lanes_recorder_new(system, integrate, options, source, lanes, &made->lanes);
    if (status.code == WHIRL_OK)
        *out = made;
    else
        free(made);
    return status;
}

void whirl_recorder_free(whirl_recorder *recorder) {
    if (!recorder) return;
    lanes_recorder_free(recorder->lanes);
    if (recorder->alone) recorder->source->abandon(recorder->source->context, &recorder->alone->task);
    recording_free(recorder->alone);
    free(recorder);
}

/// Takes the motion up where it was saved; where that does not fit, it begins anew.
static whirl_status take_up_alone(whirl_recorder *recorder, const whirl_task *task) {
    const whirl_task_source *source = recorder->source;
    size_t size = 0;
    void *bytes = source->saver ? source->saver->saved(source->context, task, &size) : NULL;
    archive a = {ARCHIVE_READ, bytes, size, 0, true};
    if (!bytes) return whirl_ok();
    recording_archive(recorder->alone, recorder->integrate, &a);
    free(bytes);
    if (a.sound && a.at == a.size) return whirl_ok();
    recording_free(recorder->alone);
    return recording_new(task, recorder->integrate, recorder->options, &recorder->alone);
}

static void save_alone(const whirl_recorder *recorder) {
    const whirl_task_source *source = recorder->source;
    recording *r = recorder->alone;
    if (!source->saver || !source->saver->wanted(source->context)) return;
    archive a = {.way = ARCHIVE_MEASURE};
    recording_archive(r, recorder->integrate, &a);
    a = (archive){ARCHIVE_WRITE, malloc(a.at), a.at, 0, true};
    if (!a.bytes) return;
    recording_archive(r, recorder->integrate, &a);
    source->saver->save(source->context, &(whirl_motion_state){&r->task, r->record->revolutions, a.bytes, a.size}, 1);
    free(a.bytes);
}

/// The next motion, if there is one.
static whirl_status begin_alone(whirl_recorder *recorder) {
    const whirl_task_source *source = recorder->source;
    whirl_task task;
    if (recorder->alone || !source->next(source->context, &task)) return whirl_ok();
    whirl_status status = recording_new(&task, recorder->integrate, recorder->options, &recorder->alone);
    if (status.code == WHIRL_OK) status = take_up_alone(recorder, &task);
    if (status.code != WHIRL_OK) source->abandon(source->context, &task);
    return status;
}

static whirl_status revolve_alone(whirl_recorder *recorder, size_t *turned) {
    const whirl_status status = begin_alone(recorder);
    recording *r = recorder->alone;
    *turned = r ? 1 : 0;
    if (status.code != WHIRL_OK || !r) return status;
    if (!carry_on(r)) {
        save_alone(recorder);
        return status;
    }
    const whirl_status looked = steps_look(r->task.system, recorder->integrate, r->record);
    if (looked.code != WHIRL_OK) return looked;
    record_close_turns(r->record);
    const whirl_task task = r->task;
    whirl_record *record = r->record;
    r->record = NULL;
    recorder->alone = NULL;
    recording_free(r);
    return recorder->source->done(recorder->source->context, &task, record);
}

whirl_status whirl_recorder_revolve(whirl_recorder *recorder, size_t *turned) {
    return recorder->lanes ? lanes_recorder_revolve(recorder->lanes, turned) : revolve_alone(recorder, turned);
}

/// To the end, or until the monitor asks for a stop; it is told of every revolution of every motion.
static whirl_status record_all(const whirl_system *system, const whirl_integrate_options *integrate,
                               const whirl_record_options *options, const whirl_task_source *source, size_t lanes,
                               const whirl_monitor *monitor) {
    whirl_recorder *recorder;
    size_t turned = 1;
    whirl_status status = whirl_recorder_new(system, integrate, options, source, lanes, &recorder);
    while (status.code == WHIRL_OK && turned > 0) {
        status = whirl_recorder_revolve(recorder, &turned);
        for (size_t i = 0; i < turned && status.code == WHIRL_OK && monitor; i++)
            if (!monitor->revolution_done(monitor->context)) status = whirl_fail(WHIRL_STOPPED, "stopped");
    }
    whirl_recorder_free(recorder);
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
    single_task single = {.task = {system, start, NULL}, .out = out};
    const whirl_task_source source = {single_next, single_done, single_abandon, &single, NULL};
    *out = NULL;
    const whirl_status status = record_all(system, integrate, options, &source, 2, monitor);
    if (status.code != WHIRL_OK) {
        whirl_record_free(*out);
        *out = NULL;
    }
    return status;
}

whirl_status whirl_record_motions(const whirl_system *system, const whirl_integrate_options *integrate,
                                  const whirl_record_options *options, const whirl_task_source *source,
                                  const whirl_monitor *monitor) {
    return record_all(system, integrate, options, source, 0, monitor);
}
