#include <math.h>
#include <stddef.h>

#include "direction.h"

void direction_area(const whirl_system *system, const double *a, const double *b, double out[2]) {
    out[0] = out[1] = 0.0;
    for (size_t p = 0; p < system->probe_count; p++) {
        const whirl_probe *probe = &system->probes[p];
        const double *ax = a + 2 * probe->x, *ay = a + 2 * probe->y, *bx = b + 2 * probe->x, *by = b + 2 * probe->y;
        if (probe->x == probe->y) continue;
        // i (conj(ax) by - conj(ay) bx)
        const double way = whirl_probe_way(probe);
        out[0] += way * (-(ax[0] * by[1] - ax[1] * by[0]) + (ay[0] * bx[1] - ay[1] * bx[0]));
        out[1] += way * ((ax[0] * by[0] + ax[1] * by[1]) - (ay[0] * bx[0] + ay[1] * bx[1]));
    }
}

static double direction_coordinate(const double *v, size_t k) {
    return hypot(v[2 * k], v[2 * k + 1]);
}

void direction_drop_rounding(const whirl_system *system, double *v) {
    static const double least = 1e-11; // of the largest displacement or tilt
    double all = 0.0, seen = 0.0;
    if (system->probe_count == 0 || system->probes->vx <= system->probes->x) return;
    // Displacements and tilts come first, then their rates.
    for (size_t k = 0; k < system->probes->vx - system->probes->x; k++) all = fmax(all, direction_coordinate(v, k));
    for (size_t p = 0; p < system->probe_count; p++)
        seen = fmax(seen,
                    fmax(direction_coordinate(v, system->probes[p].x), direction_coordinate(v, system->probes[p].y)));
    if (seen > least * all) return;
    for (size_t p = 0; p < system->probe_count; p++)
        for (size_t i = 0; i < 2; i++) v[2 * system->probes[p].x + i] = v[2 * system->probes[p].y + i] = 0.0;
}

double whirl_direction(const whirl_system *system, const double *v) {
    double area[2], square = 0.0;
    direction_area(system, v, v, area);
    for (size_t p = 0; p < system->probe_count; p++) {
        const whirl_probe *probe = &system->probes[p];
        const double *x = v + 2 * probe->x, *y = v + 2 * probe->y;
        square += x[0] * x[0] + x[1] * x[1];
        if (probe->x != probe->y) square += y[0] * y[0] + y[1] * y[1];
    }
    return square > 0.0 ? area[0] / square : 0.0;
}
