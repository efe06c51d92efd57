// An unbalance mass fixed to a station, turning with the shaft.
#include <math.h>

#include "element.h"

enum { AT, MOMENT, ANGLE, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = {"at", "", "", WHIRL_KEY_STATION, true, "", WHIRL_ANY, NULL, "station that carries it", ""},
    [MOMENT] = {"moment", "U", "kg m", WHIRL_KEY_NUMBER, true, "", WHIRL_NOT_NEGATIVE, NULL,
                "unbalance: mass times distance from the shaft's centre", "ISO 21940-1"},
    [ANGLE] = {"angle", "beta", "rad", WHIRL_KEY_NUMBER, false, "0", WHIRL_ANY, NULL,
               "where it lies at t = 0, from the x axis towards y", ""},
};

enum { UNBALANCE_COS, UNBALANCE_SIN };

static whirl_status build(const key_value *values, const scales *scale, element *out) {
    double numbers[STATION_NUMBERS] = {0};
    out->station[0] = values[AT].station[0];
    add_unbalance(scale, out->station[0], values[MOMENT].number, values[ANGLE].number, numbers);
    out->number[UNBALANCE_COS] = numbers[STATION_UNBALANCE_COS];
    out->number[UNBALANCE_SIN] = numbers[STATION_UNBALANCE_SIN];
    return whirl_ok();
}

static void lump(const element *own, size_t station_count, double (*stations)[STATION_NUMBERS]) {
    (void)station_count;
    stations[own->station[0]][STATION_UNBALANCE_COS] += own->number[UNBALANCE_COS];
    stations[own->station[0]][STATION_UNBALANCE_SIN] += own->number[UNBALANCE_SIN];
}

const element_type unbalance_element = {
    .group = {"unbalance", "an unbalance beyond a station's own eccentricity", "", keys, KEY_COUNT, NULL},
    .kernel = KERNEL_NONE,
    .build = build,
    .lump = lump,
};
