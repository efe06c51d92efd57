#include "pad_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// Volumes around a full turn, in the films at the nodes.
enum { AROUND_A_TURN = 128 };

static double largest_y(double arc, double x) {
    const double cosine = cos(0.5 * arc);
    return x >= cosine ? sqrt(1.0 - x * x) : (1.0 - x * cosine) / sin(0.5 * arc);
}

static double *coefficient(double *all, int t, int w, int alpha) {
    return all + (size_t)t * PAD_SHEET + (size_t)w * PAD_ROW + 2 * (size_t)alpha;
}

// ---------------------------------------------------------------- values

/// Computes S at a node.
static whirl_status solve_node(const pad_film *film, pad_workspace *work, int t, int w, int k, double value[2]) {
    const double thickness = pow(PAD_MIN_T + PAD_STEP_T * t, 2.0), x = 1.0 - thickness,
                 own = PAD_STEP_W * w - PAD_MAX_W;
    const double v = 2.0 * own / (1.0 + own * own), scale = (1.0 - v * v) * thickness * thickness;
    const double y = v * largest_y(film->arc, x), alpha = PAD_STEP_ALPHA * k - PAD_HALF_TURN;
    const pad_place at = {.x = x, .y = y, .a = cos(alpha), .b = sin(alpha)};
    pad_answer answer;
    const whirl_status status = pad_solve(work, film, &at, &answer);
    for (int i = 0; i < 2 && status.code == WHIRL_OK; i++) value[i] = scale * answer.force[i];
    return status;
}

/// Computes S at the nodes of one t and w, for all alphas.
static whirl_status fill_nodes(double *all, const pad_film *film, pad_workspace *work, int t, int w) {
    whirl_status status = whirl_ok();
    for (int k = 0; k < PAD_ALPHA_NODES && status.code == WHIRL_OK; k++)
        status = solve_node(film, work, t, w, k, coefficient(all, t + 1, w + 1, k + 1));
    return status;
}

/// Fills in the mirror images: if y and A change sign, so does the force along the pad, and alpha becomes pi - alpha.
static void mirror_nodes(double *all, int t, int w) {
    const int other = PAD_W_NODES - 1 - w, count = PAD_ALPHA_NODES;
    for (int k = 0; k < count; k++) {
        const double *value = coefficient(all, t + 1, w + 1, (count + count / 2 - k) % count + 1);
        const double along = value[1];
        double *image = coefficient(all, t + 1, other + 1, k + 1);
        if (other == w) continue;
        image[0] = value[0];
        image[1] = -along;
    }
}

// ---------------------------------------------------------------- splines

/// Computes the coefficients of the cubic spline through values [count] at equal distances. They replace the values: c
/// [count + 2] with a stride, whose values begin at c[1]. Third differences vanish at both ends; or the spline is
/// periodic (then c has count + 3 numbers).
static void spline(double *c, int count, size_t stride, bool periodic, double *work) {
    double *low = work, *value = work + count, *far = value + count;
    // The equations are (c[i-1] + 4 c[i] + c[i+1])/6 = value.
    for (int i = 0; i < count; i++) value[i] = 6.0 * c[(size_t)(i + 1) * stride], far[i] = 0.0;
    if (!periodic) {
        // With c[-1] = 3 c[0] - 3 c[1] + c[2] the first row is 7, -2, 1; the last row likewise. The next row eliminates
        // the third number: (7, -2, 1) - (1, 4, 1) = (6, -6, 0).
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
    // Gauss-Seidel iteration converges by a factor of 4 or more in a round.
    for (int i = 0; i < count; i++) far[i] = value[i] / 6.0;
    for (int round = 0; round < 60; round++)
        for (int i = 0; i < count; i++) far[i] = (value[i] - far[(i + count - 1) % count] - far[(i + 1) % count]) / 4.0;
    for (int i = 0; i < count; i++) c[(size_t)(i + 1) * stride] = far[i];
    c[0] = far[count - 1];
    c[(size_t)(count + 1) * stride] = far[0];
    c[(size_t)(count + 2) * stride] = far[1];
}

static void make_splines(double *all, double *work) {
    for (int i = 1; i <= PAD_T_NODES; i++)
        for (int j = 1; j <= PAD_W_NODES; j++)
            for (int k = 0; k < 2; k++) spline(coefficient(all, i, j, 0) + k, PAD_ALPHA_NODES, 2, true, work);
    for (int i = 1; i <= PAD_T_NODES; i++)
        for (int k = 0; k < PAD_ROW; k++) spline(coefficient(all, i, 0, 0) + k, PAD_W_NODES, PAD_ROW, false, work);
    for (int k = 0; k < PAD_SHEET; k++) spline(all + k, PAD_T_NODES, PAD_SHEET, false, work);
}

// ---------------------------------------------------------------- the whole

/// Returns the film with the grid of a table. Pads with L/D above one half need more volumes along their length.
pad_film pad_table_film(const pad_table_key *key) {
    const int around = 16 * (int)ceil(key->arc / (2.0 * PAD_HALF_TURN) * AROUND_A_TURN / 16.0), least = 64;
    const double along = 4.0 * ceil(4.0 * key->ratio / key->arc);
    return (pad_film){.arc = key->arc,
                      .ratio = key->ratio,
                      .law = key->law,
                      .around = around > least ? around : least,
                      .along = (int)fmin(fmax(along, 8.0), 24.0),
                      .turbulence = key->turbulence,
                      .reynolds = key->reynolds};
}

pad_table *pad_table_empty(void) {
    pad_table *table = aligned_alloc(_Alignof(pad_table), sizeof *table);
    if (table) memset(table, 0, sizeof *table);
    return table;
}

void pad_table_rows(pad_table *table) {
    for (size_t place = 0; place < (size_t)(PAD_T_NODES + 2) * (PAD_W_NODES + 2); place++)
        for (size_t cell = 0; cell < PAD_ALPHA_NODES; cell++)
            memcpy(table->rows + place * PAD_W_APART + cell * PAD_ALPHA_APART,
                   table->coefficients + place * PAD_ROW + 2 * cell, PAD_ALPHA_APART * sizeof(double));
}

whirl_status pad_table_fill(pad_table *table, const pad_film *film, pad_workspace *work, int t) {
    whirl_status status = whirl_ok();
    for (int w = PAD_W_NODES / 2; w < PAD_W_NODES && status.code == WHIRL_OK; w++) {
        status = fill_nodes(table->coefficients, film, work, t, w);
        if (status.code == WHIRL_OK) mirror_nodes(table->coefficients, t, w);
    }
    return status;
}

void pad_table_splines(pad_table *table) {
    double line[4 * PAD_ALPHA_NODES];
    make_splines(table->coefficients, line);
}

// ---------------------------------------------------------------- pads that tilt freely

/// Returns the force along the pad, by the spline over alpha.
static double along_alpha(const double line[PAD_ROW], double alpha, const double along[2]) {
    const double place = (alpha + PAD_HALF_TURN) / PAD_STEP_ALPHA + PAD_ALPHA_NODES;
    const int cell = (int)place % PAD_ALPHA_NODES;
    const double u = place - floor(place), m = 1.0 - u;
    const double weight[] = {m * m * m / 6.0, 2.0 / 3.0 + u * u * (0.5 * u - 1.0), 2.0 / 3.0 + m * m * (0.5 * m - 1.0),
                             u * u * u / 6.0};
    double sum = 0.0;
    for (int k = 0; k < 4; k++)
        for (int n = 0; n < 2; n++) sum += weight[k] * along[n] * line[2 * (cell + k) + n];
    return sum;
}

/// Copies the coefficients along alpha at a node of t and w.
static void line_of(const pad_table *table, int t, int w, double line[PAD_ROW]) {
    static const double at_node[] = {1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};
    for (int k = 0; k < PAD_ROW; k++) {
        line[k] = 0.0;
        for (int i = 0; i < 9; i++)
            line[k] += at_node[i / 3] * at_node[i % 3] *
                       table->coefficients[(t + i / 3) * PAD_SHEET + (w + i % 3) * PAD_ROW + k];
    }
}

/// Finds the direction (p, r) = (cos, sin) of the tilt: the steepest sign change of the moment, which grows with r.
/// Returns r/p.
static double lean_of(const double line[PAD_ROW], double lead) {
    enum { LOOKS = 64 };
    const double along[] = {sin(lead), cos(lead)}, step = PAD_HALF_TURN / LOOKS;
    double steepest = 0.0, found = 0.0, before = 0.0;
    for (int k = 0; k <= LOOKS; k++) {
        const double angle = step * k - 0.5 * PAD_HALF_TURN;
        const double moment = along_alpha(line, 0.5 * PAD_HALF_TURN - lead - angle, along);
        if (k > 0 && before < 0.0 && moment > 0.0 && moment - before > steepest) {
            steepest = moment - before;
            found = angle - step * moment / steepest;
        }
        before = moment;
    }
    return fmin(fmax(tan(found), -20.0), 20.0);
}

void pad_table_lean(pad_table *table, double lead) {
    double line[PAD_ROW];
    for (int t = 0; t < PAD_T_NODES; t++)
        for (int w = 0; w < PAD_W_NODES; w++) {
            line_of(table, t, w, line);
            table->lean[t][w] = lean_of(line, lead);
        }
}

// ---------------------------------------------------------------- tables of other programs

/// Number of places that are compared, spread over all nodes by the golden ratio; and their largest accepted
/// difference, divided by the largest force. Rounding causes 1e-13, another solution far more.
enum { CONFIRMED = 24 };
static const double confirmed_within = 1e-9;

whirl_status pad_table_confirm(const pad_table *table, const pad_table_key *key, bool *confirmed) {
    const int half = PAD_W_NODES / 2 + 1, all = PAD_T_NODES * half * PAD_ALPHA_NODES; // the other nodes are mirror
                                                                                      // images
    const pad_film film = pad_table_film(key);
    pad_workspace *work;
    double largest = 0.0, apart = 0.0;
    whirl_status status = pad_workspace_new(film.around, film.along, &work);
    // Compare nodes that are spread evenly over the table with new solutions.
    for (int i = 0; i < CONFIRMED && status.code == WHIRL_OK; i++) {
        const int node = (int)(all * fmod((i + 1) * 0.6180339887498949, 1.0));
        const int k = node % PAD_ALPHA_NODES, w = PAD_W_NODES / 2 + node / PAD_ALPHA_NODES % half;
        const int t = node / PAD_ALPHA_NODES / half;
        double line[PAD_ROW], value[2] = {0.0, 0.0};
        status = solve_node(&film, work, t, w, k, value);
        line_of(table, t, w, line);
        for (int n = 0; n < 2; n++) {
            const double here = (line[2 * k + n] + 4.0 * line[2 * (k + 1) + n] + line[2 * (k + 2) + n]) / 6.0;
            largest = fmax(largest, fabs(value[n]));
            apart = fmax(apart, fabs(here - value[n]));
        }
    }
    pad_workspace_free(work);
    *confirmed = status.code == WHIRL_OK && apart <= confirmed_within * largest;
    return status;
}
