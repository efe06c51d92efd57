#include "curve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "elimination.h"
#include "matrix.h"

bool curve_begin(curve *c) {
    const size_t all = c->count + 1;
    c->matrix = calloc(all * all + 2 * all, sizeof *c->matrix);
    if (!c->matrix) return false;
    c->scale = c->matrix + all * all;
    c->known = false;
    c->share = 1.0;
    c->values = c->scale + all;
    return true;
}

void curve_end(curve *c) {
    free(c->matrix);
    c->matrix = NULL;
}

double curve_dot(const curve *c, const double *a, const double *b) {
    double sum = 0.0;
    for (size_t i = 0; i <= c->count; i++) sum += a[i] / c->scale[i] * (b[i] / c->scale[i]);
    return sum;
}

/// Writes what a row of the equations has to be so that its product with u is curve_dot's with a.
static void write_row(const curve *c, const double *a, double *row) {
    for (size_t i = 0; i <= c->count; i++) row[i] = a[i] / c->scale[i] / c->scale[i];
}

// ---------------------------------------------------------------- points

static bool evaluate(void *context, const double *u, double *value, double *derivative) {
    curve *c = context;
    if (!c->evaluate(c->context, u, value, derivative)) return false;
    for (size_t i = 0; i <= c->count; i++) c->values[i] = u[i] - c->from[i];
    value[c->count] = curve_dot(c, c->direction, c->values);
    if (!derivative) return true;
    write_row(c, c->direction, derivative + c->count * (c->count + 1));
    memcpy(c->matrix, derivative, (c->count + 1) * (c->count + 1) * sizeof *derivative);
    c->known = true;
    return true;
}

static double size_of(void *context, const double *u, const double *value) {
    const curve *c = context;
    return fmax(c->size(c->context, u, value), fabs(value[c->count]));
}

/// Points are near where they are looked for, or a shorter step finds them sooner.
enum { MOST_STEPS = 8, MOST_HALVINGS = 2 };

newton_result curve_correct(curve *c, const double *direction, double *u) {
    const size_t all = c->count + 1;
    newton_result result = {.size = INFINITY};
    double *from = malloc((all + all * all) * sizeof *from);
    if (!from) return result;
    double *nearby = from + all;
    memcpy(from, u, all * sizeof *from);
    write_row(c, direction, c->matrix + c->count * all);
    memcpy(nearby, c->matrix, all * all * sizeof *nearby);
    c->direction = direction;
    c->from = from;
    result = newton_solve(&(newton_problem){.count = c->count + 1,
                                            .context = c,
                                            .evaluate = evaluate,
                                            .size = size_of,
                                            .nearby = c->known ? nearby : NULL,
                                            .share = &c->share,
                                            .scale = c->scale,
                                            .tolerance = c->tolerance,
                                            .most_steps = MOST_STEPS,
                                            .most_halvings = MOST_HALVINGS},
                          u);
    free(from);
    return result;
}

double curve_pace(const newton_result *result) {
    return result->steps <= 3 ? 1.5 : result->steps <= 4 ? 1.1 : 0.6;
}

// ---------------------------------------------------------------- directions

static bool make_unit(const curve *c, double *a) {
    const double length = sqrt(curve_dot(c, a, a));
    if (!(isfinite(length) && length > 0.0)) return false;
    for (size_t i = 0; i <= c->count; i++) a[i] /= length;
    return true;
}

bool curve_tangent(curve *c, const double *along, double *tangent) {
    const size_t n = c->count, all = n + 1;
    double *factors = malloc(all * all * sizeof *factors);
    size_t *order = malloc(all * sizeof *order);
    write_row(c, along, c->matrix + n * all);
    memset(tangent, 0, n * sizeof *tangent);
    tangent[n] = 1.0;
    if (factors) memcpy(factors, c->matrix, all * all * sizeof *factors);
    const bool solved = factors && order && elimination_decompose(all, factors, order);
    if (solved) elimination_solve(all, factors, order, tangent);
    free(factors);
    free(order);
    return solved && make_unit(c, tangent);
}

/// Unknowns in units of the scale: rows of the derivative as they are.
bool curve_other(curve *c, const double *tangent, double *other) {
    const size_t n = c->count, all = n + 1;
    double *square = calloc(all * all + all + 1, sizeof *square), *values = square ? square + all * all : NULL;
    double *vectors = calloc(all * all + 1, sizeof *vectors);
    bool good = square && vectors;
    // The least singular direction of the derivative with the tangent for its last row.
    write_row(c, tangent, c->matrix + n * all);
    for (size_t i = 0; i < all && good; i++)
        for (size_t k = 0; k < all; k++)
            for (size_t r = 0; r < all; r++)
                square[i * all + k] += c->matrix[r * all + i] * c->scale[i] * c->matrix[r * all + k] * c->scale[k];
    good = good && matrix_symmetric_modes(all, square, NULL, values, vectors);
    for (size_t i = 0; i < all && good; i++) other[i] = vectors[i] * c->scale[i];
    free(square);
    free(vectors);
    return good && make_unit(c, other);
}
