// An annular seal with a turning fluid: its keys, and the numbers of its kernel.
#define KERNEL_FILE "elements/supports/seal_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 0
#define KERNEL_NUMBERS SEAL_NUMBERS
#define KERNEL_SWITCHES 0

/// Numbers: K_0, D_0 and m_f in newtons per length scale and radian; 1/c^2 in length scales; lambda_0 by tau, n and b;
/// the torque of the shear on the shaft, N m (0: unknown), and lambda_0 by the shaft's own speed, which kernels do not
/// read.
enum {
    SEAL_STIFFNESS,
    SEAL_DAMPING,
    SEAL_MASS,
    SEAL_OVER_CLEARANCE_SQUARE,
    SEAL_RATIO,
    SEAL_GROWTH,
    SEAL_SLOWING,
    SEAL_SHEAR,
    SEAL_SHARE,
    SEAL_NUMBERS
};

/// Bits of the law: coefficients follow from geometry; the powers n and b are given.
enum { SEAL_BLACK = 1, SEAL_GROWS = 2, SEAL_SLOWS = 4 };

#include "black.h"
#include "generic.h"
#include "registry.h"

const element_kernels ISA(seal_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>
#include <stdio.h>

enum {
    AT,
    FROM,
    LAW,
    CLEARANCE,
    STIFFNESS,
    DAMPING,
    MASS,
    RATIO,
    GROWTH,
    SLOWING,
    RADIUS,
    LENGTH,
    DENSITY,
    VISCOSITY,
    KINEMATIC,
    PRESSURE,
    LOSS,
    SWIRL,
    KEY_COUNT
};

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station in the seal"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of the housing; absent: the ground"),
    [LAW] = CITED_CHOICE_KEY("law", DEFAULT("muszynska"), "muszynska|black",
                             "muszynska: stiffness, damping, mass and ratio are given; black: they follow from radius, "
                             "length, density, viscosity, pressure, loss and swirl at the speed of the shaft",
                             "Muszynska 1988; Black 1969; Black, Jenssen 1970"),
    [CLEARANCE] = NUMBER_KEY("clearance", "c", "m", REQUIRED, WHIRL_POSITIVE, "radial clearance"),
    [STIFFNESS] = NUMBER_KEY("stiffness", "K_0", "N/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "stiffness in the middle"),
    [DAMPING] = NUMBER_KEY("damping", "D_0", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                           "damping in the middle, of the motion against the turning fluid"),
    [MASS] = NUMBER_KEY("mass", "m_f", "kg", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                        "mass of the fluid that moves with the station"),
    [RATIO] = CITED_NUMBER_KEY(
        "ratio", "lambda_0", "1", OPTIONAL, WHIRL_NOT_NEGATIVE,
        "mean speed of the turning fluid over that of the shaft, in the middle; below 0.5 as a rule; required with law "
        "muszynska",
        "Muszynska 1988"),
    [GROWTH] = CITED_NUMBER_KEY(
        "growth", "n", "1", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
        "power by which stiffness and damping grow with the eccentricity ratio e, as (1 - e^2)^-n", "Muszynska 1988"),
    [SLOWING] = CITED_NUMBER_KEY("slowing", "b", "1", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                                 "power by which the fluid slows down with the eccentricity ratio, as (1 - e)^b",
                                 "Muszynska 1988"),
    [RADIUS] = NUMBER_KEY("radius", "R", "m", OPTIONAL, WHIRL_POSITIVE, "radius of the shaft in the seal; with black"),
    [LENGTH] = NUMBER_KEY("length", "L", "m", OPTIONAL, WHIRL_POSITIVE, "length of the seal; with black"),
    [DENSITY] = NUMBER_KEY("density", "rho", "kg/m3", OPTIONAL, WHIRL_POSITIVE, "density of the liquid; with black"),
    [VISCOSITY] =
        NUMBER_KEY("viscosity", "mu", "Pa s", OPTIONAL, WHIRL_POSITIVE, "dynamic viscosity of the liquid; with black"),
    [KINEMATIC] = NUMBER_KEY("kinematic_viscosity", "nu", "m2/s", OPTIONAL, WHIRL_POSITIVE,
                             "kinematic viscosity of the liquid, in place of viscosity; with black"),
    [PRESSURE] = NUMBER_KEY("pressure", "Delta_p", "Pa", OPTIONAL, WHIRL_POSITIVE,
                            "pressure drop over inlet and seal; with black"),
    [LOSS] = CITED_NUMBER_KEY("loss", "xi", "1", DEFAULT("0.5"), WHIRL_NOT_NEGATIVE,
                              "loss at the inlet over rho V^2/2, in addition to the velocity head itself",
                              "Black, Jenssen 1970"),
    [SWIRL] = CITED_NUMBER_KEY("swirl", "s", "1", DEFAULT("0.5"), WHIRL_FROM_TO(-2, 2),
                               "swirl of the entering liquid over the speed of the shaft's surface; it tends to 0.5 "
                               "along the seal, and its mean is the ratio",
                               "Black, Allaire, Barrett 1981; Childs 1983"),
};

/// Returns the coefficients at the centre: as given, or from the geometry.
static black_coefficients middle_of(const key_value *values, double speed) {
    const double density = values[DENSITY].number;
    const double viscosity = values[KINEMATIC].given ? values[KINEMATIC].number * density : values[VISCOSITY].number;
    const black_seal seal = {
        values[RADIUS].number,   values[LENGTH].number, values[CLEARANCE].number, density, viscosity,
        values[PRESSURE].number, values[LOSS].number,   values[SWIRL].number};
    if (values[LAW].choice) return black_find(&seal, speed);
    return (black_coefficients){.stiffness = values[STIFFNESS].number,
                                .damping = values[DAMPING].number,
                                .mass = values[MASS].number,
                                .ratio = values[RATIO].number};
}

/// Returns the speed of the shaft in the seal, rad/s, without its sense.
static double seal_speed(const key_value *values, const assembly *to) {
    const double ratio = to->stations[values[AT].station[0]].ratio;
    return ratio == 1.0 ? to->speed : fabs(ratio) * to->speed;
}

/// Checks that the keys of the seal's law are given, and no keys of the other law.
static whirl_status check_law(const key_value *values) {
    const bool black = values[LAW].choice;
    for (int k = STIFFNESS; k <= RATIO; k++)
        if (black && values[k].given)
            return whirl_fail(WHIRL_BAD_INPUT, "has law black and %s, which follows from it, expected one of them",
                              keys[k].name);
    for (int k = RADIUS; k <= SWIRL; k++) {
        if (!black && values[k].given)
            return whirl_fail(WHIRL_BAD_INPUT, "has %s, which law muszynska does not know, expected law black",
                              keys[k].name);
        if (black && !values[k].given && k < LOSS && k != VISCOSITY && k != KINEMATIC)
            return whirl_fail(WHIRL_BAD_INPUT, "has no %s, expected one with law black", keys[k].name);
    }
    if (black && values[VISCOSITY].given == values[KINEMATIC].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s, expected one of viscosity and kinematic_viscosity with law black",
                          values[VISCOSITY].given ? "both" : "neither");
    return black || values[RATIO].given ? whirl_ok() : whirl_fail(WHIRL_BAD_INPUT, "has no ratio, expected one");
}

static whirl_status seal_inertia(const key_value *values, assembly *to) {
    const whirl_status status = check_law(values);
    if (status.code == WHIRL_OK && !values[FROM].given)
        to->stations[values[AT].station[0]].fluid += middle_of(values, seal_speed(values, to)).mass;
    return status;
}

static whirl_status seal_build(const key_value *values, assembly *to, element *out) {
    const double clearance = values[CLEARANCE].number / to->length;
    const whirl_status status = element_in_housing(&values[AT], &values[FROM], to, out);
    if (status.code != WHIRL_OK) return status;
    const assembly_station *const at = &to->stations[values[AT].station[0]];
    const black_coefficients middle = middle_of(values, seal_speed(values, to));
    out->law = (values[LAW].choice ? SEAL_BLACK : 0) | (values[GROWTH].given ? SEAL_GROWS : 0) |
               (values[SLOWING].given ? SEAL_SLOWS : 0);
    for (size_t a = 0; a < KERNEL_AXES && values[FROM].given; a++)
        assembly_inerter(to, out->port[a], out->port[KERNEL_AXES + a], middle.mass);
    out->number[SEAL_STIFFNESS] = middle.stiffness * to->length;
    out->number[SEAL_DAMPING] = middle.damping * to->clock * to->length;
    out->number[SEAL_MASS] = middle.mass * to->clock * to->clock * to->length;
    out->number[SEAL_OVER_CLEARANCE_SQUARE] = 1.0 / (clearance * clearance);
    out->number[SEAL_RATIO] = middle.ratio * at->ratio * to->turn;
    out->number[SEAL_GROWTH] = values[GROWTH].number;
    out->number[SEAL_SLOWING] = values[SLOWING].number;
    out->number[SEAL_SHEAR] = middle.shear;
    out->number[SEAL_SHARE] = middle.ratio;
    out->fluid = (fluid_drag){.shear = middle.shear,
                              .turns = {at->ratio, 0.0},
                              .spool = {at->spool, 0},
                              .housing = values[FROM].given ? values[FROM].station[0] : GROUND};
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

/// Raises doubts about Blasius' friction of smooth walls, and about the neglect of circumferential flow.
static void doubt_black(const key_value *values, double speed, const doubt_teller *to) {
    const double least = 3000.0, most = 1e5, reynolds = middle_of(values, speed).reynolds;
    const double share = values[LENGTH].number / (2.0 * values[RADIUS].number), longest = 0.5 * (1.0 + 1e-9);
    if (reynolds < least || reynolds > most)
        doubt_value(to, keys[PRESSURE].name,
                    "is %.4g Pa, by which the Reynolds number is %.3g: the law is for turbulent flow between smooth "
                    "walls, %g to %g",
                    values[PRESSURE].number, reynolds, least, most);
    if (share > longest)
        doubt_value(to, keys[LENGTH].name,
                    "is %.3g times the diameter: the law is for short seals, up to 0.5, its stiffness too large beyond",
                    share);
}

/// Raises doubts about values beyond measurements (theory.md, "Annular seal").
static void seal_doubt(const key_value *values, double speed, const doubt_teller *to) {
    static const struct {
        int key;
        double most;
    } known[] = {{RATIO, 0.5}, {GROWTH, 3.0}, {SLOWING, 1.0}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (values[known[i].key].number > known[i].most)
            doubt_value(to, keys[known[i].key].name, "is %g, and seals have up to %g as a rule",
                        values[known[i].key].number, known[i].most);
    if (values[LAW].choice) doubt_black(values, speed, to);
}

/// Describes a seal given by its geometry: its coefficients in the rotating fluid, and for a centred station.
static void seal_note(const element *own, double length, double clock, char *text, size_t size) {
    const double *number = own->number, turn = number[SEAL_RATIO] * clock;
    const double K = number[SEAL_STIFFNESS] / length, C = number[SEAL_DAMPING] / (clock * length);
    const double M = number[SEAL_MASS] / (clock * clock * length);
    if (!(own->law & SEAL_BLACK)) return;
    snprintf(
        text, size,
        "in the fluid K %.5g N/m, C %.5g N s/m, M %.4g kg, which turns at %.4g of the shaft's speed: kxx %.5g N/m, "
        "kxy %.5g N/m, cxx %.5g N s/m, cxy %.5g N s/m",
        K, C, M, fabs(number[SEAL_SHARE]), K - M * turn * turn, C * turn, C, 2.0 * M * turn);
}

/// Implements element_type.drag: the shear, and the couple that turns the fluid at lambda times the shaft's speed.
static void seal_drag(const element *own, const drag_view *in, double torque[2]) {
    const double *number = own->number;
    const double share = in->distance / in->length * sqrt(number[SEAL_OVER_CLEARANCE_SQUARE]);
    const double slower = number[SEAL_SLOWING] > 0.0 ? pow(1.0 - share, number[SEAL_SLOWING]) : 1.0;
    const double ratio = number[SEAL_SHARE] * slower, shear = copysign(number[SEAL_SHEAR], in->spin[0]);
    const double couple = in->place[0] * in->force[1] - in->place[1] * in->force[0];
    torque[0] = -shear - ratio * couple;
    torque[1] = shear - (1.0 - ratio) * couple;
}

static double seal_clearance(const element *own) {
    return 1.0 / sqrt(own->number[SEAL_OVER_CLEARANCE_SQUARE]);
}

/// Describes the range: coefficients of the centre hold up to about half the clearance (Childs 1993).
static bool seal_range(const element *own, size_t index, const element_seen *seen, element_range *out) {
    const bool grows = own->number[SEAL_GROWTH] > 0.0;
    const char *const limit =
        grows ? "at which the rotor touches the seal" : "to which coefficients of the middle hold";
    *out = (element_range){"eccentricity ratio", "1", limit, grows ? 1.0 : 0.5, 0.0};
    out->reached = seen->radius * sqrt(own->number[SEAL_OVER_CLEARANCE_SQUARE]);
    return index == 0;
}

KERNELS_OF_EVERY_ISA(seal_kernels);

const element_type seal_element = {
    .group = {"seal", "an annular seal or lightly loaded bearing whose fluid turns with the shaft",
              "Muszynska 1988; Bently & Muszynska 1988", keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .follows = true,
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .kernels = kernels,
    .inertia = seal_inertia,
    .build = seal_build,
    .drags = true,
    .drag = seal_drag,
    .bearing_clearance = seal_clearance,
    .range = seal_range,
    .note = seal_note,
    .doubt = seal_doubt,
};
#endif
