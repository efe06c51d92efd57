// The synchronous response: what small forcing once a revolution makes of a machine at rest.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "linear_parts.h"
#include "matrix.h"

static const double two_pi = 6.283185307179586476925;

/// What the forcing adds at rest, as its first harmonic [count][2]; phases that turn once a revolution turn with it.
static void take_forcing(mean_system *m, const double *x, double *out) {
    enum { INSTANTS = 32 };
    const whirl_system *system = m->system;
    const size_t d = system->dimension;
    double forcing[WHIRL_MAX_FORCING] = {0};
    memset(out, 0, 2 * m->count * sizeof *out);
    for (int k = 0; k < INSTANTS; k++) {
        const double share = (double)k / INSTANTS, t = share * system->period;
        if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
        memcpy(m->state, x, d * sizeof *x);
        system->rhs(system->model, t, forcing, m->state, m->slope);
        for (size_t i = 0; system->turns && i < d; i++) {
            const double rounds = m->slope[i] * system->period / (system->turns[i] != 0.0 ? system->turns[i] : 1.0);
            if (system->turns[i] != 0.0 && fabs(fabs(rounds) - 1.0) < 1e-9)
                m->state[i] += round(rounds) * share * system->turns[i];
        }
        if (system->turns) system->rhs(system->model, t, forcing, m->state, m->slope);
        const double c = 2.0 / INSTANTS * cos(two_pi * share), s = 2.0 / INSTANTS * sin(two_pi * share);
        for (size_t i = 0; i < m->count; i++) {
            out[2 * i] += c * m->slope[m->kept[i]];
            out[2 * i + 1] -= s * m->slope[m->kept[i]];
        }
    }
}

/// (i w - J) X = F.
static bool solve(mean_system *m, const double *x, double *matrix, double *side) {
    const size_t n = m->count;
    double *jacobian = matrix + 2 * n * n;
    mean_jacobian(m, x, jacobian);
    for (size_t i = 0; i < n * n; i++) {
        matrix[2 * i] = -jacobian[i];
        matrix[2 * i + 1] = i % (n + 1) == 0 ? two_pi / m->system->period : 0.0;
    }
    return matrix_solve_complex(n, matrix, 1, side);
}

static whirl_status respond(mean_system *m, double *rest, double *response, double *work) {
    const size_t n = m->count, d = m->system->dimension;
    double *side = work + 3 * n * n, period;
    whirl_status status = rest_find(m, rest);
    if (status.code != WHIRL_OK) return status;
    if (mean_is_modulated(m, rest, work)) {
        status = periodic_find(m, rest, true, work, &period);
        if (status.code == WHIRL_OK) status = periodic_harmonic(m, rest, side, response);
        if (status.code == WHIRL_OK) memcpy(rest, side, d * sizeof *rest);
        return status;
    }
    take_forcing(m, rest, side);
    if (!solve(m, rest, work, side))
        return whirl_fail(WHIRL_BAD_INPUT, "the response is beyond all bounds: the machine turns at a critical speed "
                                           "without damping, or a free motion is driven");
    memset(response, 0, 2 * d * sizeof *response);
    for (size_t i = 0; i < n; i++) memcpy(response + 2 * m->kept[i], side + 2 * i, 2 * sizeof *side);
    return status;
}

whirl_status whirl_synchronous_check(const whirl_system *system, double speed) {
    static const double rounding = 1e-9; // as of tables over the speed
    const size_t count = system->frequency_count;
    const double frequency = fabs(speed);
    if (count == 0 || (frequency >= system->frequencies[0] * (1.0 - rounding) &&
                       frequency <= system->frequencies[count - 1] * (1.0 + rounding)))
        return whirl_ok();
    return whirl_fail(
        WHIRL_BAD_INPUT,
        "bearings are known at frequencies of whirl from %g to %g rad/s, and the rotor turns at %g rad/s, "
        "which is the frequency of synchronous motions",
        system->frequencies[0], system->frequencies[count - 1], frequency);
}

whirl_status whirl_forced_response(const whirl_system *system, const double *start, double *rest, double *response) {
    mean_system mean;
    void *block;
    whirl_status status = mean_begin(&mean, system, &block);
    if (status.code != WHIRL_OK) return status;
    double *work = calloc(3 * mean.count * mean.count + 2 * system->dimension + 1, sizeof *work);
    memcpy(rest, start, system->dimension * sizeof *rest);
    status = work ? respond(&mean, rest, response, work)
                  : whirl_fail(WHIRL_NO_MEMORY, "no memory for the response of %zu coordinates", system->dimension);
    free(work);
    free(block);
    return status;
}
