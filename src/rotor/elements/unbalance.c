// An unbalance mass, turning with the shaft that carries the station or with another one.
#include "harmonic.h"
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { AT, MOMENT, ANGLE, RATIO, SPEED, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = {"at", "", "", WHIRL_KEY_STATION, true, "", WHIRL_ANY, NULL, "station that carries it", ""},
    [MOMENT] = {"moment", "U", "kg m", WHIRL_KEY_NUMBER, true, "", WHIRL_NOT_NEGATIVE, NULL,
                "unbalance: mass times distance from the shaft's centre", "ISO 21940-1"},
    [ANGLE] = {"angle", "beta", "rad", WHIRL_KEY_NUMBER, false, "0", WHIRL_ANY, NULL,
               "where it lies at t = 0, from the x axis towards y", ""},
    [RATIO] = {"ratio",
               "rho",
               "1",
               WHIRL_KEY_NUMBER,
               false,
               "1",
               {-HARMONIC_FASTEST, HARMONIC_FASTEST, false, false},
               NULL,
               "speed of the shaft that it turns with over the speed of the rotor; below 0 against the rotation",
               ""},
    [SPEED] = {"speed", "", "rad/s", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL,
               "that speed where it does not depend on the rotor's, in place of ratio", ""},
};

static whirl_status build(const key_value *values, assembly *to, element *out) {
    const size_t station = values[AT].station[0];
    const double moment = values[MOMENT].number, angle = values[ANGLE].number;
    const double ratio = values[SPEED].given ? values[SPEED].number / to->speed : values[RATIO].number;
    const double speed = ratio * to->speed;
    out->lumped = !values[RATIO].given && !values[SPEED].given;
    if (out->lumped) {
        assembly_unbalance(to, station, moment, angle);
        return whirl_ok();
    }
    if (values[RATIO].given && values[SPEED].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has both ratio and speed, expected one of them");
    if (!(fabs(ratio) <= HARMONIC_FASTEST))
        return whirl_fail(WHIRL_BAD_INPUT, "is %g times as fast as the rotor, expected at most %g times", fabs(ratio),
                          HARMONIC_FASTEST);
    out->station = station;
    out->port[0] = to->stations[station].coordinate[AXIS_X];
    out->port[1] = to->stations[station].coordinate[AXIS_Y];
    harmonic_turning(out, to, moment * speed * speed, angle, ratio);
    return whirl_ok();
}

const element_type unbalance_element = {
    .group = {"unbalance", "an unbalance beyond a station's own eccentricity, of this shaft or another one", "", keys,
              KEY_COUNT, NULL, NULL},
    .number_count = HARMONIC_NUMBERS,
    .state_count = 1,
    .turning = 1,
    .rounds = harmonic_rounds,
    .kernels = harmonic_kernels,
    .build = build,
};
#endif
