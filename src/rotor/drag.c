// Drag of films and seals on shafts whose speed is a state: shear between the surfaces, and the couple of a force that
// does not act along the line of centres.
//
// The fluid has no inertia, so that its effects are in balance: T + T' + r x F = 0, where T and T' are the torques on
// journal and housing about their own centres, and F is the force on the journal, which is at r from the housing's
// centre. Half of the couple of the pressure acts on either side. To it is added the torque S of the shear between the
// surfaces.
#include <math.h>

#include "machine.h"
#include "turbulence.h"

void drag_of_film(const element *own, const drag_view *in, double clearance, double torque[2]) {
    const double slip = in->spin[0] - in->spin[1], share = in->distance / clearance;
    const double factor = turbulent_shear((whirl_turbulence)own->fluid.turbulence, fabs(own->fluid.reynolds * slip));
    const double shear = own->fluid.shear * factor * slip / sqrt(1.0 - share * share);
    const double couple = 0.5 * (in->place[0] * in->force[1] - in->place[1] * in->force[0]);
    torque[0] = -shear - couple;
    torque[1] = shear - couple;
}

void rotor_drag_with(const whirl_rotor *rotor, const element *own, double *numbers, const double *x, double speed,
                     const double spin[2], double torque[2]) {
    const size_t n = rotor->lanes.degrees;
    const element_place at = rotor_see(rotor, own, x);
    double a[MAX_ROWS];
    const lanes_view view = {.model = rotor, .stride = 1, .vectors = 1, .numbers = numbers, .q = x, .v = x + n, .a = a};
    // Collect the accelerations by this element alone, which are its forces divided by the inertia of its ports.
    for (size_t p = 0; p < MAX_PORTS; p++)
        if (own->port[p] != NO_COORDINATE) a[own->port[p]] = 0.0;
    machine_element_flow(&view, own);
    drag_view in = {.at = &at, .length = rotor->length, .speed = speed, .spin = {spin[0], spin[1]}};
    for (size_t i = 0; i < 2; i++) {
        const size_t port = own->port[i] != NO_COORDINATE ? own->port[i] : own->port[2 + i];
        const double sense = i == 1 && rotor->way < 0.0 ? -1.0 : 1.0;
        if (port == NO_COORDINATE) continue;
        const double scale = rotor->inertia[port] * rotor->unit[port] * speed * speed;
        in.place[i] = sense * rotor->length * (at.q[i] - at.q[2 + i]);
        in.force[i] = sense * (port == own->port[i] ? scale : -scale) * a[port];
        in.force_scale = i == 0 || in.force_scale == 0.0 ? scale : in.force_scale;
    }
    in.distance = hypot(in.place[0], in.place[1]);
    element moved = *own;
    moved.number = numbers + own->first_number;
    own->type->drag(&moved, &in, torque);
}
