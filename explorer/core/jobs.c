// Computes points, one revolution of all running points at a time.
#include "core.h"
#include "looks.h"
#include "whirl/engine/ensemble.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// Result of a point.
typedef struct finished_point {
    bool done, taken;
    double *numbers; ///< [block size + dimension]
} finished_point;

struct job {
    const plan *plan;
    whirl_recorder *recorder;
    bool carried;
    size_t count, begun, oldest; ///< points; points begun; the first one that may not have been taken
    double *values;              ///< [count]
    whirl_machine first;         ///< machine with the structure of the recorder's machines
    bool unlike;                 ///< true if the next machine has another structure and needs a new recorder
    whirl_machine *machines;     ///< [count] machines of running points
    finished_point *points;      ///< [count]
    double *start;               ///< [dimension] instead of the machines' starts, or NULL
    bool waiting;                ///< a carried point is running
};

static void job_release(job *j, size_t index) {
    whirl_machine *machine = &j->machines[index];
    if (machine->release) machine->release(machine->owner);
    *machine = (whirl_machine){0};
}

/// Builds the machine of the next point, unless it exists already.
static whirl_status build_next(job *j) {
    const plan *p = j->plan;
    whirl_machine *machine = &j->machines[j->begun];
    if (j->unlike) return whirl_ok();
    const whirl_status status = p->study.machine(p->study.family, &p->batch, j->values[j->begun], machine);
    return status.code == WHIRL_OK ? whirl_ensemble_check(j->first.system, machine->system) : status;
}

/// Gives the next point to the recorder; returns false if no point can begin now.
static bool next_point(job *j, whirl_status *status) {
    if (j->begun == j->count || j->waiting) return false;
    whirl_machine *machine = &j->machines[j->begun];
    *status = build_next(j);
    if (status->code != WHIRL_OK) {
        job_release(j, j->begun);
        return false;
    }
    j->unlike = !whirl_ensemble_alike(j->first.system, machine->system);
    if (j->unlike) return false;
    const whirl_task task = {machine->system, j->start ? j->start : machine->start, &j->points[j->begun]};
    j->begun++;
    j->waiting = j->carried;
    *status = whirl_recorder_add(j->recorder, &task, NULL, 0);
    return status->code == WHIRL_OK;
}

/// Makes the end of a carried point the start of the next; after a divergence the next point has the case's start.
static whirl_status carry(job *j, const whirl_record *record) {
    const size_t bytes = j->plan->dimension * sizeof *j->start;
    j->waiting = false;
    if (!j->carried) return whirl_ok();
    if (record->motion != WHIRL_BOUNDED) {
        free(j->start);
        j->start = NULL;
        return whirl_ok();
    }
    if (!j->start) j->start = malloc(bytes + 1);
    if (!j->start) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a state");
    memcpy(j->start, record->end, bytes);
    return whirl_ok();
}

/// Analyzes the record of a finished point, and frees it.
static whirl_status finish_point(job *j, finished_point *point, whirl_record *record) {
    const plan *p = j->plan;
    point->numbers = malloc((p->layout.size + p->dimension + 1) * sizeof *point->numbers);
    whirl_status status = point->numbers
                              ? whirl_analyze(record, &p->batch.record, p->batch.analyses, &p->layout, point->numbers)
                              : whirl_fail(WHIRL_NO_MEMORY, "no memory for the numbers of a point");
    for (size_t i = 0; status.code == WHIRL_OK && i < p->dimension; i++)
        point->numbers[p->layout.size + i] = record->motion == WHIRL_BOUNDED ? record->end[i] : NAN;
    if (status.code == WHIRL_OK) status = carry(j, record);
    point->done = status.code == WHIRL_OK;
    whirl_record_free(record);
    job_release(j, (size_t)(point - j->points));
    return status;
}

/// Starts a recorder for machines with the structure of the machine at a value.
static whirl_status turn_to_structure(job *j, double value) {
    const plan *p = j->plan;
    whirl_recorder_free(j->recorder);
    j->recorder = NULL;
    if (j->first.release) j->first.release(j->first.owner);
    j->first = (whirl_machine){0};
    const whirl_status status = p->study.machine(p->study.family, &p->batch, value, &j->first);
    if (status.code != WHIRL_OK) return status;
    // A motion and its perturbed copy take two lanes.
    const size_t lanes = j->carried || j->count == 1 ? 2 : 0;
    return whirl_recorder_new(j->first.system, &p->batch.integrate, &p->batch.record, lanes, &j->recorder);
}

static whirl_status start_job(job *j, const double *values, const double *start) {
    const plan *p = j->plan;
    const size_t bytes = p->dimension * sizeof *j->start;
    j->values = calloc(j->count, sizeof *j->values);
    j->machines = calloc(j->count, sizeof *j->machines);
    j->points = calloc(j->count, sizeof *j->points);
    if (start) j->start = malloc(bytes + 1);
    if (!j->values || !j->machines || !j->points || (start && !j->start))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", j->count);
    memcpy(j->values, values, j->count * sizeof *values);
    if (start) memcpy(j->start, start, bytes);
    return turn_to_structure(j, values[0]);
}

EXPORTED job *explorer_job_new(const plan *p, const double *values, size_t count, int carried, const double *start) {
    job *j = calloc(1, sizeof *j);
    whirl_status status = whirl_ok();
    if (j) {
        *j = (job){.plan = p, .carried = carried != 0, .count = count};
        status = start_job(j, values, start);
    } else {
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", count);
    }
    if (explorer_good(&status)) return j;
    explorer_job_free(j);
    return NULL;
}

EXPORTED void explorer_job_free(job *j) {
    if (!j) return;
    whirl_recorder_free(j->recorder);
    if (j->first.release) j->first.release(j->first.owner);
    for (size_t i = 0; j->machines && i < j->count; i++) job_release(j, i);
    for (size_t i = 0; j->points && i < j->count; i++) free(j->points[i].numbers);
    free(j->points);
    free(j->machines);
    free(j->values);
    free(j->start);
    free(j);
}

/// Advances running points, and new ones, by one revolution.
static whirl_status jobs_revolve(job *j, size_t *turned) {
    whirl_task task;
    whirl_record *record;
    whirl_status status = whirl_recorder_begin(j->recorder);
    while (status.code == WHIRL_OK && whirl_recorder_has_room(j->recorder) && next_point(j, &status)) {
    }
    if (status.code == WHIRL_OK) status = whirl_recorder_revolve(j->recorder, turned);
    while (status.code == WHIRL_OK && whirl_recorder_take(j->recorder, &task, &record))
        status = finish_point(j, task.tag, record);
    return status;
}

EXPORTED double explorer_job_turn(job *j) {
    size_t turned = 0;
    whirl_status status = jobs_revolve(j, &turned);
    if (status.code == WHIRL_OK && turned == 0 && j->unlike) {
        status = turn_to_structure(j, j->values[j->begun]);
        if (status.code == WHIRL_OK) status = jobs_revolve(j, &turned);
    }
    return explorer_good(&status) ? (double)turned : -1.0;
}

EXPORTED int explorer_job_take(job *j, double *block, double *end) {
    const size_t size = j->plan->layout.size, dimension = j->plan->dimension;
    while (j->oldest < j->begun && j->points[j->oldest].taken) j->oldest++;
    for (size_t i = j->oldest; i < j->begun; i++) {
        finished_point *point = &j->points[i];
        if (!point->done || point->taken) continue;
        memcpy(block, point->numbers, size * sizeof *block);
        look_withhold(j->plan, block);
        if (end) memcpy(end, point->numbers + size, dimension * sizeof *end);
        free(point->numbers);
        point->numbers = NULL;
        point->taken = true;
        return (int)i;
    }
    return -1;
}
