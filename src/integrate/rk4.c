// The classical Runge-Kutta method of order 4 (Kutta 1901) with fixed steps.
//
// The forcing at the steps' ends and middles is tabulated once: every revolution sees exactly the same forcing, and no
// sine is computed while the machine runs.
#include <stdlib.h>

#include "method.h"
#include "orthonormal.h"
#include "unlocated.h"

typedef struct rk4 {
    double step;
    size_t forcing_count;
    double *forcing; ///< [2 steps + 1][forcing_count] at 0, step/2, step, ...
    double *k[4];    ///< [dimension] slopes
    double *stage;   ///< [dimension]
} rk4;

static whirl_status start(whirl_integrator *integrator) {
    const whirl_system *system = integrator->system;
    const size_t steps = (size_t)integrator->options.steps_per_revolution;
    const size_t n = system->dimension, table = (2 * steps + 1) * system->forcing_count;
    rk4 *work = malloc(sizeof *work + (table + 5 * n) * sizeof(double));
    if (!work) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu steps a revolution", steps);
    double *numbers = (double *)(work + 1);
    *work = (rk4){.step = system->period / (double)steps, .forcing_count = system->forcing_count, .forcing = numbers};
    for (int i = 0; i < 4; i++) work->k[i] = numbers + table + (size_t)i * n;
    work->stage = numbers + table + 4 * n;
    if (system->forcing_count > 0)
        for (size_t i = 0; i <= 2 * steps; i++)
            system->forcing(system->model, system->period * ((double)i / (double)(2 * steps)),
                            work->forcing + i * system->forcing_count);
    integrator->workspace = work;
    return whirl_ok();
}

/// Disturbances on their way through the stages of a step.
typedef struct variation {
    const whirl_system *system;
    whirl_disturbances *set;
    double *k[4], *stage; ///< [count][dimension]
    double *spare;        ///< [SPARE_ROWS][dimension]
    double divergence[4];
} variation;

static variation begin_variation(const whirl_integrator *integrator, whirl_disturbances *set) {
    variation v = {.system = integrator->system, .set = set};
    const size_t row = integrator->most_disturbances * integrator->system->dimension;
    for (size_t i = 0; set && i < 4; i++) v.k[i] = integrator->slopes + i * row;
    if (set) {
        v.stage = integrator->slopes + 4 * row;
        v.spare = v.stage + row;
    }
    return v;
}

/// Stage i at (t, x), which lies `way` after the step's beginning along the slope before.
static void vary_stage(variation *v, int i, double way, double t, const double *forcing, const double *x) {
    if (!v->set) return;
    const size_t size = v->set->count * v->system->dimension;
    const double *from = v->set->vectors;
    if (i > 0) {
        for (size_t d = 0; d < size; d++) v->stage[d] = from[d] + way * v->k[i - 1][d];
        from = v->stage;
    }
    v->system->tangent(v->system->model, t, forcing, x, NULL, v->set->count, from, v->k[i]);
    v->divergence[i] = divergence_at(v->system, t, forcing, x, NULL);
}

static void end_variation(const variation *v, double h) {
    if (!v->set) return;
    const size_t size = v->set->count * v->system->dimension;
    const double *divergence = v->divergence, sixth = h / 6.0;
    for (size_t d = 0; d < size; d++)
        v->set->vectors[d] += sixth * (v->k[0][d] + 2.0 * (v->k[1][d] + v->k[2][d]) + v->k[3][d]);
    v->set->volume += sixth * (divergence[0] + 2.0 * (divergence[1] + divergence[2]) + divergence[3]);
}

/// One step from t; `forcing` points to the table's entries at t, t + step/2, t + step.
static void take_step(const whirl_system *system, const rk4 *work, double t, const double *forcing, double *restrict x,
                      variation *v) {
    const size_t n = system->dimension;
    const double h = work->step, half = 0.5 * h;
    const double *middle = forcing + work->forcing_count, *end = middle + work->forcing_count;
    double *restrict k1 = work->k[0], *restrict k2 = work->k[1], *restrict k3 = work->k[2], *restrict k4 = work->k[3];
    double *restrict stage = work->stage;
    system->rhs(system->model, t, forcing, x, k1);
    vary_stage(v, 0, 0.0, t, forcing, x);
    for (size_t i = 0; i < n; i++) stage[i] = x[i] + half * k1[i];
    system->rhs(system->model, t + half, middle, stage, k2);
    vary_stage(v, 1, half, t + half, middle, stage);
    for (size_t i = 0; i < n; i++) stage[i] = x[i] + half * k2[i];
    system->rhs(system->model, t + half, middle, stage, k3);
    vary_stage(v, 2, half, t + half, middle, stage);
    for (size_t i = 0; i < n; i++) stage[i] = x[i] + h * k3[i];
    system->rhs(system->model, t + h, end, stage, k4);
    vary_stage(v, 3, h, t + h, end, stage);
    const double sixth = h / 6.0;
    for (size_t i = 0; i < n; i++) x[i] += sixth * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
    end_variation(v, h);
}

static whirl_motion revolve(whirl_integrator *integrator, double *x, whirl_disturbances *disturbances,
                            whirl_observe_fn observe, void *observer) {
    enum { ORTHONORMAL = 64 }; // times in a revolution, so that fast decays do not drown in rounding
    const whirl_system *system = integrator->system;
    const rk4 *work = integrator->workspace;
    const int steps = integrator->options.steps_per_revolution, often = (steps + ORTHONORMAL - 1) / ORTHONORMAL;
    const double *forcing = work->forcing;
    variation v = begin_variation(integrator, disturbances);
    unlocated_step step = {.system = system, .length = work->step, .slope = work->k[0], .rows = v.spare};
    if (disturbances) step.before = v.spare + SPARE_ROWS * system->dimension;
    for (int i = 0; i < steps; i++) {
        if (disturbances) unlocated_begin(&step, i * work->step, x);
        take_step(system, work, i * work->step, forcing, x, &v);
        if (disturbances) unlocated_saltate(&step, x, disturbances);
        if (disturbances && disturbances->growth && ((i + 1) % often == 0 || i + 1 == steps))
            make_orthonormal(system->dimension, disturbances->count, disturbances->vectors, disturbances->growth);
        forcing += 2 * work->forcing_count;
        if (observe) observe(observer, system->period * ((double)(i + 1) / steps), x);
    }
    return state_motion(integrator, x);
}

static void end(whirl_integrator *integrator) {
    free(integrator->workspace);
}

const method rk4_method = {
    .about = {"rk4", "Runge-Kutta of order 4, fixed steps; goes over contacts unless they are to be located", false,
              true, false},
    .start = start,
    .revolve = revolve,
    .disturbance_rows = 5,
    .end = end,
    .located = &rk4_located_method,
    .amplification = rk4_amplification,
};
