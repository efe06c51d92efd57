// What a rotor's system gives beyond its right-hand side: sides of its switches, its Jacobian, the switches'
// derivatives. All by the one-lane build of flow.inc.
#include <string.h>

#include "machine.h"

enum { MAX_DEGREES = 2 * WHIRL_MAX_STATIONS };

static lanes_view view_of(const whirl_rotor *rotor, const double *forcing, const double *sides) {
    return (lanes_view){
        .model = rotor, .stride = 1, .vectors = 1, .numbers = rotor->numbers, .forcing = forcing, .sides = sides};
}

void rotor_rhs_on_sides(const void *model, double t, const double *forcing, const double *x, const double *sides,
                        double *dxdt) {
    const whirl_rotor *rotor = model;
    const size_t degrees = rotor->lanes.degrees;
    lanes_view view = view_of(rotor, forcing, sides);
    (void)t;
    view.q = x;
    view.v = x + degrees;
    view.a = dxdt + degrees;
    memcpy(dxdt, x + degrees, degrees * sizeof *dxdt);
    machine_flow[0](&view);
}

/// The state and as many disturbances as there is room for, positions and velocities apart as lanes want them.
typedef struct group {
    double q[2 * MAX_DEGREES], v[2 * MAX_DEGREES], a[2 * MAX_DEGREES];
} group;

void rotor_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                   size_t count, const double *dx, double *ddxdt) {
    const whirl_rotor *rotor = model;
    const size_t degrees = rotor->lanes.degrees, bytes = degrees * sizeof *x;
    const size_t most = (size_t)2 * MAX_DEGREES / degrees - 1;
    lanes_view view = view_of(rotor, forcing, sides);
    group g;
    (void)t;
    view.q = g.q;
    view.v = g.v;
    view.a = g.a;
    memcpy(g.q, x, bytes);
    memcpy(g.v, x + degrees, bytes);
    for (size_t first = 0; first < count; first += most) {
        view.tangents = count - first < most ? count - first : most;
        for (size_t k = 0; k < view.tangents; k++) {
            memcpy(g.q + (k + 1) * degrees, dx + 2 * (first + k) * degrees, bytes);
            memcpy(g.v + (k + 1) * degrees, dx + (2 * (first + k) + 1) * degrees, bytes);
        }
        machine_flow[0](&view);
        for (size_t k = 0; k < view.tangents; k++) {
            memcpy(ddxdt + 2 * (first + k) * degrees, g.v + (k + 1) * degrees, bytes);
            memcpy(ddxdt + (2 * (first + k) + 1) * degrees, g.a + (k + 1) * degrees, bytes);
        }
    }
}

double rotor_divergence(const void *model, double t, const double *forcing, const double *x, const double *sides) {
    const whirl_rotor *rotor = model;
    double a[MAX_DEGREES], divergence;
    lanes_view view = view_of(rotor, forcing, sides);
    (void)t;
    view.q = x;
    view.v = x + rotor->lanes.degrees;
    view.a = a;
    view.divergence = &divergence;
    machine_flow[0](&view);
    return divergence;
}

/// The element that has switch *index, which becomes its own index there.
static const element *owner_of(const whirl_rotor *rotor, size_t *index) {
    const element *own = rotor->elements;
    for (;; own++) {
        const size_t count = own->type->switch_count ? own->type->switch_count(own) : 0;
        if (*index < count) return own;
        *index -= count;
    }
}

void rotor_switch_gradient(const void *model, double t, const double *x, size_t index, double *gradient,
                           double *by_time) {
    const whirl_rotor *rotor = model;
    const size_t degrees = rotor->lanes.degrees;
    const element *own = owner_of(rotor, &index);
    const size_t at = 2 * own->station[0];
    (void)t;
    memset(gradient, 0, 2 * degrees * sizeof *gradient);
    *by_time = 0.0;
    own->type->switch_gradient(own, x, x + degrees, index, gradient + at, gradient + degrees + at);
}

void rotor_switch_curvature(const void *model, double t, const double *x, size_t index, const double *u, double *out) {
    const whirl_rotor *rotor = model;
    const size_t degrees = rotor->lanes.degrees;
    const element *own = owner_of(rotor, &index);
    const size_t at = 2 * own->station[0];
    (void)t;
    memset(out, 0, 2 * degrees * sizeof *out);
    own->type->switch_curvature(own, x, x + degrees, index, u + at, u + degrees + at, out + at, out + degrees + at);
}
