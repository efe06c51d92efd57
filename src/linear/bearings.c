// The coefficients of bearings: derivatives of their forces. Inner states of bearings (tilting pads, rings,
// controllers) follow the journal at the frequency of the shaft. Their effect is included in the coefficients.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exhausted.h"
#include "lanes.h"
#include "linear_status.h"
#include "matrix.h"
#include "mean.h"
#include "whirl/engine/linear.h"

/// A machine of bearings alone, linearised at its equilibrium, and the inner states of its bearings.
typedef struct inner_states {
    const mean_system *mean;
    const double *jacobian; ///< [count][count]
    double frequency;       ///< frequency of the whirl, per unit of the system's time
    size_t count;           ///< number of inner states
    size_t *place;          ///< [count] indices among the mean's coordinates
    double *matrix;         ///< [count][count][2] i frequency - the Jacobian of the inner states
    double *side;           ///< [4][count][2] response of the inner states to x, y, vx, vy
} inner_states;

/// Returns the index of a coordinate of the state among the coordinates of the mean.
static size_t bearings_index(const mean_system *m, size_t coordinate) {
    size_t i = 0;
    while (i < m->count && m->kept[i] != coordinate) i++;
    return i;
}

/// Solves (i w - J_ss) s = J_sc for the response of the inner states to a unit of each of four columns.
static bool bearings_follow(const inner_states *s, const size_t column[4]) {
    const size_t n = s->mean->count, count = s->count;
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < count; k++) {
            s->matrix[2 * (i * count + k)] = -s->jacobian[s->place[i] * n + s->place[k]];
            s->matrix[2 * (i * count + k) + 1] = i == k ? s->frequency : 0.0;
        }
        for (size_t c = 0; c < 4; c++) {
            s->side[2 * (c * count + i)] = s->jacobian[s->place[i] * n + column[c]];
            s->side[2 * (c * count + i) + 1] = 0.0;
        }
    }
    return count == 0 || matrix_solve_complex(count, s->matrix, 4, s->side);
}

/// Writes the coefficients of a bearing. The station has 1 kg, so that the forces on it are its accelerations.
static bool bearings_take(const inner_states *s, double clock, const whirl_probe *probe, double *out) {
    const mean_system *m = s->mean;
    const size_t n = m->count, row[] = {bearings_index(m, probe->vx), bearings_index(m, probe->vy)};
    const size_t column[] = {bearings_index(m, probe->x), bearings_index(m, probe->y), row[0], row[1]};
    if (!bearings_follow(s, column)) return false;
    for (size_t r = 0; r < 2; r++)
        for (size_t c = 0; c < 2; c++) {
            const double *force = s->jacobian + row[r] * n;
            // Columns are displacements, then velocities; a velocity is i w times the displacement.
            double by[2] = {force[column[c]], force[column[2 + c]]};
            for (size_t i = 0; i < s->count; i++) {
                const double *still = s->side + 2 * (c * s->count + i),
                             *moving = s->side + 2 * ((2 + c) * s->count + i);
                by[0] += force[s->place[i]] * (still[0] - s->frequency * moving[1]);
                by[1] += force[s->place[i]] * (still[1] / s->frequency + moving[0]);
            }
            out[2 * r + c] = -clock * clock * by[0];
            out[4 + 2 * r + c] = -clock * by[1];
        }
    return true;
}

/// Finds the inner states of bearings: all states other than the displacements and velocities of the stations.
static void find_states(const mean_system *m, inner_states *s) {
    for (size_t i = 0; i < m->count && m->system->lanes; i++)
        if (m->kept[i] >= 2 * m->system->lanes->degrees) s->place[s->count++] = i;
}

static void take_all(const whirl_machine *alone, mean_system *m, double *work, size_t *place, double *out) {
    const whirl_system *system = alone->system;
    const double speed = fabs(alone->speed) / alone->clock;
    inner_states s = {.mean = m, .jacobian = work, .place = place, .frequency = speed > 0.0 ? speed : 1e-6};
    mean_leave_idle(m, work);
    const size_t n = m->count, d = system->dimension;
    s.jacobian = work + d;
    s.matrix = work + d + n * n;
    s.side = s.matrix + 2 * n * n;
    mean_jacobian(m, work, work + d);
    find_states(m, &s);
    for (size_t p = 0; p < system->probe_count; p++)
        if (!bearings_take(&s, alone->clock, &system->probes[p], out + 8 * p))
            for (size_t i = 0; i < 8; i++) out[8 * p + i] = (double)NAN;
}

whirl_status whirl_bearing_coefficients(const whirl_machine *alone, const double *x, double *coefficients) {
    const whirl_system *system = alone->system;
    mean_system mean;
    void *block;
    whirl_status status = mean_begin(&mean, system, &block);
    if (status.code != WHIRL_OK) return status;
    const size_t d = system->dimension;
    const int before = exhausted_watch();
    double *work = calloc(d + 3 * d * d + 8 * d + 1, sizeof *work);
    size_t *place = calloc(d + 1, sizeof *place);
    if (work && place) {
        memcpy(work, x, d * sizeof *x);
        mean_settle(&mean, work);
        take_all(alone, &mean, work, place, coefficients);
    } else {
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the coefficients of %zu stations", system->probe_count);
    }
    free(work);
    free(place);
    free(block);
    return linear_status(before, status, d);
}
