#include "shooting.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "turns.h"

static whirl_status check(const whirl_system *system, const whirl_orbit_options *options, size_t revolutions,
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

static whirl_status make_parts(shooting *s, const whirl_orbit_options *options) {
    const double whole = s->revolutions > 0 ? s->system->period : s->period;
    const double length = whole / (double)s->part_count;
    whirl_integrate_options own = options->integrate;
    whirl_status status = whirl_ok();
    own.steps_per_revolution = (own.steps_per_revolution + (int)s->part_count - 1) / (int)s->part_count;
    for (size_t j = 0; j < s->part_count && status.code == WHIRL_OK; j++) {
        part_of(&s->parts[j], s->system, length * (double)j, length, 1.0);
        status = whirl_integrator_new(&s->parts[j].own, &own, &s->integrators[j]);
        if (status.code == WHIRL_OK) status = whirl_integrator_follow(s->integrators[j], s->kept_count);
    }
    return status;
}

static bool allocate(shooting *s) {
    const size_t d = s->dimension;
    s->kept = calloc(d + 1, sizeof *s->kept);
    for (size_t i = 0; s->kept && i < d; i++)
        if (!turns_on(s->system->turns, i)) s->kept[s->kept_count++] = i;
    const size_t n = s->kept_count;
    s->parts = calloc(s->part_count, sizeof *s->parts);
    s->integrators = calloc(s->part_count, sizeof *s->integrators);
    s->unit = calloc(2 * n * d + s->count * (d + n * n) + 1, sizeof *s->unit);
    if (!s->kept || !s->parts || !s->integrators || !s->unit) return false;
    s->vectors = s->unit + n * d;
    s->ends = s->vectors + n * d;
    s->matrices = s->ends + s->count * d;
    for (size_t i = 0; i < n; i++) s->unit[i * d + s->kept[i]] = 1.0;
    return true;
}

whirl_status shooting_new(const whirl_system *system, const whirl_orbit_options *options, size_t revolutions,
                          double period, shooting **out) {
    *out = NULL;
    whirl_status status = check(system, options, revolutions, period);
    if (status.code != WHIRL_OK) return status;
    shooting *s = calloc(1, sizeof *s);
    const bool rests = revolutions == 0 && period == 0.0;
    const size_t parts = rests ? 1 : (size_t)options->segments;
    if (!s) return whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit of %zu segments", parts);
    *s = (shooting){.system = system,
                    .dimension = system->dimension,
                    .revolutions = revolutions,
                    .period = revolutions > 0 ? system->period * (double)revolutions : period,
                    .part_count = parts,
                    .count = parts * (revolutions > 0 ? revolutions : 1)};
    if (!allocate(s)) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit of %zu segments", parts);
    if (status.code == WHIRL_OK && !rests) status = make_parts(s, options);
    if (status.code == WHIRL_OK)
        *out = s;
    else
        shooting_free(s);
    return status;
}

void shooting_free(shooting *s) {
    if (!s) return;
    for (size_t j = 0; s->integrators && j < s->part_count; j++) whirl_integrator_free(s->integrators[j]);
    free(s->integrators);
    free(s->parts);
    free(s->unit);
    free(s->kept);
    free(s);
}

/// Carries one segment from `from` to its end, with its derivative where it is wanted.
static bool carry_segment(shooting *s, size_t j, const double *from, bool derivatives) {
    const size_t d = s->dimension, n = s->kept_count;
    double *end = s->ends + j * d, *matrix = s->matrices + j * n * n;
    whirl_integrator *integrator = s->integrators[j % s->part_count];
    memcpy(end, from, d * sizeof *end);
    if (!derivatives) return whirl_integrator_revolve(integrator, end, NULL, NULL) == WHIRL_BOUNDED;
    whirl_disturbances all = {.count = n, .vectors = s->vectors};
    memcpy(s->vectors, s->unit, n * d * sizeof *s->vectors);
    if (whirl_integrator_carry(integrator, end, &all, NULL, NULL) != WHIRL_BOUNDED) return false;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) matrix[i * n + k] = s->vectors[k * d + s->kept[i]];
    s->volume += all.volume;
    return true;
}

static void stretch(shooting *s, double period) {
    for (size_t j = 0; s->revolutions == 0 && j < s->part_count; j++) s->parts[j].stretch = period / s->period;
}

bool shooting_carry(shooting *s, const double *nodes, double period, bool derivatives) {
    stretch(s, period);
    s->volume = 0.0;
    for (size_t j = 0; j < s->count; j++)
        if (!carry_segment(s, j, nodes + j * s->dimension, derivatives)) return false;
    return true;
}

/// Tells of a part as of the whole.
typedef struct part_observer {
    double before, stretch; ///< the orbit's time when the segment begins, and of a unit of the part's
    whirl_observe_fn observe;
    void *observer;
} part_observer;

static void observe_part(void *context, double t, const double *x) {
    const part_observer *o = context;
    o->observe(o->observer, o->before + o->stretch * t, x);
}

bool shooting_observe(shooting *s, const double *nodes, double period, whirl_observe_fn observe, void *observer) {
    part_observer o = {
        .stretch = s->revolutions > 0 ? 1.0 : period / s->period, .observe = observe, .observer = observer};
    stretch(s, period);
    for (size_t j = 0; j < s->count; j++) {
        double *x = s->ends + j * s->dimension;
        o.before = period / (double)s->count * (double)j;
        memcpy(x, nodes + j * s->dimension, s->dimension * sizeof *x);
        if (whirl_integrator_revolve(s->integrators[j % s->part_count], x, observe_part, &o) != WHIRL_BOUNDED)
            return false;
    }
    return true;
}

bool shooting_spread(shooting *s, double *nodes, double period) {
    stretch(s, period);
    for (size_t j = 0; j + 1 < s->count; j++) {
        if (!carry_segment(s, j, nodes + j * s->dimension, false)) return false;
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
        for (size_t i = 0; i < n; i++) gap[j * n + i] = s->ends[j * d + s->kept[i]] - next[s->kept[i]];
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
