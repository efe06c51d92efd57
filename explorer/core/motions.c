// Computes a sampled motion, which the page animates.
#include "core.h"

#include <stdlib.h>
#include <string.h>

struct motion {
    whirl_machine machine;
    whirl_integrator *integrator;
    size_t samples, stride, instants; ///< samples of a revolution; instants from sample to sample; instants observed
    double *states, *forces;          ///< next sample
    double *x;                        ///< [dimension]
};

EXPORTED void explorer_motion_free(motion *m) {
    if (!m) return;
    whirl_integrator_free(m->integrator);
    if (m->machine.release) m->machine.release(m->machine.owner);
    free(m->x);
    free(m);
}

static whirl_status start_motion(motion *m, const plan *p, double value, const double *state, int samples) {
    const whirl_integrate_options *integrate = &p->batch.integrate;
    const whirl_record_options wanted = {.samples_per_revolution = samples > 0 ? samples : 1};
    whirl_status status = p->study.machine(p->study.family, &p->batch, value, &m->machine);
    if (status.code == WHIRL_OK) status = whirl_integrator_new(m->machine.system, integrate, &m->integrator);
    if (status.code != WHIRL_OK) return status;
    const size_t dimension = m->machine.system->dimension;
    m->samples = (size_t)whirl_record_samples(&wanted, integrate->steps_per_revolution);
    m->stride = (size_t)integrate->steps_per_revolution / m->samples;
    m->x = malloc((dimension + 1) * sizeof *m->x);
    if (!m->x) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a state");
    memcpy(m->x, state ? state : m->machine.start, dimension * sizeof *m->x);
    return whirl_ok();
}

EXPORTED motion *explorer_motion_new(const plan *p, double value, const double *state, int samples) {
    motion *m = calloc(1, sizeof *m);
    const whirl_status status =
        m ? start_motion(m, p, value, state, samples) : whirl_fail(WHIRL_NO_MEMORY, "no memory for a motion");
    if (explorer_good(&status)) return m;
    explorer_motion_free(m);
    return NULL;
}

EXPORTED size_t explorer_motion_samples(const motion *m) {
    return m->samples;
}

EXPORTED size_t explorer_motion_contacts(const motion *m) {
    return m->machine.system->contact_count;
}

EXPORTED const double *explorer_motion_state(const motion *m) {
    return m->x;
}

static void sample(void *context, double t, const double *x) {
    motion *m = context;
    const whirl_system *system = m->machine.system;
    (void)t;
    if (++m->instants % m->stride != 0) return;
    memcpy(m->states, x, system->dimension * sizeof *x);
    m->states += system->dimension;
    if (system->contact_count == 0) return;
    system->contacts(system->model, x, m->forces);
    m->forces += system->contact_count;
}

EXPORTED int explorer_motion_turn(motion *m, double *states, double *forces) {
    m->states = states;
    m->forces = forces;
    m->instants = 0;
    return whirl_integrator_revolve(m->integrator, m->x, sample, m) == WHIRL_BOUNDED;
}
