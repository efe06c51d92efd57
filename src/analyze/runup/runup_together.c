// Runs that are carried together: whole parts of turns in vector lanes, all else for one run after the other. Each run
// has its own angle, its own steps and its own events, and no bit of it depends on the others.
#include "runup_state.h"
#include "two_pi.h"
#include "whirl/engine/ensemble.h"

#include <stdlib.h>
#include <string.h>

/// Most bytes of the samples of an ensemble, and most runs in it.
enum { SAMPLE_BYTES = 1 << 26, MAX_TOGETHER = 64 };

/// An ensemble of runs of one structure.
typedef struct runup_lanes {
    whirl_ensemble *ensemble;
    const whirl_system *first;     ///< machine that defines the structure
    size_t runs, count;            ///< lanes of runs; all lanes, of which those of the runs' copies come last
    size_t used;                   ///< lanes that a run has, or had
    bool any;                      ///< a lane is to be carried
    struct runup_member **members; ///< [runs]
    bool *observed;                ///< [2 runs]
    size_t sampled;                ///< number of observed lanes
    size_t *from;                  ///< [sampled] these lanes
    double **next;                 ///< [sampled] where the next sample of each goes
} runup_lanes;

/// A run among those that are carried together.
typedef struct runup_member {
    runner r;
    bool over, waits;             ///< the run has ended; its next part is to be carried in lanes
    const whirl_system *in_lanes; ///< its machine in lanes; NULL: it cannot be carried in lanes
    runup_lanes *in;              ///< NULL: none
    size_t lane;
    unsigned known, loaded, copy_loaded; ///< 1 + settings of the run when `in_lanes` was found, and when lanes were
                                         ///< loaded; 0: never
} runup_member;

/// Runs that are carried together.
typedef struct runup_group {
    size_t count, ensembles;
    runup_member *members; ///< [count]
    runup_lanes **lanes;   ///< [ensembles]
} runup_group;

// ---------------------------------------------------------------- lanes

static void runup_lanes_free(runup_lanes *lanes) {
    if (!lanes) return;
    whirl_ensemble_free(lanes->ensemble);
    free(lanes->members);
    free(lanes->observed);
    free(lanes->from);
    free(lanes->next);
    free(lanes);
}

/// Returns true if lanes of the structure of `first` can carry a run.
static bool runup_is_alike(const whirl_system *first, const runup_member *member) {
    return member->in_lanes && whirl_ensemble_alike(first, member->in_lanes);
}

/// Makes lanes for the run and all runs like it that have none yet.
static whirl_status runup_lanes_make(const runup_group *group, const runup_member *member, runup_lanes *made) {
    whirl_integrate_options options = member->r.plan->integrate;
    options.steps_per_revolution = member->r.plan->options->samples;
    made->first = member->in_lanes;
    for (size_t i = 0; i < group->count; i++)
        made->runs +=
            !group->members[i].over && !group->members[i].in && runup_is_alike(made->first, &group->members[i]);
    made->members = calloc(made->runs + 1, sizeof(runup_member *));
    made->observed = calloc(2 * made->runs + 1, sizeof *made->observed);
    made->from = calloc(made->runs + 1, sizeof *made->from);
    made->next = calloc(made->runs + 1, sizeof *made->next);
    if (!made->members || !made->observed || !made->from || !made->next)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for runs");
    // Lanes for copies do not depend on which runs still have theirs: a run may lose its copy while others keep theirs.
    made->count = runup_wants_copy(member->r.plan->options, member->r.contacts) ? 2 * made->runs : made->runs;
    return whirl_ensemble_flow(made->first, &options, made->count, 0, &made->ensemble);
}

/// Adds lanes to the group.
static whirl_status runup_add_lanes(runup_group *group, const runup_member *member, runup_lanes **out) {
    runup_lanes **all = realloc(group->lanes, (group->ensembles + 1) * sizeof *all), *made = NULL;
    if (all) {
        group->lanes = all;
        made = calloc(1, sizeof *made);
    }
    if (!made) return whirl_fail(WHIRL_NO_MEMORY, "no memory for runs");
    const whirl_status status = runup_lanes_make(group, member, made);
    if (status.code == WHIRL_OK)
        *out = group->lanes[group->ensembles++] = made;
    else
        runup_lanes_free(made);
    return status;
}

/// Empties the lanes of a run.
static void runup_leave_lanes(runup_member *member) {
    if (!member->in) return;
    whirl_ensemble_unload(member->in->ensemble, member->lane);
    if (member->copy_loaded > 0) whirl_ensemble_unload(member->in->ensemble, member->in->runs + member->lane);
    member->in->members[member->lane] = NULL;
    member->in = NULL;
    member->loaded = member->copy_loaded = 0;
}

/// Finds a lane for a run whose machine can be carried in lanes.
static whirl_status runup_find_lane(runup_group *group, runup_member *member) {
    if (member->in && whirl_ensemble_alike(member->in->first, member->in_lanes)) return whirl_ok();
    runup_leave_lanes(member);
    runup_lanes *in = NULL;
    for (size_t i = 0; i < group->ensembles && !in; i++)
        if (group->lanes[i]->used < group->lanes[i]->runs && runup_is_alike(group->lanes[i]->first, member))
            in = group->lanes[i];
    const whirl_status status = in ? whirl_ok() : runup_add_lanes(group, member, &in);
    if (status.code != WHIRL_OK) return status;
    member->in = in;
    member->lane = member->in->used++;
    member->in->members[member->lane] = member;
    return status;
}

/// Puts a state into a lane: with the machine's numbers, unless these are already there.
static whirl_status runup_put(const runup_member *member, size_t lane, const double *x, unsigned *loaded) {
    whirl_ensemble *ensemble = member->in->ensemble;
    whirl_status status = whirl_ok();
    if (*loaded == member->r.settings + 1)
        whirl_ensemble_place(ensemble, lane, x);
    else
        status = whirl_ensemble_load(ensemble, lane, member->in_lanes, x);
    *loaded = member->r.settings + 1;
    whirl_ensemble_part(ensemble, lane, member->r.from, member->r.length);
    return status;
}

/// Puts the next part of a run, and that of its copy, into lanes.
static whirl_status runup_load(runup_group *group, runup_member *member) {
    const runner *r = &member->r;
    whirl_status status = runup_find_lane(group, member);
    if (status.code != WHIRL_OK) return status;
    runup_lanes *in = member->in;
    const bool part = r->phase == PHASE_PART, copy = part && r->copy;
    in->any = true;
    in->observed[member->lane] = part;
    r->machine->part(r->machine, 0.0, two_pi);
    status = runup_put(member, member->lane, r->end, &member->loaded);
    if (!copy && member->copy_loaded > 0) {
        whirl_ensemble_unload(in->ensemble, in->runs + member->lane);
        member->copy_loaded = 0;
    }
    if (status.code == WHIRL_OK && copy)
        status = runup_put(member, in->runs + member->lane, r->copy, &member->copy_loaded);
    return status;
}

/// Takes the next sample of all observed runs.
static void runup_keep_samples(void *context) {
    const runup_lanes *lanes = context;
    const size_t dimension = lanes->first->dimension;
    for (size_t d = 0; d < dimension; d++) {
        const double *row = whirl_ensemble_coordinate(lanes->ensemble, d);
        for (size_t i = 0; i < lanes->sampled; i++) *lanes->next[i]++ = row[lanes->from[i]];
    }
}

/// Carries all lanes over their parts.
static void runup_carry_lanes(runup_lanes *lanes) {
    const whirl_ensemble_observe observe = {
        .stride = 1, .sample = runup_keep_samples, .context = lanes, .lanes = lanes->observed};
    lanes->any = false;
    lanes->sampled = 0;
    for (size_t lane = 0; lane < lanes->used; lane++) {
        const runup_member *member = lanes->members[lane];
        if (!member || !lanes->observed[lane]) continue;
        const size_t dimension = member->r.dimension;
        memcpy(member->r.samples, member->r.end, dimension * sizeof *member->r.samples);
        lanes->from[lanes->sampled] = lane;
        lanes->next[lanes->sampled++] = member->r.samples + dimension;
    }
    whirl_ensemble_revolve(lanes->ensemble, lanes->count, &observe);
}

/// Reads the end of a part, and of the copy over it, from their lanes.
static void runup_unload(runup_member *member) {
    runner *r = &member->r;
    whirl_ensemble *ensemble = member->in->ensemble;
    const size_t lane = member->lane, copy = member->in->runs + lane;
    whirl_ensemble_state(ensemble, lane, r->end);
    r->copy_carried = member->copy_loaded > 0 && whirl_ensemble_motion(ensemble, copy) == WHIRL_BOUNDED;
    if (r->copy_carried) whirl_ensemble_state(ensemble, copy, r->copy_end);
    runup_take(r, whirl_ensemble_motion(ensemble, lane));
}

// ---------------------------------------------------------------- runs

/// Returns true if lanes can carry the next part of a run.
static bool runup_fits_lanes(runup_member *member) {
    const runner *r = &member->r;
    const bool implicit = strcmp(r->plan->integrate.method, "rodas5p") == 0;
    if (r->by_time || (!implicit && strcmp(r->plan->integrate.method, "dop853") != 0)) return false;
    if (member->known != r->settings + 1) {
        member->in_lanes = r->machine->in_lanes(r->machine, implicit);
        member->known = r->settings + 1;
    }
    return member->in_lanes != NULL;
}

static bool runup_is_stopped(const runner *r) {
    return whirl_stop_is_set(r->system->stop);
}

static void runup_end_member(runup_member *member) {
    runup_leave_lanes(member);
    member->over = true;
    if (member->r.status.code == WHIRL_OK) runup_finish(&member->r);
}

/// Advances a run until its next part is to be carried in lanes, or it is over.
static void runup_prepare(runup_member *member) {
    runner *r = &member->r;
    member->waits = false;
    while (!member->waits && !member->over) {
        if (r->status.code != WHIRL_OK || runup_is_stopped(r) || !runup_next(r)) {
            runup_end_member(member);
        } else if (runup_fits_lanes(member)) {
            member->waits = true;
        } else {
            runup_leave_lanes(member);
            runup_take(r, runup_carry_alone(r));
        }
    }
}

/// Carries a group of runs, which are begun, to their ends.
static void runup_carry_group(runup_group *group) {
    for (bool any = true; any;) {
        any = false;
        for (size_t i = 0; i < group->count; i++)
            if (!group->members[i].over) runup_prepare(&group->members[i]);
        for (size_t i = 0; i < group->count; i++) {
            runup_member *member = &group->members[i];
            if (member->over) continue;
            member->r.status = runup_load(group, member);
            member->waits = member->r.status.code == WHIRL_OK;
            any = true;
        }
        for (size_t i = 0; i < group->ensembles; i++)
            if (group->lanes[i]->any) runup_carry_lanes(group->lanes[i]);
        for (size_t i = 0; i < group->count; i++) {
            runup_member *member = &group->members[i];
            if (!member->over && member->waits && !runup_is_stopped(&member->r)) runup_unload(member);
        }
    }
}

/// Returns the number of runs like the first whose samples fit into memory.
static size_t runup_group_size(const runup_task *task) {
    const double sample = (double)task->running->by_angle->dimension * sizeof(double);
    const double fit = SAMPLE_BYTES / (2.0 * sample * task->plan->options->samples);
    return fit < 1.0 ? 1 : fit > MAX_TOGETHER ? MAX_TOGETHER : (size_t)fit;
}

void runup_carry_together(size_t count, runup_task *tasks) {
    for (size_t first = 0, end; first < count; first = end) {
        end = first + runup_group_size(&tasks[first]);
        if (end > count) end = count;
        runup_group group = {.count = end - first, .members = calloc(end - first, sizeof(runup_member))};
        for (size_t i = first; i < end && !group.members; i++)
            tasks[i].status = whirl_fail(WHIRL_NO_MEMORY, "no memory for runs");
        if (!group.members) continue;
        for (size_t i = 0; i < group.count; i++)
            runup_open(&group.members[i].r, tasks[first + i].running, tasks[first + i].plan, tasks[first + i].run);
        runup_carry_group(&group);
        // Free the lanes before the machines that they use.
        for (size_t i = 0; i < group.ensembles; i++) runup_lanes_free(group.lanes[i]);
        for (size_t i = 0; i < group.count; i++) {
            tasks[first + i].status = group.members[i].r.status;
            runup_close(&group.members[i].r);
        }
        free(group.lanes);
        free(group.members);
    }
}
