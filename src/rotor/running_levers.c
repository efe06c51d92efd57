// Levers of unbalances by theta'' of their shaft, and the pull on their weight.
#include "running_rotor.h"

double running_geared_lever(const running_rotor *r, size_t index, double w, const double *states, double lever[2]) {
    element own = r->rotor->elements[index];
    if (!own.type->lever || own.states == 0 || own.spool > 0) return 0.0;
    own.number = r->numbers + own.first_number;
    return own.type->lever(&own, w * r->unit, states, lever);
}

void running_find_levers(const running_rotor *r, const double *forcing) {
    const double way = r->rotor->way, c = way * forcing[COS_TAU], s = way * forcing[SIN_TAU];
    const turning_inertia *guided = r->how.lost ? r->lost_guided : r->rotor->guided;
    for (size_t i = 0; i < 2; i++) r->guided_lever[i] = guided[i].cos * s - guided[i].sin * c;
    for (size_t i = 0; i < r->rotor->lanes.degrees; i++) {
        r->lever_force[i] = r->force_cos[i] * s - r->force_sin[i] * c;
        r->lever_acceleration[i] = r->own_cos[i] * s - r->own_sin[i] * c;
        if (!r->how.lost) continue;
        r->lever_force[i] += r->lost_force_cos[i] * s - r->lost_force_sin[i] * c;
        r->lever_acceleration[i] += r->lost_cos[i] * s - r->lost_sin[i] * c;
    }
}

double running_pull(const running_rotor *r, size_t way) {
    return way < 2 ? r->rotor->pull[way] - r->shake[way] : 0.0;
}
