// The 0-1 test for chaos: the section drives p(n+1) = p(n) + u(n) cos(c n), q(n+1) = q(n) + u(n) sin(c n). For a
// regular motion (p, q) stays bounded. For a chaotic one it diffuses, so that its mean square displacement grows with
// the lag. K is the correlation of displacement and lag: near 0 for regular motion, near 1 in chaos. If c resonates
// with a line of a regular motion, K is 1 as well; the median over many c excludes such values (Gottwald, Melbourne,
// "On the implementation of the 0-1 test for chaos", SIAM J. Appl. Dyn. Syst. 8 (2009) 129).
#include <math.h>
#include <stdbool.h>

#include "section.h"
#include "zero_one.h"

enum { MAX_POINTS = 4000, FREQUENCIES = 25, MAX_LAGS = 50 };

static const double pi = 3.141592653589793238463;

/// Computes one observable of the section, with mean 0 and mean square 1: a sum of its scaled coordinates with
/// different weights, so that parts of a symmetric motion do not cancel. Returns false if no coordinate moves by more
/// than rounding.
static bool zero_one_observe(const section *points, double size, double *u) {
    double squares = 0.0;
    for (size_t n = 0; n < points->count; n++) u[n] = 0.0;
    // Add each coordinate that moves.
    for (size_t i = 0; i < points->dimension; i++) {
        const double *x = points->points + i;
        double mean = 0.0, square = 0.0;
        for (size_t n = 0; n < points->count; n++) mean += x[n * points->dimension];
        mean /= (double)points->count;
        for (size_t n = 0; n < points->count; n++) {
            const double away = x[n * points->dimension] - mean;
            square += away * away;
        }
        const double spread = sqrt(square / (double)points->count);
        if (!(spread > 1e-6 * size)) continue;
        for (size_t n = 0; n < points->count; n++)
            u[n] += (x[n * points->dimension] - mean) / (spread * (double)(i + 1));
    }
    // Scale to mean square 1.
    for (size_t n = 0; n < points->count; n++) squares += u[n] * u[n];
    if (!(squares > 0.0)) return false;
    const double scale = sqrt((double)points->count / squares);
    for (size_t n = 0; n < points->count; n++) u[n] *= scale;
    return true;
}

/// Computes p, q [count], driven with frequency c.
static void zero_one_drive(const double *u, size_t count, double c, double *p, double *q) {
    double px = 0.0, qx = 0.0;
    for (size_t n = 0; n < count; n++) {
        px += u[n] * cos(c * (double)n);
        qx += u[n] * sin(c * (double)n);
        p[n] = px;
        q[n] = qx;
    }
}

static double mean_square_displacement(const double *p, const double *q, size_t averaged, size_t lag) {
    double sum = 0.0;
    for (size_t n = 0; n < averaged; n++) {
        const double dp = p[n + lag] - p[n], dq = q[n + lag] - q[n];
        sum += dp * dp + dq * dq;
    }
    return sum / (double)averaged;
}

static double zero_one_correlate(const double *a, const double *b, size_t count) {
    double ma = 0.0, mb = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
    for (size_t i = 0; i < count; i++) {
        ma += a[i] / (double)count;
        mb += b[i] / (double)count;
    }
    for (size_t i = 0; i < count; i++) {
        aa += (a[i] - ma) * (a[i] - ma);
        bb += (b[i] - mb) * (b[i] - mb);
        ab += (a[i] - ma) * (b[i] - mb);
    }
    return aa > 0.0 && bb > 0.0 ? ab / sqrt(aa * bb) : 0.0;
}

/// Returns the growth rate K at one frequency.
static double growth_at(const double *u, size_t count, double c) {
    double p[MAX_POINTS], q[MAX_POINTS], lags[MAX_LAGS] = {0}, displacement[MAX_LAGS] = {0};
    const size_t longest = count / 10, averaged = count - longest;
    const size_t used = longest < MAX_LAGS ? longest : MAX_LAGS;
    zero_one_drive(u, count, c, p, q);
    for (size_t i = 0; i < used; i++) {
        const size_t lag = (i + 1) * longest / used;
        lags[i] = (double)lag;
        displacement[i] = mean_square_displacement(p, q, averaged, lag);
    }
    return zero_one_correlate(lags, displacement, used);
}

static double zero_one_median(double *values, size_t count) {
    for (size_t i = 1; i < count; i++) {
        const double value = values[i];
        size_t at = i;
        for (; at > 0 && values[at - 1] > value; at--) values[at] = values[at - 1];
        values[at] = value;
    }
    return values[count / 2];
}

double zero_one_test(const section *all, double size) {
    const section points = section_tail(all, MAX_POINTS);
    double u[MAX_POINTS], growth[FREQUENCIES];
    if (points.count < ZERO_ONE_MIN || !zero_one_observe(&points, size, u)) return NAN;
    for (size_t i = 0; i < FREQUENCIES; i++) {
        const double turn = fmod((double)(i + 1) * 0.6180339887498949, 1.0); // spread evenly, the same in every run
        growth[i] = growth_at(u, points.count, pi / 5.0 * (1.0 + 3.0 * turn));
    }
    return zero_one_median(growth, FREQUENCIES);
}
