// Steps of RK4 lanes that meet a switch, one lane at a time.
#include "rk4_lanes.h"
#include "stepper.h"
#include "stepper_parts.h"

void rk4_redo(const rk4_lanes *lanes, int n, size_t lane) {
    const lanes_located *own = &lanes->located;
    const size_t degrees = lanes->degrees, count = lanes->lane_count;
    const whirl_system *system = own->machines[lane];
    stepper *c = own->stepper;
    if (!system || own->ended[lane] > 0.0) return;
    for (size_t d = 0; d < degrees; d++) c->x[d] = own->begin_q[d * count + lane];
    for (size_t d = 0; d < lanes->rates; d++) c->x[degrees + d] = own->begin_v[d * count + lane];
    const double until = system->period * ((double)(n + 1) / lanes->steps);
    stepper_place(c, system, system->period * ((double)n / lanes->steps));
    stepper_find_sides(c);
    whirl_motion motion = WHIRL_BOUNDED;
    while (motion == WHIRL_BOUNDED && c->t < until) motion = stepper_step(c, until);
    own->ended[lane] = motion;
    for (size_t d = 0; d < degrees; d++) lanes->q[d * count + lane] = c->x[d];
    for (size_t d = 0; d < lanes->rates; d++) lanes->v[d * count + lane] = c->x[degrees + d];
}
