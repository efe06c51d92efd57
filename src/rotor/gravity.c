// Gravity: the same constant acceleration on every station.
#include <math.h>

#include "element.h"

enum { ACCELERATION, DIRECTION, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [ACCELERATION] = {"acceleration", "g", "m/s2", WHIRL_KEY_NUMBER, false, "9.80665", WHIRL_NOT_NEGATIVE, NULL,
                      "acceleration of gravity", ""},
    [DIRECTION] = {"direction", "", "rad", WHIRL_KEY_NUMBER, false, "-1.5707963267948966", WHIRL_ANY, NULL,
                   "where it points, from the x axis towards y; downwards, against y, where absent", ""},
};

typedef struct gravity {
    double x, y;
} gravity;

static whirl_status build(const key_value *values, const scales *scale, void *coefficients) {
    const double scaled = values[ACCELERATION].number / (scale->speed * scale->speed * scale->length);
    gravity *g = coefficients;
    // Straight down without the rounding of cos(-pi/2).
    *g = values[DIRECTION].given
             ? (gravity){scaled * cos(values[DIRECTION].number), scaled * sin(values[DIRECTION].number)}
             : (gravity){0.0, -scaled};
    return whirl_ok();
}

static void lump(const void *coefficients, size_t station_count, station_terms *terms) {
    const gravity *g = coefficients;
    for (size_t s = 0; s < station_count; s++) {
        terms[s].pull_x += g->x;
        terms[s].pull_y += g->y;
    }
}

const element_type gravity_element = {
    .group = {"gravity", "weight of all stations", "", keys, KEY_COUNT, "acceleration"},
    .size = sizeof(gravity),
    .build = build,
    .lump = lump,
};
