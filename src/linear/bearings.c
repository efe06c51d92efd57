// The coefficients of bearings: derivatives of their forces.
#include <math.h>
#include <stdlib.h>

#include "lanes.h"
#include "linear_parts.h"

/// Of a station of 1 kg: the forces on it are its accelerations.
static void take(const mean_system *m, const double *jacobian, double clock, const whirl_probe *probe, double *out) {
    const size_t columns[] = {probe->x, probe->y, probe->vx, probe->vy};
    size_t place[4] = {0};
    for (size_t i = 0; i < m->count; i++)
        for (size_t c = 0; c < 4; c++)
            if (m->kept[i] == columns[c]) place[c] = i;
    for (size_t r = 0; r < 2; r++)
        for (size_t c = 0; c < 2; c++) {
            const double *row = jacobian + place[2 + r] * m->count;
            out[2 * r + c] = -clock * clock * row[place[c]];
            out[4 + 2 * r + c] = -clock * row[place[2 + c]];
        }
}

whirl_status whirl_bearing_coefficients(const whirl_machine *alone, const double *x, double *coefficients) {
    const whirl_system *system = alone->system;
    mean_system mean;
    void *block;
    whirl_status status = mean_begin(&mean, system, &block);
    if (status.code != WHIRL_OK) return status;
    double *jacobian = malloc((mean.count * mean.count + 1) * sizeof *jacobian);
    if (!jacobian)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the coefficients of %zu stations", system->probe_count);
    if (status.code == WHIRL_OK) mean_jacobian(&mean, x, jacobian);
    // A bearing with states of its own has no coefficients that hold at every frequency.
    const bool simple = !system->lanes || mean.count <= 2 * system->lanes->degrees;
    for (size_t i = 0; i < 8 * system->probe_count && !simple; i++) coefficients[i] = (double)NAN;
    for (size_t p = 0; p < system->probe_count && status.code == WHIRL_OK && simple; p++)
        take(&mean, jacobian, alone->clock, &system->probes[p], coefficients + 8 * p);
    free(jacobian);
    free(block);
    return status;
}
