// The keys of a rub, the numbers of its kernel, and where it switches.
#define VECTOR_ISA 0
#include "rub_kernel.h"
#include "rub_switch.h"

enum { AT, GAP, STIFFNESS, DAMPING, FRICTION, LAW, RADIUS, SLIP_SPEED, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = {"at", "", "", WHIRL_KEY_STATION, true, "", WHIRL_ANY, NULL, "station that may touch the stator", ""},
    [GAP] = {"gap", "delta_1", "m", WHIRL_KEY_NUMBER, true, "", WHIRL_POSITIVE, NULL,
             "radial gap between rotor and stator", ""},
    [STIFFNESS] = {"stiffness", "k_c", "N/m", WHIRL_KEY_NUMBER, true, "", WHIRL_NOT_NEGATIVE, NULL,
                   "radial stiffness of the stator", ""},
    [DAMPING] = {"damping", "c_c", "N s/m", WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
                 "viscous damping of the contact along its normal; the stator never pulls", ""},
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
    // A given damping of 0 counts, so that a sweep may begin there; but not with a stator that does nothing at all.
    const bool damped = values[DAMPING].given && (values[DAMPING].number > 0.0 || values[STIFFNESS].number > 0.0);
    out->law = values[LAW].choice | (damped ? RUB_DAMPED : 0);
    out->number[RUB_GAP] = values[GAP].number / scale->length;
    out->number[RUB_STIFFNESS] = values[STIFFNESS].number / stiffness_scale(scale, station);
    out->number[RUB_DAMPING] = values[DAMPING].number / (scale->mass[station] * scale->speed);
    out->number[RUB_FRICTION] = values[FRICTION].number;
    out->number[RUB_SURFACE] = slip ? values[RADIUS].number / scale->length : 0.0;
    out->number[RUB_SLIP_SPEED] = values[SLIP_SPEED].number / (scale->speed * scale->length);
    out->number[RUB_GAP_SQUARE] = out->number[RUB_GAP] * out->number[RUB_GAP];
    out->number[RUB_NEWTONS] = stiffness_scale(scale, station) * scale->length;
    return whirl_ok();
}

static size_t switch_count(const element *own) {
    return rub_switch_count(own);
}

static void switches(const element *own, const double *q, const double *v, double *values) {
    rub_switches(own, 1, own->number, q, v, NULL, values, NULL);
}

static bool slides(const element *own) {
    return rub_sharp(own);
}

static double contact_gap(const element *own) {
    return own->number[RUB_GAP];
}

static double contact_force(const element *own, const double *q, const double *v) {
    return rub_normal(own, 1, own->number, q, v);
}

static bool contact_damped(const element *own) {
    return rub_damped(own);
}

const element_type rub_element = {
    .group = {"rub", "an elastic stator ring with Coulomb friction around a station",
              "rub-impact paper 2015, eq. (3); Black 1968", keys, KEY_COUNT, NULL},
    .kernel = KERNEL_RUB,
    .number_count = RUB_NUMBERS,
    .build = build,
    .switch_count = switch_count,
    .switches = switches,
    .switch_gradient = rub_switch_gradient,
    .switch_curvature = rub_switch_curvature,
    .slides = slides,
    .contact_gap = contact_gap,
    .contact_force = contact_force,
    .contact_damped = contact_damped,
};
