// The method rodas5p without the kernel of its steps: perturbations, and its table.
#include <math.h>
#include <string.h>

#include "adaptive_lanes.h"
#include "method.h"
#include "sparsity.h"
#include "stepper_parts.h"

// ---------------------------------------------------------------- perturbations

/// Computes `from` plus the weighted sum of the first `count` rows.
static void sum_rows(size_t size, const double *weights, int count, double *const *rows, const double *from,
                     double *out) {
    memcpy(out, from, size * sizeof *out);
    for (int j = 0; j < count; j++)
        for (size_t d = 0; d < size; d++) out[d] += weights[j] * rows[j][d];
}

/// Computes the increment of stage i for the perturbations by the derivative of the step. With the increments w of a
/// perturbation d, and the increments u of the state,
///
///     (1/(gamma h) - J) w_i = J(t_i, x_i) (d + sum_j a_ij w_j) + sum_j g_ij/h w_j + (J d)' (u_i, h d_i)
///
/// where the last term is the derivative of J d along the increment and by time. It is computed by a difference, which
/// is exact to 1e-9 of the change of J within the step.
static void take_varied_increment(const stepper *c, int i, double h) {
    const stepper_variation *v = &c->variation;
    const size_t n = c->dimension, count = v->set->count, size = count * n;
    const double share = 0x1p-10, *u = c->slot->rodas5p.u_v[i], half = share * h * rodas5p_d[i];
    double *const *w = v->k, *ahead = v->k[RODAS5P_STAGES], *behind = v->k[RODAS5P_STAGES + 1];
    double *x = c->slot->rodas5p.between_v;
    c->method->one->take_stage(c->slot, i);
    sum_rows(size, rodas5p_a[i], i, w, v->set->vectors, v->stage);
    memset(w[i], 0, size * sizeof *w[i]);
    sum_rows(size, rodas5p_g[i], i, w, w[i], w[i]);
    stepper_apply_jacobian(c, c->begin + rodas5p_c[i] * h, c->stage, count, v->stage, ahead);
    for (size_t d = 0; d < size; d++) w[i][d] = w[i][d] / h + ahead[d];
    for (size_t d = 0; d < n; d++) x[d] = c->start[d] + share * u[d];
    stepper_apply_jacobian(c, c->begin + half, x, count, v->set->vectors, ahead);
    for (size_t d = 0; d < n; d++) x[d] = c->start[d] - share * u[d];
    stepper_apply_jacobian(c, c->begin - half, x, count, v->set->vectors, behind);
    for (size_t d = 0; d < size; d++) w[i][d] += (ahead[d] - behind[d]) / (2.0 * share);
    for (size_t k = 0; k < count; k++) c->method->one->solve(c->slot, w[i] + k * n);
}

/// Integrates the divergence over the step by Gauss' formula of order 6 along the interpolant.
static double integrated_divergence(stepper *c) {
    static const double weights[] = {5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0};
    const double apart = 0.5 * sqrt(0.6);
    double sum = 0.0;
    c->method->one->take_polynomials(c->slot);
    for (int i = 0; i < 3; i++) {
        const double theta = 0.5 + (i - 1) * apart;
        stepper_between(c, theta, c->stage);
        sum += weights[i] * stepper_divergence(c, c->begin + theta * c->length, c->stage);
    }
    return c->length * sum;
}

/// Returns the error estimate of perturbation `which` over the step, the length of its last increment, divided by its
/// tolerance (stepper_varied_tolerance).
static double estimated_error(const stepper *c, size_t which) {
    const size_t n = c->dimension;
    const double *error = c->variation.k[RODAS5P_STAGES - 1] + which * n;
    double square = 0.0;
    for (size_t d = 0; d < n; d++) square += error[d] * error[d];
    return sqrt(square) / stepper_varied_tolerance(c, which);
}

static double try_varied(stepper *c) {
    stepper_variation *v = &c->variation;
    const size_t size = v->set->count * c->dimension;
    double error = 0.0;
    for (int i = 0; i < RODAS5P_STAGES; i++) take_varied_increment(c, i, c->length);
    for (size_t d = 0; d < size; d++) v->end[d] = v->stage[d] + v->k[RODAS5P_STAGES - 1][d];
    for (size_t k = 0; k < v->set->count; k++) error = fmax(error, estimated_error(c, k));
    v->volume = integrated_divergence(c);
    return error;
}

// ---------------------------------------------------------------- in lanes

static adaptive_lanes_revolve *const revolves[VECTOR_ISAS] = EVERY_ISA(, rodas5p_lanes);

static size_t group(size_t rates) {
    return rates <= 6 ? 4 : 2;
}

static size_t rodas5p_lay_out(adaptive_lanes *lanes, double *block) {
    rodas5p_work *own = &lanes->rodas5p;
    const size_t n = lanes->degrees, m = lanes->rates, quads = (m + 3) / 4;
    const size_t matrix = own->sparsity->dense ? 4 * quads * (2 * m + 1) : m * m; // two factors and a column, or one
    const size_t sets = 1 + own->sparsity->perturbations;
    const struct {
        double **array;
        size_t rows;
    } parts[] = {
        {&lanes->slope, m},       {&lanes->end_slope, m},
        {&own->unit_q, sets * n}, {&own->unit_v, sets * m},
        {&own->by, sets * m},     {&own->matrix, matrix},
        {&own->pivot, m},         {&own->doubtful, 1},
        {&own->shift, 1},         {&own->rate, m},
        {&own->right_q, n},       {&own->between_q, n},
        {&own->between_v, m},     {&own->ahead, lanes->forcing_count},
    };
    // Lay out the stages, then all other arrays, one after the other.
    size_t row = 0;
    for (int i = 0; i < RODAS5P_STAGES; i++, row += n + m) {
        own->u_q[i] = lanes_row(lanes, block, row);
        own->u_v[i] = lanes_row(lanes, block, row + n);
    }
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++, row += parts[i - 1].rows)
        *parts[i].array = lanes_row(lanes, block, row);
    lanes->later = own->rate;
    return row;
}

/// Sets the perturbations that find the Jacobian, which do not change.
static void rodas5p_prepare(adaptive_lanes *lanes) {
    const size_t n = lanes->degrees, m = lanes->rates, *by = lanes->rodas5p.sparsity->perturbation;
    for (size_t slot = 0; slot < lanes->slots; slot++) {
        for (size_t d = 0; d < n; d++) lanes->rodas5p.unit_q[((1 + by[d]) * n + d) * lanes->slots + slot] = 1.0;
        for (size_t d = 0; d < m; d++) lanes->rodas5p.unit_v[((1 + by[n + d]) * m + d) * lanes->slots + slot] = 1.0;
    }
}

const lanes_method rodas5p_in_lanes = {revolves, &rodas5p_slot,   true,           try_varied, RODAS5P_DENSE,
                                       group,    rodas5p_lay_out, rodas5p_prepare};
