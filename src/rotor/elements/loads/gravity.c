// Gravity: the same constant acceleration on every station, across the shafts; along them it acts by thrust.c alone.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

#include "shafts.h"

static const whirl_key keys[GRAVITY_KEYS] = {
    [GRAVITY_ACCELERATION] =
        NUMBER_KEY("acceleration", "g", "m/s2", DEFAULT("9.80665"), WHIRL_NOT_NEGATIVE, "acceleration of gravity"),
    [GRAVITY_DIRECTION] = NUMBER_KEY("direction", "", "rad", DEFAULT("-1.5707963267948966"), WHIRL_ANY,
                                     "where it points, from the x axis towards y; downwards, against y, where absent"),
    [GRAVITY_AXIS] = CITED_CHOICE_KEY("axis", DEFAULT("horizontal"), "horizontal|vertical",
                                      "vertical: the shafts stand; their weight loads no bearing across and pulls or "
                                      "presses them along their axis",
                                      "Greenhill 1881; Naguleswaran 2004"),
    [GRAVITY_HELD_AT] = STATION_KEY("held_at", OPTIONAL,
                                    "of axis: vertical: station whose thrust bearing holds its shaft; required with "
                                    "shafts of finite elements, one gravity for each"),
    [GRAVITY_TOP] = CHOICE_OF_KEY("top", DEFAULT("start"), "start|end", "held_at",
                                  "which end of that shaft is up: that of the least position or the other one"),
};

static whirl_status build(const key_value *values, assembly *to, element *out) {
    const double size = values[GRAVITY_ACCELERATION].number, direction = values[GRAVITY_DIRECTION].number;
    const bool stands = values[GRAVITY_AXIS].choice == GRAVITY_VERTICAL;
    (void)out;
    if (stands && values[GRAVITY_DIRECTION].given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has a direction across the shafts and axis: vertical, expected one of them");
    if (!stands && values[GRAVITY_HELD_AT].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has held_at without axis: vertical, expected both or none of them");
    if (stands) return whirl_ok();
    // Straight down without the rounding of cos(-pi/2).
    if (values[GRAVITY_DIRECTION].given)
        assembly_pull(to, size * cos(direction), size * sin(direction));
    else
        assembly_pull(to, 0.0, -size);
    return whirl_ok();
}

const element_type gravity_element = {
    .group = {"gravity", "weight of all stations", "", keys, GRAVITY_KEYS, "acceleration", NULL},
    .build = build,
};
#endif
