// Gravity: the same constant acceleration on every station.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { ACCELERATION, DIRECTION, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [ACCELERATION] = {"acceleration", "g", "m/s2", WHIRL_KEY_NUMBER, false, "9.80665", WHIRL_NOT_NEGATIVE, NULL,
                      "acceleration of gravity", ""},
    [DIRECTION] = {"direction", "", "rad", WHIRL_KEY_NUMBER, false, "-1.5707963267948966", WHIRL_ANY, NULL,
                   "where it points, from the x axis towards y; downwards, against y, where absent", ""},
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
