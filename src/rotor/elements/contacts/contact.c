// A stator that a station touches, by laws of impact and friction: its keys, and the numbers of its kernel.
#define KERNEL_FILE "elements/contacts/contact_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 1
#define KERNEL_FEWER_STATES
#define KERNEL_NUMBERS CONTACT_NUMBERS
#define KERNEL_SWITCHES 4
#define KERNEL_CURVED

enum { CONTACT_DEPTH, CONTACT_PUSH, CONTACT_SLIP, CONTACT_ARC };

/// Bits of the law: a normal force with loss; friction, with a jump where the slip reverses, or with bristles; a part
/// of a circle; a power other than 3/2; a coefficient that falls with the slip.
enum {
    CONTACT_LOSSY = 1,
    CONTACT_SLIPS = 2,
    CONTACT_SHARP = 4,
    CONTACT_BRISTLES = 8,
    CONTACT_PARTIAL = 16,
    CONTACT_POWERED = 32,
    CONTACT_FALLS = 64
};

/// Numbers, in the notation of contact_kernel.h: gap; K in newtons by length scales to the power n; n - 1; chi; R (the
/// surface's speed by tau); f_k; f_s - f_k; 1/v_s; v_0; s_2; s_0; s_1; s_0/s_1; all in length scales by tau. Then
/// direction of the arc's middle, and cosine of half of the arc; R with the sign of the rotation; a length scale in
/// metres; the power in W of 1 N that slides at one length scale by tau.
enum {
    CONTACT_GAP,
    CONTACT_STIFFNESS,
    CONTACT_POWER,
    CONTACT_LOSS,
    CONTACT_SURFACE,
    CONTACT_KINETIC,
    CONTACT_EXCESS,
    CONTACT_STRIBECK,
    CONTACT_SLIP_SPEED,
    CONTACT_VISCOUS,
    CONTACT_BRISTLE,
    CONTACT_BRISTLE_DAMPING,
    CONTACT_BACK,
    CONTACT_ARC_X,
    CONTACT_ARC_Y,
    CONTACT_ARC_HALF,
    CONTACT_LEVER,
    CONTACT_METRES,
    CONTACT_WATTS,
    CONTACT_NUMBERS
};

#include "contact_range.h"
#include "generic.h"
#include "registry.h"
#include "rub_switch.h"

static void contact_normal_force(const element *own, const block *b, void *force, void *friction) {
    vec *out = force, *rubbing = friction;
    for (size_t k = 0; k < b->vectors; k++) {
        const kernel_view view = view_of(own, b, k);
        kernel_inputs in;
        inputs_of(own, b, 0, k, false, &in);
        vec over;
        vec_mask touching;
        const vec r = distance_plain(in.d, &over);
        out[k] = normal_plain(own, &view, in.d, in.w, r, over, &touching);
        if (rubbing) rubbing_plain(own, &view, out[k], in.d, in.w, in.s, rubbing + k);
    }
}

const element_kernels ISA(contact_kernels) = {
    .flow = generic_flow, .switches = generic_switches, .contact = contact_normal_force};

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum {
    AT,
    FROM,
    GAP,
    STIFFNESS,
    POWER,
    LAW,
    LOSS,
    RESTITUTION,
    IMPACT_SPEED,
    FRICTION_LAW,
    FRICTION,
    STATIC_FRICTION,
    STRIBECK_SPEED,
    VISCOUS,
    SLIP_SPEED,
    BRISTLE,
    BRISTLE_DAMPING,
    RADIUS,
    ARC_WIDTH,
    ARC_MIDDLE,
    KEY_COUNT
};
enum { HERTZ, HUNT_CROSSLEY, LANKARANI };
enum { COULOMB, STRIBECK, LUGRE };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station that may touch the stator"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of a stator that moves; absent: the ground"),
    [GAP] = NUMBER_KEY("gap", "delta_1", "m", REQUIRED, WHIRL_POSITIVE, "radial gap between rotor and stator"),
    [STIFFNESS] = NUMBER_KEY("stiffness", "K", "1", REQUIRED, WHIRL_POSITIVE,
                             "stiffness of the contact in N/m^n: force over depth to the power n"),
    [POWER] = CITED_NUMBER_KEY("power", "n", "1", DEFAULT("1.5"), WHIRL_FROM_TO(1, 4),
                               "power n of the depth: 3/2 for a point, 10/9 for rollers, 1 for a spring", "Hertz 1882"),
    [LAW] = CITED_CHOICE_KEY("law", DEFAULT("hertz"), "hertz|hunt_crossley|lankarani_nikravesh",
                             "hertz: without loss; hunt_crossley: with loss; lankarani_nikravesh: with restitution",
                             "Hunt, Crossley 1975; Lankarani, Nikravesh 1990"),
    [LOSS] = CITED_NUMBER_KEY("loss", "chi", "s/m", OPTIONAL, WHIRL_POSITIVE,
                              "law hunt_crossley: damping over stiffness, the force is K d^n (1 + chi d')",
                              "Hunt, Crossley 1975"),
    [RESTITUTION] = CITED_NUMBER_KEY("restitution", "e", "1", OPTIONAL, WHIRL_FROM_TO(0, 1),
                                     "law lankarani_nikravesh: chi is 3 (1 - e^2)/(4 v); the actual e is near this one "
                                     "for little loss, and larger for much",
                                     "Lankarani, Nikravesh 1990"),
    [IMPACT_SPEED] = NUMBER_KEY("impact_speed", "v", "m/s", OPTIONAL, WHIRL_POSITIVE,
                                "law lankarani_nikravesh: speed of the impact at which restitution holds"),
    [FRICTION_LAW] = CITED_CHOICE_KEY("friction_law", DEFAULT("coulomb"), "coulomb|stribeck|lugre",
                                      "coulomb: one coefficient; stribeck: a larger one near rest; lugre: bristles "
                                      "that bend before they slide",
                                      "Canudas de Wit et al. 1995"),
    [FRICTION] =
        NUMBER_KEY("friction", "f_k", "1", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "coefficient while the surfaces slide"),
    [STATIC_FRICTION] = NUMBER_KEY("static_friction", "f_s", "1", OPTIONAL, WHIRL_POSITIVE,
                                   "coefficient near rest, at least friction; with stribeck and lugre"),
    [STRIBECK_SPEED] = NUMBER_KEY("stribeck_speed", "v_s", "m/s", OPTIONAL, WHIRL_POSITIVE,
                                  "speed of sliding at which the excess of the coefficient over `friction` has fallen "
                                  "by 1 - 1/e; with stribeck and lugre"),
    [VISCOUS] = NUMBER_KEY("viscous", "sigma_2", "s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                           "growth of the coefficient with the speed of sliding"),
    [SLIP_SPEED] = NUMBER_KEY("slip_speed", "v_0", "m/s", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                              "friction grows as v_t/sqrt(v_t^2 + v_0^2); 0 for a sharp reversal; not with lugre"),
    [BRISTLE] = CITED_NUMBER_KEY("bristle_stiffness", "sigma_0", "1/m", OPTIONAL, WHIRL_POSITIVE,
                                 "with lugre: tangential over normal force, divided by the bristles' deflection",
                                 "Canudas de Wit et al. 1995"),
    [BRISTLE_DAMPING] =
        CITED_NUMBER_KEY("bristle_damping", "sigma_1", "s/m", OPTIONAL, WHIRL_POSITIVE,
                         "with lugre: tangential over normal force, divided by the rate of the bristles' deflection",
                         "Canudas de Wit et al. 1995"),
    [RADIUS] = NUMBER_KEY("radius", "R_d", "m", OPTIONAL, WHIRL_POSITIVE,
                          "radius of the rotor's surface that rubs; required with friction"),
    [ARC_WIDTH] =
        NUMBER_KEY("arc", "", "rad", OPTIONAL, WHIRL_POSITIVE, "angle that the stator covers; absent: all around"),
    [ARC_MIDDLE] = ANGLE_KEY("arc_middle", "", "arc", "position of the middle of the arc, from the x axis towards y"),
};

/// Checks that a choice has the key that it needs, and that other choices do not have it.
static whirl_status check_pair(const key_value *values, int key, bool needed, const char *choice) {
    if (needed && !values[key].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has no %s, expected one: %s needs it", keys[key].name, choice);
    if (!needed && values[key].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has a %s, which only %s uses, expected that, or no %s", keys[key].name,
                          choice, keys[key].name);
    return whirl_ok();
}

/// Returns true if the keys describe friction, which needs a radius. A radius implies friction, even of 0, so that a
/// sweep may begin there.
static bool contact_has_friction(const key_value *values) {
    return values[FRICTION].number > 0.0 || values[STATIC_FRICTION].given || values[VISCOUS].number > 0.0 ||
           values[FRICTION_LAW].choice != COULOMB;
}

static whirl_status contact_check_keys(const key_value *values) {
    const int law = values[LAW].choice, rubbing = values[FRICTION_LAW].choice;
    const bool falls = rubbing != COULOMB, bristles = rubbing == LUGRE;
    // Each law needs some keys, and does not use others.
    const double turn = 6.283185307179586476925;
    const struct {
        int key;
        bool needed;
        const char *choice;
    } rules[] = {{LOSS, law == HUNT_CROSSLEY, "law: hunt_crossley"},
                 {RESTITUTION, law == LANKARANI, "law: lankarani_nikravesh"},
                 {IMPACT_SPEED, law == LANKARANI, "law: lankarani_nikravesh"},
                 {STATIC_FRICTION, falls, "friction_law: stribeck or lugre"},
                 {STRIBECK_SPEED, falls, "friction_law: stribeck or lugre"},
                 {BRISTLE, bristles, "friction_law: lugre"},
                 {BRISTLE_DAMPING, bristles, "friction_law: lugre"},
                 {RADIUS, contact_has_friction(values) || values[RADIUS].given, "friction"}};
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        const whirl_status status = check_pair(values, rules[i].key, rules[i].needed, rules[i].choice);
        if (status.code != WHIRL_OK) return status;
    }
    // Check for contradictions between given keys.
    if (falls && values[STATIC_FRICTION].number < values[FRICTION].number)
        return whirl_fail(WHIRL_BAD_INPUT, "has a static_friction of %g below a friction of %g, expected one above it",
                          values[STATIC_FRICTION].number, values[FRICTION].number);
    if (bristles && !(values[FRICTION].number > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "has no friction, expected one above 0: friction_law: lugre needs it");
    if (bristles && values[SLIP_SPEED].number > 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "has a slip_speed, which friction_law: lugre has no use for, expected none");
    if (values[ARC_WIDTH].given && !(values[ARC_WIDTH].number < turn))
        return whirl_fail(WHIRL_BAD_INPUT, "has an arc of %g rad, expected less than a turn, or no arc",
                          values[ARC_WIDTH].number);
    return whirl_ok();
}

/// Returns the factor chi of the loss, s/m.
static double loss_of(const key_value *values) {
    const double e = values[RESTITUTION].number;
    if (values[LAW].choice == HUNT_CROSSLEY) return values[LOSS].number;
    return values[LAW].choice == LANKARANI ? 0.75 * (1.0 - e * e) / values[IMPACT_SPEED].number : 0.0;
}

static int law_of(const key_value *values) {
    const bool bristles = values[FRICTION_LAW].choice == LUGRE;
    const bool sharp = !bristles && !(values[SLIP_SPEED].number > 0.0);
    return (loss_of(values) > 0.0 ? CONTACT_LOSSY : 0) | (values[ARC_WIDTH].given ? CONTACT_PARTIAL : 0) |
           (values[POWER].given ? CONTACT_POWERED : 0) | (values[STATIC_FRICTION].given ? CONTACT_FALLS : 0) |
           (values[RADIUS].given ? CONTACT_SLIPS | (bristles ? CONTACT_BRISTLES : 0) | (sharp ? CONTACT_SHARP : 0) : 0);
}

/// Returns how fast the surface at the station turns relative to the stator, by tau. A stator on a shaft with a speed
/// of its own turns, and so does one that such a shaft touches.
static double contact_turn(const key_value *values, const assembly *to) {
    const size_t at = values[AT].station[0];
    if (!values[FROM].given) return to->turn * to->stations[at].ratio;
    const size_t from = values[FROM].station[0];
    if (to->stations[at].spool + to->stations[from].spool == 0) return to->turn;
    return to->turn * (to->stations[at].ratio - assembly_housing_ratio(to, from));
}

static whirl_status contact_build(const key_value *values, assembly *to, element *out) {
    const double length = to->length, fast = to->clock * length, n = values[POWER].number;
    const double kinetic = values[FRICTION].number, half = 0.5 * values[ARC_WIDTH].number;
    whirl_status status = contact_check_keys(values);
    if (status.code == WHIRL_OK) status = element_in_housing(&values[AT], &values[FROM], to, out);
    if (status.code != WHIRL_OK) return status;
    out->fluid.housing = values[FROM].given ? values[FROM].station[0] : GROUND;
    // Choose the law and its state, and convert the numbers to the rotor's units.
    double *number = out->number;
    out->law = law_of(values);
    out->states = out->law & CONTACT_BRISTLES ? 1 : 0;
    number[CONTACT_GAP] = values[GAP].number / length;
    number[CONTACT_STIFFNESS] = values[STIFFNESS].number * pow(length, n);
    number[CONTACT_POWER] = n - 1.0;
    number[CONTACT_LOSS] = loss_of(values) * fast;
    number[CONTACT_SURFACE] = values[RADIUS].given ? values[RADIUS].number / length * contact_turn(values, to) : 0.0;
    number[CONTACT_KINETIC] = kinetic;
    number[CONTACT_EXCESS] = values[STATIC_FRICTION].given ? values[STATIC_FRICTION].number - kinetic : 0.0;
    number[CONTACT_STRIBECK] = values[STRIBECK_SPEED].given ? fast / values[STRIBECK_SPEED].number : 0.0;
    number[CONTACT_SLIP_SPEED] = values[SLIP_SPEED].number / fast;
    number[CONTACT_VISCOUS] = values[VISCOUS].number * fast;
    number[CONTACT_BRISTLE] = values[BRISTLE].number * length;
    number[CONTACT_BRISTLE_DAMPING] = values[BRISTLE_DAMPING].number * fast;
    if (out->states) number[CONTACT_BACK] = values[BRISTLE].number / (values[BRISTLE_DAMPING].number * to->clock);
    number[CONTACT_ARC_X] = cos(values[ARC_MIDDLE].number);
    number[CONTACT_ARC_Y] = sin(values[ARC_MIDDLE].number);
    number[CONTACT_ARC_HALF] = cos(half);
    number[CONTACT_LEVER] = copysign(values[RADIUS].number / length, to->turn);
    number[CONTACT_METRES] = length;
    number[CONTACT_WATTS] = fast;
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

/// Returns the radial part of a switch; the rest of the switch is linear.
static radial_form form_of(const element *own, size_t index) {
    const double *number = own->number;
    if (index == CONTACT_DEPTH) return (radial_form){.by_r = 1.0};
    if (index == CONTACT_PUSH) return (radial_form){.by_growth = own->law & CONTACT_LOSSY ? number[CONTACT_LOSS] : 0.0};
    if (index == CONTACT_ARC)
        return (radial_form){.by_r = own->law & CONTACT_PARTIAL ? -number[CONTACT_ARC_HALF] : 0.0};
    return (radial_form){own->law & (CONTACT_SHARP | CONTACT_BRISTLES), number[CONTACT_SURFACE], 0.0};
}

static void contact_curvature(const element *own, const element_place *from, size_t index, const element_place *along,
                              element_place *by) {
    double at[4][2], *by_q = by->q, *by_v = by->v;
    for (int a = 0; a < 2; a++) {
        at[0][a] = from->q[a] - from->q[2 + a];
        at[1][a] = from->v[a] - from->v[2 + a];
        at[2][a] = along->q[a] - along->q[2 + a];
        at[3][a] = along->v[a] - along->v[2 + a];
    }
    const radial_form form = form_of(own, index);
    by_q[0] = by_q[1] = by_v[0] = by_v[1] = 0.0;
    if (form.slip || index != CONTACT_SLIP) radial_curvature(form, at[0], at[1], at[2], at[3], by_q, by_v);
    for (int a = 0; a < 2; a++) {
        by_q[2 + a] = 0.0 - by_q[a];
        by_v[2 + a] = 0.0 - by_v[a];
    }
}

static bool contact_slides(const element *own) {
    return (own->law & CONTACT_SHARP) != 0;
}

static bool contact_jumps(const element *own) {
    return (own->law & CONTACT_PARTIAL) != 0;
}

static double contact_radial_gap(const element *own) {
    return element_housing_stands(own) && !(own->law & CONTACT_PARTIAL) ? own->number[CONTACT_GAP] : 0.0;
}

/// Returns 1 if the law has friction, otherwise 0.
static int contact_takes_power(const element *own) {
    return own->law & CONTACT_SLIPS ? 1 : 0;
}

/// Returns true: the gap alone does not determine contact.
static bool contact_is_damped(const element *own) {
    (void)own;
    return true;
}

/// Returns the rebound speed of an impact at v, divided by v, from chi v (1 + e) = ln((1 + chi v)/(1 - chi v e)).
static double contact_comes_back(double share) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; i++) {
        const double e = 0.5 * (low + high);
        const bool below = share * (1.0 + e) > log((1.0 + share) / (1.0 - fmin(share * e, 1.0 - 1e-12)));
        low = below ? e : low;
        high = below ? high : e;
    }
    return low;
}

static void contact_doubt(const key_value *values, double speed, const doubt_teller *to) {
    const double share = values[GAP].number / values[RADIUS].number, most = 0.1;
    if (values[RADIUS].given && share > most)
        doubt_value(to, keys[GAP].name, "is %.3g times the radius, and stators are up to %g times away", share, most);
    const double e = values[RESTITUTION].number, back = contact_comes_back(0.75 * (1.0 - e * e));
    if (values[LAW].choice == LANKARANI && fabs(back - e) > 0.05)
        doubt_value(to, keys[RESTITUTION].name,
                    "is used in a law for small losses: impacts rebound with %.3g of their speed", back);
    const double damping = values[BRISTLE_DAMPING].number, surface = values[RADIUS].number * fabs(speed);
    const double passive = 4.0 * values[FRICTION].number * (damping + values[VISCOUS].number) / (damping * damping);
    if (values[FRICTION_LAW].choice == LUGRE && surface > passive)
        doubt_value(to, keys[BRISTLE_DAMPING].name,
                    "is so large that friction may give power where the sliding changes above %.3g m/s, and the "
                    "surface runs at %.3g m/s",
                    passive, surface);
}

static bool contact_force_range(const element *own, size_t index, const element_seen *seen, element_range *out) {
    return contact_range(own->number[CONTACT_GAP], fabs(own->number[CONTACT_LEVER]), index, seen, out);
}

KERNELS_OF_EVERY_ISA(contact_kernels);

const element_type contact_element = {
    .group = {"contact", "a stator that a station touches, by laws of impact and friction, all around or over an arc",
              "Hunt, Crossley 1975; Canudas de Wit et al. 1995", keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .slides_by_shaft = true,
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .kernels = kernels,
    .build = contact_build,
    GENERIC_SWITCHES,
    .switch_curvature = contact_curvature,
    .slides = contact_slides,
    .jumps = contact_jumps,
    .contact_gap = contact_radial_gap,
    .rubs = contact_takes_power,
    .contact_damped = contact_is_damped,
    .range = contact_force_range,
    .doubt = contact_doubt,
};
#endif
