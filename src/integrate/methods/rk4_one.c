// One lane of rk4: its memory, and steps of any length for a stepper.
#include <math.h>
#include <string.h>

#include "stepper.h"
#include "stepper_parts.h"

rk4_one rk4_one_of(lanes_flow *flow, const void *model, size_t dimension) {
    return (rk4_one){
        .lanes = {
            .model = model, .flow = flow, .stride = 1, .vectors = 1, .lane_count = 1, .used = 1, .rates = dimension}};
}

void rk4_one_place(rk4_one *one, double *rows, size_t row) {
    rk4_lanes *lanes = &one->lanes;
    lanes->v = rows;
    lanes->stage_v = rows + row;
    for (int i = 0; i < 3; i++) lanes->k[i] = rows + (2 + i) * row;
    for (int i = 0; i < 4; i++) lanes->divergence[i] = &one->divergence[i];
    lanes->volume = &one->volume;
    one->volume = 0.0;
}

double rk4_amplification(double real, double imaginary) {
    double x = 1.0, y = 0.0; // value of 1 + z (1 + z/2 (1 + z/3 (1 + z/4)))
    for (int i = 4; i > 0; i--) {
        const double re = (real * x - imaginary * y) / i;
        y = (real * y + imaginary * x) / i;
        x = 1.0 + re;
    }
    return hypot(x, y);
}

// ---------------------------------------------------------------- steps of a stepper

/// Takes a step from `start`, and carries `perturbations` perturbations.
static void step(stepper *c, double *rows, size_t row, double h, size_t perturbations) {
    rk4_lanes *lanes = &c->fixed.lanes;
    rk4_one_place(&c->fixed, rows, row);
    memcpy(lanes->v, c->start, c->dimension * sizeof *lanes->v);
    for (int i = 0; i < 3; i++) c->times[i] = c->begin + 0.5 * i * h;
    lanes->forcing = c->times;
    lanes->now = &c->times[3];
    lanes->forcing_count = 1;
    lanes->steps = 1;
    lanes->step = h;
    lanes->perturbations = perturbations;
    rk4_lanes_scalar(lanes);
}

void rk4_try_step(stepper *c, double h) {
    step(c, c->rows, c->dimension, h, 0);
    memcpy(c->end, c->fixed.lanes.v, c->dimension * sizeof *c->end);
    stepper_slope(c, c->begin + h, c->end, c->last);
}

double rk4_try_varied(stepper *c) {
    stepper_variation *v = &c->variation;
    const size_t n = c->dimension, size = v->set->count * n;
    memcpy(v->k[0] + n, v->set->vectors, size * sizeof *v->end);
    step(c, v->k[0], (size_t)(v->k[1] - v->k[0]), c->length, v->set->count);
    memcpy(v->end, v->k[0] + n, size * sizeof *v->end);
    v->volume = c->fixed.volume;
    return 0.0;
}
