#include "ensemble_alone.h"

#include <math.h>
#include <stdlib.h>

#include "watch.h"

alone_lanes *alone_lanes_new(const whirl_integrate_options *options, size_t followed, size_t dimension,
                             size_t lane_count) {
    alone_lanes *alone = calloc(1, sizeof *alone);
    if (!alone) return NULL;
    *alone = (alone_lanes){.options = *options,
                           .followed = followed,
                           .dimension = dimension,
                           .lane_count = lane_count,
                           .state = calloc(dimension, sizeof *alone->state),
                           .integrator = calloc(lane_count, sizeof *alone->integrator)};
    if (alone->state && alone->integrator) return alone;
    alone_lanes_free(alone);
    return NULL;
}

void alone_lanes_free(alone_lanes *alone) {
    if (!alone) return;
    for (size_t lane = 0; alone->integrator && lane < alone->lane_count; lane++)
        whirl_integrator_free(alone->integrator[lane]);
    free(alone->integrator);
    free(alone->state);
    free(alone->samples);
    free(alone);
}

whirl_status alone_lanes_load(const alone_lanes *alone, size_t lane, const whirl_system *system) {
    whirl_integrator **own = &alone->integrator[lane];
    whirl_integrator_free(*own);
    *own = NULL;
    if (!system) return whirl_ok();
    const whirl_status status = whirl_integrator_new(system, &alone->options, own);
    if (status.code != WHIRL_OK || alone->followed == 0) return status;
    return whirl_integrator_follow(*own, alone->followed);
}

void alone_lanes_move(const alone_lanes *alone, size_t from, size_t to) {
    alone->integrator[to] = alone->integrator[from];
    alone->integrator[from] = NULL;
}

// ---------------------------------------------------------------- what is observed

/// A lane that is observed during a revolution.
typedef struct watched_lane {
    const alone_lanes *lanes;
    size_t lane, instant;
    const whirl_ensemble_observe *observe;
    size_t samples; ///< number of samples with room
} watched_lane;

/// Returns the lane's number in a row of an array.
static double *number_in(const watched_lane *w, double *array, size_t row) {
    return &array[row * w->lanes->lane_count + w->lane];
}

/// Returns the observations of the lane.
static whirl_ensemble_seen seen_in(const watched_lane *w) {
    const lanes_observe *o = w->lanes->watched;
#define SEEN(array, ...) .array = number_in(w, o->array, 0),
    return (whirl_ensemble_seen){.low = number_in(w, o->low, 0), .high = number_in(w, o->high, 0), WHIRL_WATCHED(SEEN)};
#undef SEEN
}

static void observe(void *context, double t, const double *x) {
    watched_lane *w = context;
    const size_t dimension = w->lanes->dimension, stride = w->observe->stride;
    (void)t;
    w->instant++;
    if (w->observe->extremes) {
        const whirl_ensemble_seen seen = seen_in(w);
        watch_instant(w->lanes->machines[w->lane], x, w->lanes->lane_count, &seen,
                      number_in(w, w->lanes->watched->touching, 0));
    }
    if (stride == 0 || w->instant % stride != 0 || w->instant / stride > w->samples) return;
    for (size_t i = 0; i < dimension; i++)
        *number_in(w, w->lanes->samples, (w->instant / stride - 1) * dimension + i) = x[i];
}

// ---------------------------------------------------------------- revolutions

/// Allocates the samples of a revolution, and sets them to NaN, which remains for lanes that end early. Returns the
/// number of samples that fit.
static size_t alone_make_room(alone_lanes *alone, size_t samples) {
    const size_t numbers = alone->dimension * alone->lane_count;
    if (samples > alone->sample_capacity) {
        free(alone->samples);
        alone->samples = malloc(samples * numbers * sizeof(double));
        alone->sample_capacity = alone->samples ? samples : 0;
    }
    const size_t capacity = alone->sample_capacity < samples ? 0 : samples;
    for (size_t i = 0; i < capacity * numbers; i++) alone->samples[i] = (double)NAN;
    return capacity;
}

static void revolve_lane(const alone_lanes *alone, watched_lane *w) {
    whirl_integrator *own = alone->integrator[w->lane];
    whirl_perturbations *beside = alone->beside[w->lane];
    const whirl_observe_fn watch = w->observe ? observe : NULL;
    double *x = alone->state;
    for (size_t i = 0; i < alone->dimension; i++) x[i] = *number_in(w, alone->x, i);
    alone->ended[w->lane] =
        beside ? whirl_integrator_carry(own, x, beside, watch, w) : whirl_integrator_revolve(own, x, watch, w);
    for (size_t i = 0; i < alone->dimension; i++) *number_in(w, alone->x, i) = x[i];
    alone->beside[w->lane] = NULL;
}

size_t alone_lanes_revolve(alone_lanes *alone, size_t count, const whirl_ensemble_observe *observe) {
    const size_t steps = (size_t)alone->options.steps_per_revolution;
    const size_t wanted = observe && observe->stride > 0 ? steps / observe->stride : 0;
    const size_t samples = alone_make_room(alone, wanted);
    for (size_t lane = 0; lane < count; lane++) {
        watched_lane w = {.lanes = alone, .lane = lane, .observe = observe, .samples = samples};
        if (!alone->machines[lane] || alone->ended[lane] != WHIRL_BOUNDED) continue;
        revolve_lane(alone, &w);
        if (samples < wanted) alone->ended[lane] = WHIRL_STUCK; // no memory for its samples
    }
    return samples;
}
