// Two gears: a rigid ratio of twists, or a mesh with stiffness, damping, play and error.
#define KERNEL_FILE "elements/shafts/gear_kernel.h"
#define KERNEL_AXES 3
#define KERNEL_STATES 1
#define KERNEL_FEWER_STATES
#define KERNEL_NUMBERS GEAR_NUMBERS
#define KERNEL_SWITCHES 3
#define KERNEL_SWITCHES_BY_STATES
#define KERNEL_SWITCHES_OF(own) GEAR_SWITCHES(own)
#define KERNEL_CURVED
#define KERNEL_TILTS

/// Bits of the law: with play; with a changing number of pairs in contact, and so a changing stiffness; with an error;
/// with a profile of the stiffness. The rest of the law is the number of harmonics of the profile.
enum { GEAR_PLAY = 1, GEAR_PAIRS = 2, GEAR_ERROR = 4, GEAR_PROFILE = 8, GEAR_LAWS = 16 };

/// Phases over which linear analyses take means; and most harmonics of a profile, the mean of which these phases give
/// exactly.
enum { GEAR_PHASES = 16, GEAR_HARMONICS = GEAR_PHASES - 1 };

#define GEAR_SWITCHES(own) (((own)->law & GEAR_PLAY ? 2 : 0) + ((own)->law & GEAR_PAIRS ? 1 : 0))

/// Numbers, in newtons and length scales: the line of action along x and y; half the share of more pairs, rad of psi;
/// the error by cos psi and by -sin psi; psi'; levers of the force about the axes of both gears, m; a length scale in
/// m.
enum {
    GEAR_ALONG_X,
    GEAR_ALONG_Y,
    GEAR_STIFFNESS,
    GEAR_STIFFNESS_LESS,
    GEAR_DAMPING,
    GEAR_GAP,
    GEAR_SHARE,
    GEAR_ERROR_COS,
    GEAR_ERROR_SIN,
    GEAR_RATE,
    GEAR_LEVER,
    GEAR_LEVER_SECOND,
    GEAR_LENGTH,
    GEAR_PARTS, ///< stiffness by cos n psi, then by sin n psi, of every harmonic
    GEAR_NUMBERS = GEAR_PARTS + 2 * GEAR_HARMONICS
};

#include "generic.h"
#include "registry.h"

const element_kernels ISA(gear_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>
#include <stdio.h>

enum {
    BETWEEN,
    RADII,
    PRESSURE_ANGLE,
    DIRECTION,
    HELIX,
    STIFFNESS,
    DAMPING,
    BACKLASH,
    TEETH,
    VARIATION,
    SHARE,
    PROFILE,
    ERROR,
    ERROR_ANGLE,
    KEY_COUNT
};

static const double pi = 3.14159265358979323846;

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED,
                             "the two gears, which turn against each other; with a stiffness one may be ground, a rack "
                             "that stands"),
    [RADII] =
        CITED_NUMBERS_KEY("base_radii", "r_b", "m", REQUIRED, WHIRL_POSITIVE,
                          "radii of both base circles: pitch radius times the cosine of the pressure angle; without "
                          "a stiffness their ratio alone counts",
                          "Kahraman, Singh 1990"),
    [PRESSURE_ANGLE] =
        NUMBER_KEY("pressure_angle", "alpha", "rad", DEFAULT("0.3490658503988659"), WHIRL_FROM_TO(-1.5, 1.5),
                   "angle between the line of action and what is square to the line of centres; below "
                   "0: the other flank carries; absent: 20 degrees"),
    [DIRECTION] = ANGLE_KEY("direction", "gamma", NULL, "direction of the line of centres, from the x axis towards y"),
    [HELIX] = NUMBER_KEY("helix", "beta_b", "rad", DEFAULT("0"), WHIRL_FROM_TO(-1.5, 1.5),
                         "helix angle on the base circle; 0: spur gears"),
    [STIFFNESS] =
        CITED_NUMBER_KEY("stiffness", "k_m", "N/m", OPTIONAL, WHIRL_POSITIVE,
                         "mean stiffness of the mesh along the line of action; absent: rigid, the twists have "
                         "the ratio of the radii",
                         "Kahraman, Singh 1990"),
    [DAMPING] = NUMBER_KEY("damping", "c_m", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                           "damping of the mesh while teeth touch"),
    [BACKLASH] = NUMBER_KEY("backlash", "2b", "m", OPTIONAL, WHIRL_NOT_NEGATIVE,
                            "whole play along the line of action, the middle of which is the place of rest; absent: "
                            "teeth never part"),
    [TEETH] = WHOLE_KEY("teeth", "z", OPTIONAL, WHIRL_FROM_TO(1, 1000),
                        "number of teeth of the first gear, which turns as its shaft does; required with variation, "
                        "profile or error"),
    [VARIATION] =
        CITED_NUMBER_KEY("variation", "eps", "1", DEFAULT("0"), WHIRL_FROM_TO(0.0, 1.0),
                         "share by which the stiffness is above its mean while more pairs of teeth touch, and "
                         "below it while fewer do",
                         "Kahraman, Blankenship 1997"),
    [SHARE] = NUMBER_KEY("contact_share", "d", "1", DEFAULT("0.5"), WHIRL_FROM_TO(0.001, 0.999),
                         "share of a tooth's period with more pairs: contact ratio less its whole part"),
    [PROFILE] =
        CITED_NUMBERS_KEY("profile", "", "1", OPTIONAL, WHIRL_POSITIVE,
                          "factors of the stiffness at 3 to 31 equal angles of the mesh, from tooth to tooth, in "
                          "place of variation; between them the trigonometric polynomial through them",
                          "Gauss 1866"),
    [ERROR] =
        NUMBER_KEY("error", "e", "m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                   "amplitude of the transmission error along the line of action, once a tooth, in the sense of the "
                   "rotation"),
    [ERROR_ANGLE] = ANGLE_KEY("error_angle", "phi", "error", "phase of the error where more pairs begin to touch"),
};

static bool gear_is_rigid(const key_value *values) {
    return !values[STIFFNESS].given;
}

/// Checks for keys that contradict each other. Stations that do not twist are found where coordinates are numbered or
/// looked up.
static whirl_status gear_check(const key_value *values) {
    static const int of_meshes[] = {DAMPING, BACKLASH,       VARIATION, SHARE, PROFILE,
                                    ERROR,   PRESSURE_ANGLE, DIRECTION, HELIX, TEETH};
    if (values[RADII].count != 2)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu base_radii, expected those of both gears", values[RADII].count);
    // A rigid mesh must have none of the keys of an elastic one.
    for (size_t i = 0; gear_is_rigid(values) && i < sizeof of_meshes / sizeof *of_meshes; i++)
        if (values[of_meshes[i]].given)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "has %s and no stiffness, without which a mesh is rigid, expected both or "
                              "neither",
                              keys[of_meshes[i]].name);
    // A stiffness, error or profile that varies along a tooth needs the number of teeth.
    const bool varies = values[VARIATION].number > 0.0 || values[ERROR].number > 0.0 || values[PROFILE].given;
    if (varies && !values[TEETH].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has a variation or an error and no teeth, expected their number");
    if (values[PROFILE].given && (values[VARIATION].given || values[SHARE].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has a profile and a variation, expected one of them");
    if (values[PROFILE].given &&
        (values[PROFILE].count < 3 || values[PROFILE].count > 2 * GEAR_HARMONICS + 1 || values[PROFILE].rows > 1))
        return whirl_fail(WHIRL_BAD_INPUT, "has a profile of %zu numbers, expected 3 to %d", values[PROFILE].count,
                          2 * GEAR_HARMONICS + 1);
    // A mesh joins two stations.
    const size_t *station = values[BETWEEN].station;
    if (gear_is_rigid(values) && (station[0] == GROUND || station[1] == GROUND))
        return whirl_fail(WHIRL_BAD_INPUT, "is rigid and joins the ground, expected two stations that twist");
    if (station[0] == station[1]) return whirl_fail(WHIRL_BAD_INPUT, "between names one station twice, expected two");
    return whirl_ok();
}

/// Makes the twist of the second gear of a rigid pair follow that of the first, in the opposite direction.
static whirl_status gear_inertia(const key_value *values, assembly *to) {
    if (!gear_is_rigid(values) || values[RADII].count != 2) return whirl_ok();
    const size_t *station = values[BETWEEN].station;
    if (station[0] == GROUND || station[1] == GROUND || station[0] == station[1]) return whirl_ok();
    return assembly_gear(to, station[1], station[0], -values[RADII].list[0] / values[RADII].list[1]);
}

/// Returns the stiffness of a mesh at its phase psi, as its kernel computes it.
static double gear_stiffness_at(const element *own, double psi) {
    const double *n = own->number;
    double sum = n[GEAR_STIFFNESS];
    if (own->law & GEAR_PAIRS) return cos(psi - n[GEAR_SHARE]) > cos(n[GEAR_SHARE]) ? sum : n[GEAR_STIFFNESS_LESS];
    for (int k = 0; k < own->law / GEAR_LAWS; k++)
        sum += n[GEAR_PARTS + k] * cos((k + 1) * psi) + n[GEAR_PARTS + GEAR_HARMONICS + k] * sin((k + 1) * psi);
    return sum;
}

/// Sets the harmonics of a profile of factors of `stiffness`. WHIRL_BAD_INPUT if the polynomial through its values is
/// not above 0 everywhere.
static whirl_status gear_set_profile(const key_value *profile, double stiffness, element *out) {
    enum { LOOKS = 720 };
    const size_t count = profile->count, harmonics = count / 2;
    double mean = 0.0;
    for (size_t i = 0; i < count; i++) mean += profile->list[i] / (double)count;
    out->number[GEAR_STIFFNESS] = stiffness * mean;
    out->law |= GEAR_PROFILE | (int)harmonics * GEAR_LAWS;
    for (size_t k = 1; k <= harmonics; k++) {
        // For an even number of values, the last harmonic has only a cosine, with half the weight.
        const double weight = stiffness * (2 * k == count ? 1.0 : 2.0) / (double)count;
        double c = 0.0, s = 0.0;
        for (size_t i = 0; i < count; i++) {
            const double angle = 2.0 * pi * (double)(k * i % count) / (double)count;
            c += weight * profile->list[i] * cos(angle);
            s += weight * profile->list[i] * sin(angle);
        }
        out->number[GEAR_PARTS + k - 1] = c;
        out->number[GEAR_PARTS + GEAR_HARMONICS + k - 1] = 2 * k == count ? 0.0 : s;
    }
    for (int i = 0; i < LOOKS; i++)
        if (!(gear_stiffness_at(out, 2.0 * pi * i / LOOKS) > 0.0))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "has a profile between whose values the stiffness falls to 0, at %.3g of a tooth's "
                              "period, expected more or smoother values",
                              (double)i / LOOKS);
    return whirl_ok();
}

/// Sets the numbers of a mesh, whose forces are in newtons and whose closing is in length scales.
static void gear_set_numbers(const key_value *values, const assembly *to, element *out) {
    const double flat = cos(values[HELIX].number), alpha = values[PRESSURE_ANGLE].number;
    const double gamma = values[DIRECTION].number;
    const double stiffness = values[STIFFNESS].number * to->length, more = values[VARIATION].number;
    double *number = out->number;
    for (size_t i = 0; i < 2; i++) {
        const size_t port = i == 0 ? 2 : 5;
        out->share[port] *= (i == 0 ? 1.0 : -1.0) * flat * values[RADII].list[i];
        number[GEAR_LEVER + i] = out->port[port] == NO_COORDINATE ? 0.0 : -flat * values[RADII].list[i];
    }
    number[GEAR_LENGTH] = to->length;
    generic_tilts(out, to);
    number[GEAR_ALONG_X] = flat * sin(alpha - gamma);
    number[GEAR_ALONG_Y] = flat * cos(alpha - gamma);
    number[GEAR_STIFFNESS] = stiffness * (1.0 + more);
    number[GEAR_STIFFNESS_LESS] = stiffness * (1.0 - more);
    number[GEAR_DAMPING] = values[DAMPING].number * to->length * to->clock;
    number[GEAR_GAP] = 0.5 * values[BACKLASH].number / to->length;
    number[GEAR_SHARE] = pi * values[SHARE].number;
    // The error is positive along the rotation, so that a mirror image has the same error.
    const double error = copysign(values[ERROR].number / to->length, to->turn);
    number[GEAR_ERROR_COS] = error * cos(values[ERROR_ANGLE].number);
    number[GEAR_ERROR_SIN] = error * sin(values[ERROR_ANGLE].number);
}

extern const element_type gear_turning;

static whirl_status gear_build(const key_value *values, assembly *to, element *out) {
    static const axis axes[KERNEL_AXES] = {AXIS_X, AXIS_Y, AXIS_TWIST};
    // Rigid gears need no kernel: they reduce the coordinates.
    whirl_status status = gear_check(values);
    out->lumped = gear_is_rigid(values);
    if (status.code != WHIRL_OK || out->lumped) return status;
    status = element_between(&values[BETWEEN], to, axes, KERNEL_AXES, out);
    if (status.code != WHIRL_OK) return status;
    // Compute the numbers of the mesh.
    const size_t first = values[BETWEEN].station[0];
    const double ratio = first == GROUND ? 1.0 : to->stations[first].ratio;
    out->law = (values[BACKLASH].given ? GEAR_PLAY : 0) | (values[VARIATION].number > 0.0 ? GEAR_PAIRS : 0) |
               (values[ERROR].number > 0.0 ? GEAR_ERROR : 0);
    gear_set_numbers(values, to, out);
    out->number[GEAR_RATE] = values[TEETH].number * fabs(ratio * to->turn);
    out->states = 0;
    if (values[PROFILE].given) {
        status = gear_set_profile(&values[PROFILE], values[STIFFNESS].number * to->length, out);
        if (status.code != WHIRL_OK) return status;
    }
    // A mesh that varies has its phase as a state.
    if (!(out->law & (GEAR_PAIRS | GEAR_ERROR | GEAR_PROFILE))) return whirl_ok();
    out->states = 1;
    out->type = &gear_turning;
    return whirl_ok();
}

static double gear_rounds(const element *own, size_t state) {
    (void)state;
    return own->number[GEAR_RATE];
}

/// Finds the force of the mesh, as its kernel computes it.
static void gear_carry(const element *own, const element_place *at, element_carried *out) {
    const double *n = own->number, along[KERNEL_AXES] = {n[GEAR_ALONG_X], n[GEAR_ALONG_Y], 1.0};
    const double cosine = cos(at->s[0]), sine = sin(at->s[0]);
    const bool errs = own->law & GEAR_ERROR;
    *out = (element_carried){.unit = n[GEAR_LENGTH], .damping = n[GEAR_DAMPING]};
    double closing = 0.0, rate = 0.0;
    for (size_t port = 0; port < (size_t)KERNEL_PORTS; port++) {
        const size_t a = port % KERNEL_AXES;
        out->closing[port] = (port < KERNEL_AXES ? 1.0 : -1.0) * along[a] * unit_of(own, (int)port);
        closing += out->closing[port] * at->q[port];
        rate += out->closing[port] * at->v[port];
    }
    for (size_t i = 0; i < 2; i++) out->lever[i] = n[GEAR_LEVER + i];
    if (errs) {
        out->error_order = n[GEAR_RATE];
        out->error[0] = n[GEAR_ERROR_COS];
        out->error[1] = n[GEAR_ERROR_SIN];
        closing -= n[GEAR_ERROR_COS] * cosine - n[GEAR_ERROR_SIN] * sine;
        rate += n[GEAR_RATE] * (n[GEAR_ERROR_COS] * sine + n[GEAR_ERROR_SIN] * cosine);
    }
    // The stiffness is the mean that linear analyses use: over the phases from that of the state on.
    for (int k = 0; k < GEAR_PHASES; k++)
        out->stiffness += gear_stiffness_at(own, at->s[0] + 2.0 * pi * k / GEAR_PHASES) / GEAR_PHASES;
    const double gap = own->law & GEAR_PLAY ? n[GEAR_GAP] : 0.0;
    out->open = (own->law & GEAR_PLAY) && fabs(closing) <= gap;
    out->play = gap;
    if (!out->open)
        out->force = gear_stiffness_at(own, at->s[0]) * (closing - copysign(gap, closing)) + n[GEAR_DAMPING] * rate;
}

/// Returns true if the force may jump: the stiffness jumps, or a damper acts where teeth meet.
static bool gear_jumps(const element *own) {
    return (own->law & GEAR_PAIRS) || ((own->law & GEAR_PLAY) && own->number[GEAR_DAMPING] > 0.0);
}

static bool gear_touches(const element *own, size_t index) {
    return (own->law & GEAR_PLAY) && index == 0;
}

/// Computes the second derivatives, which are by psi alone: those of the error, and of the share of more pairs.
static void gear_curvature(const element *own, const element_place *at, size_t index, const element_place *along,
                           element_place *by) {
    const double c = cos(at->s[0]), s = sin(at->s[0]);
    *by = (element_place){.q = {0.0}};
    if ((own->law & GEAR_PLAY) && index < 2) {
        if (own->law & GEAR_ERROR)
            by->s[0] = along->s[0] * (own->number[GEAR_ERROR_COS] * c - own->number[GEAR_ERROR_SIN] * s);
    } else {
        by->s[0] = -along->s[0] * cos(at->s[0] - own->number[GEAR_SHARE]);
    }
}

static bool gear_named_order(const element *own, size_t index, double *order, const char **name) {
    *order = own->number[GEAR_RATE];
    *name = "mesh";
    return index == 0 && own->states > 0;
}

KERNELS_OF_EVERY_ISA(gear_kernels);

#define GEAR_TYPE                                                                                                      \
    .group = {"gear",                                                                                                  \
              "two gears whose twists a rigid ratio or a mesh joins: stiffness, play, error",                          \
              "Kahraman, Singh 1990",                                                                                  \
              keys,                                                                                                    \
              KEY_COUNT,                                                                                               \
              NULL,                                                                                                    \
              NULL},                                                                                                   \
    .number_count = KERNEL_NUMBERS + 2 * KERNEL_PORTS, .kernels = kernels, .inertia = gear_inertia,                    \
    .build = gear_build, GENERIC_SWITCHES, .switch_curvature = gear_curvature, .touches = gear_touches,                \
    .jumps = gear_jumps, .carry = gear_carry, .carries_as = WHIRL_TORQUE_MESH

const element_type gear_element = {GEAR_TYPE};

/// The gear with a mesh that varies, whose phase is a state.
const element_type gear_turning = {GEAR_TYPE, .state_count = KERNEL_STATES, .turning = 1, .rounds = gear_rounds,
                                   .named_order = gear_named_order};
#endif
