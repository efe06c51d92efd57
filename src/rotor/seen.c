// States and extremes of a rotor as its elements see them.
#include <string.h>

#include "machine.h"

size_t rotor_states_seen(const element *own) {
    return own->states < MAX_ELEMENT_STATES ? own->states : MAX_ELEMENT_STATES;
}

element_place rotor_see(const whirl_rotor *rotor, const element *own, const double *x) {
    element_place seen = {.q = {0.0}};
    for (size_t p = 0; p < MAX_PORTS; p++) {
        if (own->port[p] == NO_COORDINATE) continue;
        seen.q[p] = x[own->port[p]];
        seen.v[p] = x[rotor->lanes.degrees + own->port[p]];
    }
    memcpy(seen.s, x + rotor->lanes.degrees + own->state, rotor_states_seen(own) * sizeof *x);
    return seen;
}
