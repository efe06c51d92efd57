// Best weights within limits: least largest vibration, or least squares, by Newton's method on a barrier.
#include "balance_limits.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"

/// State of the search, in numbers of the order of 1: z holds real and imaginary parts of the unknowns and, if the
/// largest row is minimized, a bound t of all rows.
typedef struct barrier {
    size_t n, rows, planes, size; ///< unknowns, rows of the goal, planes; numbers of z
    bool bound;                   ///< t is part of z
    double complex *effect;       ///< [rows][n]
    double complex *before;       ///< [rows]
    double complex *share;        ///< [planes][n] moments over their limits
    double *z, *trial;            ///< [size]
    double *gradient, *hessian;   ///< [size], [size][size]
    double sharpness;             ///< weight of the goal against the barrier
} barrier;

/// Returns the value of a row at z, from complex coefficients [n].
static double complex row_at(const barrier *b, const double complex *of, double complex at_zero, const double *z) {
    for (size_t j = 0; j < b->n; j++) at_zero += of[j] * (z[2 * j] + z[2 * j + 1] * I);
    return at_zero;
}

/// Returns the derivative of a row by number k of z.
static double complex slope_of(const double complex *of, size_t k) {
    return k % 2 ? of[k / 2] * I : of[k / 2];
}

/// Returns the barrier -log(limit^2 - |u|^2), infinite outside of the limit.
static double balance_limits_wall(double complex u, double limit) {
    const double inside = limit - cabs(u);
    return inside > 0.0 ? -log(inside * (limit + cabs(u))) : (double)INFINITY;
}

/// Returns the function to be minimized: sharpness times the goal, plus a wall at every limit.
static double barrier_value(const barrier *b, const double *z) {
    double goal = b->bound ? z[b->size - 1] : 0.0, walls = 0.0;
    for (size_t r = 0; r < b->rows; r++) {
        const double complex u = row_at(b, b->effect + r * b->n, b->before[r], z);
        if (b->bound)
            walls += balance_limits_wall(u, z[b->size - 1]);
        else
            goal += creal(u * conj(u));
    }
    for (size_t p = 0; p < b->planes; p++) walls += balance_limits_wall(row_at(b, b->share + p * b->n, 0.0, z), 1.0);
    return b->sharpness * goal + walls;
}

/// Adds factor |u|^2 to gradient and Hessian.
static void add_square(const barrier *b, const double complex *of, double complex u, double factor) {
    for (size_t k = 0; k < 2 * b->n; k++) {
        const double complex own = conj(slope_of(of, k));
        b->gradient[k] += 2.0 * factor * creal(own * u);
        for (size_t l = 0; l <= k; l++) b->hessian[k * b->size + l] += 2.0 * factor * creal(own * slope_of(of, l));
    }
}

/// Adds the wall of a row: its limit is t where `moves`, else 1.
static void balance_limits_add_wall(const barrier *b, const double complex *of, double complex u, bool moves) {
    const size_t t = b->size - 1;
    const double limit = moves ? b->z[t] : 1.0, gap = (limit - cabs(u)) * (limit + cabs(u)), square = gap * gap;
    add_square(b, of, u, 1.0 / gap);
    for (size_t k = 0; k < 2 * b->n; k++) {
        const double along = creal(conj(slope_of(of, k)) * u);
        for (size_t l = 0; l <= k; l++)
            b->hessian[k * b->size + l] += 4.0 * along * creal(conj(slope_of(of, l)) * u) / square;
        if (moves) b->hessian[t * b->size + k] -= 4.0 * limit * along / square;
    }
    if (!moves) return;
    b->gradient[t] -= 2.0 * limit / gap;
    b->hessian[t * b->size + t] += 2.0 * (limit * limit + creal(u * conj(u))) / square;
}

static void find_derivatives(const barrier *b) {
    memset(b->gradient, 0, b->size * sizeof *b->gradient);
    memset(b->hessian, 0, b->size * b->size * sizeof *b->hessian);
    if (b->bound) b->gradient[b->size - 1] = b->sharpness;
    for (size_t r = 0; r < b->rows; r++) {
        const double complex *of = b->effect + r * b->n, u = row_at(b, of, b->before[r], b->z);
        if (b->bound)
            balance_limits_add_wall(b, of, u, true);
        else
            add_square(b, of, u, b->sharpness);
    }
    for (size_t p = 0; p < b->planes; p++)
        balance_limits_add_wall(b, b->share + p * b->n, row_at(b, b->share + p * b->n, 0.0, b->z), false);
}

/// Takes a Newton step, halved until the value falls; false if no gain is left.
static bool take_step(barrier *b) {
    enum { MAX_HALVINGS = 60 };
    static const double near = 1e-9; // relative to the decrement, half of which is about the remaining gain
    const double value = barrier_value(b, b->z);
    double decrement = 0.0, part = 1.0, *step = b->gradient;
    find_derivatives(b);
    memcpy(b->trial, b->gradient, b->size * sizeof *b->trial);
    if (!matrix_solve_definite(b->size, b->hessian, 1, step)) return false;
    for (size_t k = 0; k < b->size; k++) decrement += b->trial[k] * step[k];
    if (!(decrement > near)) return false;
    for (int halving = 0; halving < MAX_HALVINGS; halving++, part *= 0.5) {
        for (size_t k = 0; k < b->size; k++) b->trial[k] = b->z[k] - part * step[k];
        if (!(barrier_value(b, b->trial) <= value - 0.1 * part * decrement)) continue;
        memcpy(b->z, b->trial, b->size * sizeof *b->z);
        return true;
    }
    return false;
}

/// Follows the minima as the goal's weight grows: the last one is at most 2 (rows + planes)/sharpness above the least
/// value (Boyd and Vandenberghe 2004, sec. 11.2 and 11.6.2).
static void balance_limits_follow(barrier *b) {
    enum { MAX_STEPS = 100 };
    static const double gap = 1e-12, growth = 8.0;
    const double walls = 2.0 * (double)((b->bound ? b->rows : 0) + b->planes);
    for (b->sharpness = 1.0; walls / b->sharpness > gap; b->sharpness *= growth)
        for (int k = 0; k < MAX_STEPS && take_step(b); k++) {
        }
}

/// Scales the goal to numbers of the order of 1; `scale` [n] are kg m of the unknowns. False if nothing vibrates.
static bool barrier_begin(const balance_goal *goal, barrier *b, double *scale) {
    const size_t n = goal->n;
    double largest = 0.0;
    for (size_t r = 0; r < goal->rows; r++) largest = fmax(largest, cabs(goal->before[r]));
    if (!(largest > 0.0)) return false;
    for (size_t j = 0; j < n; j++) {
        double sum = 0.0;
        for (size_t r = 0; r < goal->rows; r++) sum += creal(goal->effect[r * n + j] * conj(goal->effect[r * n + j]));
        scale[j] = largest / sqrt(sum);
    }
    for (size_t r = 0; r < goal->rows; r++) {
        b->before[r] = goal->before[r] / largest;
        for (size_t j = 0; j < n; j++) b->effect[r * n + j] = goal->effect[r * n + j] * (scale[j] / largest);
    }
    for (size_t p = 0; p < goal->planes; p++)
        for (size_t j = 0; j < n; j++) b->share[p * n + j] = goal->share[p * n + j] * (scale[j] / goal->limits[p]);
    if (b->bound) b->z[b->size - 1] = 2.0;
    return true;
}

bool balance_best_within(const balance_goal *goal, double complex *amounts) {
    const size_t n = goal->n, lines = goal->rows + goal->planes;
    barrier b = {.n = n,
                 .rows = goal->rows,
                 .planes = goal->planes,
                 .size = 2 * n + (goal->least_max ? 1 : 0),
                 .bound = goal->least_max};
    double complex *block = calloc(lines * n + goal->rows + 1, sizeof *block);
    double *numbers = calloc(3 * b.size + b.size * b.size + n + 1, sizeof *numbers), *scale = numbers;
    const bool allocated = block && numbers;
    // Divide one allocation.
    if (allocated) {
        b.effect = block;
        b.share = block + goal->rows * n;
        b.before = block + lines * n;
        b.z = numbers + n;
        b.trial = b.z + b.size;
        b.gradient = b.trial + b.size;
        b.hessian = b.gradient + b.size;
        // Begin inside the limits, and follow the central path.
        if (barrier_begin(goal, &b, scale)) balance_limits_follow(&b);
        for (size_t j = 0; j < n; j++) amounts[j] = scale[j] * (b.z[2 * j] + b.z[2 * j + 1] * I);
    }
    free(block);
    free(numbers);
    return allocated;
}
