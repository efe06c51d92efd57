// The motion of a run at equal times, interpolated between computed states.
#include "run_motion.h"

#include <math.h>

/// Returns the time of an instant, s.
static double run_motion_time(const whirl_run_motion *of, size_t instant) {
    return of->times ? of->times[instant] : of->from + (double)instant * of->step;
}

bool run_motion_reaches(const whirl_run_motion *to, double end) {
    static const double rounding = 1e-10;
    if (to->filled == to->count) return false;
    const double time = run_motion_time(to, to->filled);
    return to->times ? time <= end * (1.0 + rounding) : time < end;
}

/// Sets the displacement of a station along an axis at an instant.
static void run_motion_set(whirl_run_motion *to, size_t instant, size_t probe, size_t axis, double x) {
    to->x[(2 * probe + axis) * to->count + instant] = x;
}

void run_motion_begin(whirl_run_motion *to, const whirl_probe *probes, const double *state, double angle) {
    to->filled = 0;
    for (; to->filled < to->count && run_motion_time(to, to->filled) < 0.0; to->filled++) {
        for (size_t p = 0; p < to->probes; p++)
            for (size_t axis = 0; axis < 2; axis++)
                run_motion_set(to, to->filled, p, axis, whirl_probe_value(&probes[p], state, axis));
        to->angle[to->filled] = angle;
    }
}

/// Weights of the values, slopes and second derivatives of both ends at the share s of a step, by Hermite's polynomial
/// of the fifth degree; slopes times the step, second derivatives times its square.
static void quintic_weights(double s, double weights[3][2]) {
    const double t = 1.0 - s, s3 = s * s * s, t3 = t * t * t;
    weights[0][0] = t3 * (1.0 + 3.0 * s + 6.0 * s * s);
    weights[0][1] = s3 * (1.0 + 3.0 * t + 6.0 * t * t);
    weights[1][0] = s * t3 * (1.0 + 3.0 * s);
    weights[1][1] = -t * s3 * (1.0 + 3.0 * t);
    weights[2][0] = 0.5 * s * s * t3;
    weights[2][1] = 0.5 * t * t * s3;
}

/// Returns the displacement (nth 0), velocity (1) or acceleration (2) by time of a station along an axis.
static double run_motion_value(const motion_node *node, const whirl_probe *probe, size_t axis, size_t nth) {
    if (nth == 0) return whirl_probe_value(probe, node->state, axis);
    const double first = whirl_probe_value(probe, node->state, 2 + axis);
    if (nth == 1) return node->by_time ? first : node->speed * first;
    const double second = whirl_probe_value(probe, node->slope, 2 + axis);
    return node->by_time ? second : node->speed * node->speed * second + node->rate * first;
}

/// Returns a displacement between two states that are `step` apart, with the weights of its place.
static double run_motion_between(const motion_node *const ends[2], const whirl_probe *probe, size_t axis, double step,
                                 double weights[3][2]) {
    double sum = 0.0;
    for (size_t side = 0; side < 2; side++)
        sum += weights[0][side] * run_motion_value(ends[side], probe, axis, 0) +
               step * weights[1][side] * run_motion_value(ends[side], probe, axis, 1) +
               step * step * weights[2][side] * run_motion_value(ends[side], probe, axis, 2);
    return sum;
}

void run_motion_fill(whirl_run_motion *to, const whirl_probe *probes, const motion_node *low, const motion_node *high,
                     double unit) {
    const motion_node *const ends[] = {low, high};
    const double step = (high->time - low->time) / unit;
    for (; run_motion_reaches(to, high->time); to->filled++) {
        const double time = run_motion_time(to, to->filled);
        const double s = (time - low->time) / (high->time - low->time), t = 1.0 - s;
        double weights[3][2];
        quintic_weights(s, weights);
        for (size_t p = 0; p < to->probes; p++)
            for (size_t axis = 0; axis < 2; axis++)
                run_motion_set(to, to->filled, p, axis, run_motion_between(ends, &probes[p], axis, step, weights));
        to->angle[to->filled] =
            t * low->angle + s * high->angle +
            s * t * ((t - s) * (low->angle - high->angle) + step * (t * low->speed - s * high->speed));
    }
}

double run_motion_error(size_t probe_count, const whirl_probe *probes, const motion_node *low,
                        const motion_node *middle, const motion_node *high, double unit, double *size) {
    const motion_node *const ends[] = {low, high};
    const double span = high->time - low->time;
    double weights[3][2], largest = 0.0;
    quintic_weights((middle->time - low->time) / span, weights);
    for (size_t p = 0; p < probe_count; p++)
        for (size_t axis = 0; axis < 2; axis++) {
            const double x = run_motion_value(middle, &probes[p], axis, 0);
            const double between = run_motion_between(ends, &probes[p], axis, span / unit, weights);
            largest = fmax(largest, fabs(between - x));
            *size = fmax(*size, fabs(x));
        }
    return largest;
}

void run_motion_archive(whirl_run_motion *motion, archive *a) {
    archive_count(a, &motion->filled, motion->count);
    archive_part(a, motion->x, 2 * motion->probes * motion->count * sizeof *motion->x);
    archive_part(a, motion->angle, motion->count * sizeof *motion->angle);
}
