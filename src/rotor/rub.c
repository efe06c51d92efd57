// A stator ring that a station touches when its displacement r exceeds the gap: elastic, with Coulomb friction.
//
// Normal force N = k (r - gap), friction f N against the sliding of the rotor's surface. For a surface that moves
// counter-clockwise past the stator (v_t > 0)
//
//     (Fx, Fy) = -k (1 - gap/r) [1 -f; f 1] (x, y),      v_t = R omega + (x y' - y x')/r.
//
// `law: paper` keeps this for every motion, as the paper of 2015 (eq. 3) does; `law: slip` gives the friction the sign
// of v_t, so that backward whirl settles to rolling where v_t = 0 (Black 1968; Bartha 2000).
#include <math.h>

#include "element.h"

enum { AT, GAP, STIFFNESS, FRICTION, LAW, RADIUS, SLIP_SPEED, KEY_COUNT };
enum { LAW_PAPER, LAW_SLIP };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = {"at", "", "", WHIRL_KEY_STATION, true, "", WHIRL_ANY, NULL, "station that may touch the stator", ""},
    [GAP] = {"gap", "delta_1", "m", WHIRL_KEY_NUMBER, true, "", WHIRL_POSITIVE, NULL,
             "radial gap between rotor and stator", ""},
    [STIFFNESS] = {"stiffness", "k_c", "N/m", WHIRL_KEY_NUMBER, true, "", WHIRL_NOT_NEGATIVE, NULL,
                   "radial stiffness of the stator", ""},
    [FRICTION] = {"friction", "f", "1", WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
                  "coefficient of Coulomb friction", ""},
    [LAW] = {"law", "", "", WHIRL_KEY_CHOICE, false, "paper", WHIRL_ANY, "paper|slip",
             "paper: friction always against the rotation; slip: against the sliding, which backward whirl can reverse",
             "rub-impact paper 2015, eq. (3); Black 1968"},
    [RADIUS] = {"radius", "R_d", "m", WHIRL_KEY_NUMBER, false, "", WHIRL_POSITIVE, NULL,
                "radius of the rotor's surface that rubs; law slip needs it", ""},
    [SLIP_SPEED] = {"slip_speed", "v_0", "m/s", WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
                    "law slip: friction grows as tanh(v_t/v_0); 0 for a sharp reversal", ""},
};

typedef struct rub {
    size_t station;
    double gap;       ///< in length scales
    double stiffness; ///< k/(m omega^2)
    double friction;
    double newtons; ///< k times the length scale: N per length scale of indentation
    bool follows_slip;
    double surface;    ///< R_d in length scales, which is the surface's speed by tau
    double slip_speed; ///< v_0/(omega length scale)
} rub;

static whirl_status build(const key_value *values, const scales *scale, void *coefficients) {
    const bool slip = values[LAW].choice == LAW_SLIP;
    if (slip && !values[RADIUS].given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has no radius, expected one: law slip needs the radius of the surface that rubs");
    const size_t station = values[AT].station[0];
    rub *r = coefficients;
    *r = (rub){.station = station,
               .gap = values[GAP].number / scale->length,
               .stiffness = values[STIFFNESS].number / stiffness_scale(scale, station),
               .friction = values[FRICTION].number,
               .newtons = values[STIFFNESS].number * scale->length,
               .follows_slip = slip,
               .surface = slip ? values[RADIUS].number / scale->length : 0.0,
               .slip_speed = values[SLIP_SPEED].number / (scale->speed * scale->length)};
    return whirl_ok();
}

/// Friction coefficient with the sign of the sliding, at radius `radius`.
static double signed_friction(const rub *r, const double *q, const double *v, double radius) {
    if (!r->follows_slip) return r->friction;
    const double slip = r->surface + (q[0] * v[1] - q[1] * v[0]) / radius;
    if (r->slip_speed > 0.0) return r->friction * tanh(slip / r->slip_speed);
    return slip > 0.0 ? r->friction : slip < 0.0 ? -r->friction : 0.0;
}

static void force(const void *coefficients, const double *forcing, const double *q, const double *v, double *a) {
    const rub *r = coefficients;
    const size_t i = 2 * r->station;
    const double x = q[i], y = q[i + 1];
    const double radius_squared = x * x + y * y;
    (void)forcing;
    if (radius_squared <= r->gap * r->gap) return;
    const double radius = sqrt(radius_squared);
    const double push = (1.0 - r->gap / radius) * r->stiffness;
    const double f = signed_friction(r, q + i, v + i, radius);
    a[i] -= push * (x - f * y);
    a[i + 1] -= push * (f * x + y);
}

static size_t switch_count(const void *coefficients) {
    const rub *r = coefficients;
    return r->follows_slip && r->slip_speed <= 0.0 ? 2 : 1;
}

static void switches(const void *coefficients, const double *q, const double *v, double *values) {
    const rub *r = coefficients;
    const size_t i = 2 * r->station;
    const double radius = sqrt(q[i] * q[i] + q[i + 1] * q[i + 1]);
    values[0] = radius - r->gap;
    if (switch_count(r) == 2) values[1] = r->surface * radius + q[i] * v[i + 1] - q[i + 1] * v[i];
}

static size_t contact_station(const void *coefficients) {
    return ((const rub *)coefficients)->station;
}

static double contact_force(const void *coefficients, const double *q) {
    const rub *r = coefficients;
    const size_t i = 2 * r->station;
    const double depth = sqrt(q[i] * q[i] + q[i + 1] * q[i + 1]) - r->gap;
    return depth > 0.0 ? depth * r->newtons : 0.0;
}

const element_type rub_element = {
    .group = {"rub", "an elastic stator ring with Coulomb friction around a station",
              "rub-impact paper 2015, eq. (3); Black 1968", keys, KEY_COUNT, NULL},
    .size = sizeof(rub),
    .build = build,
    .force = force,
    .switch_count = switch_count,
    .switches = switches,
    .contact_station = contact_station,
    .contact_force = contact_force,
};
