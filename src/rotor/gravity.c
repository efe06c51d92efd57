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

enum { GRAVITY_X, GRAVITY_Y };

static whirl_status build(const key_value *values, const scales *scale, element *out) {
    const double scaled = values[ACCELERATION].number / (scale->speed * scale->speed * scale->length);
    const double direction = values[DIRECTION].number;
    // Straight down without the rounding of cos(-pi/2).
    out->number[GRAVITY_X] = values[DIRECTION].given ? scaled * cos(direction) : 0.0;
    out->number[GRAVITY_Y] = values[DIRECTION].given ? scaled * sin(direction) : -scaled;
    return whirl_ok();
}

static void lump(const element *own, size_t station_count, double (*stations)[STATION_NUMBERS]) {
    for (size_t s = 0; s < station_count; s++) {
        stations[s][STATION_PULL_X] += own->number[GRAVITY_X];
        stations[s][STATION_PULL_Y] += own->number[GRAVITY_Y];
    }
}

const element_type gravity_element = {
    .group = {"gravity", "weight of all stations", "", keys, KEY_COUNT, "acceleration"},
    .kernel = KERNEL_NONE,
    .build = build,
    .lump = lump,
};
