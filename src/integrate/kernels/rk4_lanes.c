// RK4 in Nystrom's form for x'' = f(t, x, x') and its variational equations over vector lanes, compiled once for every
// instruction set.
//
// Loops go stage by stage, with quantities outermost and vectors innermost: independent vectors hide each other's
// latency.
#include "rk4_lanes.h"
#include "rk4_scheme.h"
#include "watched_kernel.h"

/// Calls `body` for every vector of the rows from <= d < to, with its index i. The rows are one loop if all vectors are
/// in use.
#define FOR_ROWS(lanes, from, to, body)                                                                                \
    for (size_t d = (from), full = (lanes)->vectors == (lanes)->stride,                                                \
                run = full && (to) > (from) ? (to) - (from) : 1;                                                       \
         d < (to); d += run)                                                                                           \
        for (size_t i = d * (lanes)->stride, last = i + run * (lanes)->vectors; i < last; i++) body

/// Loops over every degree of freedom; and over the states of first order, which follow the velocities.
#define FOR_ALL(lanes, body) FOR_ROWS(lanes, 0, (lanes)->degrees, body)
#define FOR_STATES(lanes, body) FOR_ROWS(lanes, (lanes)->degrees, (lanes)->rates, body)

/// Computes accelerations of the state and its perturbations, with the forcing that all lanes share, and the divergence
/// of a stage.
static void accelerate(const rk4_lanes *lanes, const double *forcing, const vec *q, const vec *v, double *divergence,
                       vec *a) {
    const bool spread = lanes->lane_count > 1; // a single lane needs no copies
    vec *now = (vec *)lanes->now;
    for (size_t i = 0; spread && i < lanes->forcing_count; i++)
        for (size_t k = 0; k < lanes->vectors; k++) now[i * lanes->stride + k] = v_set(forcing[i]);
    const lanes_view view = {.model = lanes->model,
                             .stride = lanes->stride,
                             .vectors = lanes->vectors,
                             .numbers = lanes->numbers,
                             .places = lanes->places,
                             .forcing = spread ? (const void *)now : forcing,
                             .tangents = lanes->perturbations,
                             .q = q,
                             .v = v,
                             .a = a,
                             .divergence = lanes->perturbations > 0 ? divergence : NULL};
    lanes->flow(&view);
}

/// Computes a stage of the scheme, or its end, for the state and all perturbations.
#define ENTER_SET(stage, scheme)                                                                                       \
    FOR_ALL(lanes, stage(&(scheme), i);)                                                                               \
    FOR_STATES(lanes, stage##_state(&(scheme), i);)
#define ENTER_ALL(stage)                                                                                               \
    ENTER_SET(stage, own)                                                                                              \
    for (size_t n = 1; n <= lanes->perturbations; n++) {                                                               \
        const scheme beside = scheme_of_set(lanes, &constants, n);                                                     \
        ENTER_SET(stage, beside)                                                                                       \
    }

/// Returns a position in an array; NULL if the array is NULL.
static inline vec *place_in(void *array, size_t offset) {
    return array ? (vec *)array + offset : NULL;
}

/// Returns the scheme with the arrays of the state (n = 0) or a perturbation.
static inline scheme scheme_of_set(const rk4_lanes *lanes, const scheme *constants, size_t n) {
    const size_t place = n * lanes->degrees * lanes->stride, rate = n * lanes->rates * lanes->stride;
    return scheme_at(constants, place_in(lanes->q, place), place_in(lanes->v, rate), place_in(lanes->k[0], rate),
                     place_in(lanes->k[1], rate), place_in(lanes->k[2], rate), place_in(lanes->stage_q, place),
                     place_in(lanes->stage_v, rate));
}

/// Integrates the divergence over the step.
static void add_divergence(const rk4_lanes *lanes) {
    const vec sixth = v_set(lanes->step / 6.0), two = v_set(2.0);
    vec *volume = (vec *)lanes->volume;
    vec *const *d = (vec *const *)lanes->divergence;
    for (size_t k = 0; k < lanes->vectors; k++)
        volume[k] = v_fma(sixth, v_fma(two, v_add(d[1][k], d[2][k]), v_add(d[0][k], d[3][k])), volume[k]);
}

static void take_step(const rk4_lanes *lanes, const double *forcing) {
    const double *middle = forcing + lanes->forcing_count, *end = middle + lanes->forcing_count;
    const scheme constants = scheme_of(lanes->step), own = scheme_of_set(lanes, &constants, 0);
    accelerate(lanes, forcing, own.q, own.v, lanes->divergence[0], own.k1);
    ENTER_ALL(enter_second)
    accelerate(lanes, middle, own.stage_q, own.stage_v, lanes->divergence[1], own.k2);
    ENTER_ALL(enter_third)
    accelerate(lanes, middle, own.stage_q, own.stage_v, lanes->divergence[2], own.k3);
    ENTER_ALL(enter_fourth)
    accelerate(lanes, end, own.stage_q, own.stage_v, lanes->divergence[3], own.k3);
    ENTER_ALL(enter_end)
    if (lanes->perturbations > 0) add_divergence(lanes);
}

/// Returns true if velocities are observed after step n. Their bounds, which scale distances, need not be exact, and
/// cost as much as all other observations.
static inline bool looks_at_speeds(const rk4_lanes *lanes, int n) {
    return n % 4 == 0 || n == lanes->steps;
}

static inline void widen(vec value, vec *low, vec *high) {
    *low = v_min(value, *low);
    *high = v_max(value, *high);
}

static void observe_bounds(const rk4_lanes *lanes, const double *of, double *low, double *high) {
    FOR_ALL(lanes, widen(((const vec *)of)[i], (vec *)low + i, (vec *)high + i);)
}

static void observe_probes(const rk4_lanes *lanes, bool speeds) {
    const lanes_observe *w = &lanes->observe;
    const size_t stride = lanes->stride, speeds_at = lanes->degrees * lanes->lane_count;
    const vec *q = (const vec *)lanes->q, *v = (const vec *)lanes->v;
    observe_bounds(lanes, lanes->q, w->low, w->high);
    if (speeds) observe_bounds(lanes, lanes->v, w->low + speeds_at, w->high + speeds_at);
    if (speeds) FOR_STATES(lanes, widen(v[i], (vec *)(w->low + speeds_at) + i, (vec *)(w->high + speeds_at) + i);)
    for (size_t p = 0; p < w->probe_count; p++)
        for (size_t k = 0; k < lanes->vectors; k++) {
            const size_t x = w->probes[p].x * stride + k, y = w->probes[p].y * stride + k;
            const watched_instant now = watched_at(&w->probes[p], q[x], q[y], v[x], v[y]);
#define WATCH(array, extent, columns, fold, ...)                                                                       \
    for (size_t c = 0, at = (columns)*p * stride + k; c < (columns); c++, at += stride)                                \
        ((vec *)w->array)[at] = watched_with(fold, now.array[c], ((vec *)w->array)[at]);
            WHIRL_WATCHED_OF_STATIONS(WATCH)
#undef WATCH
        }
}

/// Observes the effect of friction.
static void observe_friction(const rk4_lanes *lanes) {
    const lanes_observe *w = &lanes->observe;
    for (size_t c = 0; c < w->contact_count; c++)
        for (size_t k = 0; k < lanes->vectors; k++) {
            const size_t at = c * lanes->stride + k;
            const vec *rubbing = (const vec *)w->friction + 2 * c * lanes->stride + k;
            watch_friction(rubbing[0], rubbing[lanes->stride], (vec *)w->contact_torque + at,
                           (vec *)w->contact_most + at, (vec *)w->contact_power + at);
        }
}

/// Observes normal forces and friction as the machine computes them.
static void observe_forces(const rk4_lanes *lanes) {
    const lanes_observe *w = &lanes->observe;
    const lanes_view view = {.model = lanes->model,
                             .stride = lanes->stride,
                             .vectors = lanes->vectors,
                             .numbers = lanes->numbers,
                             .q = lanes->q,
                             .v = lanes->v};
    w->contacts(&view, w->force, w->rubs ? w->friction : NULL);
    if (w->rubs) observe_friction(lanes);
    for (size_t c = 0; w->by_force && c < w->contact_count; c++)
        for (size_t at = c * lanes->stride, last = at + lanes->vectors; at < last; at++)
            ((vec *)w->contact_force)[at] = v_max(((const vec *)w->force)[at], ((const vec *)w->contact_force)[at]);
}

static vec_mask rk4_touches(const rk4_lanes *lanes, size_t c, size_t k) {
    const lanes_observe *w = &lanes->observe;
    const whirl_probe *probe = &w->probes[w->contact_probe[c]];
    const size_t at = c * lanes->stride + k;
    if (w->by_force) return v_less(v_set(0.0), ((const vec *)w->force)[at]);
    const vec x = ((const vec *)lanes->q)[probe->x * lanes->stride + k];
    const vec y = ((const vec *)lanes->q)[probe->y * lanes->stride + k];
    const vec gap = ((const vec *)w->gap)[at];
    return v_less(v_mul(gap, gap), v_fma(x, x, v_mul(y, y)));
}

/// Adds one step to the share and the number of contacts.
static inline void count_contact(vec_mask touching, vec *before, vec *share, vec *number) {
    const vec one = v_set(1.0);
    watch_contact(v_select(touching, one, v_set(0.0)), one, one, before, share, number);
}

static void observe_contacts(const rk4_lanes *lanes) {
    const lanes_observe *w = &lanes->observe;
    if (w->contacts) observe_forces(lanes);
    for (size_t c = 0; c < w->contact_count; c++)
        for (size_t k = 0; k < lanes->vectors; k++) {
            const size_t at = c * lanes->stride + k;
            count_contact(rk4_touches(lanes, c, k), (vec *)w->touching + at, (vec *)w->contact_share + at,
                          (vec *)w->contact_number + at);
        }
}

#include "rk4_located.inc"
#include "rk4_orthonormal.inc"

static bool locates(const rk4_lanes *lanes) {
    return lanes->located.switches != NULL;
}

static void begin_step(const rk4_lanes *lanes) {
    if (locates(lanes)) keep_beginning(lanes);
}

/// Ends step n: locates switches, makes perturbations orthonormal, observes, takes samples.
static void end_step(const rk4_lanes *lanes, int n) {
    if (locates(lanes)) locate(lanes, n);
    if (lanes->lengths && lanes->perturbations > 0) make_orthonormal(lanes, n + 1);
    if (lanes->observing) {
        observe_probes(lanes, looks_at_speeds(lanes, n + 1));
        observe_contacts(lanes);
    }
    if (lanes->sample_stride > 0 && (size_t)(n + 1) % lanes->sample_stride == 0) lanes->sample(lanes->context);
}

/// Copies rows of the ensemble to a vector's own rows, or back.
static void move_rows(const rk4_lanes *lanes, double *ensemble, size_t k, vec *own, size_t rows, bool back) {
    vec *there = (vec *)ensemble + k;
    for (size_t i = 0; i < rows; i++) {
        if (back)
            there[i * lanes->stride] = own[i];
        else
            own[i] = there[i * lanes->stride];
    }
}

enum { MAX_AT_ONCE = 8 }; ///< most vectors of pairs that are carried together
#include "../../rotor/pair_kernel.h"
#include "rk4_pair.inc"

void ISA(rk4_lanes)(const rk4_lanes *lanes) {
    if (locates(lanes)) begin_located(lanes);
    if (pair_revolve(lanes)) return;
    for (int n = 0; n < lanes->steps && !whirl_stop_is_set(lanes->stop); n++) {
        begin_step(lanes);
        take_step(lanes, lanes->forcing + (size_t)n * 2 * lanes->forcing_count);
        end_step(lanes, n);
    }
}
