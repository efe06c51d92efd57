// Description of the train of a design: inertias and speeds of stations that twist, and joints between them.
#include <math.h>
#include <stdlib.h>

#include "machine.h"

/// Adds a joint. A piece of a shaft (`piece`) joins the existing joint between the same two stations, if there is one:
/// both are springs in series.
static void train_add(whirl_model *to, const whirl_model_joint *own, bool piece) {
    for (size_t i = 0; i < to->joint_count && piece; i++) {
        whirl_model_joint *same = &to->joints[i];
        if (same->path.kind != WHIRL_TORQUE_BETWEEN || same->path.station[0] != own->path.station[0] ||
            same->path.station[1] != own->path.station[1])
            continue;
        const double ratio = same->damping / same->stiffness;
        const bool alike = fabs(own->damping / own->stiffness - ratio) <= 1e-9 * fabs(ratio);
        same->stiffness = 1.0 / (1.0 / same->stiffness + 1.0 / own->stiffness);
        same->damping = alike || (ratio == 0.0 && own->damping == 0.0) ? ratio * same->stiffness : (double)NAN;
        if (own->path.modulus > 0.0) same->path.modulus = fmin(same->path.modulus, own->path.modulus);
        return;
    }
    to->joints[to->joint_count++] = *own;
}

whirl_status rotor_model_train(const whirl_design *design, whirl_model *out) {
    whirl_rotor *rotor = NULL;
    whirl_status status = whirl_rotor_new(design, &rotor);
    if (status.code != WHIRL_OK) return status;
    for (size_t s = 0; s < rotor->station_count && rotor->twist_count > 0; s++) {
        if (rotor->twists[s].coordinate == NO_COORDINATE) continue;
        out->stations[s].twist = rotor->polar[s];
        out->stations[s].turns = rotor_turns(rotor, s);
    }
    const size_t count = rotor->twist_count > 0 ? rotor->torsion.path_count : 0;
    out->joints = calloc(count + 1, sizeof *out->joints);
    if (!out->joints) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the model of a machine");
    for (size_t k = 0; k < count && status.code == WHIRL_OK; k++) {
        const rotor_path of = rotor_path_at(rotor, k);
        whirl_model_joint own = {.stiffness = NAN, .damping = NAN};
        rotor->torsion.path(rotor, k, &own.path);
        own.turns = own.path.station[0] < rotor->station_count ? rotor_turns(rotor, own.path.station[0]) : (double)NAN;
        bool piece = false;
        if (of.link) {
            own.stiffness = of.link->stiffness;
            own.damping = of.link->damping;
            for (size_t end = 0; end < 2; end++)
                piece = piece || rotor_link_station(rotor, of.link, end) == rotor->station_count;
        }
        if (of.element) {
            // Compute stiffness and damping about the axis of the first gear.
            element_carried by;
            of.element->type->carry(of.element, &(element_place){.q = {0.0}}, &by);
            own.stiffness = by.stiffness / by.unit * by.lever[0] * by.lever[0];
            own.damping = by.damping / (by.unit * rotor->clock) * by.lever[0] * by.lever[0];
        }
        train_add(out, &own, piece);
    }
    whirl_rotor_free(rotor);
    return status;
}
