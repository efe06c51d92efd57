// Perturbations along the steps of a stepper: the exact derivative of every step, switches and sliding included.
#include <math.h>
#include <string.h>

#include "orthonormal.h"
#include "saltation.h"
#include "stepper.h"
#include "stepper_parts.h"

/// Indices of single vectors of the workspace.
enum { BEFORE, AFTER, GRADIENT, CURVED };

static double *spare(const stepper *c, int which) {
    return c->variation.spare + (size_t)which * c->dimension;
}

void stepper_follow(stepper *c, size_t most, double *work) {
    stepper_variation *v = &c->variation;
    const size_t row = (1 + most) * c->dimension;
    for (size_t i = 0; i < DOP853_STAGES; i++) v->k[i] = work + i * row;
    v->stage = work + DOP853_STAGES * row;
    v->upper = v->stage + row;
    v->end = v->upper + row;
    v->spare = work + PERTURBATION_ROWS * row;
}

static double variation_dot(size_t n, const double *a, const double *b) {
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

// ---------------------------------------------------------------- the Jacobian of motion along switches

/// Computes the mean of the Jacobians on both sides of all switches along which the motion slides, weighted as the
/// slopes are.
static void mean_jacobian(const stepper *c, double t, const double *x, const size_t *list, const double *share,
                          size_t count, const double *vectors, double *out) {
    const whirl_system *system = c->system;
    const size_t size = count * c->dimension;
    double forcing[WHIRL_MAX_FORCING], lower = 1.0, *upper = c->variation.upper;
    double *sides = stepper_row(c, ROW_SIDES_OF_MEAN);
    if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
    memcpy(sides, c->sides, system->switch_count * sizeof *sides);
    for (size_t j = 0; j < c->sliding_count; j++) {
        sides[list[j]] = -1.0;
        lower -= share[j];
    }
    system->tangent(system->model, t, forcing, x, sides, count, vectors, out);
    for (size_t d = 0; d < size; d++) out[d] *= lower;
    for (size_t j = 0; j < c->sliding_count; j++) {
        sides[list[j]] = 1.0;
        system->tangent(system->model, t, forcing, x, sides, count, vectors, upper);
        sides[list[j]] = -1.0;
        for (size_t d = 0; d < size; d++) out[d] += share[j] * upper[d];
    }
}

/// Applies the Jacobian of a motion that slides. Its slope keeps n . f + dh/dt = 0 for every switch along which it
/// slides, and so must the change of the slope by a perturbation u. So the shares change by the solution of sum_j (n_i
/// . added_j) dshare_j = -(n_i . J u + (H_i u) . f).
static void slide_along(const stepper *c, double t, const double *x, size_t vector_count, const double *vectors,
                        double *out) {
    const whirl_system *system = c->system;
    const size_t n = c->dimension, count = c->sliding_count;
    const double *added = c->work + n;
    double share[MAX_SLIDING], by_time, *slope = c->work + (MAX_SLIDING + 1) * n, *curved = spare(c, CURVED);
    size_t list[MAX_SLIDING];
    // Compute slope and shares along the switches, and apply the mean Jacobian to the vectors.
    stepper_list_sliding(c, list);
    stepper_slope_along(c, t, x, slope, share);
    mean_jacobian(c, t, x, list, share, vector_count, vectors, out);
    // Solve for the change of the shares by each vector, and add its effect.
    for (size_t k = 0; k < vector_count; k++) {
        const double *u = vectors + k * n;
        double matrix[MAX_SLIDING][MAX_SLIDING], change[MAX_SLIDING], *row = out + k * n;
        for (size_t i = 0; i < count; i++) {
            system->switch_gradient(system->model, t, x, list[i], spare(c, GRADIENT), &by_time);
            change[i] = -variation_dot(n, spare(c, GRADIENT), row);
            if (system->switch_curvature) {
                system->switch_curvature(system->model, t, x, list[i], u, curved);
                change[i] -= variation_dot(n, curved, slope);
            }
            for (size_t j = 0; j < count; j++) matrix[i][j] = variation_dot(n, spare(c, GRADIENT), added + j * n);
        }
        if (!stepper_solve(count, matrix, change)) continue;
        for (size_t j = 0; j < count; j++)
            for (size_t d = 0; d < n; d++) row[d] += change[j] * added[j * n + d];
    }
}

void stepper_vary_begin(stepper *c) {
    const whirl_system *system = c->system;
    const size_t n = c->dimension, count = c->sliding_count;
    const double *added = c->work + n;
    double share[MAX_SLIDING], by_time;
    size_t list[MAX_SLIDING];
    if (!c->variation.set || count == 0) return;
    stepper_list_sliding(c, list);
    stepper_slope_along(c, c->t, c->x, c->work + (MAX_SLIDING + 1) * n, share);
    for (size_t k = 0; k < c->variation.set->count; k++) {
        double matrix[MAX_SLIDING][MAX_SLIDING], off[MAX_SLIDING], *u = c->variation.set->vectors + k * n;
        for (size_t i = 0; i < count; i++) {
            system->switch_gradient(system->model, c->t, c->x, list[i], spare(c, GRADIENT), &by_time);
            off[i] = variation_dot(n, spare(c, GRADIENT), u);
            for (size_t j = 0; j < count; j++) matrix[i][j] = variation_dot(n, spare(c, GRADIENT), added + j * n);
        }
        if (!stepper_solve(count, matrix, off)) continue;
        for (size_t j = 0; j < count; j++)
            for (size_t d = 0; d < n; d++) u[d] -= off[j] * added[j * n + d];
    }
}

void stepper_apply_jacobian(const stepper *c, double t, const double *x, size_t count, const double *vectors,
                            double *out) {
    const whirl_system *system = c->system;
    const double *sides = system->rhs_on_sides ? c->sides : NULL;
    double forcing[WHIRL_MAX_FORCING];
    if (c->sliding_count > 0) {
        slide_along(c, t, x, count, vectors, out);
        return;
    }
    if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
    system->tangent(system->model, t, forcing, x, sides, count, vectors, out);
}

double stepper_divergence(const stepper *c, double t, const double *x) {
    const whirl_system *system = c->system;
    double forcing[WHIRL_MAX_FORCING];
    if (c->sliding_count > 0) return NAN;
    if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
    return divergence_at(system, t, forcing, x, system->rhs_on_sides ? c->sides : NULL);
}

// ---------------------------------------------------------------- steps and switches

double stepper_varied_tolerance(const stepper *c, size_t which) {
    const size_t n = c->dimension;
    const double *from = c->variation.set->vectors + which * n, *to = c->variation.end + which * n;
    return c->rtol * sqrt(fmax(variation_dot(n, from, from), variation_dot(n, to, to)));
}

void stepper_vary(stepper *c) {
    const stepper_variation *v = &c->variation;
    whirl_perturbations *set = v->set;
    if (!set) return;
    memcpy(set->vectors, v->end, set->count * c->dimension * sizeof *v->end);
    set->volume += v->volume;
    if (set->growth) make_orthonormal(c->dimension, set->count, set->vectors, set->growth);
}

void stepper_cross_varied(stepper *c, size_t which) {
    whirl_perturbations *set = c->variation.set;
    const bool slid = c->sliding[which];
    const double from = c->sides[which];
    double by_time;
    if (!set || slid || !c->system->rhs_on_sides || !c->system->switch_gradient) {
        // The slope is continuous where a motion ends sliding along a switch.
        stepper_cross(c, which);
        return;
    }
    stepper_slope(c, c->t, c->x, spare(c, BEFORE));
    c->system->switch_gradient(c->system->model, c->t, c->x, which, spare(c, GRADIENT), &by_time);
    stepper_cross(c, which);
    if (c->sides[which] == from && !c->sliding[which]) return;
    stepper_slope(c, c->t, c->x, spare(c, AFTER));
    set->volume +=
        saltate(c->dimension, spare(c, BEFORE), spare(c, AFTER), spare(c, GRADIENT), by_time, set->count, set->vectors);
    if (c->sliding[which]) set->volume = NAN;
}
