// The synchronous response: the linear response of a machine at its equilibrium to forcing once per revolution.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "equilibrium.h"
#include "exhausted.h"
#include "linear_status.h"
#include "matrix.h"
#include "mean.h"
#include "periodic.h"
#include "two_pi.h"
#include "whirl/engine/linear.h"

/// Computes the first harmonic [count][2] of what the forcing adds to the slope at the equilibrium. Phases that turn
/// once per revolution are turned, too.
static void take_forcing(mean_system *m, const double *x, double *out) {
    enum { INSTANTS = 32 };
    const whirl_system *system = m->system;
    const size_t d = system->dimension;
    double forcing[WHIRL_MAX_FORCING] = {0};
    memset(out, 0, 2 * m->count * sizeof *out);
    for (int k = 0; k < INSTANTS; k++) {
        // Compute the slope at this instant, at the equilibrium.
        const double share = (double)k / INSTANTS, t = share * system->period;
        if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
        memcpy(m->state, x, d * sizeof *x);
        system->rhs(system->model, t, forcing, m->state, m->slope);
        // Turn the phases, and compute the slope again with them.
        for (size_t i = 0; system->turns && i < d; i++) {
            const double rounds = m->slope[i] * system->period / (system->turns[i] != 0.0 ? system->turns[i] : 1.0);
            if (system->turns[i] != 0.0 && fabs(fabs(rounds) - 1.0) < 1e-9)
                m->state[i] += round(rounds) * share * system->turns[i];
        }
        if (system->turns) system->rhs(system->model, t, forcing, m->state, m->slope);
        // Add the slope to the harmonic.
        const double c = 2.0 / INSTANTS * cos(two_pi * share), s = 2.0 / INSTANTS * sin(two_pi * share);
        for (size_t i = 0; i < m->count; i++) {
            out[2 * i] += c * m->slope[m->kept[i]];
            out[2 * i + 1] -= s * m->slope[m->kept[i]];
        }
    }
}

/// Equations (i w - J) X = F, for the whole forcing and for each of its nonzero numbers alone.
typedef struct response_parts {
    size_t n, count;
    double *jacobian, *matrix; ///< [n][n], [n][n][2]
    double *side;              ///< [1 + count][n][2] F, then each of its numbers alone; when solved, X
    double *block;             ///< all of these numbers
} response_parts;

static bool parts_new(size_t n, const double *forcing, response_parts *p) {
    *p = (response_parts){.n = n};
    for (size_t i = 0; i < n; i++) p->count += forcing[2 * i] != 0.0 || forcing[2 * i + 1] != 0.0;
    p->block = calloc(3 * n * n + 2 * n * (1 + p->count) + 1, sizeof *p->block);
    if (!p->block) return false;
    p->jacobian = p->block;
    p->matrix = p->jacobian + n * n;
    p->side = p->matrix + 2 * n * n;
    memcpy(p->side, forcing, 2 * n * sizeof *forcing);
    for (size_t i = 0, part = 0; i < n; i++)
        if (forcing[2 * i] != 0.0 || forcing[2 * i + 1] != 0.0)
            memcpy(p->side + 2 * (++part * n + i), forcing + 2 * i, 2 * sizeof *forcing);
    return true;
}

static bool parts_solve(mean_system *m, const double *x, response_parts *p) {
    const size_t n = p->n;
    mean_jacobian(m, x, p->jacobian);
    for (size_t i = 0; i < n * n; i++) {
        p->matrix[2 * i] = -p->jacobian[i];
        p->matrix[2 * i + 1] = i % (n + 1) == 0 ? two_pi / m->system->period : 0.0;
    }
    return matrix_solve_complex(n, p->matrix, 1 + p->count, p->side);
}

/// Size of a response below which it is rounding, relative to its summands or to the largest response: the station is a
/// node, or nothing excites it.
static const double nothing = 1e-10;

static double size_of(const double *number) {
    return hypot(number[0], number[1]);
}

/// Copies the response into all coordinates. Sets it to 0 where the responses to single numbers of the forcing cancel.
static void take_sums(const mean_system *m, const response_parts *p, double *response) {
    memset(response, 0, 2 * m->system->dimension * sizeof *response);
    for (size_t i = 0; i < p->n; i++) {
        double sizes = 0.0;
        for (size_t part = 1; part <= p->count; part++) sizes += size_of(p->side + 2 * (part * p->n + i));
        if (size_of(p->side + 2 * i) > nothing * sizes)
            memcpy(response + 2 * m->kept[i], p->side + 2 * i, 2 * sizeof *response);
    }
}

/// Sets those displacements and rates of stations to 0 that are rounding against the largest one.
static void drop_rounding(const whirl_system *system, double *response) {
    double largest[2] = {0.0, 0.0};
    for (int pass = 0; pass < 2; pass++)
        for (size_t p = 0; p < system->probe_count; p++) {
            const whirl_probe *probe = &system->probes[p];
            const size_t places[] = {probe->x, probe->y, probe->vx, probe->vy};
            for (size_t i = 0; i < 4; i++) {
                double *own = response + 2 * places[i];
                if (pass == 0) largest[i / 2] = fmax(largest[i / 2], size_of(own));
                if (pass == 1 && size_of(own) <= nothing * largest[i / 2]) own[0] = own[1] = 0.0;
            }
        }
}

/// Computes the response about x for coefficients that do not turn with the shaft.
static whirl_status respond_at(mean_system *m, const double *x, double *forcing, double *response) {
    response_parts parts;
    take_forcing(m, x, forcing);
    if (!parts_new(m->count, forcing, &parts))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the response of %zu coordinates", m->system->dimension);
    const bool bounded = parts_solve(m, x, &parts);
    if (bounded) take_sums(m, &parts, response);
    free(parts.block);
    if (bounded) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "the response is beyond all bounds: the machine turns at a critical speed "
                                       "without damping, or a free motion is driven");
}

static whirl_status respond(mean_system *m, double *rest, double *response, double *work) {
    const size_t n = m->count, d = m->system->dimension;
    double *side = work + n * n, period;
    whirl_status status = rest_find(m, rest);
    if (status.code != WHIRL_OK) return status;
    if (mean_is_modulated(m, rest, work)) {
        status = periodic_find(m, rest, true, work, &period);
        if (status.code == WHIRL_OK) status = periodic_harmonic(m, rest, side, response);
        if (status.code == WHIRL_OK) memcpy(rest, side, d * sizeof *rest);
    } else {
        status = respond_at(m, rest, side, response);
    }
    if (status.code == WHIRL_OK) drop_rounding(m->system, response);
    return status;
}

whirl_status whirl_synchronous_check(const whirl_system *system, double speed) {
    static const double rounding = 1e-9; // as in tables over the speed
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
    const int before = exhausted_watch();
    double *work = calloc(mean.count * mean.count + 2 * system->dimension + 1, sizeof *work);
    memcpy(rest, start, system->dimension * sizeof *rest);
    status = work ? respond(&mean, rest, response, work)
                  : whirl_fail(WHIRL_NO_MEMORY, "no memory for the response of %zu coordinates", system->dimension);
    free(work);
    free(block);
    return linear_status(before, status, system->dimension);
}
