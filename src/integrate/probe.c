// Motion that a probe sees, and descriptors of its members.
#include <math.h>

#include "member_table.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/system.h"

bool whirl_probe_sees(const whirl_probe *probe, size_t which) {
    return probe->x != probe->y || probe->along_y == (which == 1);
}

double whirl_probe_value(const whirl_probe *probe, const double *state, size_t nth) {
    const size_t at[] = {probe->x, probe->y, probe->vx, probe->vy};
    if (!whirl_probe_sees(probe, nth % 2)) return 0.0;
    return probe->units ? probe->units[nth] * state[at[nth]] : state[at[nth]];
}

double whirl_probe_runout(const whirl_probe *probe, size_t which, double revolutions) {
    double sum = 0.0;
    for (size_t i = 0; i < probe->runout_count; i++) {
        const whirl_runout *own = &probe->runout[i];
        const double *v = which == 0 ? own->first : own->second;
        const double at = 6.283185307179586476925 * fmod((double)own->order * revolutions, 1.0);
        sum += v[0] * cos(at) - v[1] * sin(at);
    }
    return whirl_probe_sees(probe, which) ? sum : 0.0;
}

size_t whirl_watched_probes(const whirl_system *system) {
    return system->probe_count + system->extra_count;
}

double whirl_probe_way(const whirl_probe *probe) {
    return probe->clockwise ? -1.0 : 1.0;
}

// The range comes last: some tools expand it to its parts before they count arguments.
#define PROBE(TYPE, field, symbol, unit, part, fallback, meaning, ...)                                                 \
    MEMBER(whirl_probe, TYPE, #field, field, part, false, #field, symbol, unit, WHIRL_KEY_NUMBER, false, fallback,     \
           __VA_ARGS__, NULL, meaning, "")
/// Keys of the state in a case are the names of its coordinates.
#define COORDINATE(field, symbol, meaning) PROBE(INDEX, field, symbol, "1", "initial", "0", meaning, WHIRL_ANY)
#define LENGTH(field, meaning) PROBE(NUMBER, field, "", "length", "", "", meaning, WHIRL_NOT_NEGATIVE)
#define PLACE "displacement in length scales, or with a unit of length"
#define RATE "velocity in length scales per radian of rotation, or with a unit of m/s"

const whirl_member *whirl_probe_members(void) {
    static const whirl_member members[] = {
        LENGTH(clearance, "clearance of the journal bearing, 0 without one"),
        LENGTH(gap, "radius at which a stator is touched, 0 without one"),
        COORDINATE(x, "x", PLACE),
        COORDINATE(y, "y", PLACE),
        COORDINATE(vx, "x'", RATE),
        COORDINATE(vy, "y'", RATE),
        PROBE(INDEX, shaft, "", "1", "", "", "number of the shaft of finite elements, from 1; 0: on none", WHIRL_ANY),
        PROBE(NUMBER, position, "", "m", "", "", "place along that shaft, m", WHIRL_ANY),
        PROBE(FLAG, along_y, "", "1", "", "", "whether the only coordinate is that along y", WHIRL_ANY),
        PROBE(FLAG, twists, "", "1", "", "",
              "whether the station only turns about the shaft's axis: lengths in m are angles in rad", WHIRL_ANY),
        PROBE(FLAG, clockwise, "", "1", "", "", "whether the rotor turns clockwise, from y to x", WHIRL_ANY),
        {.part = NULL},
    };
    return members;
}
