// The keys of a rub, the numbers of its kernel, and where it switches.
#define VECTOR_ISA 0
#include "rub_kernel.h"

enum { AT, GAP, STIFFNESS, FRICTION, LAW, RADIUS, SLIP_SPEED, KEY_COUNT };

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
                    "law slip: friction grows as v_t/sqrt(v_t^2 + v_0^2); 0 for a sharp reversal", ""},
};

static whirl_status build(const key_value *values, const scales *scale, element *out) {
    const bool slip = values[LAW].choice == RUB_LAW_SLIP;
    if (slip && !values[RADIUS].given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has no radius, expected one: law slip needs the radius of the surface that rubs");
    if (!slip && (values[RADIUS].given || values[SLIP_SPEED].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has a %s, which only law slip uses, expected law: slip, or no %s",
                          values[RADIUS].given ? "radius" : "slip_speed",
                          values[RADIUS].given ? "radius" : "slip_speed");
    const size_t station = values[AT].station[0];
    out->station[0] = station;
    out->law = values[LAW].choice;
    out->number[RUB_GAP] = values[GAP].number / scale->length;
    out->number[RUB_STIFFNESS] = values[STIFFNESS].number / stiffness_scale(scale, station);
    out->number[RUB_FRICTION] = values[FRICTION].number;
    out->number[RUB_SURFACE] = slip ? values[RADIUS].number / scale->length : 0.0;
    out->number[RUB_SLIP_SPEED] = values[SLIP_SPEED].number / (scale->speed * scale->length);
    out->number[RUB_NEWTONS] = values[STIFFNESS].number * scale->length;
    return whirl_ok();
}

static double radius_at(const element *own, const double *q) {
    const size_t i = 2 * own->station[0];
    return sqrt(q[i] * q[i] + q[i + 1] * q[i + 1]);
}

static size_t switch_count(const element *own) {
    return own->law == RUB_LAW_SLIP && own->number[RUB_SLIP_SPEED] <= 0.0 ? 2 : 1;
}

static void switches(const element *own, const double *q, const double *v, double *values) {
    const size_t i = 2 * own->station[0];
    const double radius = radius_at(own, q);
    values[0] = radius - own->number[RUB_GAP];
    if (switch_count(own) == 2) values[1] = own->number[RUB_SURFACE] * radius + q[i] * v[i + 1] - q[i + 1] * v[i];
}

static double contact_gap(const element *own) {
    return own->number[RUB_GAP];
}

static double contact_force(const element *own, const double *q) {
    const double depth = radius_at(own, q) - own->number[RUB_GAP];
    return depth > 0.0 ? depth * own->number[RUB_NEWTONS] : 0.0;
}

const element_type rub_element = {
    .group = {"rub", "an elastic stator ring with Coulomb friction around a station",
              "rub-impact paper 2015, eq. (3); Black 1968", keys, KEY_COUNT, NULL},
    .kernel = KERNEL_RUB,
    .number_count = RUB_NUMBERS,
    .build = build,
    .switch_count = switch_count,
    .switches = switches,
    .contact_gap = contact_gap,
    .contact_force = contact_force,
};
