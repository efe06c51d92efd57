// The classical Runge-Kutta method of order 4 (Kutta 1901) with fixed steps.
//
// The forcing at the steps' ends and middles is tabulated once: every revolution sees exactly the same forcing, and no
// sine is computed while the machine runs.
#include <stdlib.h>

#include "method.h"

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

/// One step from t; `forcing` points to the table's entries at t, t + step/2, t + step.
static void take_step(const whirl_system *system, const rk4 *work, double t, const double *forcing,
                      double *restrict x) {
    const size_t n = system->dimension;
    const double h = work->step, half = 0.5 * h;
    const double *middle = forcing + work->forcing_count, *end = middle + work->forcing_count;
    double *restrict k1 = work->k[0], *restrict k2 = work->k[1], *restrict k3 = work->k[2], *restrict k4 = work->k[3];
    double *restrict stage = work->stage;
    system->rhs(system->model, t, forcing, x, k1);
    for (size_t i = 0; i < n; i++) stage[i] = x[i] + half * k1[i];
    system->rhs(system->model, t + half, middle, stage, k2);
    for (size_t i = 0; i < n; i++) stage[i] = x[i] + half * k2[i];
    system->rhs(system->model, t + half, middle, stage, k3);
    for (size_t i = 0; i < n; i++) stage[i] = x[i] + h * k3[i];
    system->rhs(system->model, t + h, end, stage, k4);
    const double sixth = h / 6.0;
    for (size_t i = 0; i < n; i++) x[i] += sixth * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
}

static whirl_motion revolve(whirl_integrator *integrator, double *x, whirl_observe_fn observe, void *observer) {
    const whirl_system *system = integrator->system;
    const rk4 *work = integrator->workspace;
    const int steps = integrator->options.steps_per_revolution;
    const double *forcing = work->forcing;
    for (int i = 0; i < steps; i++) {
        take_step(system, work, i * work->step, forcing, x);
        forcing += 2 * work->forcing_count;
        if (observe) observe(observer, system->period * ((double)(i + 1) / steps), x);
    }
    return state_motion(integrator, x);
}

static void end(whirl_integrator *integrator) {
    free(integrator->workspace);
}

const method rk4_method = {
    .about = {"rk4", "Runge-Kutta of order 4, fixed steps; walks over contacts", false},
    .start = start,
    .revolve = revolve,
    .end = end,
};
