// A run turn by turn: from standstill by time to the first whole turn, from then on by the angle; events are landed on.
#include "runup.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double two_pi = 6.283185307179586476925;

/// What ends a search for an instant: the part of what was to be divided that is left.
static const double located = 1e-14;

typedef struct runner {
    whirl_running *machine;
    const runup_plan *plan;
    const whirl_system *system; ///< by the angle
    whirl_integrator *turn, *part, *timed;
    size_t rotor, dimension; ///< of the rotor's state, and with speed and time
    size_t probes, contacts;
    double unit;
    whirl_turning how;
    double *x;                       ///< [dimension] now
    double *begin;                   ///< [dimension] at the beginning of the turn
    double *samples;                 ///< [samples + 1][dimension] of the turn
    double *scratch;                 ///< [3][dimension]
    double *force;                   ///< [samples + 1][contacts] normal forces of the turn
    double *largest, *share;         ///< [contacts] of the turn
    runup_station *stations;         ///< [probes] of the turn
    double turns, angle0;            ///< whole turns behind, and the angle of the first state
    double *peak_state;              ///< [probes][dimension] the sample before the largest radius
    double *peak_from, *peak_length; ///< [probes] its angle, and how far the sample after it is
    runup_run *run;
} runner;

static double runup_speed_of(const runner *r, const double *x) {
    return x[r->rotor] * r->unit;
}
static double runup_time_of(const runner *r, const double *x) {
    return x[r->rotor + 1] / r->unit;
}

static bool runup_stopped(const runner *r) {
    return r->plan->integrate.stop && whirl_integrate_stopped(&r->plan->integrate);
}

// ---------------------------------------------------------------- carrying

typedef struct sampler {
    runner *r;
    size_t next;
} sampler;

static void runup_keep_sample(void *context, double t, const double *x) {
    sampler *s = context;
    (void)t;
    memcpy(s->r->samples + s->next++ * s->r->dimension, x, s->r->dimension * sizeof *x);
}

/// Carries x from an angle over a length.
static whirl_motion runup_carry_part(runner *r, double from, double length, double *x) {
    if (length <= 0.0) return WHIRL_BOUNDED;
    r->machine->part(r->machine, from, length);
    return whirl_integrator_revolve(r->part, x, NULL, NULL);
}

/// The same with all samples.
static whirl_motion runup_carry_seen(runner *r, double from, double length, double *x) {
    sampler s = {r, 1};
    memcpy(r->samples, x, r->dimension * sizeof *x);
    r->machine->part(r->machine, from, length);
    return whirl_integrator_revolve(r->turn, x, runup_keep_sample, &s);
}

/// A number of a state: of its station or switch `which`, where it has one.
typedef double quantity(const runner *r, const double *x, size_t which);

/// Finds where a quantity passes a target on the way of `length` from `state` at the angle `from` on (regula falsi
/// after Dowell and Jarratt 1971, "Illinois"). low, high: its values at both ends, on different sides of the target.
/// Gives the length of the way up to there, and the state there.
static double runup_find_passage(runner *r, quantity *of, size_t which, double target, const double *state, double from,
                                 double length, double low, double high, double *there) {
    double a = 0.0, b = length, fa = low - target, fb = high - target, at = fa == 0.0 ? 0.0 : length;
    int side = 0;
    for (int i = 0; i < 80 && fa * fb < 0.0 && b - a > located * length; i++) {
        const double before = at;
        at = (a * fb - b * fa) / (fb - fa);
        if (!(at > a && at < b)) at = 0.5 * (a + b);
        memcpy(there, state, r->dimension * sizeof *there);
        if (runup_carry_part(r, from, at, there) != WHIRL_BOUNDED) break;
        const double f = of(r, there, which) - target;
        if (f == 0.0 || fabs(at - before) < located * length) return at;
        if ((f < 0.0) == (fb < 0.0)) {
            b = at, fb = f;
            if (side == -1) fa *= 0.5;
            side = -1;
        } else {
            a = at, fa = f;
            if (side == 1) fb *= 0.5;
            side = 1;
        }
    }
    memcpy(there, state, r->dimension * sizeof *there);
    runup_carry_part(r, from, at, there);
    return at;
}

// ---------------------------------------------------------------- what is seen of a part of a turn

static double runup_radius_of(const runner *r, const double *x, size_t probe) {
    const whirl_probe *p = &r->system->probes[probe];
    return hypot(whirl_probe_value(p, x, 0), whirl_probe_value(p, x, 1));
}

/// Half the slope of the square of the radius.
static double runup_radial_slope(const runner *r, const double *x, size_t probe) {
    const whirl_probe *p = &r->system->probes[probe];
    return whirl_probe_value(p, x, 0) * whirl_probe_value(p, x, 2) +
           whirl_probe_value(p, x, 1) * whirl_probe_value(p, x, 3);
}

static double runup_switch_of(const runner *r, const double *x, size_t which) {
    double values[WHIRL_MAX_SWITCHES];
    r->system->switches(r->system->model, 0.0, x, values);
    return values[which];
}

static const double *runup_sample(const runner *r, size_t k) {
    return r->samples + k * r->dimension;
}

/// Largest radii of the part, and the samples around those that are the largest so far.
static void runup_see_radii(runner *r, double from, double step, size_t count) {
    for (size_t p = 0; p < r->probes; p++)
        for (size_t k = 1; k <= count; k++) {
            const double radius = runup_radius_of(r, runup_sample(r, k), p);
            runup_peak *peak = &r->run->peaks[p];
            r->stations[p].radius = fmax(r->stations[p].radius, radius);
            if (!(radius > peak->radius)) continue;
            const size_t before = k - 1, span = k < count ? 2 : 1;
            *peak = (runup_peak){radius, runup_time_of(r, runup_sample(r, k)), runup_speed_of(r, runup_sample(r, k))};
            memcpy(r->peak_state + p * r->dimension, runup_sample(r, before), r->dimension * sizeof *r->x);
            r->peak_from[p] = from + (double)before * step;
            r->peak_length[p] = (double)span * step;
        }
}

/// A contact that closed or opened between two samples: when that was.
static double runup_find_change(runner *r, size_t contact, const double *state, double from, double length) {
    double *there = r->scratch;
    const size_t which = r->machine->contact_switch(r->machine, contact);
    memcpy(there, state, r->dimension * sizeof *there);
    const double low = runup_switch_of(r, there, which);
    if (runup_carry_part(r, from, length, there) != WHIRL_BOUNDED) return runup_time_of(r, state);
    const double high = runup_switch_of(r, there, which);
    // A damped contact lets go before its gap opens: then the instant is known to the sample.
    if (!(low * high < 0.0)) return runup_time_of(r, there);
    runup_find_passage(r, runup_switch_of, which, 0.0, state, from, length, low, high, there);
    return runup_time_of(r, there);
}

static void runup_see_contacts(runner *r, double from, double step, size_t count) {
    for (size_t k = 0; k <= count && r->contacts > 0; k++)
        r->machine->contacts(r->machine, runup_sample(r, k), r->force + k * r->contacts);
    for (size_t c = 0; c < r->contacts; c++) {
        runup_contact *own = &r->run->contacts[c];
        for (size_t k = 0; k < count; k++) {
            const bool before = r->force[k * r->contacts + c] > 0.0, after = r->force[(k + 1) * r->contacts + c] > 0.0;
            const double begin = runup_time_of(r, runup_sample(r, k)), end = runup_time_of(r, runup_sample(r, k + 1));
            double closed = before && after ? end - begin : 0.0;
            r->largest[c] = fmax(r->largest[c], r->force[(k + 1) * r->contacts + c]);
            if (before != after) {
                const double at = runup_find_change(r, c, runup_sample(r, k), from + (double)k * step, step);
                closed = after ? end - at : at - begin;
                if (after) own->count += 1.0;
                if (after && isnan(own->first)) own->first = at;
                if (!after) own->last = at;
            }
            own->time += closed;
            r->share[c] += closed;
        }
    }
}

/// Weights of the integral over equal steps, of the order 6 at both ends (Gregory).
static double runup_weight(size_t k, size_t count) {
    static const double ends[] = {95.0 / 288.0, 317.0 / 240.0, 23.0 / 30.0, 793.0 / 720.0, 157.0 / 160.0};
    const size_t from_end = k < count - k ? k : count - k;
    return from_end < sizeof ends / sizeof *ends ? ends[from_end] : 1.0;
}

/// Means and orders of a whole turn.
static void runup_see_orders(runner *r, size_t count) {
    for (size_t p = 0; p < r->probes; p++) {
        runup_station *own = &r->stations[p];
        const whirl_probe *probe = &r->system->probes[p];
        *own = (runup_station){.radius = own->radius};
        for (size_t k = 0; k <= count; k++) {
            const double share = runup_weight(k, count) / (double)count;
            const double x = share * whirl_probe_value(probe, runup_sample(r, k), 0);
            const double y = share * whirl_probe_value(probe, runup_sample(r, k), 1);
            own->mean[0] += x;
            own->mean[1] += y;
            for (size_t order = 1; order <= RUNUP_ORDERS; order++) {
                const double complex turned = 2.0 * cexp(-I * two_pi * (double)(order * k % count) / (double)count);
                own->x[order - 1] += turned * x;
                own->y[order - 1] += turned * y;
            }
        }
    }
}

static void runup_begin_turn(runner *r) {
    for (size_t p = 0; p < r->probes; p++) r->stations[p].radius = 0.0;
    for (size_t c = 0; c < r->contacts; c++) r->largest[c] = r->share[c] = 0.0;
}

static void runup_show_turn(runner *r, bool whole) {
    const double end = runup_time_of(r, r->x), begin = runup_time_of(r, r->begin);
    runup_turn turn = {.time = 0.5 * (begin + end),
                       .speed = whole ? two_pi / (end - begin) : runup_speed_of(r, r->x),
                       .end = end,
                       .turns = r->turns,
                       .whole = whole,
                       .stations = r->stations,
                       .force = r->largest,
                       .share = r->share};
    for (size_t c = 0; c < r->contacts; c++) r->share[c] = end > begin ? r->share[c] / (end - begin) : 0.0;
    r->machine->torques(r->machine, r->x, r->angle0, &turn.torques);
    if (r->plan->see) r->plan->see(r->plan->context, &turn);
}

// ---------------------------------------------------------------- events

/// What happens next.
typedef enum event { EVENT_NONE, EVENT_END, EVENT_DWELL, EVENT_TRIP, EVENT_LOSS } event;

/// Something that happens when a quantity passes a target.
typedef struct coming {
    event what;
    quantity *of;
    double target;
} coming;

static double runup_time_quantity(const runner *r, const double *x, size_t which) {
    (void)which;
    return runup_time_of(r, x);
}
static double runup_speed_quantity(const runner *r, const double *x, size_t which) {
    (void)which;
    return runup_speed_of(r, x);
}

/// All that may come in the state that the run is in.
static size_t runup_list_coming(const runner *r, coming list[6]) {
    const whirl_runup_options *o = r->plan->options;
    size_t count = 0;
    if (o->duration > 0.0) list[count++] = (coming){EVENT_END, runup_time_quantity, o->duration};
    if (o->to > 0.0 && (r->how.driven || r->how.rate != 0.0))
        list[count++] =
            (coming){!r->how.driven && o->duration > 0.0 ? EVENT_DWELL : EVENT_END, runup_speed_quantity, o->to};
    if (r->how.driven && !r->how.tripped && o->trip_time > 0.0)
        list[count++] = (coming){EVENT_TRIP, runup_time_quantity, o->trip_time};
    if (r->how.driven && !r->how.tripped && o->trip_speed > 0.0)
        list[count++] = (coming){EVENT_TRIP, runup_speed_quantity, o->trip_speed};
    if (*o->loss_at && !r->how.lost && o->loss_speed > 0.0)
        list[count++] = (coming){EVENT_LOSS, runup_speed_quantity, o->loss_speed};
    if (*o->loss_at && !r->how.lost && o->loss_speed == 0.0)
        list[count++] = (coming){EVENT_LOSS, runup_time_quantity, o->loss_time};
    return count;
}

static bool runup_passes(double target, double before, double after) {
    return (before < target && after >= target) || (before > target && after <= target);
}

/// Lets it happen.
static void runup_happen(runner *r, event what) {
    const double time = runup_time_of(r, r->x);
    switch (what) {
    case EVENT_DWELL:
        r->how.rate = 0.0;
        r->x[r->rotor] = r->plan->options->to / r->unit;
        break;
    case EVENT_TRIP:
        r->how.tripped = true;
        r->run->trip = time;
        break;
    case EVENT_LOSS:
        r->how.lost = true;
        r->run->loss = time;
        break;
    default:
        break;
    }
    r->machine->turn(r->machine, &r->how);
}

/// Lets all happen that comes where the run is now. Returns whether it ends.
static bool runup_happen_now(runner *r) {
    coming list[6];
    const size_t count = runup_list_coming(r, list);
    bool ends = false;
    for (size_t i = 0; i < count; i++) {
        if (fabs(list[i].of(r, r->x, 0) - list[i].target) > 1e-12 * list[i].target) continue;
        runup_happen(r, list[i].what);
        ends = ends || list[i].what == EVENT_END;
    }
    return ends;
}

/// The first event between two states, over a length of the angle; where it is, and the state there.
static event runup_find_event(runner *r, const double *begin, double from, double length, const double *end, double *at,
                              double *there) {
    coming list[6];
    const size_t count = runup_list_coming(r, list);
    event first = EVENT_NONE;
    *at = length;
    for (size_t i = 0; i < count; i++) {
        const double before = list[i].of(r, begin, 0), after = list[i].of(r, end, 0);
        if (!runup_passes(list[i].target, before, after)) continue;
        const double place =
            runup_find_passage(r, list[i].of, 0, list[i].target, begin, from, length, before, after, r->scratch);
        if (first != EVENT_NONE && place >= *at) continue;
        first = list[i].what;
        *at = place;
        memcpy(there, r->scratch, r->dimension * sizeof *there);
    }
    return first;
}

// ---------------------------------------------------------------- turns

static runup_end runup_end_of(const runner *r, whirl_motion motion) {
    if (runup_stopped(r)) return RUNUP_STOPPED;
    if (motion == WHIRL_DIVERGED) return RUNUP_DIVERGED;
    return r->x[r->rotor] < 1e-3 || isnan(r->x[r->rotor]) ? RUNUP_STALLED : RUNUP_STUCK;
}

/// Carries the run over the next turn. True while it goes on.
static bool runup_turn_on(runner *r) {
    const size_t count = (size_t)r->plan->options->samples;
    double *end = r->scratch + r->dimension, *there = r->scratch + 2 * r->dimension;
    double angle = 0.0; // within the turn
    bool whole = true;  // no event parts it
    memcpy(r->begin, r->x, r->dimension * sizeof *r->x);
    runup_begin_turn(r);
    while (angle < two_pi) {
        const double length = two_pi - angle, from = r->angle0 + angle;
        double at;
        memcpy(end, r->x, r->dimension * sizeof *end);
        whirl_motion motion = runup_carry_seen(r, from, length, end);
        if (motion != WHIRL_BOUNDED || !(end[r->rotor] > 0.0)) {
            memcpy(r->x, end, r->dimension * sizeof *end);
            r->run->end = runup_end_of(r, motion);
            return false;
        }
        const event what = runup_find_event(r, r->x, from, length, end, &at, there);
        if (what != EVENT_NONE) {
            whole = false;
            memcpy(end, r->x, r->dimension * sizeof *end);
            if (at > 0.0) motion = runup_carry_seen(r, from, at, end);
            memcpy(end, there, r->dimension * sizeof *end);
        }
        if (at > 0.0) {
            runup_see_radii(r, from, at / (double)count, count);
            runup_see_contacts(r, from, at / (double)count, count);
        }
        if (whole) runup_see_orders(r, count);
        memcpy(r->x, end, r->dimension * sizeof *end);
        angle = what == EVENT_NONE ? two_pi : angle + at;
        r->turns += (what == EVENT_NONE ? length : at) / two_pi;
        runup_happen(r, what);
        if (runup_happen_now(r) || what == EVENT_END) {
            runup_show_turn(r, false);
            r->run->end = RUNUP_DONE;
            return false;
        }
    }
    runup_show_turn(r, whole);
    return true;
}

// ---------------------------------------------------------------- from standstill

/// Carries x by time.
static whirl_motion runup_carry_time(runner *r, double length, double *x) {
    r->machine->part(r->machine, 0.0, length);
    return whirl_integrator_revolve(r->timed, x, NULL, NULL);
}

/// From a shaft that stands, by time, to the end of the first turn. False where there is none.
static bool runup_start_turning(runner *r) {
    const size_t d = r->rotor;
    const double last = r->plan->options->duration > 0.0 ? r->plan->options->duration * r->unit : INFINITY;
    whirl_torques torques;
    double time = 0.0, passed = 0.0, *x = r->scratch + r->dimension, *before = r->scratch + 2 * r->dimension;
    memcpy(x, r->x, r->dimension * sizeof *x);
    x[d + 1] = r->angle0;
    r->machine->torques(r->machine, r->x, r->angle0, &torques);
    const double faster = fabs(torques.acceleration) / (r->unit * r->unit);
    double step = faster > 0.0 ? 0.05 * sqrt(2.0 * two_pi / faster) : 0.0;
    r->run->end = RUNUP_STALLED;
    if (!(torques.acceleration > 0.0)) return false;
    while (x[d + 1] < r->angle0 + two_pi) {
        if (runup_stopped(r)) return r->run->end = RUNUP_STOPPED, false;
        if (x[d] < 0.0) return false;
        if (time >= last) { // at its end in its first turn
            r->turns = (x[d + 1] - r->angle0) / two_pi;
            r->machine->to_angle(r->machine, x);
            x[d + 1] = last;
            memcpy(r->x, x, r->dimension * sizeof *x);
            return r->run->end = RUNUP_DONE, false;
        }
        memcpy(before, x, r->dimension * sizeof *x);
        step = fmin(step, last - time);
        passed = time;
        if (runup_carry_time(r, step, x) != WHIRL_BOUNDED) return r->run->end = RUNUP_DIVERGED, false;
        time = step < last - time ? time + step : last;
    }
    // Back to the end of the turn, by Newton's method: the slope of the angle is the speed.
    double part = step * (r->angle0 + two_pi - before[d + 1]) / (x[d + 1] - before[d + 1]);
    time = passed;
    for (int i = 0; i < 12; i++) {
        memcpy(x, before, r->dimension * sizeof *x);
        runup_carry_time(r, part, x);
        const double miss = (r->angle0 + two_pi - x[d + 1]) / x[d];
        if (i > 0 && fabs(miss) <= located * step) break;
        part += miss;
    }
    r->machine->to_angle(r->machine, x);
    x[d + 1] = time + part;
    memcpy(r->x, x, r->dimension * sizeof *x);
    r->turns = 1.0;
    return true;
}

/// Turns at the first speed until the motion has settled, before time begins.
static bool runup_settle(runner *r) {
    const whirl_turning how = r->how;
    r->how.driven = r->how.lost = false;
    r->how.rate = 0.0;
    r->machine->turn(r->machine, &r->how);
    const size_t turns = (size_t)r->plan->options->settle;
    for (size_t turn = 0; turn < turns; turn++) {
        const whirl_motion motion = runup_carry_part(r, r->angle0, two_pi, r->x);
        if (motion != WHIRL_BOUNDED || runup_stopped(r)) {
            r->run->end = runup_end_of(r, motion);
            return false;
        }
    }
    r->x[r->rotor] = r->plan->options->from / r->unit;
    r->x[r->rotor + 1] = 0.0;
    r->how = how;
    r->machine->turn(r->machine, &r->how);
    return true;
}

// ---------------------------------------------------------------- all

/// The tops of radii between samples.
static void runup_locate_peaks(runner *r) {
    for (size_t p = 0; p < r->probes; p++) {
        const double *state = r->peak_state + p * r->dimension;
        double *there = r->scratch + r->dimension;
        if (!(r->peak_length[p] > 0.0)) continue;
        memcpy(there, state, r->dimension * sizeof *there);
        if (runup_carry_part(r, r->peak_from[p], r->peak_length[p], there) != WHIRL_BOUNDED) continue;
        const double low = runup_radial_slope(r, state, p), high = runup_radial_slope(r, there, p);
        if (!(low > 0.0 && high < 0.0)) continue;
        runup_find_passage(r, runup_radial_slope, p, 0.0, state, r->peak_from[p], r->peak_length[p], low, high, there);
        const double radius = runup_radius_of(r, there, p);
        if (radius >= r->run->peaks[p].radius)
            r->run->peaks[p] = (runup_peak){radius, runup_time_of(r, there), runup_speed_of(r, there)};
    }
}

static void runup_run_all(runner *r) {
    const whirl_runup_options *o = r->plan->options;
    const bool steady = strcmp(o->begin, "steady") == 0;
    bool going = !steady || runup_settle(r);
    if (going && o->from == 0.0) going = runup_start_turning(r);
    if (going && *o->loss_at && o->loss_speed == 0.0 && o->loss_time == 0.0) runup_happen(r, EVENT_LOSS);
    while (going) going = !runup_stopped(r) && runup_turn_on(r);
    if (runup_stopped(r)) r->run->end = RUNUP_STOPPED;
    if (r->run->end == RUNUP_DONE || r->run->end == RUNUP_STALLED) runup_locate_peaks(r);
    r->run->time = runup_time_of(r, r->x);
    r->run->speed = runup_speed_of(r, r->x);
    r->run->turns = r->turns;
    memcpy(r->run->last, r->x, r->dimension * sizeof *r->x);
}

static whirl_status runup_open(runner *r) {
    const size_t d = r->dimension, samples = (size_t)r->plan->options->samples;
    const size_t numbers = d * (2 + samples + 1 + 3 + r->probes) + r->contacts * (samples + 3) + 2 * r->probes;
    whirl_integrate_options options = r->plan->integrate;
    r->x = calloc(numbers + 1, sizeof *r->x);
    r->stations = calloc(r->probes + 1, sizeof *r->stations);
    if (!r->x || !r->stations) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a run");
    r->begin = r->x + d;
    r->samples = r->begin + d;
    r->scratch = r->samples + (samples + 1) * d;
    r->peak_state = r->scratch + 3 * d;
    r->force = r->peak_state + r->probes * d;
    r->largest = r->force + (samples + 1) * r->contacts;
    r->share = r->largest + r->contacts;
    r->peak_from = r->share + r->contacts;
    r->peak_length = r->peak_from + r->probes;
    options.steps_per_revolution = (int)samples;
    whirl_status status = whirl_integrator_new(r->system, &options, &r->turn);
    options.steps_per_revolution = 1;
    if (status.code == WHIRL_OK) status = whirl_integrator_new(r->system, &options, &r->part);
    if (status.code == WHIRL_OK) status = whirl_integrator_new(r->machine->by_time, &options, &r->timed);
    return status;
}

static void runup_close(runner *r) {
    whirl_integrator_free(r->turn);
    whirl_integrator_free(r->part);
    whirl_integrator_free(r->timed);
    free(r->x);
    free(r->stations);
}

whirl_status runup_carry(whirl_running *running, const runup_plan *plan, runup_run *run) {
    const whirl_runup_options *o = plan->options;
    const whirl_system *system = running->by_angle;
    runner r = {.machine = running,
                .plan = plan,
                .system = system,
                .dimension = system->dimension,
                .rotor = system->dimension - 2,
                .probes = system->probe_count,
                .contacts = running->contact_count,
                .unit = running->unit,
                .angle0 = plan->angle,
                .run = run};
    r.how = (whirl_turning){.driven = o->rate == 0.0, .rate = o->to > 0.0 && o->to < o->from ? -o->rate : o->rate};
    run->trip = run->loss = (double)NAN;
    for (size_t p = 0; p < r.probes; p++) run->peaks[p] = (runup_peak){0.0, NAN, NAN};
    for (size_t c = 0; c < r.contacts; c++) run->contacts[c] = (runup_contact){NAN, NAN, 0.0, 0.0};
    whirl_status status = runup_open(&r);
    if (status.code == WHIRL_OK) {
        memcpy(r.x, plan->start, r.rotor * sizeof *r.x);
        r.x[r.rotor] = o->from / r.unit;
        if (o->from > 0.0) running->to_angle(running, r.x);
        running->turn(running, &r.how);
        runup_run_all(&r);
    }
    runup_close(&r);
    return status;
}
