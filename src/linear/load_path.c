// Equilibria over the share of the load, by pseudo-arc-length continuation: unknowns are all coordinates over a unit,
// and the share. A step goes along the tangent, and Newton's method returns to the path at right angles to it.
#include "load_path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"

/// Length of the first and of the longest step, and of the shortest one, below which the path is lost.
static const double first_step = 0.05, longest_step = 0.1, shortest_step = 1e-5;

typedef struct load_path {
    mean_system *mean;
    size_t n; ///< coordinates; the share is unknown number n
    double unit;
    double *load;    ///< [n] f at the start
    double *state;   ///< [dimension] workspace
    double *f;       ///< [n]
    double *matrix;  ///< [n + 1][n + 1]
    double *solved;  ///< [n + 1]
    double *slope;   ///< [n][n]
    double *at;      ///< [n + 1] last point
    double *tangent; ///< [n + 1] there
    double *next;    ///< [n + 1]
    double *turned;  ///< [n + 1] tangent at `next`
} load_path;

static void path_set_state(const load_path *p, const double *z) {
    for (size_t i = 0; i < p->n; i++) p->state[p->mean->kept[i]] = p->unit * z[i];
}

/// Solves for the equations of motion and, as the last one, row . solved = right. Writes `solved`; the equations of
/// motion have the right-hand side -f + (1 - share) load if `corrects`, else 0.
static bool path_solve(load_path *p, const double *z, const double *row, double right, bool corrects) {
    const size_t n = p->n, wide = n + 1;
    path_set_state(p, z);
    mean_slope(p->mean, p->state, p->f);
    mean_jacobian(p->mean, p->state, p->slope);
    for (size_t i = 0; i < n; i++) {
        double largest = fabs(p->load[i]), *own = p->matrix + i * wide;
        for (size_t k = 0; k < n; k++) {
            own[k] = p->unit * p->slope[i * n + k];
            largest = fmax(largest, fabs(own[k]));
        }
        own[n] = p->load[i];
        p->solved[i] = corrects ? (1.0 - z[n]) * p->load[i] - p->f[i] : 0.0;
        if (!(largest > 0.0) || !isfinite(largest) || !isfinite(p->solved[i])) return false;
        for (size_t k = 0; k < wide; k++) own[k] /= largest;
        p->solved[i] /= largest;
    }
    memcpy(p->matrix + n * wide, row, wide * sizeof *row);
    p->solved[n] = right;
    return matrix_solve(wide, p->matrix, 1, p->solved);
}

/// Writes the tangent at z that goes on in the direction of `before`.
static bool path_turn(load_path *p, const double *z, const double *before, double *tangent) {
    double square = 0.0;
    if (!path_solve(p, z, before, 1.0, false)) return false;
    for (size_t i = 0; i <= p->n; i++) square += p->solved[i] * p->solved[i];
    for (size_t i = 0; i <= p->n; i++) tangent[i] = p->solved[i] / sqrt(square);
    return isfinite(square) && square > 0.0;
}

/// Goes a step from `at` to `next`; *quick: Newton's method converged in few iterations.
static bool path_step(load_path *p, double step, bool *quick) {
    enum { MAX_ITERATIONS = 8, FEW = 3 };
    for (size_t i = 0; i <= p->n; i++) p->next[i] = p->at[i] + step * p->tangent[i];
    for (int k = 0; k < MAX_ITERATIONS; k++) {
        double along = 0.0, length = 0.0;
        for (size_t i = 0; i <= p->n; i++) along += p->tangent[i] * (p->next[i] - p->at[i]);
        if (!path_solve(p, p->next, p->tangent, step - along, true)) return false;
        for (size_t i = 0; i <= p->n; i++) {
            p->next[i] += p->solved[i];
            length = fmax(length, fabs(p->solved[i]));
        }
        *quick = k < FEW;
        if (length < 1e-9) return path_turn(p, p->next, p->tangent, p->turned);
        if (!(length < 1.0)) return false;
    }
    return false;
}

/// Solves at share 1. Begins between the last two points, where the share is interpolated as 1.
static bool path_finish(load_path *p) {
    enum { MAX_ITERATIONS = 20 };
    const size_t n = p->n;
    const double part = (1.0 - p->at[n]) / (p->next[n] - p->at[n]);
    for (size_t i = 0; i <= n; i++) p->next[i] = p->at[i] + part * (p->next[i] - p->at[i]);
    memset(p->turned, 0, n * sizeof *p->turned);
    p->turned[n] = 1.0;
    for (int k = 0; k < MAX_ITERATIONS; k++) {
        double length = 0.0;
        if (!path_solve(p, p->next, p->turned, 1.0 - p->next[n], true)) return false;
        for (size_t i = 0; i <= n; i++) {
            p->next[i] += p->solved[i];
            length = fmax(length, fabs(p->solved[i]));
        }
        if (length < 1e-12) return true;
        if (!(length < 1.0)) return false;
    }
    return false;
}

static bool path_reach(load_path *p) {
    enum { MAX_STEPS = 300 };
    const size_t n = p->n;
    double step = first_step;
    memset(p->turned, 0, n * sizeof *p->turned);
    p->turned[n] = 1.0;
    if (!path_turn(p, p->at, p->turned, p->tangent)) return false;
    for (int k = 0; k < MAX_STEPS && p->at[n] > -0.5; k++) {
        bool quick = false;
        if (!path_step(p, step, &quick)) {
            step *= 0.5;
            if (step < shortest_step) return false;
            continue;
        }
        if (p->next[n] >= 1.0) return path_finish(p);
        memcpy(p->at, p->next, (n + 1) * sizeof *p->at);
        memcpy(p->tangent, p->turned, (n + 1) * sizeof *p->tangent);
        if (quick) step = fmin(2.0 * step, longest_step);
    }
    return false;
}

bool load_path_follow(mean_system *m, double unit, double *x) {
    const size_t n = m->count, d = m->system->dimension, wide = n + 1;
    double *block = calloc(2 * n + n * n + wide * wide + 5 * wide + d, sizeof *block);
    if (!block) return false;
    load_path p = {.mean = m, .n = n, .unit = unit, .load = block, .f = block + n, .slope = block + 2 * n};
    p.matrix = p.slope + n * n;
    p.solved = p.matrix + wide * wide;
    p.at = p.solved + wide;
    p.tangent = p.at + wide;
    p.next = p.tangent + wide;
    p.turned = p.next + wide;
    p.state = p.turned + wide;
    memcpy(p.state, x, d * sizeof *x);
    mean_slope(m, x, p.load);
    for (size_t i = 0; i < n; i++) p.at[i] = x[m->kept[i]] / unit;
    const bool reached = path_reach(&p);
    for (size_t i = 0; i < n && reached; i++) x[m->kept[i]] = unit * p.next[i];
    free(block);
    return reached;
}
