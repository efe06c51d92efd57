// Gravity: the same constant acceleration of every station, across the shafts or along them. The axial force in shafts
// by gravity along them is computed in thrust.c.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

#include "shafts.h"

static const whirl_key keys[GRAVITY_KEYS] = {
    [GRAVITY_ACCELERATION] =
        NUMBER_KEY("acceleration", "g", "m/s2", DEFAULT("9.80665"), WHIRL_NOT_NEGATIVE, "acceleration of gravity"),
    [GRAVITY_DIRECTION] =
        NUMBER_KEY("direction", "", "rad", DEFAULT("-1.5707963267948966"), WHIRL_ANY,
                   "direction of the weight, from the x axis towards y; absent: downwards, against y"),
    [GRAVITY_AXIS] = CITED_CHOICE_KEY("axis", DEFAULT("horizontal"), "horizontal|vertical",
                                      "vertical: a vertical machine, whose weight loads no bearing across and pulls or "
                                      "presses the shafts along their axis",
                                      "Greenhill 1881; Naguleswaran 2004"),
    [GRAVITY_HELD_AT] = STATION_KEY("held_at", OPTIONAL,
                                    "with axis: vertical: station of the thrust bearing of its shaft; required with "
                                    "shafts of finite elements, one gravity for each"),
    [GRAVITY_TOP] = CHOICE_OF_KEY("top", DEFAULT("start"), "start|end", "held_at",
                                  "upper end of that shaft: start (least position) or end"),
};

static whirl_status gravity_build(const key_value *values, assembly *to, element *out) {
    const double size = values[GRAVITY_ACCELERATION].number, direction = values[GRAVITY_DIRECTION].number;
    const bool stands = values[GRAVITY_AXIS].choice == GRAVITY_VERTICAL;
    (void)out;
    if (stands && values[GRAVITY_DIRECTION].given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has a direction across the shafts and axis: vertical, expected one of them");
    if (!stands && values[GRAVITY_HELD_AT].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has held_at without axis: vertical, expected both or none of them");
    if (stands) {
        // Positions grow downwards from the upper end, or upwards to it.
        const key_value *held = &values[GRAVITY_HELD_AT];
        const size_t shaft = held->given ? to->stations[held->station[0]].shaft : NO_SHAFT;
        assembly_pull_axially(to, shaft, values[GRAVITY_TOP].choice == 0 ? size : -size);
        return whirl_ok();
    }
    // Gravity straight down avoids the rounding of cos(-pi/2).
    if (values[GRAVITY_DIRECTION].given)
        assembly_pull(to, size * cos(direction), size * sin(direction));
    else
        assembly_pull(to, 0.0, -size);
    return whirl_ok();
}

const element_type gravity_element = {
    .group = {"gravity", "weight of all stations", "", keys, GRAVITY_KEYS, "acceleration", NULL},
    .build = gravity_build,
};
#endif
