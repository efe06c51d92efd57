// Two gears: a rigid ratio of twists, or a mesh with stiffness, damping, play and error.
#define KERNEL_AXES 3 // x, y and twist

#include "gear_parts.h"

const element_kernels ISA(gear_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
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
                   "angle between the line of action and the perpendicular to the line of centres; below "
                   "0: the other flank carries; absent: 20 degrees"),
    [DIRECTION] = ANGLE_KEY("direction", "gamma", NULL, "direction of the line of centres, from the x axis towards y"),
    [HELIX] = NUMBER_KEY("helix", "beta_b", "rad", DEFAULT("0"), WHIRL_FROM_TO(-1.5, 1.5),
                         "helix angle on the base circle, above 0 if the first gear is left-handed; 0: spur gears"),
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

enum { HELICAL_AXES = KERNEL_AXES + 3 };

/// Returns true if a tilt or an axial displacement of either gear closes the teeth.
static bool gear_is_helical(const key_value *values, const assembly *to) {
    bool moves = false;
    for (size_t i = 0; i < 2; i++) {
        const size_t station = values[BETWEEN].station[i];
        const size_t *coordinate = station == GROUND ? NULL : to->stations[station].coordinate;
        moves = moves ||
                (coordinate && (coordinate[AXIS_TILT_X] != NO_COORDINATE || coordinate[AXIS_AXIAL] != NO_COORDINATE));
    }
    return moves && values[HELIX].number != 0.0;
}

/// Sets the ports of tilts and axial displacements. A point of the pitch circle at (X, Y) from the gear's centre moves
/// by z - (phi_x X + phi_y Y) along the shaft.
static void gear_set_shifts(const key_value *values, const assembly *to, element *out) {
    const double gamma = values[DIRECTION].number;
    for (size_t i = 0; i < 2; i++) {
        const size_t station = values[BETWEEN].station[i], first = i * HELICAL_AXES;
        const double radius = values[RADII].list[i] / cos(values[PRESSURE_ANGLE].number);
        // The pitch points lie in opposite directions from the centres, and what counts is the first less the second.
        const double along = sin(values[HELIX].number), lever = (i == 0 ? -1.0 : 1.0) * along * radius;
        if (station == GROUND) continue;
        out->port[first + GEAR_TILT_X] = to->stations[station].coordinate[AXIS_TILT_X];
        out->port[first + GEAR_TILT_Y] = to->stations[station].coordinate[AXIS_TILT_Y];
        out->share[first + GEAR_TILT_X] = lever * cos(gamma);
        out->share[first + GEAR_TILT_Y] = lever * sin(gamma);
        out->port[first + GEAR_AXIAL] = to->stations[station].coordinate[AXIS_AXIAL];
        out->share[first + GEAR_AXIAL] = along;
    }
}

/// Sets the numbers of a mesh, whose forces are in newtons and whose closing is in length scales.
static void gear_set_numbers(const key_value *values, const assembly *to, bool helical, element *out) {
    const double flat = cos(values[HELIX].number), alpha = values[PRESSURE_ANGLE].number;
    const double gamma = values[DIRECTION].number;
    const double stiffness = values[STIFFNESS].number * to->length, more = values[VARIATION].number;
    double *number = out->number;
    for (size_t i = 0; i < 2; i++) {
        const size_t port = i * (size_t)(helical ? HELICAL_AXES : KERNEL_AXES) + GEAR_TWIST;
        out->share[port] *= (i == 0 ? 1.0 : -1.0) * flat * values[RADII].list[i];
        number[GEAR_LEVER + i] = out->port[port] == NO_COORDINATE ? 0.0 : -flat * values[RADII].list[i];
    }
    number[GEAR_LENGTH] = to->length;
    if (helical) {
        gear_set_shifts(values, to, out);
        gear_helical_scale(out, to);
    } else {
        generic_tilts(out, to);
    }
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
    static const axis axes[HELICAL_AXES] = {AXIS_X, AXIS_Y, AXIS_TWIST, AXES, AXES, AXES}; // gear_set_shifts: the last
    // Rigid gears need no kernel: they reduce the coordinates.
    whirl_status status = gear_check(values);
    out->lumped = gear_is_rigid(values);
    if (status.code != WHIRL_OK || out->lumped) return status;
    const bool helical = gear_is_helical(values, to);
    status = element_between(&values[BETWEEN], to, axes, helical ? HELICAL_AXES : KERNEL_AXES, out);
    if (status.code != WHIRL_OK) return status;
    // Compute the numbers of the mesh.
    const size_t first = values[BETWEEN].station[0];
    const double ratio = first == GROUND ? 1.0 : to->stations[first].ratio;
    out->law = (values[BACKLASH].given ? GEAR_PLAY : 0) | (values[VARIATION].number > 0.0 ? GEAR_PAIRS : 0) |
               (values[ERROR].number > 0.0 ? GEAR_ERROR : 0);
    gear_set_numbers(values, to, helical, out);
    out->number[GEAR_RATE] = values[TEETH].number * fabs(ratio * to->turn);
    out->states = 0;
    if (helical) out->type = &gear_helical;
    if (values[PROFILE].given) {
        status = gear_set_profile(&values[PROFILE], values[STIFFNESS].number * to->length, out);
        if (status.code != WHIRL_OK) return status;
    }
    // A mesh that varies has its phase as a state.
    if (!(out->law & (GEAR_PAIRS | GEAR_ERROR | GEAR_PROFILE))) return whirl_ok();
    out->states = 1;
    out->type = helical ? &gear_helical_turning : &gear_turning;
    return whirl_ok();
}

KERNELS_OF_EVERY_ISA(gear_kernels);

#define GEAR_ELEMENT                                                                                                   \
    GEAR_TYPE,                                                                                                         \
        .group = {"gear",                                                                                              \
                  "two gears whose twists a rigid ratio or a mesh joins: stiffness, play, error",                      \
                  "Kahraman, Singh 1990",                                                                              \
                  keys,                                                                                                \
                  KEY_COUNT,                                                                                           \
                  NULL,                                                                                                \
                  NULL},                                                                                               \
        .inertia = gear_inertia, .build = gear_build, .variant = &gear_helical

const element_type gear_element = {GEAR_ELEMENT};

/// The gear with a mesh that varies.
const element_type gear_turning = {GEAR_ELEMENT, GEAR_TURNING};
#endif
