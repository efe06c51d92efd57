#include "touch.h"
#include "shooting.h"
#include "whirl/engine/orbit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// State of observing an orbit: the last instant and the present one.
typedef struct watch {
    const whirl_system *system;
    whirl_orbit *orbit;
    double t;
    double *x, *slope;         ///< [dimension] at the last instant
    double *x2, *slope2, *mid; ///< [dimension] at the present instant, and between both
    double *gradient;          ///< [dimension]
    double *values;            ///< [switch_count]
    double *from, *rate;       ///< [touch_count] values and their rates at the last instant
    size_t seen;
} watch;

static bool touches_at(const whirl_system *system, size_t index) {
    return !system->switch_touches || system->switch_touches(system->model, index);
}

size_t whirl_touch_count(const whirl_system *system) {
    size_t count = 0;
    for (size_t i = 0; i < system->switch_count; i++) count += touches_at(system, i);
    return count;
}

size_t whirl_touch_closings(const whirl_touch *touch) {
    return touch->share >= 1.0 ? 0 : touch->intervals;
}

static void slope_at(const watch *w, double t, const double *x, double *slope) {
    double forcing[WHIRL_MAX_FORCING];
    if (w->system->forcing_count > 0) w->system->forcing(w->system->model, t, forcing);
    w->system->rhs(w->system->model, t, forcing, x, slope);
}

static double touch_value_at(const watch *w, size_t index, double t, const double *x) {
    w->system->switches(w->system->model, t, x, w->values);
    return w->values[index];
}

/// Returns the rate of a switching function along a slope, by a one-sided difference if the system gives no gradient.
static double rate_at(const watch *w, size_t index, double t, const double *x, const double *slope) {
    const whirl_system *system = w->system;
    double sum = 0.0;
    if (system->switch_gradient) {
        system->switch_gradient(system->model, t, x, index, w->gradient, &sum);
        for (size_t i = 0; i < system->dimension; i++) sum += w->gradient[i] * slope[i];
        return sum;
    }
    const double h = 0x1p-20 * system->period;
    for (size_t i = 0; i < system->dimension; i++) w->gradient[i] = x[i] + h * slope[i];
    const double ahead = touch_value_at(w, index, t + h, w->gradient);
    for (size_t i = 0; i < system->dimension; i++) w->gradient[i] = x[i] - h * slope[i];
    return (ahead - touch_value_at(w, index, t - h, w->gradient)) / (2.0 * h);
}

/// Interpolates state and slope between the last instant and the present one, by the cubic through both states and
/// slopes.
static void touch_between(const watch *w, double t, double theta, double h, double *x, double *slope) {
    const double a = theta * theta * (3.0 - 2.0 * theta), b = theta * (1.0 - theta);
    for (size_t i = 0; i < w->system->dimension; i++) {
        const double rise = w->x2[i] - w->x[i];
        x[i] = w->x[i] + a * rise + h * b * ((1.0 - theta) * w->slope[i] - theta * w->slope2[i]);
    }
    slope_at(w, t + theta * h, x, slope);
}

/// Returns the extreme between the last instant and the present one, whose rates have opposite signs.
static double extreme_between(const watch *w, size_t index, double t, double h, double rate) {
    double low = 0.0, high = 1.0, *slope = w->mid + w->system->dimension;
    for (int k = 0; k < 40; k++) {
        const double theta = 0.5 * (low + high);
        touch_between(w, t, theta, h, w->mid, slope);
        if ((rate_at(w, index, t + theta * h, w->mid, slope) < 0.0) == (rate < 0.0))
            low = theta;
        else
            high = theta;
    }
    touch_between(w, t, 0.5 * (low + high), h, w->mid, slope);
    return touch_value_at(w, index, t + 0.5 * (low + high) * h, w->mid);
}

static void touch_look_at(watch *w, size_t which, double t, double h) {
    whirl_touch *touch = &w->orbit->touches[which];
    const double value = touch_value_at(w, touch->index, t, w->x2),
                 rate = rate_at(w, touch->index, t, w->x2, w->slope2);
    const double from = w->from[which], from_rate = w->rate[which];
    w->from[which] = value;
    w->rate[which] = rate;
    if (h == 0.0) return;
    const bool now = value > 0.0, before = from > 0.0;
    touch->intervals += now > before;
    // Add the closed part of this interval; a straight line gives the instant of a change.
    touch->share += h * (now == before ? (double)now : fmax(value, from) / (fabs(value) + fabs(from)));
    if ((from_rate < 0.0) == (rate < 0.0)) return;
    const double extreme = extreme_between(w, touch->index, w->t, h, from_rate);
    // An extreme beyond zero between two instants on the same side of it is a contact, or a gap in one, between the
    // instants. Its length is that of a parabola with these ends.
    if (now == before && (extreme > 0.0) != now) {
        const double height = fabs(extreme) + 0.5 * (fabs(value) + fabs(from));
        touch->intervals++;
        touch->share += (now ? -h : h) * sqrt(fabs(extreme) / height);
    }
    if (fabs(extreme) < fabs(touch->nearest)) touch->nearest = extreme;
}

/// Observes x at the next instant t.
static void touch_add(watch *w, double t, const double *x, double h) {
    whirl_orbit *orbit = w->orbit;
    const size_t d = orbit->dimension;
    memcpy(w->x2, x, d * sizeof *x);
    if (orbit->touch_count > 0) slope_at(w, t, x, w->slope2);
    for (size_t k = 0; k < orbit->touch_count; k++) touch_look_at(w, k, t, h);
    for (size_t i = 0; i < d; i++) {
        orbit->low[i] = fmin(orbit->low[i], x[i]);
        orbit->high[i] = fmax(orbit->high[i], x[i]);
    }
    memcpy(w->x, w->x2, d * sizeof *x);
    memcpy(w->slope, w->slope2, d * sizeof *x);
    w->t = t;
}

static void touch_observe(void *observer, double t, const double *x) {
    watch *w = observer;
    touch_add(w, t, x, t - w->t);
}

/// Initializes the bounds, to be widened, and the functions of the touches.
static void touch_prepare(watch *w) {
    whirl_orbit *orbit = w->orbit;
    for (size_t i = 0; i < orbit->dimension; i++) {
        orbit->low[i] = INFINITY;
        orbit->high[i] = -(double)INFINITY;
    }
    for (size_t i = 0, k = 0; k < orbit->touch_count; i++)
        if (touches_at(w->system, i)) orbit->touches[k++] = (whirl_touch){.index = i, .nearest = INFINITY};
}

whirl_status touch_find(shooting *s, whirl_orbit *orbit) {
    const size_t d = s->dimension, switches = s->system->switch_count;
    double *work = calloc(8 * d + 3 * switches + 1, sizeof *work);
    if (!work) return whirl_fail(WHIRL_NO_MEMORY, "no memory to follow an orbit");
    // Parts of one allocation.
    watch w = {.system = s->system, .orbit = orbit, .x = work, .slope = work + d, .x2 = work + 2 * d};
    w.slope2 = w.x2 + d;
    w.mid = w.slope2 + d;
    w.gradient = w.mid + 2 * d;
    w.values = w.gradient + d;
    w.from = w.values + switches;
    w.rate = w.from + switches;
    // Watch the switching functions along the orbit; bounds suffice without contacts.
    touch_prepare(&w);
    touch_add(&w, 0.0, orbit->nodes, 0.0);
    const bool good =
        shooting_rests(s) ||
        (orbit->touch_count == 0 && shooting_bounds(s, orbit->nodes, orbit->period, orbit->low, orbit->high)) ||
        shooting_observe(s, orbit->nodes, orbit->period, touch_observe, &w);
    // Turn times into shares of the period.
    for (size_t k = 0; k < orbit->touch_count; k++) {
        whirl_touch *touch = &orbit->touches[k];
        touch->share = orbit->period > 0.0 ? fmin(fmax(touch->share / orbit->period, 0.0), 1.0) : w.from[k] > 0.0;
        if (shooting_rests(s)) touch->nearest = w.from[k];
        if (touch->intervals == 0 && w.from[k] > 0.0) touch->intervals = 1;
    }
    free(work);
    return good ? whirl_ok() : whirl_fail(WHIRL_BAD_INPUT, "the motion along an orbit leaves its bounds");
}
