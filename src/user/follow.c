// Motions of a user's system over time: states at given instants, with events that may reset the state. The system
// needs no period. A motion is followed in legs: the solver carries it over a leg, and events are searched within.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bracket.h"
#include "user.h"

/// SAMPLES: equidistant instants of a leg at which events are looked for. MAX_EVALUATIONS: evaluations of the slopes in
/// a leg up to which these instants are at least as dense as the solver's steps.
enum { SAMPLES = 32, MAX_EVALUATIONS = SAMPLES / 2 * 16 };

/// Largest number of events of a motion.
enum { MAX_HAPPENED = 1000000 };

/// HALVINGS: tries to find a time after an event at which its function has left 0, each half as long. SEARCHES: steps
/// in the search of a zero.
enum { HALVINGS = 60, SEARCHES = 200 };

/// Part of the whole time: if the time between two events of one kind shrinks and is below it, events accumulate.
static const double accumulated = 1e-12;

typedef struct happened {
    size_t which;
    double time;
} happened;

struct whirl_user_motion {
    size_t dimension, count; ///< count: instants that were reached
    double *states;          ///< [count][dimension]
    size_t event_count, capacity;
    happened *events; ///< [event_count]
    double *sides;    ///< [event_count][2][dimension] states before and after
    int end;
    double time;
    char words[256];
};

/// A motion under way.
typedef struct follower {
    const whirl_user_system *from;
    whirl_user_motion *motion;
    whirl_system system;
    whirl_integrator *integrator;
    double *parameters;
    double begin, end;       ///< first and last instant
    double time, leg;        ///< present time; length of the next leg
    double origin;           ///< time at which the present integration begins
    long evaluations;        ///< evaluations of the slopes so far
    double *x;               ///< [dimension] present state, in units of `unit`
    double *unit;            ///< [dimension] scales of the coordinates
    double *samples;         ///< [SAMPLES + 1][dimension] states of the leg
    double *there, *found;   ///< [dimension] workspace
    double *user;            ///< [dimension] a state in the user's units
    size_t sample;           ///< next sample
    double *before, *offset; ///< [event_count] value of an event's function near the beginning of a leg, and how long
                             ///< after the beginning it was taken
    double *last, *between;  ///< [event_count] time of the last event of a kind, and the time between the last two
    size_t stays; ///< event whose function stays 0 after its reset, so that the motion stops; event_count: none
    bool failed;
} follower;

static void follow_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    follower *f = *(follower *const *)model;
    const whirl_user_system *from = f->from;
    const size_t n = from->dimension;
    const double time = f->origin + t;
    (void)forcing;
    f->evaluations++;
    for (size_t k = 0; k < n; k++) f->user[k] = x[k] * f->unit[k];
    const int code = f->failed     ? 1
                     : from->lanes ? from->lanes(1, 1, &time, f->user, f->parameters, dxdt, from->context)
                                   : from->rates(time, f->user, f->parameters, dxdt, from->context);
    for (size_t k = 0; k < n; k++) dxdt[k] = code == 0 ? dxdt[k] / f->unit[k] : (double)NAN;
    if (code == 0 || f->failed) return;
    f->failed = true;
    snprintf(f->motion->words, sizeof f->motion->words, "a function of the system gave %d at t = %.10g", code, time);
}

static void follow_keep(void *context, double t, const double *x) {
    follower *f = context;
    (void)t;
    memcpy(f->samples + f->sample++ * f->from->dimension, x, f->from->dimension * sizeof *x);
}

/// Integrates x from the time `from` over `length`; seen: writes the samples.
static whirl_motion follow_carry(follower *f, double from, double length, double *x, bool seen) {
    if (!(length > 0.0)) return WHIRL_BOUNDED;
    f->origin = from;
    f->system.period = length;
    f->sample = 1;
    if (seen) memcpy(f->samples, x, f->from->dimension * sizeof *x);
    return whirl_integrator_revolve(f->integrator, x, seen ? follow_keep : NULL, f);
}

/// Returns the value of an event's function at a state; 0 after a failure.
static double follow_value(follower *f, size_t event, double time, const double *x) {
    const user_event *own = &f->from->events[event];
    for (size_t k = 0; k < f->from->dimension; k++) f->user[k] = x[k] * f->unit[k];
    const double value = f->failed ? 0.0 : own->value(time, f->user, f->parameters, own->context);
    if (!isnan(value)) return value;
    f->failed = true;
    snprintf(f->motion->words, sizeof f->motion->words, "the function of event '%s' is no number at t = %.10g",
             own->name, time);
    return 0.0;
}

/// Returns true if the event happens where its function goes from `before` to `after`.
static bool follow_passes(const user_event *own, double before, double after) {
    return (own->passing >= 0 && before < 0.0 && after >= 0.0) || (own->passing <= 0 && before > 0.0 && after <= 0.0);
}

/// Returns true if the function of an event leaves 0 as the square of time, after a reset that stops the motion.
static bool follow_grazes(follower *f, size_t event, double step) {
    double value[2];
    for (int i = 0; i < 2; i++, step *= 0.5) {
        memcpy(f->there, f->x, f->from->dimension * sizeof *f->x);
        if (follow_carry(f, f->time, step, f->there, false) != WHIRL_BOUNDED) return false;
        value[i] = follow_value(f, event, f->time + step, f->there);
    }
    return fabs(value[0]) > 3.0 * fabs(value[1]) || value[0] == 0.0;
}

/// Sets before and offset of an event: the value of its function when a leg begins. If the event has just happened, the
/// function is 0 there: then the value is taken a short time later, and its sign is the side to which the motion
/// leaves.
static void follow_begin_side(follower *f, size_t event, double step) {
    const user_event *own = &f->from->events[event];
    f->offset[event] = 0.0;
    f->before[event] = follow_value(f, event, f->time, f->x);
    if (f->last[event] != f->time) return;
    // Halve the time until the event does not happen again within it.
    f->before[event] = 0.0;
    const double longest = step;
    for (int i = 0; i < HALVINGS && f->before[event] == 0.0; i++, step *= 0.5) {
        memcpy(f->there, f->x, f->from->dimension * sizeof *f->x);
        if (follow_carry(f, f->time, step, f->there, false) != WHIRL_BOUNDED) return;
        const double next = follow_value(f, event, f->time + step, f->there);
        if (own->passing == 0 ? i < HALVINGS / 2 : follow_passes(own, -next, next)) continue;
        f->before[event] = next;
        f->offset[event] = step;
    }
    if (f->before[event] == 0.0 && own->reset && follow_grazes(f, event, longest / 1024.0)) f->stays = event;
}

/// Returns the time after `from` at which an event's function passes 0 within a bracket; `state` is the state at
/// `from`. Writes the state there to f->there.
static double follow_find(follower *f, size_t event, double from, const double *state, bracket between) {
    const size_t n = f->from->dimension;
    double at = between.b;
    for (int i = 0; i < SEARCHES && bracket_width(&between) > 4e-16 * fmax(fabs(from), between.b); i++) {
        at = bracket_next(&between);
        memcpy(f->there, state, n * sizeof *state);
        if (follow_carry(f, from, at, f->there, false) != WHIRL_BOUNDED) break;
        const double value = follow_value(f, event, from + at, f->there);
        if (value == 0.0) return at;
        bracket_update(&between, at, value);
    }
    at = between.b;
    memcpy(f->there, state, n * sizeof *state);
    follow_carry(f, from, at, f->there, false);
    return at;
}

/// Returns the first event of a leg; event_count if there is none. Writes the time from the beginning of the leg to
/// *at, and the state there to f->there.
static size_t follow_first(follower *f, double length, double *at) {
    const size_t n = f->from->dimension, events = f->from->event_count;
    const double step = length / SAMPLES;
    size_t first = events;
    // Look at each event in the samples up to the earliest event found so far.
    for (size_t e = 0; e < events; e++) {
        double before = f->before[e];
        for (size_t k = 0; k < SAMPLES; k++) {
            const double begin = (double)k * step, offset = k == 0 ? f->offset[e] : 0.0;
            const double after = follow_value(f, e, f->time + begin + step, f->samples + (k + 1) * n);
            if (first < events && begin > *at) break;
            // Locate a passage within its sample, and keep it if it is the first.
            if (follow_passes(&f->from->events[e], before, after)) {
                const double place = begin + follow_find(f, e, f->time + begin, f->samples + k * n,
                                                         bracket_between(offset, before, step, after));
                if (first == events || place < *at) {
                    first = e;
                    *at = place;
                    memcpy(f->found, f->there, n * sizeof *f->found);
                }
                break;
            }
            before = after;
        }
    }
    if (first < events) memcpy(f->there, f->found, n * sizeof *f->found);
    return first;
}

/// Notes an event and resets the state, if the event has a reset. Returns a sentence if the motion ends here, else
/// NULL.
static const char *follow_happen(follower *f, size_t event) {
    whirl_user_motion *m = f->motion;
    const user_event *own = &f->from->events[event];
    const size_t n = f->from->dimension;
    // Make room for the event and its two states.
    if (m->event_count == m->capacity) {
        const size_t capacity = 2 * m->capacity + 64;
        happened *events = realloc(m->events, capacity * sizeof *events);
        if (events) m->events = events;
        double *sides = realloc(m->sides, 2 * n * capacity * sizeof *sides);
        if (sides) m->sides = sides;
        if (!events || !sides) return "no memory for more events";
        m->capacity = capacity;
    }
    // Store the state before, reset it, and store the state after.
    double *before = m->sides + 2 * n * m->event_count, *after = before + n;
    for (size_t k = 0; k < n; k++) before[k] = after[k] = f->x[k] * f->unit[k];
    m->events[m->event_count++] = (happened){event, f->time};
    const int code = own->reset ? own->reset(f->time, before, f->parameters, after, own->context) : 0;
    for (size_t k = 0; k < n; k++) {
        f->x[k] = after[k] / f->unit[k];
        if (!isfinite(after[k])) f->failed = true;
    }
    if (code != 0 || f->failed) {
        f->failed = true;
        snprintf(m->words, sizeof m->words, "the reset at event '%s' gave %s at t = %.10g", own->name,
                 code != 0 ? "an error" : "a number that is not finite", f->time);
        return m->words;
    }
    // Events of one kind that come faster and faster end a motion. Its end is predicted as that of a geometric series.
    const double passed = f->time - f->last[event], before_that = f->between[event];
    f->last[event] = f->time;
    f->between[event] = passed;
    if (passed < before_that && passed < accumulated * (f->end - f->begin)) {
        const double ratio = passed / before_that, left = ratio < 1.0 ? passed * ratio / (1.0 - ratio) : 0.0;
        m->end = WHIRL_USER_ACCUMULATED;
        snprintf(m->words, sizeof m->words, "events '%s' come faster and faster, towards t = %.12g", own->name,
                 f->time + left);
        return m->words;
    }
    if (m->event_count == MAX_HAPPENED) {
        m->end = WHIRL_USER_ACCUMULATED;
        snprintf(m->words, sizeof m->words, "the motion has %d events", MAX_HAPPENED);
        return m->words;
    }
    // An event may end the motion.
    if (!own->ends) return NULL;
    m->end = WHIRL_USER_EVENT;
    snprintf(m->words, sizeof m->words, "event '%s'", own->name);
    return m->words;
}

/// Writes the states at the requested instants of a leg, up to its end.
static whirl_motion follow_show(follower *f, const double *times, size_t count, double length) {
    whirl_user_motion *m = f->motion;
    const size_t n = f->from->dimension;
    const double step = length / SAMPLES;
    for (; m->count < count && times[m->count] <= f->time + length; m->count++) {
        const double passed = times[m->count] - f->time;
        size_t k = step > 0.0 ? (size_t)(passed / step) : 0;
        if (k > SAMPLES) k = SAMPLES;
        const double *state = step > 0.0 ? f->samples + k * n : f->x;
        memcpy(f->there, state, n * sizeof *state);
        const whirl_motion motion =
            follow_carry(f, f->time + (double)k * step, passed - (double)k * step, f->there, false);
        if (motion != WHIRL_BOUNDED) return motion;
        for (size_t i = 0; i < n; i++) m->states[m->count * n + i] = f->there[i] * f->unit[i];
    }
    return WHIRL_BOUNDED;
}

/// Integrates `next` over the next leg, with samples at least as dense as the steps, and writes the leg's length.
static whirl_motion follow_leg(follower *f, double *length, double *next) {
    const double left = f->end - f->time;
    for (int tries = 0;; tries++) {
        const long before = f->evaluations;
        *length = fmin(f->leg, left);
        memcpy(next, f->x, f->from->dimension * sizeof *next);
        const whirl_motion motion = follow_carry(f, f->time, *length, next, true);
        const double used = (double)(f->evaluations - before) / MAX_EVALUATIONS;
        f->leg = *length * fmin(4.0, fmax(0.1, 0.8 / used));
        if (tries == 12 || f->failed || (motion == WHIRL_BOUNDED && used <= 1.5)) return motion;
    }
}

/// Follows the motion to its end.
static void follow_all(follower *f, const double *times, size_t count, double *next) {
    whirl_user_motion *m = f->motion;
    const whirl_user_system *from = f->from;
    const size_t n = from->dimension, events = from->event_count;
    const char *ended = NULL;
    follow_show(f, times, count, 0.0);
    while (f->time < f->end && !ended) {
        double length, at = 0.0;
        whirl_motion motion = follow_leg(f, &length, next);
        // Find the sides on which the functions of events begin; a motion that stays at an event ends.
        for (size_t e = 0; e < events && motion == WHIRL_BOUNDED; e++) follow_begin_side(f, e, length / SAMPLES);
        if (f->stays < events) {
            m->end = WHIRL_USER_ACCUMULATED;
            snprintf(m->words, sizeof m->words, "after event '%s' the motion stays where it happens",
                     from->events[f->stays].name);
            break;
        }
        // Find the first event, and end the leg there.
        const size_t event = motion == WHIRL_BOUNDED ? follow_first(f, length, &at) : events;
        if (event < events) {
            length = at;
            memcpy(next, f->there, n * sizeof *next);
            memcpy(f->found, f->x, n * sizeof *f->found);
            if (at > 0.0) motion = follow_carry(f, f->time, at, f->found, true);
        }
        // Write the states at instants of the leg; a motion that diverges or fails ends.
        if (motion == WHIRL_BOUNDED) motion = follow_show(f, times, count, length);
        if (motion != WHIRL_BOUNDED || f->failed) {
            m->end = motion == WHIRL_DIVERGED && !f->failed ? WHIRL_USER_DIVERGED : WHIRL_USER_STUCK;
            if (!*m->words)
                snprintf(m->words, sizeof m->words, "%s",
                         m->end == WHIRL_USER_DIVERGED ? "the motion left its bounds" : "the solver could not go on");
            break;
        }
        // Go on from the end of the leg; the next one is not much longer than the time to this event.
        memcpy(f->x, next, n * sizeof *next);
        f->time = event == events && length == f->end - f->time ? f->end : f->time + length;
        if (event == events) continue;
        ended = follow_happen(f, event);
        f->leg = fmin(f->leg, 4.0 * length + 1e-12 * (f->end - f->begin));
    }
    m->time = f->time;
}

/// Checks that the system has slopes, and that the instants are numbers that rise.
static whirl_status follow_check(const whirl_user_system *system, const double *times, size_t count) {
    if (!system->rates && !system->lanes)
        return whirl_fail(WHIRL_BAD_INPUT, "the system has no slopes, expected a function of them");
    if (count < 2) return whirl_fail(WHIRL_BAD_INPUT, "a motion has %zu instants, expected at least 2", count);
    for (size_t i = 0; i < count; i++)
        if (!isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1])))
            return whirl_fail(WHIRL_BAD_INPUT, "instant %zu of the motion is %.10g, expected instants that rise", i,
                              times[i]);
    return user_check_form(system);
}

/// Returns the options of the integrator: those of the system, with an adaptive method.
static whirl_integrate_options follow_options(const whirl_user_system *system) {
    whirl_integrate_options options = system->integrate;
    const bool fixed = !whirl_method_is_adaptive(options.method);
    if (fixed) snprintf(options.method, sizeof options.method, "dop853");
    options.steps_per_revolution = SAMPLES;
    return options;
}

whirl_status whirl_user_system_follow(const whirl_user_system *system, const double *times, size_t count,
                                      whirl_user_motion **out) {
    *out = NULL;
    whirl_status status = follow_check(system, times, count);
    if (status.code != WHIRL_OK) return status;
    const size_t n = system->dimension, events = system->event_count;
    const whirl_integrate_options options = follow_options(system);
    follower f = {.from = system, .begin = times[0], .end = times[count - 1], .time = times[0], .stays = events};
    follower *self = &f;
    whirl_user_motion *m = f.motion = calloc(1, sizeof *m);
    double *numbers = calloc((SAMPLES + 1 + 6) * n + 4 * events + system->parameter_count + 1, sizeof *numbers);
    if (m) m->states = calloc(count * n, sizeof *m->states);
    if (!m || !numbers || !m->states) {
        free(numbers);
        whirl_user_motion_free(m);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a motion");
    }
    // Share out the workspace; the state is in units of the coordinates' scales.
    f.x = numbers, f.unit = f.x + n, f.there = f.unit + n, f.user = f.there + n, f.found = f.user + n;
    double *next = f.found + n;
    f.samples = next + n;
    f.before = f.samples + (SAMPLES + 1) * n, f.offset = f.before + events, f.last = f.offset + events;
    f.between = f.last + events, f.parameters = f.between + events;
    for (size_t k = 0; k < n; k++) {
        f.unit[k] = system->scales && system->scales[k] > 0.0 ? system->scales[k] : 1.0;
        f.x[k] = system->start[k] / f.unit[k];
    }
    for (size_t e = 0; e < events; e++) f.last[e] = -(double)INFINITY, f.between[e] = (double)INFINITY;
    for (size_t k = 0; k < system->parameter_count; k++) f.parameters[k] = system->parameters[k].value;
    f.leg = (f.end - f.begin) / (double)SAMPLES;
    f.system = (whirl_system){.dimension = n, .period = f.leg, .rhs = follow_rhs, .model = &self};
    m->dimension = n;
    status = whirl_integrator_new(&f.system, &options, &f.integrator);
    if (status.code == WHIRL_OK) {
        follow_all(&f, times, count, next);
        whirl_integrator_free(f.integrator);
    }
    if (f.failed) status = whirl_fail(WHIRL_NUMERICAL_FAILURE, "%s, expected 0 and finite numbers", m->words);
    free(numbers);
    if (status.code == WHIRL_OK)
        *out = m;
    else
        whirl_user_motion_free(m);
    return status;
}

void whirl_user_motion_free(whirl_user_motion *motion) {
    if (!motion) return;
    free(motion->states);
    free(motion->events);
    free(motion->sides);
    free(motion);
}

const double *whirl_user_motion_states(const whirl_user_motion *motion, size_t *count) {
    *count = motion->count;
    return motion->states;
}

size_t whirl_user_motion_events(const whirl_user_motion *motion) {
    return motion->event_count;
}

int whirl_user_motion_event(const whirl_user_motion *motion, size_t index, size_t *which, double *time,
                            const double **before, const double **after) {
    if (index >= motion->event_count) return 0;
    *which = motion->events[index].which;
    *time = motion->events[index].time;
    *before = motion->sides + 2 * motion->dimension * index;
    *after = *before + motion->dimension;
    return 1;
}

int whirl_user_motion_end(const whirl_user_motion *motion, double *time, const char **words) {
    *time = motion->time;
    *words = motion->words;
    return motion->end;
}

whirl_status whirl_user_system_event(whirl_user_system *system, const char *name, whirl_user_event_fn value,
                                     int passing, whirl_user_reset_fn reset, int ends, void *context) {
    if (!value) return whirl_fail(WHIRL_BAD_INPUT, "the event '%.63s' has no function, expected one", name);
    if (passing < -1 || passing > 1)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the event '%.63s' has passing %d, expected 1 for rising, -1 for falling, 0 "
                          "for both",
                          name, passing);
    if (ends && reset)
        return whirl_fail(WHIRL_BAD_INPUT, "the event '%.63s' ends the motion and has a reset, expected one of both",
                          name);
    if (system->event_count == USER_MAX_EVENTS)
        return whirl_fail(WHIRL_BAD_INPUT, "there are more than %d events", USER_MAX_EVENTS);
    user_event *more = realloc(system->events, (system->event_count + 1) * sizeof *more);
    if (!more) return whirl_fail(WHIRL_NO_MEMORY, "no memory for an event");
    system->events = more;
    user_event *own = &more[system->event_count++];
    *own = (user_event){.value = value, .reset = reset, .passing = passing, .ends = ends != 0, .context = context};
    snprintf(own->name, sizeof own->name, "%s", name);
    whirl_make_plain(own->name);
    return whirl_ok();
}
