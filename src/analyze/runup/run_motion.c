// The motion of a run at equal times, interpolated between computed states.
#include "run_motion.h"

#include <math.h>

/// Sets the displacement of a station along an axis at an instant.
static void run_motion_set(whirl_run_motion *to, size_t instant, size_t probe, size_t axis, double x) {
    to->x[(2 * probe + axis) * to->count + instant] = x;
}

void run_motion_begin(whirl_run_motion *to, const whirl_probe *probes, const double *state, double angle) {
    to->filled = 0;
    for (; to->filled < to->count && to->from + (double)to->filled * to->step < 0.0; to->filled++) {
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

void run_motion_fill(whirl_run_motion *to, const whirl_probe *probes, const motion_node *low, const motion_node *high,
                     double begin, double end, double step) {
    const motion_node *const ends[] = {low, high};
    for (; to->filled < to->count; to->filled++) {
        const double time = to->from + (double)to->filled * to->step;
        if (!(time < end)) return;
        const double s = (time - begin) / (end - begin), t = 1.0 - s;
        double weights[3][2];
        quintic_weights(s, weights);
        for (size_t p = 0; p < to->probes; p++)
            for (size_t axis = 0; axis < 2; axis++) {
                double sum = 0.0;
                for (size_t side = 0; side < 2; side++)
                    sum += weights[0][side] * whirl_probe_value(&probes[p], ends[side]->state, axis) +
                           step * weights[1][side] * whirl_probe_value(&probes[p], ends[side]->state, 2 + axis) +
                           step * step * weights[2][side] * whirl_probe_value(&probes[p], ends[side]->slope, 2 + axis);
                run_motion_set(to, to->filled, p, axis, sum);
            }
        to->angle[to->filled] =
            t * low->angle + s * high->angle +
            s * t * ((t - s) * (low->angle - high->angle) + step * (t * low->speed - s * high->speed));
    }
}

void run_motion_archive(whirl_run_motion *motion, archive *a) {
    archive_count(a, &motion->filled, motion->count);
    archive_part(a, motion->x, 2 * motion->probes * motion->count * sizeof *motion->x);
    archive_part(a, motion->angle, motion->count * sizeof *motion->angle);
}
