#include "shooting.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "turns.h"

static whirl_status shooting_check(const whirl_system *system, const whirl_orbit_options *options, size_t revolutions,
                                   double period) {
    const size_t repeats = system->turns ? system->repeats : 1;
    const size_t segments = (size_t)options->segments * (revolutions > 0 ? revolutions : 1);
    if (revolutions > WHIRL_MAX_ORBIT)
        return whirl_fail(WHIRL_BAD_INPUT, "an orbit of %zu revolutions, expected at most %d", revolutions,
                          WHIRL_MAX_ORBIT);
    if (options->segments < 1 || segments > WHIRL_MAX_SEGMENTS)
        return whirl_fail(WHIRL_BAD_INPUT, "an orbit of %zu segments, expected 1 to %d", segments, WHIRL_MAX_SEGMENTS);
    if (revolutions == 0 && !(isfinite(period) && period >= 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "an orbit's period is %g, expected a number above 0", period);
    if (repeats == 0 && !(revolutions == 0 && period == 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "forces turn with a phase that fits no number of revolutions: there are no "
                                           "periodic orbits");
    if (repeats > 0 && revolutions % repeats != 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "an orbit of %zu revolutions, expected a multiple of %zu, after which all "
                          "that turns comes back",
                          revolutions, repeats);
    return whirl_ok();
}

bool shooting_rests(const shooting *s) {
    return s->period == 0.0;
}

static whirl_status make_parts(shooting *s) {
    const double whole = s->revolutions > 0 ? s->system->period : s->period;
    const double length = whole / (double)s->part_count;
    whirl_status status = whirl_ok();
    for (size_t j = 0; j < s->part_count && status.code == WHIRL_OK; j++) {
        part_of(&s->parts[j], s->system, length * (double)j, length, 1.0);
        if (s->lanes) continue;
        status = whirl_integrator_new(&s->parts[j].own, &s->integrate, &s->integrators[j]);
        if (status.code == WHIRL_OK) status = whirl_integrator_follow(s->integrators[j], s->kept_count);
    }
    return status;
}

/// Makes lanes for the segments, if the machine runs in lanes.
static whirl_status make_lanes(shooting *s) {
    if (!whirl_ensemble_flows(s->system, &s->integrate)) return whirl_ok();
    whirl_status status = whirl_ensemble_flow(s->system, &s->integrate, s->count, s->kept_count, &s->lanes);
    for (size_t j = 0; j < s->count && status.code == WHIRL_OK; j++)
        status = whirl_ensemble_load(s->lanes, j, s->system, s->ends);
    return status;
}

static bool shooting_allocate(shooting *s) {
    const size_t d = s->dimension;
    s->kept = calloc(d + 1, sizeof *s->kept);
    for (size_t i = 0; s->kept && i < d; i++)
        if (!turns_on(s->system->turns, i)) s->kept[s->kept_count++] = i;
    const size_t n = s->kept_count;
    s->parts = calloc(s->part_count, sizeof *s->parts);
    s->integrators = calloc(s->part_count, sizeof *s->integrators);
    s->columns = calloc(s->count, sizeof *s->columns);
    s->unit = calloc(n * d + s->count * (n * d + d + n * n) + 1, sizeof *s->unit);
    if (!s->kept || !s->parts || !s->integrators || !s->columns || !s->unit) return false;
    s->vectors = s->unit + n * d;
    s->ends = s->vectors + s->count * n * d;
    s->matrices = s->ends + s->count * d;
    for (size_t i = 0; i < n; i++) s->unit[i * d + s->kept[i]] = 1.0;
    return true;
}

whirl_status shooting_new(const whirl_system *system, const whirl_orbit_options *options, size_t revolutions,
                          double period, shooting **out) {
    *out = NULL;
    whirl_status status = shooting_check(system, options, revolutions, period);
    if (status.code != WHIRL_OK) return status;
    shooting *s = calloc(1, sizeof *s);
    // An equilibrium has one segment and is not integrated.
    const bool rests = revolutions == 0 && period == 0.0;
    const size_t parts = rests ? 1 : (size_t)options->segments;
    if (!s) return whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit of %zu segments", parts);
    *s = (shooting){.system = system,
                    .first = system,
                    .dimension = system->dimension,
                    .integrate = options->integrate,
                    .revolutions = revolutions,
                    .period = revolutions > 0 ? system->period * (double)revolutions : period,
                    .part_count = parts,
                    .count = parts * (revolutions > 0 ? revolutions : 1)};
    // Allocate; the instants of a revolution are dealt to its segments.
    if (!shooting_allocate(s)) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit of %zu segments", parts);
    s->integrate.steps_per_revolution = (s->integrate.steps_per_revolution + (int)parts - 1) / (int)parts;
    if (status.code == WHIRL_OK && !rests) status = make_lanes(s);
    if (status.code == WHIRL_OK && !rests) status = make_parts(s);
    if (status.code == WHIRL_OK)
        *out = s;
    else
        shooting_free(s);
    return status;
}

void shooting_free(shooting *s) {
    if (!s) return;
    for (size_t j = 0; s->integrators && j < s->part_count; j++) whirl_integrator_free(s->integrators[j]);
    whirl_ensemble_free(s->lanes);
    whirl_ensemble_free(s->motion_lanes);
    free(s->columns);
    free(s->integrators);
    free(s->parts);
    free(s->unit);
    free(s->kept);
    free(s);
}

// ---------------------------------------------------------------- segments, one after the other

/// Stores a segment's derivative, and adds its part of the volume.
static void take_columns(shooting *s, size_t j, const whirl_perturbations *columns) {
    const size_t d = s->dimension, n = s->kept_count;
    double *matrix = s->matrices + j * n * n;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) matrix[i * n + k] = columns->vectors[k * d + s->kept[i]];
    s->volume += columns->volume;
}

/// Sets the unit perturbations of a segment.
static whirl_perturbations *begin_columns(shooting *s, size_t j) {
    const size_t size = s->kept_count * s->dimension;
    s->columns[j] = (whirl_perturbations){.count = s->kept_count, .vectors = s->vectors + j * size};
    memcpy(s->columns[j].vectors, s->unit, size * sizeof *s->vectors);
    return &s->columns[j];
}

static bool carry_alone(shooting *s, size_t j, const double *from, bool derivatives) {
    double *end = s->ends + j * s->dimension;
    whirl_integrator *integrator = s->integrators[j % s->part_count];
    memcpy(end, from, s->dimension * sizeof *end);
    if (!derivatives) return whirl_integrator_revolve(integrator, end, NULL, NULL) == WHIRL_BOUNDED;
    whirl_perturbations *columns = begin_columns(s, j);
    if (whirl_integrator_carry(integrator, end, columns, NULL, NULL) != WHIRL_BOUNDED) return false;
    take_columns(s, j, columns);
    return true;
}

// ---------------------------------------------------------------- side by side

/// Places segment j of a machine in a lane.
static void shooting_place(const shooting *s, whirl_ensemble *lanes, size_t lane, size_t j, const double *from) {
    const part *p = &s->parts[j % s->part_count];
    whirl_ensemble_part(lanes, lane, s->revolutions > 0 ? p->from : 0.0, p->stretch * p->own.period);
    whirl_ensemble_place(lanes, lane, from);
}

/// Makes lanes for motions of other machines, unless they exist. Returns false if lanes do not carry such motions.
static bool has_motion_lanes(shooting *s) {
    const size_t some = MAX_MACHINES * s->count, lanes = some > MAX_ABREAST ? some : MAX_ABREAST;
    if (!s->lanes || s->motion_lanes) return s->motion_lanes;
    return whirl_ensemble_flow(s->first, &s->integrate, lanes, 0, &s->motion_lanes).code == WHIRL_OK;
}

/// Carries `count` segments from segment `first` on, in lanes.
static bool carry_in_lanes(shooting *s, size_t first, size_t count, const double *nodes, bool derivatives) {
    const size_t d = s->dimension;
    bool good = true;
    for (size_t i = 0; i < count; i++) {
        shooting_place(s, s->lanes, i, first + i, nodes + (first + i) * d);
        if (derivatives) whirl_ensemble_carry(s->lanes, i, begin_columns(s, first + i));
    }
    whirl_ensemble_revolve(s->lanes, count, NULL);
    for (size_t i = 0; i < count; i++) {
        whirl_ensemble_state(s->lanes, i, s->ends + (first + i) * d);
        good = good && whirl_ensemble_motion(s->lanes, i) == WHIRL_BOUNDED;
        if (derivatives) take_columns(s, first + i, &s->columns[first + i]);
    }
    return good;
}

static bool shooting_carry_segments(shooting *s, size_t first, size_t count, const double *nodes, bool derivatives) {
    bool good = true;
    if (s->lanes) return carry_in_lanes(s, first, count, nodes, derivatives);
    for (size_t j = first; j < first + count && good; j++)
        good = carry_alone(s, j, nodes + j * s->dimension, derivatives);
    return good;
}

static void shooting_stretch(shooting *s, double period) {
    for (size_t j = 0; s->revolutions == 0 && j < s->part_count; j++) s->parts[j].stretch = period / s->period;
}

bool shooting_carry(shooting *s, const double *nodes, double period, bool derivatives) {
    shooting_stretch(s, period);
    s->volume = 0.0;
    return shooting_carry_segments(s, 0, s->count, nodes, derivatives);
}

// ---------------------------------------------------------------- other machines

bool shooting_renew(shooting *s, const whirl_system *system) {
    if (!s->lanes || system->dimension != s->dimension) return false;
    for (size_t j = 0; j < s->count; j++)
        if (whirl_ensemble_load(s->lanes, j, system, s->ends).code != WHIRL_OK) return false;
    for (size_t j = 0; j < s->part_count; j++) {
        const part *p = &s->parts[j];
        part_of(&s->parts[j], system, p->from, p->own.period, p->stretch);
    }
    s->system = system;
    return true;
}

bool shooting_carry_machines(shooting *s, size_t count, const whirl_system *const *systems, const double *nodes,
                             double period, double *ends) {
    const size_t d = s->dimension, lanes = count * s->count;
    if (count > MAX_MACHINES || !has_motion_lanes(s)) return false;
    shooting_stretch(s, period);
    for (size_t lane = 0; lane < lanes; lane++) {
        const size_t j = lane % s->count;
        if (whirl_ensemble_load(s->motion_lanes, lane, systems[lane / s->count], nodes + j * d).code != WHIRL_OK)
            return false;
        shooting_place(s, s->motion_lanes, lane, j, nodes + j * d);
    }
    whirl_ensemble_revolve(s->motion_lanes, lanes, NULL);
    for (size_t lane = 0; lane < lanes; lane++) {
        whirl_ensemble_state(s->motion_lanes, lane, ends + lane * d);
        if (whirl_ensemble_motion(s->motion_lanes, lane) != WHIRL_BOUNDED) return false;
    }
    return true;
}

// ---------------------------------------------------------------- the whole map

static bool map_in_lanes(shooting *s, size_t count, double *x, double period) {
    const size_t d = s->dimension, revolutions = s->revolutions > 0 ? s->revolutions : 1;
    bool good = true;
    for (size_t i = 0; i < count && good; i++)
        good = whirl_ensemble_load(s->motion_lanes, i, s->system, x + i * d).code == WHIRL_OK;
    for (size_t i = 0; i < count && good; i++)
        whirl_ensemble_part(s->motion_lanes, i, 0.0, s->revolutions > 0 ? s->system->period : period);
    for (size_t i = 0; i < revolutions && good; i++) whirl_ensemble_revolve(s->motion_lanes, count, NULL);
    for (size_t i = 0; i < count && good; i++) {
        whirl_ensemble_state(s->motion_lanes, i, x + i * d);
        good = whirl_ensemble_motion(s->motion_lanes, i) == WHIRL_BOUNDED;
    }
    return good;
}

bool shooting_map(shooting *s, size_t count, double *x, double period) {
    shooting_stretch(s, period);
    if (has_motion_lanes(s)) return map_in_lanes(s, count, x, period);
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j < s->count; j++)
            if (s->lanes || whirl_integrator_revolve(s->integrators[j % s->part_count], x + i * s->dimension, NULL,
                                                     NULL) != WHIRL_BOUNDED)
                return false;
    return true;
}

/// Passes on the observations of a segment at times of the whole orbit.
typedef struct part_observer {
    double before, stretch; ///< the orbit's time at the segment's start; the orbit's time per unit of the part's time
    whirl_observe_fn observe;
    void *observer;
} part_observer;

static void observe_part(void *context, double t, const double *x) {
    const part_observer *o = context;
    o->observe(o->observer, o->before + o->stretch * t, x);
}

static bool observe_alone(shooting *s, const double *nodes, part_observer *o, double length) {
    for (size_t j = 0; j < s->count; j++) {
        double *x = s->ends + j * s->dimension;
        o->before = length * (double)j;
        memcpy(x, nodes + j * s->dimension, s->dimension * sizeof *x);
        if (whirl_integrator_revolve(s->integrators[j % s->part_count], x, observe_part, o) != WHIRL_BOUNDED)
            return false;
    }
    return true;
}

/// Observations of all segments at once, to be passed on segment by segment.
typedef struct lane_watch {
    const shooting *s;
    double *next; ///< [instants][segments][dimension]
} lane_watch;

static void keep_sample(void *context) {
    lane_watch *w = context;
    for (size_t j = 0; j < w->s->count; j++, w->next += w->s->dimension) whirl_ensemble_state(w->s->lanes, j, w->next);
}

static bool observe_in_lanes(shooting *s, const double *nodes, const part_observer *o, double length) {
    const size_t d = s->dimension, instants = (size_t)s->integrate.steps_per_revolution;
    double *samples = malloc((instants * s->count * d + 1) * sizeof *samples);
    lane_watch watch = {s, samples};
    const whirl_ensemble_observe all = {.stride = 1, .sample = keep_sample, .context = &watch};
    bool good = samples != NULL;
    for (size_t j = 0; j < s->count && good; j++) shooting_place(s, s->lanes, j, j, nodes + j * d);
    if (good) whirl_ensemble_revolve(s->lanes, s->count, &all);
    for (size_t j = 0; j < s->count && good; j++) good = whirl_ensemble_motion(s->lanes, j) == WHIRL_BOUNDED;
    for (size_t j = 0; j < s->count && good; j++)
        for (size_t i = 0; i < instants; i++)
            o->observe(o->observer, length * ((double)j + (double)(i + 1) / (double)instants),
                       samples + (i * s->count + j) * d);
    free(samples);
    return good;
}

bool shooting_observe(shooting *s, const double *nodes, double period, whirl_observe_fn observe, void *observer) {
    const double length = period / (double)s->count;
    part_observer o = {
        .stretch = s->revolutions > 0 ? 1.0 : period / s->period, .observe = observe, .observer = observer};
    shooting_stretch(s, period);
    return s->lanes ? observe_in_lanes(s, nodes, &o, length) : observe_alone(s, nodes, &o, length);
}

bool shooting_bounds(shooting *s, const double *nodes, double period, double *low, double *high) {
    // Make memory for the bounds of one segment.
    const whirl_ensemble_observe watch = {.extremes = true};
    const size_t d = s->dimension;
    double *lowest = malloc((2 * d + 1) * sizeof *lowest), *highest = lowest ? lowest + d : NULL;
    const whirl_ensemble_seen seen = {.low = lowest, .high = highest};
    bool good = s->lanes && lowest;
    // Carry all segments at once.
    shooting_stretch(s, period);
    for (size_t j = 0; j < s->count && good; j++) {
        shooting_place(s, s->lanes, j, j, nodes + j * d);
        whirl_ensemble_forget(s->lanes, j);
    }
    if (good) whirl_ensemble_revolve(s->lanes, s->count, &watch);
    // Widen the bounds by those of each segment.
    for (size_t j = 0; j < s->count && good; j++) {
        good = whirl_ensemble_motion(s->lanes, j) == WHIRL_BOUNDED;
        whirl_ensemble_read(s->lanes, j, &seen);
        for (size_t i = 0; i < d && good; i++) {
            low[i] = fmin(low[i], lowest[i]);
            high[i] = fmax(high[i], highest[i]);
        }
    }
    free(lowest);
    return good;
}

bool shooting_spread(shooting *s, double *nodes, double period) {
    shooting_stretch(s, period);
    for (size_t j = 0; j + 1 < s->count; j++) {
        if (!shooting_carry_segments(s, j, 1, nodes, false)) return false;
        memcpy(nodes + (j + 1) * s->dimension, s->ends + j * s->dimension, s->dimension * sizeof *nodes);
    }
    return true;
}

void shooting_turn(const shooting *s, double *nodes) {
    const size_t d = s->dimension;
    for (size_t j = 0; s->kept_count < d && j + 1 < s->count; j++)
        for (size_t i = 0; i < d; i++)
            if (turns_on(s->system->turns, i)) nodes[(j + 1) * d + i] = s->ends[j * d + i];
}

void shooting_gap(const shooting *s, const double *nodes, double *gap) {
    const size_t d = s->dimension, n = s->kept_count;
    for (size_t j = 0; j < s->count; j++) {
        const double *next = nodes + (j + 1) % s->count * d;
        for (size_t i = 0; i < n; i++) {
            const double away = s->ends[j * d + s->kept[i]] - next[s->kept[i]];
            gap[j * n + i] = short_way(s->system->angles, s->kept[i], away);
        }
    }
}

void shooting_by_period(const shooting *s, size_t j, double *slope) {
    const whirl_system *system = s->system;
    const part *p = &s->parts[j % s->part_count];
    const double t = p->from + p->stretch * p->own.period;
    double forcing[WHIRL_MAX_FORCING];
    if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
    system->rhs(system->model, t, forcing, s->ends + j * s->dimension, slope);
    for (size_t i = 0; i < s->dimension; i++) slope[i] /= (double)s->count;
}

double shooting_size(const shooting *s, const double *nodes) {
    double size = 0.0;
    for (size_t j = 0; j < s->count; j++)
        for (size_t i = 0; i < s->kept_count; i++) size = fmax(size, fabs(nodes[j * s->dimension + s->kept[i]]));
    return size;
}
