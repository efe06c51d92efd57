// The method of Dormand and Prince without the kernel of its steps: stability, perturbations, and its table.
#include <math.h>

#include "adaptive_lanes.h"
#include "dop853_sums.h"
#include "method.h"
#include "stepper_parts.h"

double dop853_amplification(double real, double imaginary) {
    double re[DOP853_STAGES + 1] = {0}, im[DOP853_STAGES + 1] = {0}, x = 1.0, y = 0.0;
    for (int i = 0; i <= DOP853_STAGES; i++) { // stage by stage on x' = z x from x = 1
        x = 1.0;
        y = 0.0;
        for (int j = 0; j < i; j++) {
            x += dop853_a[i][j] * re[j];
            y += dop853_a[i][j] * im[j];
        }
        re[i] = real * x - imaginary * y;
        im[i] = real * y + imaginary * x;
    }
    return hypot(x, y);
}

// ---------------------------------------------------------------- perturbations

/// Computes the perturbations at which slope i is taken, out [size].
static void take_stage(const stepper_variation *v, int i, size_t size, double h, double *restrict out) {
    const double *restrict from = v->set->vectors;
    for (size_t d = 0; d < size; d++) out[d] = 0.0;
    for (int j = 0; j < i; j++) {
        const double *restrict k = v->k[j], a = dop853_a[i][j];
        for (size_t d = 0; d < size; d++) out[d] += a * k[d];
    }
    for (size_t d = 0; d < size; d++) out[d] = from[d] + h * out[d];
}

/// Returns the error estimate of perturbation `which` over the step, by the formula of the kernel, divided by its
/// tolerance: rtol times its length, at the beginning or the end, whichever is larger.
static double estimated_error(const stepper *c, size_t which) {
    const stepper_variation *v = &c->variation;
    const size_t n = c->dimension, first = which * n;
    double *restrict e5 = v->stage, *restrict e3 = v->stage + n; // not in use between steps
    double square5 = 0.0, square3 = 0.0;
    for (size_t d = 0; d < n; d++) e5[d] = e3[d] = 0.0;
    for (int j = 0; j < DOP853_STAGES; j++) {
        const double *restrict k = v->k[j] + first, by5 = dop853_e5[j], by3 = dop853_e3[j];
        for (size_t d = 0; d < n; d++) {
            e5[d] += by5 * k[d];
            e3[d] += by3 * k[d];
        }
    }
    for (size_t d = 0; d < n; d++) {
        square5 += e5[d] * e5[d];
        square3 += e3[d] * e3[d];
    }
    const double mixed = square5 + 0.01 * square3;
    return mixed > 0.0 ? c->length * square5 / (sqrt(mixed) * stepper_varied_tolerance(c, which)) : mixed;
}

static double try_varied(stepper *c) {
    stepper_variation *v = &c->variation;
    const size_t size = v->set->count * c->dimension;
    const double h = c->length;
    double error = 0.0;
    v->volume = 0.0;
    for (int i = 0; i < DOP853_STAGES; i++) {
        const double t = c->begin + dop853_c[i] * h;
        c->method->one->take_stage(c->slot, i);
        take_stage(v, i, size, h, v->stage);
        stepper_apply_jacobian(c, t, c->stage, v->set->count, v->stage, v->k[i]);
        v->volume += h * dop853_a[DOP853_STAGES][i] * stepper_divergence(c, t, c->stage);
    }
    take_stage(v, DOP853_STAGES, size, h, v->end);
    for (size_t k = 0; k < v->set->count; k++) error = fmax(error, estimated_error(c, k));
    return error;
}

// ---------------------------------------------------------------- in lanes

static adaptive_lanes_revolve *const revolves[VECTOR_ISAS] = EVERY_ISA(, dop853_lanes);

static size_t group(size_t rates) {
    return rates <= 8 ? 4 : rates <= 20 ? 2 : 1;
}

static size_t dop853_lay_out(adaptive_lanes *lanes, double *block) {
    dop853_work *own = &lanes->dop853;
    const size_t apart = (1 + lanes->followed) * lanes->rates;
    size_t row = 0;
    for (size_t i = 0; i < DOP853_SLOPES; i++, row += apart) own->k[i] = lanes_row(lanes, block, row);
    own->base = lanes_row(lanes, block, row);
    own->divergence = lanes_row(lanes, block, row + 2);
    lanes->slope = own->k[0];
    lanes->end_slope = own->k[DOP853_STAGES];
    lanes->later = own->k[1];
    lanes->divergence = own->divergence;
    lanes->end_divergence = lanes_row(lanes, block, row + 2 + DOP853_STAGES);
    return row + 3 + DOP853_STAGES;
}

static void dop853_prepare(adaptive_lanes *lanes) {
    dop853_sums_fill(&lanes->dop853.sums, (1 + lanes->followed) * lanes->rates * lanes->stride);
}

const lanes_method dop853_in_lanes = {revolves, &dop853_slot, false,          try_varied,
                                      DENSE,    group,        dop853_lay_out, dop853_prepare};
