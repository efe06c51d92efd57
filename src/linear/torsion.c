// Response of a machine about its equilibrium to given slopes: harmonic ones at any frequency, and constant ones.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exhausted.h"
#include "linear_status.h"
#include "matrix.h"
#include "mean.h"
#include "whirl/engine/torsion.h"

/// Computes the Jacobian at the equilibrium. Its memory is `extra` numbers longer. Freed by the caller.
static whirl_status torsion_jacobian(mean_system *m, const double *rest, size_t extra, double **out) {
    const size_t n = m->count;
    *out = calloc(n * n + extra + 1, sizeof **out);
    if (!*out) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the response of %zu coordinates", n);
    if (mean_is_modulated(m, rest, *out))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "coefficients turn with the shaft, expected ones that do not, for a response "
                          "to torques of another frequency");
    mean_jacobian(m, rest, *out);
    return whirl_ok();
}

static whirl_status harmonic_solve(mean_system *m, const double *rest, double frequency, const double *drive,
                                   double *response) {
    const size_t n = m->count;
    double *jacobian = NULL;
    whirl_status status = torsion_jacobian(m, rest, 2 * n * n + 2 * n, &jacobian);
    if (status.code == WHIRL_OK) {
        // Solve (i w - J) X = F.
        double *matrix = jacobian + n * n, *side = matrix + 2 * n * n;
        for (size_t i = 0; i < n * n; i++) {
            matrix[2 * i] = -jacobian[i];
            matrix[2 * i + 1] = i % (n + 1) == 0 ? frequency : 0.0;
        }
        for (size_t i = 0; i < n; i++) memcpy(side + 2 * i, drive + 2 * m->kept[i], 2 * sizeof *side);
        if (!matrix_solve_complex(n, matrix, 1, side))
            status = whirl_fail(WHIRL_BAD_INPUT, "the response is beyond all bounds: a torque has the frequency of a "
                                                 "mode without damping");
        memset(response, 0, 2 * m->system->dimension * sizeof *response);
        for (size_t i = 0; i < n && status.code == WHIRL_OK; i++)
            memcpy(response + 2 * m->kept[i], side + 2 * i, 2 * sizeof *side);
    }
    free(jacobian);
    return status;
}

/// Returns true if a turn [count] meets no resistance: J times the turn is 0, to rounding.
static bool static_is_free(size_t n, const double *jacobian, const double *turn) {
    static const double rounding = 1e-10;
    bool any = false;
    for (size_t i = 0; i < n; i++) {
        double sum = 0.0, size = 0.0;
        for (size_t k = 0; k < n; k++) {
            sum += jacobian[i * n + k] * turn[k];
            size += fabs(jacobian[i * n + k] * turn[k]);
        }
        if (fabs(sum) > rounding * size) return false;
        any = any || turn[i] != 0.0;
    }
    return any;
}

static whirl_status static_solve(mean_system *m, const double *rest, const double *turn, const double *drive,
                                 double *response) {
    const size_t n = m->count, more = n + 1;
    double *jacobian = NULL;
    whirl_status status = torsion_jacobian(m, rest, more * more + 2 * more, &jacobian);
    if (status.code == WHIRL_OK) {
        // Solve J x = -F. If the turn is free, one more equation excludes it from x, and one more unknown is a force
        // along it, which becomes 0.
        double *matrix = jacobian + n * n, *side = matrix + more * more, *own = side + more;
        for (size_t i = 0; i < n; i++) own[i] = turn[m->kept[i]];
        const bool is_free = static_is_free(n, jacobian, own);
        const size_t size = is_free ? more : n;
        for (size_t i = 0; i < n; i++) {
            memcpy(matrix + i * size, jacobian + i * n, n * sizeof *matrix);
            side[i] = -drive[m->kept[i]];
        }
        for (size_t i = 0; i < n && is_free; i++) {
            const size_t rate = mean_rate_of(jacobian, n, i);
            if (rate < n) matrix[rate * size + n] = own[i];
            matrix[n * size + i] = own[i];
        }
        if (!matrix_solve(size, matrix, 1, side))
            status = whirl_fail(WHIRL_BAD_INPUT, "steady torques turn something that nothing holds");
        memset(response, 0, m->system->dimension * sizeof *response);
        for (size_t i = 0; i < n && status.code == WHIRL_OK; i++) response[m->kept[i]] = side[i];
    }
    free(jacobian);
    return status;
}

/// Computes the response about `rest`: to steady torques if a rigid turn to be excluded is given, otherwise at a
/// frequency.
static whirl_status torsion_respond(const whirl_system *system, const double *rest, double frequency,
                                    const double *turn, const double *drive, double *response) {
    mean_system mean;
    void *block;
    whirl_status status = mean_begin(&mean, system, &block);
    if (status.code != WHIRL_OK) return status;
    const int before = exhausted_watch();
    status = turn ? static_solve(&mean, rest, turn, drive, response)
                  : harmonic_solve(&mean, rest, frequency, drive, response);
    free(block);
    return linear_status(before, status, system->dimension);
}

whirl_status whirl_harmonic_response(const whirl_system *system, const double *rest, double frequency,
                                     const double *drive, double *response) {
    return torsion_respond(system, rest, frequency, NULL, drive, response);
}

whirl_status whirl_static_response(const whirl_system *system, const double *rest, const double *turn,
                                   const double *drive, double *response) {
    return torsion_respond(system, rest, 0.0, turn, drive, response);
}
