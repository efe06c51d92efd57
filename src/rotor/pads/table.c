#include "table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// Nodes, and volumes of the films at them.
enum { T_NODES = 28, W_NODES = 27, ALPHA_NODES = 48, AROUND_A_TURN = 128 };

static const double least_t = 0.14, most_t = 1.6, most_w = 0.92, two_pi = 6.28318530717958647693;

static double largest_y(const pad_table *table, double x) {
    return x >= table->cosine ? sqrt(1.0 - x * x) : (1.0 - x * table->cosine) / table->sine;
}

static double node(const pad_axis *axis, int i) {
    return axis->first + axis->step * i;
}

static double *coefficient(const pad_table *table, int t, int w, int alpha) {
    const int rows = table->w.count + 2, columns = table->alpha.count + 3;
    return table->coefficients + 2 * (((size_t)(t * rows + w)) * (size_t)columns + (size_t)alpha);
}

// ---------------------------------------------------------------- values

/// S at the nodes of one t and w, at all alphas.
static whirl_status fill_nodes(pad_table *table, const pad_film *film, pad_workspace *work, int t, int w) {
    const double thickness = pow(node(&table->t, t), 2.0), x = 1.0 - thickness, own = node(&table->w, w);
    const double v = 2.0 * own / (1.0 + own * own), scale = (1.0 - v * v) * thickness * thickness;
    const double y = v * largest_y(table, x);
    for (int k = 0; k < table->alpha.count; k++) {
        const double alpha = node(&table->alpha, k);
        const pad_place at = {.x = x, .y = y, .a = cos(alpha), .b = sin(alpha)};
        pad_answer answer;
        const whirl_status status = pad_solve(work, film, &at, &answer);
        if (status.code != WHIRL_OK) return status;
        for (int i = 0; i < 2; i++) coefficient(table, t + 1, w + 1, k + 1)[i] = scale * answer.force[i];
    }
    return whirl_ok();
}

/// The pad is its own mirror image: with y and A the force along it changes its sign, and alpha becomes pi - alpha.
static void mirror_nodes(pad_table *table, int t, int w) {
    const int other = table->w.count - 1 - w, count = table->alpha.count;
    for (int k = 0; k < count; k++) {
        const double *value = coefficient(table, t + 1, w + 1, (count + count / 2 - k) % count + 1);
        const double along = value[1];
        double *image = coefficient(table, t + 1, other + 1, k + 1);
        if (other == w) continue;
        image[0] = value[0];
        image[1] = -along;
    }
}

// ---------------------------------------------------------------- splines

/// Coefficients of the cubic spline through values [count] at equal distances, in place of the values, c [count + 2]
/// with a stride, values from c[1] on. Third differences vanish at both ends, or it is periodic (then c [count + 3]).
static void spline(double *c, int count, size_t stride, bool periodic, double *work) {
    double *low = work, *value = work + count, *far = value + count;
    // (c[i-1] + 4 c[i] + c[i+1])/6 = value.
    for (int i = 0; i < count; i++) value[i] = 6.0 * c[(size_t)(i + 1) * stride], far[i] = 0.0;
    if (!periodic) {
        // c[-1] = 3 c[0] - 3 c[1] + c[2]: first row 7, -2, 1; the last one likewise. The third entry is taken away
        // by the row beside it: (7, -2, 1) - (1, 4, 1) = (6, -6, 0).
        value[0] -= value[1];
        value[count - 1] -= value[count - 2];
        low[0] = -1.0; // -6/6
        value[0] /= 6.0;
        for (int i = 1; i < count - 1; i++) {
            const double over = 1.0 / (4.0 - low[i - 1]);
            low[i] = over;
            value[i] = (value[i] - value[i - 1]) * over;
        }
        const int last = count - 1;
        value[last] = (value[last] + 6.0 * value[last - 1]) / (6.0 + 6.0 * low[last - 1]);
        for (int i = last; i-- > 0;) value[i] -= low[i] * value[i + 1];
        for (int i = 0; i < count; i++) c[(size_t)(i + 1) * stride] = value[i];
        c[0] = 3.0 * value[0] - 3.0 * value[1] + value[2];
        c[(size_t)(count + 1) * stride] = 3.0 * value[last] - 3.0 * value[last - 1] + value[last - 2];
        return;
    }
    // Gauss-Seidel converges by a factor of 4 a round and more.
    for (int i = 0; i < count; i++) far[i] = value[i] / 6.0;
    for (int round = 0; round < 60; round++)
        for (int i = 0; i < count; i++) far[i] = (value[i] - far[(i + count - 1) % count] - far[(i + 1) % count]) / 4.0;
    for (int i = 0; i < count; i++) c[(size_t)(i + 1) * stride] = far[i];
    c[0] = far[count - 1];
    c[(size_t)(count + 1) * stride] = far[0];
    c[(size_t)(count + 2) * stride] = far[1];
}

static void make_splines(pad_table *table, double *work) {
    const int t = table->t.count, w = table->w.count, alpha = table->alpha.count;
    const size_t along_alpha = 2, along_w = 2 * (size_t)(alpha + 3), along_t = along_w * (size_t)(w + 2);
    for (int i = 1; i <= t; i++)
        for (int j = 1; j <= w; j++)
            for (int k = 0; k < 2; k++) spline(coefficient(table, i, j, 0) + k, alpha, along_alpha, true, work);
    for (int i = 1; i <= t; i++)
        for (size_t k = 0; k < along_w; k++) spline(coefficient(table, i, 0, 0) + k, w, along_w, false, work);
    for (size_t k = 0; k < along_t; k++) spline(table->coefficients + k, t, along_t, false, work);
}

// ---------------------------------------------------------------- the whole

void pad_table_free(pad_table *table) {
    if (table) free(table->coefficients);
    free(table);
}

size_t pad_table_size(const pad_table *table) {
    return 2 * (size_t)(table->t.count + 2) * (size_t)(table->w.count + 2) * (size_t)(table->alpha.count + 3);
}

pad_table *pad_table_empty(double arc) {
    pad_table *table = calloc(1, sizeof *table);
    if (!table) return NULL;
    *table = (pad_table){.cosine = cos(0.5 * arc),
                         .sine = sin(0.5 * arc),
                         .t = {least_t, (most_t - least_t) / (T_NODES - 1), T_NODES},
                         .w = {-most_w, 2.0 * most_w / (W_NODES - 1), W_NODES},
                         .alpha = {-0.5 * two_pi, two_pi / ALPHA_NODES, ALPHA_NODES}};
    table->coefficients = calloc(pad_table_size(table), sizeof *table->coefficients);
    if (table->coefficients) return table;
    free(table);
    return NULL;
}

static whirl_status fill(pad_table *table, const pad_film *film) {
    pad_workspace *work;
    double *lines = malloc(4 * (size_t)ALPHA_NODES * sizeof *lines);
    whirl_status status = pad_workspace_new(film->around, film->along, &work);
    if (status.code == WHIRL_OK && !lines) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the table of a pad");
    for (int t = 0; t < T_NODES && status.code == WHIRL_OK; t++)
        for (int w = W_NODES / 2; w < W_NODES && status.code == WHIRL_OK; w++) {
            status = fill_nodes(table, film, work, t, w);
            if (status.code == WHIRL_OK) mirror_nodes(table, t, w);
        }
    if (status.code == WHIRL_OK) make_splines(table, lines);
    pad_workspace_free(work);
    free(lines);
    return status;
}

/// The grid of a table: half as long as it is wide, or longer, a pad needs more volumes along it.
static pad_film film_of(const pad_table_key *key) {
    const int around = 16 * (int)ceil(key->arc / two_pi * AROUND_A_TURN / 16.0), least = 64;
    const double along = 4.0 * ceil(4.0 * key->ratio / key->arc);
    return (pad_film){.arc = key->arc,
                      .ratio = key->ratio,
                      .law = key->law,
                      .around = around > least ? around : least,
                      .along = (int)fmin(fmax(along, 8.0), 24.0),
                      .turbulence = key->turbulence,
                      .reynolds = key->reynolds};
}

whirl_status pad_table_new(const pad_table_key *key, pad_table **out) {
    const pad_film film = film_of(key);
    pad_table *table = pad_table_empty(key->arc);
    const whirl_status status =
        table ? fill(table, &film) : whirl_fail(WHIRL_NO_MEMORY, "no memory for the table of a pad");
    *out = status.code == WHIRL_OK ? table : NULL;
    if (status.code != WHIRL_OK) pad_table_free(table);
    return status;
}
