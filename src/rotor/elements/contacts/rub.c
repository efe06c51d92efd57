// A rub: its pass over vectors, its keys, and the numbers of its kernel.
#include "block.h"
#include "contact_range.h"
#include "registry.h"
#include "rub_switch.h"
#include "rub_tangent.h"

/// Adds a rub's forces to vector k and its perturbations.
static void rub_add_vector(const element *own, const block *b, size_t k) {
    const vec *sides = sides_of(b, own), *number = numbers_of(b, own) + k, *q = b->q + k, *v = b->v + k;
    tangent_block tangent;
    if (sides) sides += k;
    rub_kernel(own, b->stride, number, sides, q, v, b->a + k);
    if (wants_tangent(b) && rub_tangent(own, b->stride, number, sides, q, v, &tangent))
        tangent_apply(&tangent, own, b, k);
}

static void rub_flow(const element *first, size_t count, const block *b) {
    for (const element *own = first; own < first + count; own++)
        for (size_t k = 0; k < b->vectors; k++) rub_add_vector(own, b, k);
}

static void rub_write_switches(const element *own, const block *b, void *values, void *rates) {
    vec *value = values, *rate = rates;
    for (size_t k = 0; k < b->vectors; k++)
        rub_switches(own, b->stride, numbers_of(b, own) + k, b->q + k, b->v + k, rate ? b->a + k : NULL, value + k,
                     rate ? rate + k : NULL);
}

static void rub_contact(const element *own, const block *b, void *force, void *friction) {
    vec *out = force, *rubbing = friction;
    for (size_t k = 0; k < b->vectors; k++) {
        const vec *number = numbers_of(b, own) + k;
        out[k] = rub_normal(own, b->stride, number, b->q + k, b->v + k);
        if (rubbing) rub_rubbing(own, b->stride, number, b->q + k, b->v + k, rubbing + k);
    }
}

const element_kernels ISA(rub_kernels) = {.flow = rub_flow, .switches = rub_write_switches, .contact = rub_contact};

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { AT, GAP, STIFFNESS, DAMPING, FRICTION, LAW, RADIUS, SLIP_SPEED, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station that may touch the stator"),
    [GAP] = NUMBER_KEY("gap", "delta_1", "m", REQUIRED, WHIRL_POSITIVE, "radial gap between rotor and stator"),
    [STIFFNESS] = NUMBER_KEY("stiffness", "k_c", "N/m", REQUIRED, WHIRL_NOT_NEGATIVE, "radial stiffness of the stator"),
    [DAMPING] = NUMBER_KEY("damping", "c_c", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                           "viscous damping of the contact along its normal; the stator never pulls"),
    [FRICTION] = NUMBER_KEY("friction", "f", "1", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "coefficient of Coulomb friction"),
    [LAW] = CITED_CHOICE_KEY(
        "law", DEFAULT("paper"), "paper|slip",
        "paper: friction always against the rotation; slip: against the sliding, which backward whirl can reverse",
        "rub-impact paper 2015, eq. (3); Black 1968"),
    [RADIUS] = NUMBER_KEY(
        "radius", "R_d", "m", OPTIONAL, WHIRL_POSITIVE,
        "radius of the rotor's surface that rubs, for torque and power of the friction; required with law slip"),
    [SLIP_SPEED] = NUMBER_KEY("slip_speed", "v_0", "m/s", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                              "law slip: friction grows as v_t/sqrt(v_t^2 + v_0^2); 0 for a sharp reversal"),
};

static whirl_status rub_build(const key_value *values, assembly *to, element *out) {
    const bool slip = values[LAW].choice == RUB_LAW_SLIP;
    if (slip && !values[RADIUS].given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has no radius, expected one: law slip needs the radius of the surface that rubs");
    if (!slip && values[SLIP_SPEED].given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has a slip_speed, which only law slip uses, expected law: slip, or no slip_speed");
    out->station = values[AT].station[0];
    out->fluid.housing = GROUND;
    const whirl_status status = assembly_find_plane(to, out->station, out->port);
    if (status.code != WHIRL_OK) return status;
    // A given damping of 0 counts as damping, so that a sweep may begin there; but not if the stator has no force at
    // all.
    const bool damped = values[DAMPING].given && (values[DAMPING].number > 0.0 || values[STIFFNESS].number > 0.0);
    const bool sharp = slip && !(values[SLIP_SPEED].number > 0.0);
    const double turn = to->turn * to->stations[out->station].ratio; // of the surface
    out->law = values[LAW].choice | (damped ? RUB_DAMPED : 0) | (sharp ? RUB_SHARP : 0);
    out->number[RUB_GAP] = values[GAP].number / to->length;
    out->number[RUB_STIFFNESS] = values[STIFFNESS].number / assembly_stiffness_scale(to, out->station);
    out->number[RUB_DAMPING] = values[DAMPING].number / (assembly_inertia(to, out->station) * to->clock);
    out->number[RUB_FRICTION] = slip ? values[FRICTION].number : copysign(values[FRICTION].number, turn);
    out->number[RUB_SURFACE] = values[RADIUS].number / to->length * turn;
    out->number[RUB_SLIP_SPEED] = values[SLIP_SPEED].number / (to->clock * to->length);
    out->number[RUB_GAP_SQUARE] = out->number[RUB_GAP] * out->number[RUB_GAP];
    out->number[RUB_LEVER] = copysign(values[RADIUS].number / to->length, to->turn);
    out->number[RUB_METRES] = to->length;
    out->number[RUB_WATTS] = to->clock * to->length;
    out->number[RUB_NEWTONS] = assembly_stiffness_scale(to, out->station) * to->length;
    return whirl_ok();
}

static size_t rub_count_switches(const element *own) {
    return rub_switch_count(own);
}

static bool rub_slides(const element *own) {
    return rub_sharp(own);
}

static double rub_contact_gap(const element *own) {
    return own->number[RUB_GAP];
}

/// Returns 1 if the radius is given: then friction counts even if it is 0, since it may not be 0 in other machines of a
/// sweep.
static int rub_takes_power(const element *own) {
    if (own->number[RUB_LEVER] != 0.0) return 1;
    return own->number[RUB_FRICTION] == 0.0 ? 0 : -1;
}

static bool rub_contact_damped(const element *own) {
    return rub_damped(own);
}

static bool rub_range(const element *own, size_t index, const element_seen *seen, element_range *out) {
    return contact_range(own->number[RUB_GAP], fabs(own->number[RUB_LEVER]), index, seen, out);
}

static void rub_doubt(const key_value *values, double speed, const doubt_teller *to) {
    const double share = values[GAP].number / values[RADIUS].number, most = 0.1;
    (void)speed;
    if (values[RADIUS].given && share > most)
        doubt_value(to, keys[GAP].name, "is %.3g times the radius, and stators are up to %g times away", share, most);
}

KERNELS_OF_EVERY_ISA(rub_kernels);

const element_type rub_element = {
    .group = {"rub", "an elastic stator ring with Coulomb friction around a station",
              "rub-impact paper 2015, eq. (3); Black 1968", keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .slides_by_shaft = true,
    .number_count = RUB_NUMBERS,
    .kernels = kernels,
    .build = rub_build,
    .switch_count = rub_count_switches,
    .switch_gradient = rub_switch_gradient,
    .switch_curvature = rub_switch_curvature,
    .slides = rub_slides,
    .contact_gap = rub_contact_gap,
    .rubs = rub_takes_power,
    .contact_damped = rub_contact_damped,
    .range = rub_range,
    .doubt = rub_doubt,
};
#endif
