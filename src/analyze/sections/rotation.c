// Rotation numbers: how far a quasi-periodic motion goes round its closed curve from one visit to the next. The angle
// about the curve's centre, in the plane of its two main axes, is averaged with the weights of birkhoff.c, which
// converges to many digits (Das, Saiki, Sander, Yorke, "Solving the Babylonian problem of quasiperiodic rotation
// rates", Discrete Contin. Dyn. Syst. S 12 (2019) 2279).
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "birkhoff_weight.h"
#include "rotation.h"
#include "section.h"
#include "two_pi.h"

enum { MIN_POINTS = 24, ORDERED_POINTS = 2000 };

/// Every `curves`-th point, relative to the centre, in one block.
typedef struct cloud {
    size_t count, dimension;
    double *points;    ///< [count][dimension]
    double *axes[2];   ///< [dimension] main axes, unit vectors
    double *across[2]; ///< [count] coordinates of the points along the axes, mean square 1
    double *turns;     ///< [count] from each point to the next, in 0 .. 1
    double *sorted;    ///< [count] scratch
    size_t ordered;    ///< last points that are sorted: the effect of the number's error grows with their age
} cloud;

static cloud *cloud_new(const section *all, size_t curves) {
    const size_t count = all->count / curves, d = all->dimension;
    cloud *c = malloc(sizeof *c + (count * (d + 4) + 2 * d) * sizeof(double));
    if (!c) return NULL;
    // One allocation holds all arrays.
    *c = (cloud){.count = count,
                 .dimension = d,
                 .points = (double *)(c + 1),
                 .ordered = count < ORDERED_POINTS ? count : ORDERED_POINTS};
    c->axes[0] = c->points + count * d;
    c->axes[1] = c->axes[0] + d;
    c->across[0] = c->axes[1] + d;
    c->across[1] = c->across[0] + count;
    c->turns = c->across[1] + count;
    c->sorted = c->turns + count;
    // Take every point of one curve, relative to its mean.
    for (size_t n = 0; n < count; n++)
        memcpy(c->points + n * d, all->points + (all->count - 1 - (count - 1 - n) * curves) * d, d * sizeof(double));
    for (size_t i = 0; i < d; i++) {
        double mean = 0.0;
        for (size_t n = 0; n < count; n++) mean += c->points[n * d + i] / (double)count;
        for (size_t n = 0; n < count; n++) c->points[n * d + i] -= mean;
    }
    return c;
}

static double rotation_dot(const double *a, const double *b, size_t count) {
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) sum += a[i] * b[i];
    return sum;
}

static void scale_to(double *values, size_t count, double square) {
    const double factor = sqrt(square / rotation_dot(values, values, count));
    for (size_t i = 0; i < count; i++) values[i] *= factor;
}

/// Finds the axis of largest spread by power iteration, orthogonal to axis 0 for the second.
static void find_axis(cloud *c, int which) {
    enum { ITERATIONS = 40 };
    const size_t d = c->dimension;
    double *axis = c->axes[which], *along = c->across[which];
    for (size_t i = 0; i < d; i++) axis[i] = c->points[i] + c->points[c->count / 3 * d + i] * (which ? -1.0 : 1.0);
    for (int iteration = 0; iteration < ITERATIONS; iteration++) {
        if (which == 1) {
            const double overlap = rotation_dot(axis, c->axes[0], d);
            for (size_t i = 0; i < d; i++) axis[i] -= overlap * c->axes[0][i];
        }
        scale_to(axis, d, 1.0);
        for (size_t n = 0; n < c->count; n++) along[n] = rotation_dot(c->points + n * d, axis, d);
        if (iteration + 1 == ITERATIONS) break;
        memset(axis, 0, d * sizeof *axis);
        for (size_t n = 0; n < c->count; n++)
            for (size_t i = 0; i < d; i++) axis[i] += along[n] * c->points[n * d + i];
    }
    scale_to(along, c->count, (double)c->count);
}

static double rotation_fraction(double value) {
    return value - floor(value);
}

static void find_turns(cloud *c) {
    double before = 0.0;
    for (size_t n = 0; n < c->count; n++) {
        const double angle = atan2(c->across[1][n], c->across[0][n]) / two_pi;
        if (n > 0) c->turns[n - 1] = rotation_fraction(angle - before);
        before = angle;
    }
}

static int rotation_ascending(const void *a, const void *b) {
    const double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/// Makes turns continuous along the curve (they are known modulo 1): moves those past the widest gap down by one turn.
/// False without a clear gap.
static bool lift_turns(cloud *c) {
    const double least_gap = 0.02;
    const size_t count = c->count > 1 ? c->count - 1 : 1;
    memcpy(c->sorted, c->turns, count * sizeof *c->sorted);
    qsort(c->sorted, count, sizeof *c->sorted, rotation_ascending);
    double widest = c->sorted[0] + 1.0 - c->sorted[count - 1], from = 1.0;
    for (size_t i = 0; i + 1 < count; i++) {
        if (c->sorted[i + 1] - c->sorted[i] <= widest) continue;
        widest = c->sorted[i + 1] - c->sorted[i];
        from = 0.5 * (c->sorted[i + 1] + c->sorted[i]);
    }
    for (size_t n = 0; n < count; n++) c->turns[n] -= c->turns[n] > from ? 1.0 : 0.0;
    return widest >= least_gap;
}

static double weighted_mean(const double *values, size_t count) {
    double weights = 0.0, sum = 0.0;
    for (size_t n = 0; n < count; n++) {
        const double w = birkhoff_weight(n, count);
        weights += w;
        sum += w * values[n];
    }
    return sum / weights;
}

static size_t rotation_place_of(const cloud *c, size_t i) {
    return (size_t)fmod(c->sorted[i % c->ordered], 1e5);
}

static double median_of(double *values, size_t count) {
    qsort(values, count, sizeof *values, rotation_ascending);
    return values[count / 2];
}

/// Returns true if points lie where their two neighbours on the curve predict them (`sorted` has the points in order of
/// place). The prediction gets better as points fill a curve, but not on a torus of more frequencies or in a band,
/// however thin. Overwrites `across`.
static bool is_smooth(cloud *c, double number, double reach) {
    const double least = 0.02, by_bend = 0.6; // of the distance of the neighbours; a curve of some bends has reach/8
    const size_t d = c->dimension;
    for (size_t i = 0; i < c->ordered; i++) {
        const size_t from = rotation_place_of(c, i), at = rotation_place_of(c, i + 1), to = rotation_place_of(c, i + 2);
        const double before = rotation_fraction(((double)at - (double)from) * number);
        const double after = rotation_fraction(((double)to - (double)at) * number), share = before / (before + after);
        double off = 0.0, chord = 0.0;
        for (size_t k = 0; k < d; k++) {
            const double a = c->points[from * d + k], b = c->points[to * d + k];
            const double away = c->points[at * d + k] - a - share * (b - a);
            off += away * away;
            chord += (b - a) * (b - a);
        }
        c->across[0][i] = sqrt(off);
        c->across[1][i] = sqrt(chord);
    }
    const double off = median_of(c->across[0], c->ordered), chord = median_of(c->across[1], c->ordered);
    return off <= fmax(least, by_bend * chord / reach) * chord;
}

/// Returns true if the points go round a curve when they are sorted by the places that a rotation by `number` gives
/// them: then the steps from each point to the next are short. This is so only for the right number, however the
/// projection distorts the curve.
static bool goes_round(cloud *c, double number) {
    const double longest_way = 20.0; // times the greatest distance from the centre, for the whole curve
    const size_t d = c->dimension;
    double way = 0.0, reach = 0.0;
    for (size_t i = 0; i < c->ordered; i++) {
        const size_t n = c->count - c->ordered + i;
        // Pack the place and the index into one number, to sort them together.
        c->sorted[i] = floor(rotation_fraction((double)n * number) * 1e9) * 1e5 + (double)n;
        reach = fmax(reach, sqrt(rotation_dot(c->points + n * d, c->points + n * d, d)));
    }
    qsort(c->sorted, c->ordered, sizeof *c->sorted, rotation_ascending);
    for (size_t n = 0; n < c->ordered; n++) {
        const size_t from = rotation_place_of(c, n), to = rotation_place_of(c, n + 1);
        double square = 0.0;
        for (size_t i = 0; i < d; i++) {
            const double step = c->points[to * d + i] - c->points[from * d + i];
            square += step * step;
        }
        way += sqrt(square);
    }
    return way <= longest_way * reach && is_smooth(c, number, reach);
}

double rotation_number(const section *all, int curves) {
    const section points = section_tail(all, ROTATION_POINTS);
    double number = NAN;
    if (curves < 1 || points.dimension < 2 || points.count / (size_t)curves < MIN_POINTS) return NAN;
    cloud *c = cloud_new(&points, (size_t)curves);
    if (!c) return NAN;
    find_axis(c, 0);
    find_axis(c, 1);
    find_turns(c);
    if (lift_turns(c)) {
        number = rotation_fraction(weighted_mean(c->turns, c->count - 1));
        number = fmin(number, 1.0 - number);
        if (!goes_round(c, number)) number = NAN;
    }
    free(c);
    return number;
}
