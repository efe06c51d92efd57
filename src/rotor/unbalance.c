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

typedef struct unbalance {
    size_t station;
    station_terms terms;
} unbalance;

static whirl_status build(const key_value *values, const scales *scale, void *coefficients) {
    unbalance *u = coefficients;
    *u = (unbalance){.station = values[AT].station[0]};
    add_unbalance(scale, u->station, values[MOMENT].number, values[ANGLE].number, &u->terms);
    return whirl_ok();
}

static void lump(const void *coefficients, size_t station_count, station_terms *terms) {
    const unbalance *u = coefficients;
    (void)station_count;
    terms[u->station].unbalance_cos += u->terms.unbalance_cos;
    terms[u->station].unbalance_sin += u->terms.unbalance_sin;
}

const element_type unbalance_element = {
    .group = {"unbalance", "an unbalance beyond a station's own eccentricity", "", keys, KEY_COUNT, NULL},
    .size = sizeof(unbalance),
    .build = build,
    .lump = lump,
};
