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
    const whirl_system *first; ///< machine that defines the structure
    size_t runs, count;        ///< lanes of runs, and all: those of their copies follow
    size_t used;               ///< lanes that a run has, or had
    bool any;                  ///< a lane is to be carried
    struct runup_ride **rides; ///< [runs]
    bool *observed;            ///< [2 runs]
    size_t sampled;            ///< number of observed lanes
    size_t *from;              ///< [sampled] these lanes
    double **next;             ///< [sampled] where the next sample of each goes
} runup_lanes;

/// A run among those that are carried together.
typedef struct runup_ride {
    runner r;
    bool over, waits;          ///< it has ended; lanes are to carry its next part
    const whirl_system *takes; ///< its machine in lanes; NULL: lanes do not take it
    runup_lanes *in;           ///< NULL: none
    size_t lane;
    unsigned known, loaded, copy_loaded; ///< 1 + settings of the run when `takes` was found, and when lanes were
                                         ///< loaded; 0: never
} runup_ride;

/// Runs that are carried together.
typedef struct runup_group {
    size_t count, ensembles;
    runup_ride *rides;   ///< [count]
    runup_lanes **lanes; ///< [ensembles]
} runup_group;

// ---------------------------------------------------------------- lanes

static void runup_lanes_free(runup_lanes *lanes) {
    if (!lanes) return;
    whirl_ensemble_free(lanes->ensemble);
    free(lanes->rides);
    free(lanes->observed);
    free(lanes->from);
    free(lanes->next);
    free(lanes);
}

/// Returns true if lanes of the structure of `first` take the run of a ride.
static bool runup_is_alike(const whirl_system *first, const runup_ride *ride) {
    return ride->takes && whirl_ensemble_alike(first, ride->takes);
}

/// Makes lanes for the run and all runs like it that have none yet.
static whirl_status runup_lanes_make(const runup_group *group, const runup_ride *ride, runup_lanes *made) {
    whirl_integrate_options options = ride->r.plan->integrate;
    options.steps_per_revolution = ride->r.plan->options->samples;
    made->first = ride->takes;
    for (size_t i = 0; i < group->count; i++)
        made->runs += !group->rides[i].over && !group->rides[i].in && runup_is_alike(made->first, &group->rides[i]);
    made->rides = calloc(made->runs + 1, sizeof(runup_ride *));
    made->observed = calloc(2 * made->runs + 1, sizeof *made->observed);
    made->from = calloc(made->runs + 1, sizeof *made->from);
    made->next = calloc(made->runs + 1, sizeof *made->next);
    if (!made->rides || !made->observed || !made->from || !made->next)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for runs");
    // A run may lose its copy and others of the same plan have theirs: room does not depend on it.
    made->count = runup_wants_copy(ride->r.plan->options, ride->r.contacts) ? 2 * made->runs : made->runs;
    return whirl_ensemble_flow(made->first, &options, made->count, 0, &made->ensemble);
}

/// Adds lanes to the group.
static whirl_status runup_add_lanes(runup_group *group, const runup_ride *ride, runup_lanes **out) {
    runup_lanes **all = realloc(group->lanes, (group->ensembles + 1) * sizeof *all), *made = NULL;
    if (all) {
        group->lanes = all;
        made = calloc(1, sizeof *made);
    }
    if (!made) return whirl_fail(WHIRL_NO_MEMORY, "no memory for runs");
    const whirl_status status = runup_lanes_make(group, ride, made);
    if (status.code == WHIRL_OK)
        *out = group->lanes[group->ensembles++] = made;
    else
        runup_lanes_free(made);
    return status;
}

/// Empties the lanes of a run.
static void runup_leave(runup_ride *ride) {
    if (!ride->in) return;
    whirl_ensemble_unload(ride->in->ensemble, ride->lane);
    if (ride->copy_loaded > 0) whirl_ensemble_unload(ride->in->ensemble, ride->in->runs + ride->lane);
    ride->in->rides[ride->lane] = NULL;
    ride->in = NULL;
    ride->loaded = ride->copy_loaded = 0;
}

/// Finds a lane for a run whose machine lanes take.
static whirl_status runup_enter(runup_group *group, runup_ride *ride) {
    if (ride->in && whirl_ensemble_alike(ride->in->first, ride->takes)) return whirl_ok();
    runup_leave(ride);
    runup_lanes *in = NULL;
    for (size_t i = 0; i < group->ensembles && !in; i++)
        if (group->lanes[i]->used < group->lanes[i]->runs && runup_is_alike(group->lanes[i]->first, ride))
            in = group->lanes[i];
    const whirl_status status = in ? whirl_ok() : runup_add_lanes(group, ride, &in);
    if (status.code != WHIRL_OK) return status;
    ride->in = in;
    ride->lane = ride->in->used++;
    ride->in->rides[ride->lane] = ride;
    return status;
}

/// Puts a state into a lane: with the machine's numbers, unless these are already there.
static whirl_status runup_put(const runup_ride *ride, size_t lane, const double *x, unsigned *loaded) {
    whirl_ensemble *ensemble = ride->in->ensemble;
    whirl_status status = whirl_ok();
    if (*loaded == ride->r.settings + 1)
        whirl_ensemble_place(ensemble, lane, x);
    else
        status = whirl_ensemble_load(ensemble, lane, ride->takes, x);
    *loaded = ride->r.settings + 1;
    whirl_ensemble_part(ensemble, lane, ride->r.from, ride->r.length);
    return status;
}

/// Puts the next part of a run, and that of its copy, into lanes.
static whirl_status runup_board(runup_group *group, runup_ride *ride) {
    const runner *r = &ride->r;
    whirl_status status = runup_enter(group, ride);
    if (status.code != WHIRL_OK) return status;
    runup_lanes *in = ride->in;
    const bool part = r->phase == PHASE_PART, copy = part && r->copy;
    in->any = true;
    in->observed[ride->lane] = part;
    r->machine->part(r->machine, 0.0, two_pi);
    status = runup_put(ride, ride->lane, r->end, &ride->loaded);
    if (!copy && ride->copy_loaded > 0) {
        whirl_ensemble_unload(in->ensemble, in->runs + ride->lane);
        ride->copy_loaded = 0;
    }
    if (status.code == WHIRL_OK && copy) status = runup_put(ride, in->runs + ride->lane, r->copy, &ride->copy_loaded);
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
        const runup_ride *ride = lanes->rides[lane];
        if (!ride || !lanes->observed[lane]) continue;
        const size_t dimension = ride->r.dimension;
        memcpy(ride->r.samples, ride->r.end, dimension * sizeof *ride->r.samples);
        lanes->from[lanes->sampled] = lane;
        lanes->next[lanes->sampled++] = ride->r.samples + dimension;
    }
    whirl_ensemble_revolve(lanes->ensemble, lanes->count, &observe);
}

/// Takes a part from its lanes.
static void runup_alight(runup_ride *ride) {
    runner *r = &ride->r;
    whirl_ensemble *ensemble = ride->in->ensemble;
    const size_t lane = ride->lane, copy = ride->in->runs + lane;
    whirl_ensemble_state(ensemble, lane, r->end);
    r->copy_carried = ride->copy_loaded > 0 && whirl_ensemble_motion(ensemble, copy) == WHIRL_BOUNDED;
    if (r->copy_carried) whirl_ensemble_state(ensemble, copy, r->copy_end);
    runup_take(r, whirl_ensemble_motion(ensemble, lane));
}

// ---------------------------------------------------------------- runs

/// Returns true if lanes take the next part of a run.
static bool runup_rides(runup_ride *ride) {
    const runner *r = &ride->r;
    if (r->by_time || strcmp(r->plan->integrate.method, "dop853") != 0) return false;
    if (ride->known != r->settings + 1) {
        ride->takes = r->machine->in_lanes(r->machine);
        ride->known = r->settings + 1;
    }
    return ride->takes != NULL;
}

static bool runup_is_stopped(const runner *r) {
    return whirl_stop_is_set(r->system->stop);
}

static void runup_end_ride(runup_ride *ride) {
    runup_leave(ride);
    ride->over = true;
    if (ride->r.status.code == WHIRL_OK) runup_finish(&ride->r);
}

/// Goes on with a run until lanes are to carry it, or it is over.
static void runup_go_on(runup_ride *ride) {
    runner *r = &ride->r;
    ride->waits = false;
    while (!ride->waits && !ride->over) {
        if (r->status.code != WHIRL_OK || runup_is_stopped(r) || !runup_next(r)) {
            runup_end_ride(ride);
        } else if (runup_rides(ride)) {
            ride->waits = true;
        } else {
            runup_leave(ride);
            runup_take(r, runup_carry_alone(r));
        }
    }
}

/// Carries a group of runs, which are begun, to their ends.
static void runup_carry_group(runup_group *group) {
    for (bool any = true; any;) {
        any = false;
        for (size_t i = 0; i < group->count; i++)
            if (!group->rides[i].over) runup_go_on(&group->rides[i]);
        for (size_t i = 0; i < group->count; i++) {
            runup_ride *ride = &group->rides[i];
            if (ride->over) continue;
            ride->r.status = runup_board(group, ride);
            ride->waits = ride->r.status.code == WHIRL_OK;
            any = true;
        }
        for (size_t i = 0; i < group->ensembles; i++)
            if (group->lanes[i]->any) runup_carry_lanes(group->lanes[i]);
        for (size_t i = 0; i < group->count; i++) {
            runup_ride *ride = &group->rides[i];
            if (!ride->over && ride->waits && !runup_is_stopped(&ride->r)) runup_alight(ride);
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
        runup_group group = {.count = end - first, .rides = calloc(end - first, sizeof(runup_ride))};
        for (size_t i = first; i < end && !group.rides; i++)
            tasks[i].status = whirl_fail(WHIRL_NO_MEMORY, "no memory for runs");
        if (!group.rides) continue;
        for (size_t i = 0; i < group.count; i++)
            runup_open(&group.rides[i].r, tasks[first + i].running, tasks[first + i].plan, tasks[first + i].run);
        runup_carry_group(&group);
        // Machines of lanes outlive them.
        for (size_t i = 0; i < group.ensembles; i++) runup_lanes_free(group.lanes[i]);
        for (size_t i = 0; i < group.count; i++) {
            tasks[first + i].status = group.rides[i].r.status;
            runup_close(&group.rides[i].r);
        }
        free(group.lanes);
        free(group.rides);
    }
}
