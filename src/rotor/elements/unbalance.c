// An unbalance mass fixed to a station, turning with the shaft.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR

enum { AT, MOMENT, ANGLE, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = {"at", "", "", WHIRL_KEY_STATION, true, "", WHIRL_ANY, NULL, "station that carries it", ""},
    [MOMENT] = {"moment", "U", "kg m", WHIRL_KEY_NUMBER, true, "", WHIRL_NOT_NEGATIVE, NULL,
                "unbalance: mass times distance from the shaft's centre", "ISO 21940-1"},
    [ANGLE] = {"angle", "beta", "rad", WHIRL_KEY_NUMBER, false, "0", WHIRL_ANY, NULL,
               "where it lies at t = 0, from the x axis towards y", ""},
};

static whirl_status build(const key_value *values, assembly *to, element *out) {
    (void)out;
    assembly_unbalance(to, values[AT].station[0], values[MOMENT].number, values[ANGLE].number);
    return whirl_ok();
}

const element_type unbalance_element = {
    .group = {"unbalance", "an unbalance beyond a station's own eccentricity", "", keys, KEY_COUNT, NULL, NULL},
    .build = build,
};
#endif
