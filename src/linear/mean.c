#include "mean.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exhausted.h"
#include "linear_status.h"

enum { PHASES = 16 };

static bool turns(const whirl_system *system, size_t coordinate) {
    return system->turns && system->turns[coordinate] != 0.0;
}

enum { LOOKS = 5 };

/// Returns one of several instants that have no symmetry between them.
static double look_at(const whirl_system *system, int look) {
    return system->period * (0.07 + 0.19 * look);
}

/// Sets the steady values of the forcing: the value itself if it is constant (a rotor that stands still), otherwise 0.
static void find_steady(mean_system *m) {
    double forcing[WHIRL_MAX_FORCING];
    if (m->system->forcing_count == 0) return;
    m->system->forcing(m->system->model, look_at(m->system, 0), m->steady);
    for (int look = 1; look < LOOKS; look++) {
        m->system->forcing(m->system->model, look_at(m->system, look), forcing);
        for (size_t i = 0; i < m->system->forcing_count; i++)
            if (forcing[i] != m->steady[i]) m->steady[i] = 0.0;
    }
}

/// Sets the unit perturbations of the kept coordinates.
static void mean_keep(mean_system *m) {
    memset(m->unit, 0, m->count * m->system->dimension * sizeof *m->unit);
    for (size_t i = 0; i < m->count; i++) m->unit[i * m->system->dimension + m->kept[i]] = 1.0;
}

whirl_status linear_status(int before, whirl_status status, size_t coordinates) {
    if (!exhausted(before)) return status;
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for matrices of %zu coordinates", coordinates);
}

whirl_status mean_begin(mean_system *m, const whirl_system *system, void **block) {
    const size_t d = system->dimension;
    *block = NULL;
    if (!system->tangent)
        return whirl_fail(WHIRL_BAD_INPUT, "the system gives no Jacobian, expected one for linear analyses");
    // One block: numbers, then indices.
    char *all = calloc(1, (2 * d + 2 * d * d) * sizeof(double) + d * (sizeof(size_t) + sizeof(whirl_settled)) + 1);
    if (!all) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the Jacobian of %zu coordinates", d);
    *block = all;
    *m = (mean_system){.system = system, .samples = system->forcing_count > 0 ? 1 : PHASES};
    m->state = (double *)all;
    m->slope = m->state + d;
    m->unit = m->slope + d;
    m->rows = m->unit + d * d;
    m->kept = (size_t *)(m->rows + d * d);
    m->settled = (whirl_settled *)(m->kept + d);
    for (size_t i = 0; i < d; i++)
        if (turns(system, i))
            m->samples = PHASES;
        else
            m->kept[m->count++] = i;
    mean_keep(m);
    find_steady(m);
    return whirl_ok();
}

void mean_leave_idle(mean_system *m, const double *x) {
    if (!m->system->settle) return;
    memcpy(m->state, x, m->system->dimension * sizeof *x);
    mean_settle(m, m->state);
    size_t count = 0;
    for (size_t i = 0; i < m->count; i++)
        if (m->settled[m->kept[i]] != WHIRL_IDLE) m->kept[count++] = m->kept[i];
    m->count = count;
    mean_keep(m);
}

/// Sets the state at one of the phases. Returns the time of that phase.
static double at_phase(mean_system *m, const double *x, int sample) {
    const whirl_system *system = m->system;
    const double share = (double)sample / PHASES;
    memcpy(m->state, x, system->dimension * sizeof *x);
    for (size_t i = 0; system->turns && i < system->dimension; i++) m->state[i] += share * system->turns[i];
    return system->forcing_count > 0 ? 0.0 : share * system->period;
}

bool mean_settle(mean_system *m, double *x) {
    return !m->system->settle || m->system->settle(m->system->model, x, m->settled);
}

void mean_slope(mean_system *m, const double *x, double *slope) {
    memset(slope, 0, m->count * sizeof *slope);
    for (int sample = 0; sample < m->samples; sample++) {
        const double t = at_phase(m, x, sample);
        m->system->rhs(m->system->model, t, m->steady, m->state, m->slope);
        for (size_t i = 0; i < m->count; i++) slope[i] += m->slope[m->kept[i]] / m->samples;
    }
}

void mean_contacts(mean_system *m, const double *x, double *force, double *work) {
    const size_t count = m->system->contact_count;
    memset(force, 0, count * sizeof *force);
    for (int sample = 0; sample < m->samples; sample++) {
        at_phase(m, x, sample);
        m->system->contacts(m->system->model, m->state, work);
        for (size_t c = 0; c < count; c++) force[c] += work[c] / m->samples;
    }
}

/// Adds `share` times the transpose of the rows that `tangent` writes.
static void add_jacobian(mean_system *m, double t, const double *forcing, const double *x, double share,
                         double *jacobian) {
    const size_t d = m->system->dimension, n = m->count;
    m->system->tangent(m->system->model, t, forcing, x, NULL, n, m->unit, m->rows);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) jacobian[i * n + k] += share * m->rows[k * d + m->kept[i]];
}

void mean_jacobian(mean_system *m, const double *x, double *jacobian) {
    memset(jacobian, 0, m->count * m->count * sizeof *jacobian);
    for (int sample = 0; sample < m->samples; sample++) {
        const double t = at_phase(m, x, sample);
        add_jacobian(m, t, m->steady, m->state, 1.0 / m->samples, jacobian);
    }
}

bool mean_is_modulated(mean_system *m, const double *x, double *jacobian) {
    const whirl_system *system = m->system;
    const size_t d = system->dimension, n = m->count;
    double forcing[WHIRL_MAX_FORCING];
    memset(jacobian, 0, n * n * sizeof *jacobian);
    add_jacobian(m, 0.0, m->steady, x, 1.0, jacobian);
    for (int look = 0; look < LOOKS; look++) {
        const double t = look_at(system, look);
        if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
        system->tangent(system->model, t, forcing, x, NULL, n, m->unit, m->rows);
        for (size_t i = 0; i < n; i++)
            for (size_t k = 0; k < n; k++) {
                const double is = m->rows[k * d + m->kept[i]], was = jacobian[i * n + k];
                if (fabs(is - was) > 1e-9 * (1.0 + fabs(is))) return true;
            }
    }
    return false;
}

size_t mean_rate_of(const double *jacobian, size_t n, size_t row) {
    size_t found = n;
    for (size_t k = 0; k < n; k++) {
        const double number = jacobian[row * n + k];
        if (number == 0.0) continue;
        if (found < n || number != 1.0) return n;
        found = k;
    }
    return found == row ? n : found;
}
