// Records one motion to its end.
#include "whirl/engine/analyze.h"

/// Carries the motion of a recorder to its end, or until the monitor, which is called after every revolution, requests
/// a stop.
static whirl_status record_to_end(whirl_recorder *recorder, const whirl_monitor *monitor, whirl_record **out) {
    whirl_task task;
    size_t turned = 1;
    whirl_status status = whirl_ok();
    while (status.code == WHIRL_OK && turned > 0) {
        status = whirl_recorder_begin(recorder);
        if (status.code == WHIRL_OK) status = whirl_recorder_revolve(recorder, &turned);
        if (status.code == WHIRL_OK) (void)whirl_recorder_take(recorder, &task, out);
        if (status.code == WHIRL_OK && turned > 0 && monitor && !monitor->revolution_done(monitor->context))
            status = whirl_fail(WHIRL_STOPPED, "stopped");
    }
    return status;
}

whirl_status whirl_record_motion(const whirl_system *system, const whirl_integrate_options *integrate,
                                 const whirl_record_options *options, const double *start, const whirl_monitor *monitor,
                                 whirl_record **out) {
    const whirl_task task = {system, start, NULL};
    whirl_recorder *recorder;
    *out = NULL;
    whirl_status status = whirl_recorder_new(system, integrate, options, 2, &recorder);
    if (status.code == WHIRL_OK) status = whirl_recorder_add(recorder, &task, NULL, 0);
    if (status.code == WHIRL_OK) status = record_to_end(recorder, monitor, out);
    whirl_recorder_free(recorder);
    if (status.code != WHIRL_OK) {
        whirl_record_free(*out);
        *out = NULL;
    }
    return status;
}
