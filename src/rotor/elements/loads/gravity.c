// Gravity: the same constant acceleration on every station.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { ACCELERATION, DIRECTION, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [ACCELERATION] =
        NUMBER_KEY("acceleration", "g", "m/s2", DEFAULT("9.80665"), WHIRL_NOT_NEGATIVE, "acceleration of gravity"),
    [DIRECTION] = NUMBER_KEY("direction", "", "rad", DEFAULT("-1.5707963267948966"), WHIRL_ANY,
                             "where it points, from the x axis towards y; downwards, against y, where absent"),
};

static whirl_status build(const key_value *values, assembly *to, element *out) {
    const double size = values[ACCELERATION].number, direction = values[DIRECTION].number;
    (void)out;
    // Straight down without the rounding of cos(-pi/2).
    if (values[DIRECTION].given)
        assembly_pull(to, size * cos(direction), size * sin(direction));
    else
        assembly_pull(to, 0.0, -size);
    return whirl_ok();
}

const element_type gravity_element = {
    .group = {"gravity", "weight of all stations", "", keys, KEY_COUNT, "acceleration", NULL},
    .build = build,
};
#endif
