// Collects the stable orbits that motions from many starts settle on.
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "section_distance.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/orbit.h"
#include "whirl/engine/stable_orbits.h"

whirl_collect_options whirl_collect_default(const double *low, const double *high) {
    return (whirl_collect_options){.orbit = whirl_orbit_default(),
                                   .starts = 64,
                                   .low = low,
                                   .high = high,
                                   .settle = 500,
                                   .most_revolutions = 16000,
                                   .longest = 32};
}

/// A motion from one of the starts.
typedef struct runner {
    size_t lane;
    bool goes_on;
    size_t returns; ///< number of revolutions with the nearest return
    double away;    ///< distance of that return, over the largest coordinate
} runner;

typedef struct collector {
    const whirl_system *system;
    const whirl_collect_options *options;
    whirl_ensemble *ensemble;
    runner *runners;  ///< [starts], nearest return first
    double *from, *x; ///< [starts][dimension] states at the beginning; [dimension]
    whirl_collection *found;
} collector;

/// near: distance from an orbit at which a motion has reached it. same: distance between nodes which are nodes of the
/// same orbit. Both are over the largest coordinate.
static const double near = 1e-4, same = 1e-6;

/// worth: largest distance of a return from which Newton's method is tried; it must converge in STEPS_FROM_NEAR steps.
static const double worth = 0.01;
enum { STEPS_FROM_NEAR = 8 };

// ---------------------------------------------------------------- starts

/// Places start `index`, counted from 0, at multiples of the powers of 1/g, where g^(dimension + 1) = g + 1.
static void place_start(const collector *c, double g, size_t index, double *x) {
    double share = 1.0, whole;
    for (size_t i = 0; i < c->system->dimension; i++) {
        share /= g;
        const double u = modf(0.5 + share * (double)(index + 1), &whole);
        x[i] = c->options->low[i] + u * (c->options->high[i] - c->options->low[i]);
        if (c->options->around_count > 0)
            x[i] += c->options->around[index % c->options->around_count * c->system->dimension + i];
    }
}

static whirl_status load_starts(collector *c) {
    double g = 1.5;
    whirl_status status = whirl_ok();
    for (int k = 0; k < 100; k++) g = pow(1.0 + g, 1.0 / ((double)c->system->dimension + 1.0));
    for (size_t k = 0; k < c->options->starts && status.code == WHIRL_OK; k++) {
        place_start(c, g, k, c->x);
        status = whirl_ensemble_load(c->ensemble, k, c->system, c->x);
        c->runners[k] = (runner){.lane = k, .goes_on = true};
    }
    return status;
}

// ---------------------------------------------------------------- orbits

/// Returns the index of the orbit that passes near x, or the count without one.
static size_t orbit_near(const collector *c, const double *x, double within) {
    for (size_t k = 0; k < c->found->count; k++)
        if (whirl_orbit_distance(c->system, c->found->orbits[k], x) < within) return k;
    return c->found->count;
}

/// Returns the least number of revolutions after which an orbit closes.
static size_t least_revolutions(const whirl_system *system, const whirl_orbit *orbit) {
    const size_t stride = orbit_stride(orbit), repeats = system->repeats > 0 ? system->repeats : 1;
    for (size_t k = repeats; k < orbit->revolutions; k += repeats)
        if (orbit->revolutions % k == 0 && states_distance(system, orbit->nodes, orbit->nodes + k * stride) < same)
            return k;
    return orbit->revolutions;
}

static whirl_status collect_keep(collector *c, whirl_orbit *orbit) {
    whirl_collection *found = c->found;
    whirl_orbit **orbits = realloc(found->orbits, (found->count + 1) * sizeof *orbits);
    if (orbits) found->orbits = orbits;
    size_t *reached = realloc(found->reached, (found->count + 1) * sizeof *reached);
    if (reached) found->reached = reached;
    if (!orbits || !reached) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu orbits", found->count + 1);
    found->reached[found->count] = 0;
    found->orbits[found->count++] = orbit;
    return whirl_ok();
}

/// Searches an unknown stable orbit near x. *new becomes true if there is one.
static whirl_status look_near(collector *c, const double *x, size_t revolutions, bool *new) {
    whirl_orbit_options options = c->options->orbit;
    whirl_orbit *orbit = NULL, *shorter = NULL;
    *new = false;
    options.most_steps = options.most_steps < STEPS_FROM_NEAR ? options.most_steps : STEPS_FROM_NEAR;
    whirl_status status = whirl_orbit_find(c->system, x, revolutions, &options, &orbit);
    if (status.code == WHIRL_BAD_INPUT) return whirl_ok();
    if (status.code != WHIRL_OK) return status;
    const size_t least = least_revolutions(c->system, orbit);
    if (least < revolutions) {
        status = whirl_orbit_find(c->system, orbit->nodes, least, &options, &shorter);
        whirl_orbit_free(orbit);
        orbit = shorter;
        if (status.code == WHIRL_BAD_INPUT) return whirl_ok();
        if (status.code != WHIRL_OK) return status;
    }
    *new = orbit->unstable == 0 && orbit_near(c, orbit->nodes, same) == c->found->count;
    if (*new) status = collect_keep(c, orbit);
    if (!*new || status.code != WHIRL_OK) whirl_orbit_free(orbit);
    return status;
}

// ---------------------------------------------------------------- motions

static void collect_revolve(collector *c, size_t revolutions) {
    for (size_t k = 0; k < revolutions; k++) whirl_ensemble_revolve(c->ensemble, c->options->starts, NULL);
}

static bool collect_continues(collector *c, runner *r) {
    if (r->goes_on && whirl_ensemble_motion(c->ensemble, r->lane) != WHIRL_BOUNDED) {
        whirl_ensemble_unload(c->ensemble, r->lane);
        r->goes_on = false;
        c->found->lost++;
    }
    return r->goes_on;
}

/// Finds the nearest return of each motion.
static void watch_returns(collector *c) {
    const size_t d = c->system->dimension, repeats = c->system->repeats > 0 ? c->system->repeats : 1;
    for (size_t k = 0; k < c->options->starts; k++) {
        runner *r = &c->runners[k];
        r->away = INFINITY;
        r->returns = 0;
        if (collect_continues(c, r)) whirl_ensemble_state(c->ensemble, r->lane, c->from + r->lane * d);
    }
    for (size_t turn = 1; turn <= c->options->longest; turn++) {
        collect_revolve(c, 1);
        for (size_t k = 0; k < c->options->starts && turn % repeats == 0; k++) {
            runner *r = &c->runners[k];
            if (!collect_continues(c, r)) continue;
            whirl_ensemble_state(c->ensemble, r->lane, c->x);
            const double away = states_distance(c->system, c->x, c->from + r->lane * d);
            // A longer return must be much better: multiples of a period return as well.
            if (away < 0.5 * r->away) {
                r->away = away;
                r->returns = turn;
            }
        }
    }
}

static int by_return(const void *a, const void *b) {
    const runner *p = a, *q = b;
    if (p->away != q->away) return p->away < q->away ? -1 : 1;
    return p->lane < q->lane ? -1 : p->lane > q->lane;
}

/// Searches orbits from the motions, best returns first. Motions that return after a number of revolutions are tried
/// only as long as they lead to new orbits.
static whirl_status collect_search(collector *c) {
    uint64_t tried = 0; // bit k: motions that return after k + 1 revolutions lead to no more orbits
    whirl_status status = whirl_ok();
    qsort(c->runners, c->options->starts, sizeof *c->runners, by_return);
    for (size_t k = 0; k < c->options->starts && status.code == WHIRL_OK; k++) {
        runner *r = &c->runners[k];
        bool new = true;
        if (!r->goes_on || !(r->away < worth)) continue;
        whirl_ensemble_state(c->ensemble, r->lane, c->x);
        const uint64_t bit = (uint64_t)1 << (r->returns - 1);
        if (orbit_near(c, c->x, near) == c->found->count && !(tried & bit)) {
            status = look_near(c, c->x, r->returns, &new);
            if (!new) tried |= bit;
        }
        const size_t reached = orbit_near(c, c->x, near);
        if (reached == c->found->count) continue;
        c->found->reached[reached]++;
        whirl_ensemble_unload(c->ensemble, r->lane);
        r->goes_on = false;
    }
    return status;
}

static size_t count_going(const collector *c) {
    size_t count = 0;
    for (size_t k = 0; k < c->options->starts; k++) count += c->runners[k].goes_on;
    return count;
}

/// Runs the motions. After each search the total time is doubled.
static whirl_status collect_run(collector *c) {
    const whirl_collect_options *o = c->options;
    size_t done = 0, next = o->settle;
    whirl_status status = load_starts(c);
    while (status.code == WHIRL_OK && done + next + o->longest <= o->most_revolutions && count_going(c) > 0) {
        collect_revolve(c, next);
        watch_returns(c);
        status = collect_search(c);
        next += o->longest;
        done += next;
        next = done;
    }
    c->found->elsewhere = count_going(c);
    return status;
}

// ---------------------------------------------------------------- the whole

static whirl_status collect_check(const whirl_system *system, const whirl_collect_options *o) {
    if (!system->tangent)
        return whirl_fail(WHIRL_BAD_INPUT, "the machine gives no Jacobian, which the search for orbits needs");
    if (o->starts == 0) return whirl_fail(WHIRL_BAD_INPUT, "0 starts, expected 1 or more");
    if (o->settle == 0 || o->settle + o->longest > o->most_revolutions)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the first search for orbits of up to %zu revolutions is after %zu revolutions, expected 1 "
                          "or more, and both together at most the %zu revolutions of a motion",
                          o->longest, o->settle, o->most_revolutions);
    if (o->longest == 0 || o->longest > WHIRL_MAX_ORBIT)
        return whirl_fail(WHIRL_BAD_INPUT, "orbits of up to %zu revolutions, expected 1 to %d", o->longest,
                          WHIRL_MAX_ORBIT);
    for (size_t i = 0; i < system->dimension; i++)
        if (!(isfinite(o->low[i]) && isfinite(o->high[i]) && o->low[i] <= o->high[i]))
            return whirl_fail(WHIRL_BAD_INPUT, "starts from %g to %g in coordinate %zu, expected ascending numbers",
                              o->low[i], o->high[i], i + 1);
    return whirl_ok();
}

static whirl_status collect_make_room(collector *c) {
    const size_t starts = c->options->starts, d = c->system->dimension;
    // Motions need not be as exact as orbits.
    whirl_integrate_options steps = c->options->orbit.integrate;
    steps.rtol = fmax(steps.rtol, 1e-9);
    steps.atol = fmax(steps.atol, 1e-12);
    c->found = calloc(1, sizeof *c->found);
    c->runners = calloc(starts, sizeof *c->runners);
    c->from = calloc(starts * d + 1, sizeof *c->from);
    c->x = calloc(d + 1, sizeof *c->x);
    if (!c->found || !c->runners || !c->from || !c->x)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu motions", starts);
    return whirl_ensemble_takes(c->system, &steps) ? whirl_ensemble_new(c->system, &steps, starts, &c->ensemble)
                                                   : whirl_ensemble_alone(c->system, &steps, starts, 0, &c->ensemble);
}

void whirl_collection_free(whirl_collection *collection) {
    if (!collection) return;
    for (size_t k = 0; k < collection->count; k++) whirl_orbit_free(collection->orbits[k]);
    free(collection->orbits);
    free(collection->reached);
    free(collection);
}

whirl_status whirl_orbit_collect(const whirl_system *system, const whirl_collect_options *options,
                                 whirl_collection **collection) {
    collector c = {.system = system, .options = options};
    *collection = NULL;
    whirl_status status = collect_check(system, options);
    if (status.code == WHIRL_OK) status = collect_make_room(&c);
    if (status.code == WHIRL_OK) status = collect_run(&c);
    if (status.code == WHIRL_OK) {
        *collection = c.found;
        c.found = NULL;
    }
    whirl_collection_free(c.found);
    whirl_ensemble_free(c.ensemble);
    free(c.runners);
    free(c.from);
    free(c.x);
    return status;
}
