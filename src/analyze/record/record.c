// Records one motion, or all motions of a source, to the end.
#include "whirl/engine/analyze.h"

/// Records to the end, or until the monitor requests a stop; the monitor is called after every revolution of every
/// motion.
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
