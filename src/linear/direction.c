#include "direction.h"

double whirl_direction(const whirl_system *system, const double *v) {
    double area = 0.0, square = 0.0;
    for (size_t p = 0; p < system->probe_count; p++) {
        const whirl_probe *probe = &system->probes[p];
        const double *x = v + 2 * probe->x, *y = v + 2 * probe->y;
        square += x[0] * x[0] + x[1] * x[1];
        if (probe->x == probe->y) continue;
        square += y[0] * y[0] + y[1] * y[1];
        area += (probe->clockwise ? -2.0 : 2.0) * (x[1] * y[0] - x[0] * y[1]);
    }
    return square > 0.0 ? area / square : 0.0;
}
