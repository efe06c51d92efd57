// An unbalance mass that turns with the shaft on which the station is, or with another shaft.
#include "harmonic.h"
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { AT, MOMENT, ANGLE, RATIO, SPEED, KEYPHASOR, KEY_COUNT };

/// Laws of an unbalance with a phase of its own. UNBALANCE_ALONE: its speed does not depend on the rotor's;
/// UNBALANCE_GEARED: its speed is a fixed ratio of the rotor's.
enum { UNBALANCE_ALONE, UNBALANCE_GEARED };

static const whirl_key keys[KEY_COUNT] = {
    UNBALANCE_KEYS,
    [RATIO] = NUMBER_KEY("ratio", "rho", "1", OPTIONAL, WHIRL_FROM_TO(-HARMONIC_FASTEST, HARMONIC_FASTEST),
                         "speed of the unbalance's shaft over the speed of the rotor; below 0 against the rotation; "
                         "absent: that of its station's shaft"),
    [SPEED] = NUMBER_KEY("speed", "", "rad/s", OPTIONAL, WHIRL_ANY,
                         "speed of the unbalance's shaft if it does not depend on the rotor's, in place of ratio; "
                         "below 0 against the rotation"),
    [KEYPHASOR] = HARMONIC_KEYPHASOR,
};

static whirl_status unbalance_build(const key_value *values, assembly *to, element *out) {
    const double moment = values[MOMENT].number, angle = values[ANGLE].number;
    // Without a ratio or a speed it turns with the shaft of its station.
    const size_t station = values[AT].station[0];
    const bool follows = !values[RATIO].given && !values[SPEED].given;
    const double ratio = values[SPEED].given ? values[SPEED].number / to->pace
                         : follows           ? to->stations[station].ratio
                                             : values[RATIO].number;
    const double speed = ratio * to->pace;
    out->lumped = follows && !assembly_is_aside(to, station);
    if (out->lumped) {
        assembly_unbalance(to, station, moment, angle);
        return whirl_ok();
    }
    if (values[RATIO].given && values[SPEED].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has both ratio and speed, expected one of them");
    const whirl_status status = harmonic_check_rate(to, ratio);
    if (status.code != WHIRL_OK) return status;
    if (values[KEYPHASOR].choice && ratio == 0.0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "does not turn, expected a speed above 0 of the phase that defines sections");
    out->law = values[SPEED].given ? UNBALANCE_ALONE : UNBALANCE_GEARED;
    out->spool = follows ? to->stations[station].spool : 0;
    element_on(&values[AT], to, AXIS_X, out);
    harmonic_force(out, to, moment * speed * speed, 1.0, angle, 0.0, ratio * to->turn);
    return whirl_ok();
}

whirl_status unbalance_follow(const aside_unbalance *own, assembly *to, element *out) {
    const key_value values[KEY_COUNT] = {[AT] = {.given = true, .station = {own->station}},
                                         [MOMENT] = {.given = true, .number = own->moment},
                                         [ANGLE] = {.given = true, .number = own->angle}};
    return unbalance_build(values, to, out);
}

/// Computes the lever as element_type.lever: the force is U phi'^2 n(phi) - U phi'' dn/dphi, with the phase phi whose
/// rate is a constant ratio of the shaft's speed.
static double unbalance_lever(const element *own, double speed, const double *states, double lever[2]) {
    const double *n = own->number, rate = n[HARMONIC_RATE], c = cos(states[0]), s = sin(states[0]);
    if (own->law != UNBALANCE_GEARED || rate == 0.0) return 0.0;
    const double by = rate / (rate * rate * speed * speed);
    lever[0] = by * (n[HARMONIC_XC] * s - n[HARMONIC_XS] * c);
    lever[1] = by * (n[HARMONIC_YC] * s - n[HARMONIC_YS] * c);
    return by * hypot(n[HARMONIC_XC], n[HARMONIC_XS]);
}

static bool unbalance_named_order(const element *own, size_t index, double *order, const char **name) {
    *name = "unbal.";
    return harmonic_order(own, index, order);
}

static double unbalance_keyphasor(const key_value *values, double speed) {
    if (!values[KEYPHASOR].choice) return 0.0;
    const double ratio = values[RATIO].given ? values[RATIO].number : 1.0;
    return fabs(values[SPEED].given ? values[SPEED].number : ratio * speed);
}

const element_type unbalance_element = {
    .group = {"unbalance", "an unbalance in addition to a station's eccentricity, of this shaft or another one", "",
              keys, KEY_COUNT, NULL, NULL},
    .number_count = HARMONIC_NUMBERS,
    .state_count = 1,
    .turning = 1,
    .rounds = harmonic_rounds,
    .lever = unbalance_lever,
    .named_order = unbalance_named_order,
    .kernels = harmonic_kernels,
    .build = unbalance_build,
    .keyphasor = unbalance_keyphasor,
};
#endif
