// The classical Runge-Kutta method of order 4 (Kutta 1901) with fixed steps, for one system of any kind. It uses one
// lane of the kernel for rotors.
//
// The forcing at the ends and middles of the steps is tabulated once: every revolution sees exactly the same values,
// and no sine is computed while the machine runs.
#include <stdlib.h>
#include <string.h>

#include "method.h"
#include "orthonormal.h"
#include "stepper.h"
#include "stepper_parts.h"

/// Computes the slopes of any system. view->forcing is the system's forcing, followed by t.
static void rk4_system_flow(const lanes_view *view) {
    const whirl_system *system = view->model;
    const double *forcing = view->forcing, t = forcing[system->forcing_count], *x = view->v;
    const size_t n = system->dimension;
    system->rhs(system->model, t, forcing, x, view->a);
    if (view->tangents == 0) return;
    system->tangent(system->model, t, forcing, x, NULL, view->tangents, x + n, (double *)view->a + n);
    if (view->divergence) *(double *)view->divergence = divergence_at(system, t, forcing, x, NULL);
}

typedef struct rk4 {
    rk4_one one;
    stepper *beside;  ///< carries perturbations across switches
    double numbers[]; ///< the table of the forcing, then the present forcing
} rk4;

static whirl_status rk4_start(whirl_integrator *integrator) {
    const whirl_system *system = integrator->system;
    const int steps = integrator->options.steps_per_revolution;
    const size_t count = system->forcing_count + 1, instants = 2 * (size_t)steps + 1;
    rk4 *work = calloc(1, sizeof *work + (instants + 1) * count * sizeof(double));
    if (work) work->beside = stepper_new(NULL, system, &integrator->options);
    if (!work || !work->beside) {
        free(work);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for %d steps per revolution", steps);
    }
    // Describe the revolution to the kernel.
    work->one = rk4_one_of(rk4_system_flow, system, system->dimension);
    rk4_lanes *lanes = &work->one.lanes;
    lanes->forcing_count = count;
    lanes->steps = steps;
    lanes->stop = system->stop;
    lanes->step = system->period / steps;
    lanes->forcing = work->numbers;
    lanes->now = work->numbers + instants * count;
    // Tabulate the forcing at the instants and middles of all steps.
    for (size_t i = 0; i < instants; i++) {
        double *now = work->numbers + i * count, t = system->period * ((double)i / (2.0 * steps));
        if (system->forcing_count > 0) system->forcing(system->model, t, now);
        now[system->forcing_count] = t;
    }
    integrator->workspace = work;
    return whirl_ok();
}

/// A revolution in progress.
typedef struct revolution {
    const rk4 *work;
    double period;
    whirl_perturbations *set; ///< perturbations in the lane; NULL: none
    int done;                 ///< steps taken so far
    whirl_observe_fn observe;
    void *observer;
} revolution;

/// Corrects perturbations after a step across a switch.
static void mend_perturbations(const revolution *r) {
    const rk4_lanes *lanes = &r->work->one.lanes;
    const bool due = r->done % rk4_orthonormal_steps(lanes->steps) == 0 || r->done == lanes->steps;
    unlocated_saltate(r->work->beside, r->done * lanes->step, lanes->k[0], lanes->v, r->set);
    if (r->set->growth && due) make_orthonormal(lanes->rates, r->set->count, r->set->vectors, r->set->growth);
    unlocated_begin(r->work->beside, lanes->v);
}

static void after_step(void *context) {
    revolution *r = context;
    const rk4_lanes *lanes = &r->work->one.lanes;
    r->done++;
    if (r->set) mend_perturbations(r);
    if (r->observe) r->observe(r->observer, r->period * ((double)r->done / lanes->steps), lanes->v);
}

static whirl_motion revolve(whirl_integrator *integrator, double *x, whirl_perturbations *perturbations,
                            whirl_observe_fn observe, void *observer) {
    rk4 *work = integrator->workspace;
    rk4_one *one = &work->one;
    rk4_lanes *lanes = &one->lanes;
    const whirl_system *system = integrator->system;
    const size_t n = system->dimension, row = (1 + integrator->most_perturbations) * n;
    whirl_perturbations own = perturbations ? *perturbations : (whirl_perturbations){.count = 0};
    const size_t size = own.count * n * sizeof *x;
    revolution r = {.work = work, .period = system->period, .observe = observe, .observer = observer};
    // Copy state and perturbations into the lane.
    rk4_one_place(one, integrator->slopes, row);
    memcpy(lanes->v, x, n * sizeof *x);
    if (perturbations) {
        own.vectors = memcpy(lanes->v + n, perturbations->vectors, size);
        r.set = &own;
        stepper_place(work->beside, system, 0.0);
        unlocated_begin(work->beside, x);
    }
    // Carry the lane over the revolution.
    lanes->perturbations = own.count;
    lanes->sample_stride = observe || perturbations ? 1 : 0;
    lanes->sample = after_step;
    lanes->context = &r;
    rk4_lanes_scalar(lanes);
    // Copy them from the lane.
    memcpy(x, lanes->v, n * sizeof *x);
    if (perturbations) {
        memcpy(perturbations->vectors, own.vectors, size);
        perturbations->volume = own.volume + one->volume;
    }
    return state_motion(integrator, x);
}

static void rk4_end(whirl_integrator *integrator) {
    rk4 *work = integrator->workspace;
    stepper_free(work->beside);
    free(work);
}

const method rk4_method = {
    .about = {"rk4", "Runge-Kutta of order 4, fixed steps; crosses contacts unless contacts: located", false, true,
              false},
    .start = rk4_start,
    .revolve = revolve,
    .rows = RK4_ROWS,
    .end = rk4_end,
    .located = &rk4_located_method,
    .amplification = rk4_amplification,
};
