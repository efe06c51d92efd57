// Blades that rub on a casing: keys, and the numbers of the kernel.
#define KERNEL_FILE "elements/contacts/blade_rub_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 1
#define KERNEL_NUMBERS BLADE_NUMBERS
#define KERNEL_SWITCHES 128
#define KERNEL_SWITCHES_BY_STATES
#define KERNEL_SWITCHES_OF(own) blades_of(own)
#define KERNEL_CURVED

enum { MAX_BLADES = KERNEL_SWITCHES };

/// Numbers, in the notation of blade_rub_kernel.h: the casing's radius in length scales; p - 1; mu with the sign of
/// the rotation; theta' by tau; theta_0; cosine and sine of the angle between blades; a length scale in metres with the
/// sign of the rotation; the power in W of 1 N at a speed of one length scale by tau; of each blade k_j in newtons by
/// length scales to the power p, and l_j.
///
/// The law contains the number of blades, and whether keys give the power p (otherwise it is 1) and the friction
/// (otherwise it is 0).
enum {
    BLADE_CASING,
    BLADE_POWER,
    BLADE_FRICTION,
    BLADE_RATE,
    BLADE_START,
    BLADE_APART_COS,
    BLADE_APART_SIN,
    BLADE_METRES,
    BLADE_WATTS,
    BLADE_STIFFNESSES,
    BLADE_LENGTHS = BLADE_STIFFNESSES + MAX_BLADES,
    BLADE_NUMBERS = BLADE_LENGTHS + MAX_BLADES
};

enum { BLADE_POWERED = 0x100, BLADE_RUBS = 0x200 };

#include "element.h"

static inline int blades_of(const element *own) {
    return own->law & (BLADE_POWERED - 1);
}

#include "generic.h"
#include "registry.h"

static void blade_rub_contact(const element *own, const block *b, void *force, void *friction) {
    vec *out = force, *rubbing = friction;
    for (size_t k = 0; k < b->vectors; k++) {
        const kernel_view view = view_of(own, b, k);
        kernel_inputs in;
        inputs_of(own, b, 0, k, false, &in);
        vec sum[2];
        blades_plain(own, &view, in.d, in.s, sum, &out[k]);
        if (rubbing) rubbing_plain(own, &view, in.d, in.w, in.s, rubbing + k);
    }
}

const element_kernels ISA(blade_rub_kernels) = {
    .flow = generic_flow, .switches = generic_switches, .contact = blade_rub_contact};

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { AT, FROM, BLADES, RADIUS, GAP, STIFFNESS, POWER, EXTENSION, FRICTION, ANGLE, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station of the disc with the blades"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of a casing that moves; absent: the ground"),
    [BLADES] = WHOLE_KEY("blades", "n", REQUIRED, WHIRL_FROM_TO(1, 128),
                         "number of blades, at equal angles, counted along the rotation"),
    [RADIUS] = NUMBER_KEY("radius", "l", "m", REQUIRED, WHIRL_POSITIVE, "radius of the tips"),
    [GAP] = NUMBER_KEY("gap", "delta", "m", REQUIRED, WHIRL_POSITIVE,
                       "gap between the tips and the casing, with the rotor in the middle"),
    [STIFFNESS] = CITED_NUMBERS_KEY("stiffness", "k", "1", REQUIRED, WHIRL_POSITIVE,
                                    "stiffness of a blade and the casing along the blade in N/m^p: force over depth to "
                                    "the power p; one number, or one for each blade",
                                    "Ma et al. 2016"),
    [POWER] = NUMBER_KEY("power", "p", "1", DEFAULT("1"), WHIRL_FROM_TO(1, 4), "power p of the depth"),
    [EXTENSION] = CITED_NUMBERS_KEY("extension", "", "m", DEFAULT("0"), WHIRL_ANY,
                                    "length of a blade beyond the radius; one number, or one for each blade", ""),
    [FRICTION] = NUMBER_KEY("friction", "f", "1", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                            "coefficient of friction, against the rotation"),
    [ANGLE] = ANGLE_KEY("angle", "theta_0", NULL, "position of the first blade at t = 0, from the x axis towards y"),
};

/// Returns the number of a blade from a list with one number for all, or one for each blade.
static double of_blade(const key_value *list, int blade) {
    return list->count ? list->list[list->count == 1 ? 0 : blade] : list->number;
}

static whirl_status check_list(const key_value *values, int key) {
    const size_t count = values[key].count, blades = (size_t)values[BLADES].number;
    if (count <= 1 || count == blades) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "has %zu numbers of %s for %zu blades, expected one, or one for each", count,
                      keys[key].name, blades);
}

/// Returns the number of periods of the pattern of blades in a revolution; n equal blades have n periods a turn.
static double blade_rub_rounds(const element *own, size_t state) {
    (void)state;
    bool alike = true;
    for (int j = 1; j < blades_of(own); j++)
        alike = alike && own->number[BLADE_LENGTHS + j] == own->number[BLADE_LENGTHS] &&
                own->number[BLADE_STIFFNESSES + j] == own->number[BLADE_STIFFNESSES];
    return own->number[BLADE_RATE] * (alike ? blades_of(own) : 1);
}

/// Returns the blade passing order.
static bool blade_rub_named_order(const element *own, size_t index, double *order, const char **name) {
    if (index > 0 || blades_of(own) < 2) return false;
    *order = fabs(own->number[BLADE_RATE]) * blades_of(own);
    *name = "BPF";
    return true;
}

static whirl_status blade_rub_build(const key_value *values, assembly *to, element *out) {
    const double length = to->length, p = values[POWER].number, apart = 6.283185307179586476925 / values[BLADES].number;
    whirl_status status = element_in_housing(&values[AT], &values[FROM], to, out);
    if (status.code == WHIRL_OK) status = check_list(values, STIFFNESS);
    if (status.code == WHIRL_OK) status = check_list(values, EXTENSION);
    if (status.code != WHIRL_OK) return status;
    // Choose the law, and convert the numbers to the rotor's units.
    out->law = (int)values[BLADES].number | (values[POWER].given ? BLADE_POWERED : 0) |
               (values[FRICTION].given ? BLADE_RUBS : 0);
    out->number[BLADE_CASING] = (values[RADIUS].number + values[GAP].number) / length;
    out->number[BLADE_POWER] = p - 1.0;
    out->number[BLADE_FRICTION] = copysign(values[FRICTION].number, to->turn);
    out->number[BLADE_RATE] = to->turn;
    out->number[BLADE_START] = values[ANGLE].number;
    out->number[BLADE_APART_COS] = cos(apart);
    out->number[BLADE_APART_SIN] = copysign(sin(apart), to->turn); // numbered along the rotation
    out->number[BLADE_METRES] = copysign(length, to->turn);
    out->number[BLADE_WATTS] = to->clock * length;
    // Set the length and stiffness of each blade.
    for (int j = 0; j < blades_of(out); j++) {
        const double own = values[RADIUS].number + of_blade(&values[EXTENSION], j);
        if (!(own > 0.0)) return whirl_fail(WHIRL_BAD_INPUT, "has a blade of %g m, expected one above 0", own);
        out->number[BLADE_LENGTHS + j] = own / length;
        out->number[BLADE_STIFFNESSES + j] = of_blade(&values[STIFFNESS], j) * pow(length, p);
    }
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

/// Applies the second derivatives of a depth to the perturbation ud of the displacement and uz of the angle. tau = ud +
/// l uz Je is the change of a tip t, and e the blade's direction (blade_rub_kernel.h). The derivatives n = t/|t| by
/// displacement and l n Je by angle change by dn = (tau - n (n tau))/|t| and l (dn Je - uz n e).
static void blade_rub_curvature(const element *own, const element_place *at, size_t index, const element_place *along,
                                element_place *by) {
    const double *number = own->number, length = number[BLADE_LENGTHS + index];
    const double apart = atan2(number[BLADE_APART_SIN], number[BLADE_APART_COS]);
    const double angle = number[BLADE_START] + at->s[0] + (double)index * apart, turned = along->s[0];
    const double e[2] = {cos(angle), sin(angle)}, across[2] = {0.0 - e[1], e[0]};
    double tip[2], moved[2], dn[2];
    for (int a = 0; a < 2; a++) {
        tip[a] = at->q[a] - at->q[2 + a] + length * e[a];
        moved[a] = along->q[a] - along->q[2 + a] + length * turned * across[a];
    }
    const double far = hypot(tip[0], tip[1]), n[2] = {tip[0] / far, tip[1] / far};
    const double out = n[0] * moved[0] + n[1] * moved[1];
    *by = (element_place){.q = {0.0}};
    for (int a = 0; a < 2; a++) {
        dn[a] = (moved[a] - n[a] * out) / far;
        by->q[a] = dn[a];
        by->q[2 + a] = 0.0 - dn[a];
        by->s[0] += length * (dn[a] * across[a] - turned * n[a] * e[a]);
    }
}

/// Returns true: a contact begins at every blade's switch.
static bool blade_rub_touches(const element *own, size_t index) {
    (void)own, (void)index;
    return true;
}

static double blade_rub_contact_gap(const element *own) {
    (void)own;
    return 0.0;
}

static int blade_rub_takes_power(const element *own) {
    return own->law & BLADE_RUBS ? 1 : 0;
}

/// Returns true: contact also depends on the blades' angle.
static bool blade_rub_contact_damped(const element *own) {
    (void)own;
    return true;
}

static bool blade_rub_jumps(const element *own) {
    (void)own;
    return false;
}

static void blade_rub_doubt(const key_value *values, double speed, const doubt_teller *to) {
    const double share = values[GAP].number / values[RADIUS].number, most = 0.1;
    (void)speed;
    if (share > most)
        doubt_value(to, keys[GAP].name, "is %.3g times the radius, and casings are up to %g times away", share, most);
    for (int j = 0; j < (int)values[BLADES].number; j++) {
        const double over = of_blade(&values[EXTENSION], j);
        if (fabs(over) <= values[GAP].number) continue;
        doubt_value(to, keys[EXTENSION].name, "is %.3g m of a blade, more than the gap of %.3g m", over,
                    values[GAP].number);
        return;
    }
}

KERNELS_OF_EVERY_ISA(blade_rub_kernels);

const element_type blade_rub_element = {
    .group = {"blade_rub", "blades whose tips pass a casing, each with its own length and stiffness", "Ma et al. 2016",
              keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .turning = 1,
    .rounds = blade_rub_rounds,
    .kernels = kernels,
    .build = blade_rub_build,
    GENERIC_SWITCHES,
    .switch_curvature = blade_rub_curvature,
    .touches = blade_rub_touches,
    .jumps = blade_rub_jumps,
    .contact_gap = blade_rub_contact_gap,
    .named_order = blade_rub_named_order,
    .rubs = blade_rub_takes_power,
    .contact_damped = blade_rub_contact_damped,
    .doubt = blade_rub_doubt,
};
#endif
