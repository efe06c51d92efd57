#include "curve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "elimination.h"
#include "matrix.h"

whirl_status curve_check(const curve_way *w, double value) {
    const double low = fmin(w->from, w->to), high = fmax(w->from, w->to);
    if (!(isfinite(low) && isfinite(high) && low < high))
        return whirl_fail(WHIRL_BAD_INPUT, "a branch from %g to %g, expected two values", w->from, w->to);
    if (!(value >= low && value <= high))
        return whirl_fail(WHIRL_BAD_INPUT, "a branch begins at %g, expected a value from %g to %g", value, low, high);
    if (!(w->least_step > 0.0 && w->least_step <= w->step && w->step <= w->most_step && isfinite(w->most_step)))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "steps of a branch of %g to %g, the first of %g, expected them to ascend from above 0",
                          w->least_step, w->most_step, w->step);
    return whirl_ok();
}

bool curve_begin(curve *c) {
    const size_t all = c->count + 1;
    c->matrix = calloc(2 * all * all + 2 * all, sizeof *c->matrix);
    c->order = calloc(all, sizeof *c->order);
    if (!c->matrix || !c->order) return false;
    c->factors = c->matrix + all * all;
    c->scale = c->factors + all * all;
    c->known = false;
    c->decomposed = false;
    c->share = 1.0;
    c->values = c->scale + all;
    return true;
}

void curve_end(curve *c) {
    free(c->matrix);
    free(c->order);
    c->matrix = NULL;
    c->order = NULL;
}

double curve_dot(const curve *c, const double *a, const double *b) {
    double sum = 0.0;
    for (size_t i = 0; i <= c->count; i++) sum += a[i] / c->scale[i] * (b[i] / c->scale[i]);
    return sum;
}

/// Writes the row whose product with u is curve_dot of a and u.
static void write_row(const curve *c, const double *a, double *row) {
    for (size_t i = 0; i <= c->count; i++) row[i] = a[i] / c->scale[i] / c->scale[i];
}

/// Decomposes the matrix with `direction` in its last row, unless it already is decomposed so.
static bool decompose_with(curve *c, const double *direction) {
    const size_t all = c->count + 1;
    double *last = c->matrix + c->count * all, *row = c->values;
    write_row(c, direction, row);
    if (c->decomposed && memcmp(row, last, all * sizeof *row) == 0) return true;
    memcpy(last, row, all * sizeof *row);
    memcpy(c->factors, c->matrix, all * all * sizeof *c->matrix);
    c->decomposed = elimination_decompose(all, c->factors, c->order);
    return c->decomposed;
}

// ---------------------------------------------------------------- points

static bool curve_evaluate(void *context, const double *u, double *value, double *derivative) {
    curve *c = context;
    if (!c->evaluate(c->context, u, value, derivative)) return false;
    for (size_t i = 0; i <= c->count; i++) c->values[i] = u[i] - c->from[i];
    value[c->count] = curve_dot(c, c->direction, c->values);
    if (!derivative) return true;
    write_row(c, c->direction, derivative + c->count * (c->count + 1));
    memcpy(c->matrix, derivative, (c->count + 1) * (c->count + 1) * sizeof *derivative);
    c->known = true;
    c->decomposed = false;
    return true;
}

static double curve_size_of(void *context, const double *u, const double *value) {
    const curve *c = context;
    return fmax(c->size(c->context, u, value), fabs(value[c->count]));
}

/// Maximum number of steps and halvings of Newton's method. They are small since points are near their prediction;
/// otherwise a shorter step is cheaper.
enum { MAX_STEPS = 8, MAX_HALVINGS = 2 };

newton_result curve_correct(curve *c, const double *direction, double *u) {
    const size_t all = c->count + 1;
    newton_result result = {.size = INFINITY};
    double *from = malloc(all * sizeof *from);
    if (!from) return result;
    // The factors of the last point serve as an approximate derivative near it.
    memcpy(from, u, all * sizeof *from);
    const bool nearby = c->known && decompose_with(c, direction);
    c->direction = direction;
    c->from = from;
    result = newton_solve(&(newton_problem){.count = all,
                                            .context = c,
                                            .evaluate = curve_evaluate,
                                            .size = curve_size_of,
                                            .nearby = nearby ? c->factors : NULL,
                                            .nearby_order = c->order,
                                            .share = &c->share,
                                            .scale = c->scale,
                                            .tolerance = c->tolerance,
                                            .most_steps = MAX_STEPS,
                                            .most_halvings = MAX_HALVINGS},
                          u);
    free(from);
    return result;
}

double curve_pace(const newton_result *result) {
    return result->steps <= 3 ? 1.5 : result->steps <= 4 ? 1.1 : 0.6;
}

// ---------------------------------------------------------------- directions

bool curve_make_unit(const curve *c, double *direction) {
    const double length = sqrt(curve_dot(c, direction, direction));
    if (!(isfinite(length) && length > 0.0)) return false;
    for (size_t i = 0; i <= c->count; i++) direction[i] /= length;
    return true;
}

void curve_parameter_direction(const curve *c, double *direction) {
    memset(direction, 0, c->count * sizeof *direction);
    direction[c->count] = c->scale[c->count];
}

void curve_turn(const curve *c, int direction, double *tangent) {
    const bool back = (tangent[c->count] < 0.0) != (direction < 0);
    for (size_t i = 0; back && i <= c->count; i++) tangent[i] = -tangent[i];
}

bool curve_tangent(curve *c, const double *across, const double *along, double *tangent) {
    const size_t all = c->count + 1;
    memset(tangent, 0, all * sizeof *tangent);
    tangent[c->count] = 1.0;
    if (!decompose_with(c, across)) return false;
    elimination_solve(all, c->factors, c->order, tangent);
    if (!curve_make_unit(c, tangent)) return false;
    const double side = curve_dot(c, tangent, along) < 0.0 ? -1.0 : 1.0;
    for (size_t i = 0; i < all; i++) tangent[i] *= side;
    return true;
}

/// Computes the direction. The rows of the derivative are not scaled; the unknowns are in units of the scale.
bool curve_other(curve *c, const double *tangent, double *other) {
    const size_t n = c->count, all = n + 1;
    double *square = calloc(all * all + all + 1, sizeof *square), *values = square ? square + all * all : NULL;
    double *vectors = calloc(all * all + 1, sizeof *vectors);
    bool good = square && vectors;
    // Find the least singular direction of the derivative with the tangent as last row.
    write_row(c, tangent, c->matrix + n * all);
    c->decomposed = false;
    for (size_t i = 0; i < all && good; i++)
        for (size_t k = 0; k < all; k++)
            for (size_t r = 0; r < all; r++)
                square[i * all + k] += c->matrix[r * all + i] * c->scale[i] * c->matrix[r * all + k] * c->scale[k];
    good = good && matrix_symmetric_modes(all, square, NULL, values, vectors);
    for (size_t i = 0; i < all && good; i++) other[i] = vectors[i] * c->scale[i];
    free(square);
    free(vectors);
    return good && curve_make_unit(c, other);
}
