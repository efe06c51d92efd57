// Fits a curve to the sections of a motion.
//
// Weighted Birkhoff averages of x exp(-2 pi i h rho m) over the sections m are the harmonics of the curve, if rho is
// its rotation number (Das, Saiki, Sander, Yorke 2017). The average is largest at rho if the harmonic h = 1 is the
// largest one, else at the multiple of rho that belongs to the largest harmonic.
#include "torus_start.h"
#include "harmonics.h"
#include "section_map.h"
#include "torus_equations.h"
#include "two_pi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "birkhoff_weight.h"

enum { MAX_SECTIONS = 2048, MAX_HARMONICS = 24 };

/// The last sections, relative to their weighted mean.
typedef struct cloud {
    size_t count, n;
    double *points;  ///< [count][n]
    double *left;    ///< [count][n] residual of a series
    double *weights; ///< [count] their sum is 1
    double *mean;    ///< [n]
    double *real;    ///< [n] an average's cosine part
    double *minus;   ///< [n] ... and sine part
    double *series;  ///< [2 MAX_HARMONICS + 1][n]
    double radius;   ///< largest coordinate of points
} cloud;

static cloud *cloud_new(const torus_equations *e, const double *states, size_t count) {
    // One allocation holds all arrays.
    const size_t n = e->n, kept = count < MAX_SECTIONS ? count : MAX_SECTIONS, d = e->map->dimension;
    cloud *c = calloc(1, sizeof *c + (kept * (2 * n + 1) + (4 + 2 * MAX_HARMONICS) * n) * sizeof(double));
    double sum = 0.0;
    if (!c) return NULL;
    *c = (cloud){.count = kept, .n = n, .points = (double *)(c + 1)};
    c->left = c->points + kept * n;
    c->weights = c->left + kept * n;
    c->mean = c->weights + kept;
    c->real = c->mean + n;
    c->minus = c->real + n;
    c->series = c->minus + n;
    // Take the last sections, weighted for Birkhoff averages.
    for (size_t m = 0; m < kept; m++) {
        section_map_take(e->map, states + (count - kept + m) * d, c->points + m * n);
        c->weights[m] = birkhoff_weight(m, kept);
        sum += c->weights[m];
    }
    for (size_t m = 0; m < kept; m++) c->weights[m] /= sum;
    // Subtract the weighted mean.
    for (size_t m = 0; m < kept; m++)
        for (size_t i = 0; i < n; i++) c->mean[i] += c->weights[m] * c->points[m * n + i];
    for (size_t m = 0; m < kept; m++)
        for (size_t i = 0; i < n; i++) {
            c->points[m * n + i] -= c->mean[i];
            c->radius = fmax(c->radius, fabs(c->points[m * n + i]));
        }
    return c;
}

// ---------------------------------------------------------------- the rotation number

/// Returns the angle of section m at `turns` turns a section, counted from the middle section, rad.
static double angle_at(const cloud *c, size_t m, double turns) {
    return two_pi * fmod(turns * ((double)m - 0.5 * (double)c->count), 1.0);
}

/// Averages the residual at `turns` turns a section into `real` and `minus`. Returns the square of the size of the
/// average.
static double torus_start_average(cloud *c, double turns) {
    double square = 0.0;
    memset(c->real, 0, c->n * sizeof *c->real);
    memset(c->minus, 0, c->n * sizeof *c->minus);
    for (size_t m = 0; m < c->count; m++) {
        const double angle = angle_at(c, m, turns);
        const double by_cosine = c->weights[m] * cos(angle), by_sine = c->weights[m] * sin(angle);
        for (size_t i = 0; i < c->n; i++) {
            c->real[i] += by_cosine * c->left[m * c->n + i];
            c->minus[i] += by_sine * c->left[m * c->n + i];
        }
    }
    for (size_t i = 0; i < c->n; i++) square += c->real[i] * c->real[i] + c->minus[i] * c->minus[i];
    return square;
}

/// Returns the place between two others at which the average is largest, by golden section.
static double largest_between(cloud *c, double low, double high) {
    const double share = 0.6180339887498949;
    double left = high - share * (high - low), right = low + share * (high - low);
    double at_left = torus_start_average(c, left), at_right = torus_start_average(c, right);
    while (high - low > 1e-12) {
        if (at_left > at_right) {
            high = right;
            right = left;
            at_right = at_left;
            left = high - share * (high - low);
            at_left = torus_start_average(c, left);
        } else {
            low = left;
            left = right;
            at_left = at_right;
            right = low + share * (high - low);
            at_right = torus_start_average(c, right);
        }
    }
    return 0.5 * (low + high);
}

static double largest_line(cloud *c) {
    memcpy(c->left, c->points, c->count * c->n * sizeof *c->left);
    const double step = 0.5 / (double)c->count;
    double largest = -1.0, at = 0.0;
    for (size_t k = 2; k <= c->count; k++) {
        const double square = torus_start_average(c, step * (double)k);
        if (square > largest) {
            largest = square;
            at = step * (double)k;
        }
    }
    return largest_between(c, at - step, at + step);
}

static double torus_start_fold(double turns) {
    const double part = turns - floor(turns);
    return fmin(part, 1.0 - part);
}

/// Subtracts a harmonic, 2 (real cos + minus sin), from the residual.
static void take_out(cloud *c, double turns) {
    for (size_t m = 0; m < c->count; m++) {
        const double angle = angle_at(c, m, turns), by_cosine = 2.0 * cos(angle), by_sine = 2.0 * sin(angle);
        for (size_t i = 0; i < c->n; i++) c->left[m * c->n + i] -= by_cosine * c->real[i] + by_sine * c->minus[i];
    }
}

/// Fits the series for a rotation number. Returns the root mean square of the residual, divided by the size of the
/// points. Each harmonic is fitted to the residual of the lower ones: if few sections cannot separate two harmonics,
/// the lower one counts.
static double torus_start_misfit(cloud *c, double rotation) {
    const size_t n = c->n, size = c->count * n;
    const size_t most = c->count / 8 < MAX_HARMONICS ? c->count / 8 : MAX_HARMONICS;
    double off = 0.0, all = 0.0;
    memcpy(c->left, c->points, size * sizeof *c->left);
    memset(c->series, 0, (2 * MAX_HARMONICS + 1) * n * sizeof *c->series);
    for (size_t h = 1; h <= most; h++) {
        const double turns = fmod((double)h * rotation, 1.0);
        torus_start_average(c, turns);
        take_out(c, turns);
        for (size_t i = 0; i < n; i++) {
            c->series[(2 * h - 1) * n + i] = 2.0 * c->real[i];
            c->series[2 * h * n + i] = 2.0 * c->minus[i];
        }
    }
    for (size_t i = 0; i < size; i++) {
        off += c->weights[i / n] * c->left[i] * c->left[i];
        all += c->weights[i / n] * c->points[i] * c->points[i];
    }
    return sqrt(off / all);
}

/// Returns the rotation number: the place of the largest line, or a half or a third of it if that fits and the line
/// itself does not. Leaves its series.
static double rotation_of(cloud *c, double *off) {
    const double line = largest_line(c);
    const double fits = 0.05;
    double best = torus_start_fold(line);
    *off = torus_start_misfit(c, best);
    if (*off <= fits) return best;
    for (int part = 2; part <= 3; part++)
        for (int turn = 0; turn < part; turn++) {
            const double other = torus_start_fold((line + turn) / part), there = torus_start_misfit(c, other);
            if (there < 0.1 * *off) {
                best = other;
                *off = there;
            }
        }
    *off = torus_start_misfit(c, best);
    return best;
}

/// Returns the number of sections after which the points repeat, or 0 if they do not.
static size_t repeats_after(const cloud *c) {
    for (size_t q = 1; q <= c->count / 2; q++) {
        double away = 0.0;
        for (size_t m = c->count - q; m < c->count && away <= 1e-7 * c->radius; m++)
            for (size_t i = 0; i < c->n; i++)
                away = fmax(away, fabs(c->points[m * c->n + i] - c->points[(m - q) * c->n + i]));
        if (away <= 1e-7 * c->radius) return q;
    }
    return 0;
}

// ---------------------------------------------------------------- the curve

/// Returns the number of harmonics up to three small ones in a row.
static size_t harmonics_needed(const cloud *c) {
    enum { MIN_HARMONICS = 3 };
    double largest = 0.0;
    size_t last = MIN_HARMONICS, small = 0;
    for (size_t h = 1; h <= MAX_HARMONICS; h++) largest = fmax(largest, harmonics_size(c->n, c->series, h));
    for (size_t h = 1; h <= MAX_HARMONICS && small < 3; h++) {
        small = harmonics_size(c->n, c->series, h) < 1e-3 * largest ? small + 1 : 0;
        if (small == 0 && h > last) last = h;
    }
    return last;
}

static whirl_status write_curve(torus_equations *e, cloud *c, double rotation, double **u) {
    const size_t n = e->n, most = (e->options->most_nodes - 1) / 2, needed = harmonics_needed(c);
    const size_t count = 2 * (needed < most ? needed : most) + 1;
    *u = torus_equations_resize(e, count) ? calloc(count * n + 2, sizeof **u) : NULL;
    if (!*u) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a torus of %zu nodes", count);
    memcpy(c->series, c->mean, n * sizeof *c->mean);
    harmonics_spread(2 * MAX_HARMONICS + 1, n, c->series, 0.0, count, *u, NULL);
    (*u)[count * n] = two_pi * rotation;
    return whirl_ok();
}

static whirl_status torus_start_fit(torus_equations *e, cloud *c, double rotation, double **u) {
    const double enough = 0.2;
    double off = 0.0, size = 0.0;
    // Refuse a single point and a periodic motion.
    for (size_t i = 0; i < e->n; i++) size = fmax(size, fabs(c->mean[i]));
    if (!isfinite(c->radius) || !(c->radius > 1e-9 * fmax(size, c->radius)))
        return whirl_fail(WHIRL_BAD_INPUT, "the sections of a torus are one point, expected a closed curve of them");
    const size_t period = repeats_after(c);
    if (period > 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the sections of a torus repeat after %zu of them: the motion is periodic, expected one that "
                          "fills a closed curve",
                          period);
    // Fit by the given rotation number, or by one found for these sections.
    if (isfinite(rotation))
        off = torus_start_misfit(c, rotation);
    else
        rotation = rotation_of(c, &off);
    if (!(off <= enough))
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "the sections lie on no closed curve that the map turns by a constant angle: they are off the "
            "nearest one, of rotation number %.6g, by %.2g of their size",
            rotation, off);
    return write_curve(e, c, rotation, u);
}

whirl_status torus_fit(torus_equations *e, const double *states, size_t count, double rotation, double **u) {
    cloud *c = cloud_new(e, states, count);
    *u = NULL;
    if (!c) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu sections", count);
    const whirl_status status = torus_start_fit(e, c, rotation, u);
    free(c);
    return status;
}
