/// Drag of pads on their journal. Included by the scalar builds of elements with pads.
#ifndef ROTOR_PADS_DRAG_H
#define ROTOR_PADS_DRAG_H

#include "turbulence.h"
#include <math.h>

/// Integrates the shear over a pad: dp/h over its arc, with the journal at (x, y) in the frame of the pad's middle, in
/// units of its clearance. reynolds: that of the clearance.
static double pads_shear(const double *pad, double x, double y, whirl_turbulence law, double reynolds) {
    // Nodes and weights of Gauss' rule of order 20, on every quarter of the pad.
    static const double node[] = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244, 0.8650633666889845,
                                  0.9739065285171717};
    static const double weight[] = {0.2955242247147529, 0.2692667193099963, 0.2190863625159820, 0.1494513491505806,
                                    0.0666713443086881};
    const double half = acos(pad[PAD_HALF_COSINE]), part = 0.25 * half;
    double sum = 0.0;
    for (int quarter = -3; quarter <= 3; quarter += 2)
        for (int i = 0; i < 10; i++) {
            const double angle = part * (quarter + (i % 2 ? node[i / 2] : -node[i / 2]));
            const double h = 1.0 - x * cos(angle) - y * sin(angle);
            sum += weight[i / 2] * part * turbulent_shear(law, reynolds * h) / h;
        }
    return sum;
}

/// Implements element_type.drag: the shear over all pads, as if their films were full, and half of the couple of each
/// pad's force about the centre of its curvature.
static void pads_drag(const element *own, const drag_view *in, double torque[2]) {
    const kernel_view view = {.stride = 1, .number = own->number};
    const double *q = in->at->q, *v = in->at->v, d[2] = {q[0] - q[2], q[1] - q[3]}, w[2] = {v[0] - v[2], v[1] - v[3]};
    const size_t port = own->port[0] != NO_COORDINATE ? 0 : 1;
    const double unit = own->number[PADS_NUMBERS + port] * in->force_scale; // N of a film's force
    const double clearance = in->length / own->number[PADS_OVER_CLEARANCE], slip = in->spin[0] - in->spin[1];
    double f[MAX_PADS][2], slope[MAX_ELEMENT_STATES], shear = 0.0, couple = 0.0;
    pads_view_plain seen[MAX_PADS];
    pads_forces_plain(own, &view, d, w, in->at->s, seen, f, slope);
    for (size_t p = 0; p < (size_t)own->law; p++) {
        const double *pad = own->number + PADS_FIRST + p * PAD_NUMBERS;
        shear += pads_shear(pad, seen[p].x, seen[p].y, (whirl_turbulence)own->fluid.turbulence,
                            fabs(own->fluid.reynolds * slip));
        couple += 0.5 * unit * clearance * (seen[p].x * f[p][1] - seen[p].y * f[p][0]);
    }
    torque[0] = -own->fluid.shear / 6.28318530717958647692 * shear * slip - couple;
    torque[1] = 0.0;
}

#endif
