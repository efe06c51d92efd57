// A ball bearing, whose stiffness varies as its balls pass: its keys and the numbers of its kernel.
#define KERNEL_FILE "elements/ball_bearing_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 1
#define KERNEL_NUMBERS BALL_NUMBERS
#define KERNEL_SWITCHES 0

/// C in newtons by length scales to the power 3/2; g_0 in length scales; the cage's speed by tau; theta_0;
/// the cosine and sine of the angle between balls. Its law is the number of balls.
enum { BALL_STIFFNESS, BALL_GAP, BALL_RATIO, BALL_START, BALL_APART_COS, BALL_APART_SIN, BALL_NUMBERS };

#include "generic.h"
#include "registry.h"

const element_kernels ISA(ball_bearing_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { AT, FROM, BALLS, STIFFNESS, CLEARANCE, INNER, OUTER, CAGE, ANGLE, DAMPING, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station that it carries"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of its housing; the ground where absent"),
    [BALLS] = WHOLE_KEY("balls", "N_b", REQUIRED, WHIRL_FROM_TO(3, 64), "number of balls"),
    [STIFFNESS] = CITED_NUMBER_KEY(
        "stiffness", "C_b", "1", REQUIRED, WHIRL_POSITIVE,
        "Hertz stiffness of a ball between both races in N/m^1.5: force over approach to the power 3/2",
        "Harris 2001, ch. 6"),
    [CLEARANCE] = NUMBER_KEY("clearance", "g_0", "m", DEFAULT("0"), WHIRL_ANY,
                             "radial play of a ball, half the bearing's internal clearance; below zero for a preload"),
    [INNER] = NUMBER_KEY("inner", "r_i", "m", OPTIONAL, WHIRL_POSITIVE, "radius of the inner race"),
    [OUTER] = NUMBER_KEY("outer", "r_o", "m", OPTIONAL, WHIRL_POSITIVE, "radius of the outer race"),
    [CAGE] = CITED_NUMBER_KEY("cage", "", "1", OPTIONAL, WHIRL_ANY,
                              "speed of the cage over the rotor's, between those of its races, in place of the radii: "
                              "r_i/(r_i + r_o) where the outer race stands",
                              "Harris 2001, ch. 8"),
    [ANGLE] = NUMBER_KEY("angle", "theta_0", "rad", DEFAULT("0"), WHIRL_ANY,
                         "where a ball stands at t = 0, from the x axis towards y"),
    [DAMPING] =
        NUMBER_KEY("damping", "c", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "viscous damping between the races"),
};

/// Speeds of both races over the rotor's. A housing that is no station of a shaft stands.
static void find_races(const key_value *values, const assembly *to, double races[2]) {
    const assembly_station *housing = values[FROM].given ? &to->stations[values[FROM].station[0]] : NULL;
    races[0] = to->stations[values[AT].station[0]].ratio;
    races[1] = housing && housing->shaft != NO_SHAFT ? housing->ratio : 0.0;
}

/// Of its balls that roll: the mean of both races' velocities over the mean of their radii.
static whirl_status cage_ratio(const key_value *values, const double races[2], double *ratio) {
    const bool radii = values[INNER].given && values[OUTER].given;
    const double inner = values[INNER].number, outer = values[OUTER].number;
    const double low = fmin(races[0], races[1]), high = fmax(races[0], races[1]);
    *ratio = values[CAGE].number;
    if (values[CAGE].given && (values[INNER].given || values[OUTER].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has both cage and inner or outer, expected one way");
    if (values[CAGE].given && !(low < *ratio && *ratio < high))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has a cage at %.10g of the rotor's speed, expected one between its races, above %.10g and "
                          "below %.10g",
                          *ratio, low, high);
    if (values[CAGE].given) return whirl_ok();
    if (!radii) return whirl_fail(WHIRL_BAD_INPUT, "has no speed of its cage, expected cage, or inner and outer");
    if (!(inner < outer))
        return whirl_fail(WHIRL_BAD_INPUT, "has an inner race of %g m in an outer one of %g m, expected a smaller one",
                          inner, outer);
    *ratio = (races[0] * inner + races[1] * outer) / (inner + outer);
    return whirl_ok();
}

/// Of balls in a revolution.
static double passes_of(const element *own) {
    return own->law * own->number[BALL_RATIO];
}

KERNELS_OF_EVERY_ISA(ball_bearing_kernels);

static whirl_status build(const key_value *values, assembly *to, element *out) {
    const double balls = values[BALLS].number, length = to->length, apart = 6.283185307179586476925 / balls;
    double ratio, races[2];
    whirl_status status = element_in_housing(&values[AT], &values[FROM], to, out);
    if (status.code != WHIRL_OK) return status;
    find_races(values, to, races);
    status = cage_ratio(values, races, &ratio);
    if (status.code != WHIRL_OK) return status;
    out->law = (int)balls;
    out->number[BALL_STIFFNESS] = values[STIFFNESS].number * length * sqrt(length);
    out->number[BALL_GAP] = values[CLEARANCE].number / length;
    out->number[BALL_RATIO] = ratio * to->turn;
    out->number[BALL_START] = values[ANGLE].number;
    out->number[BALL_APART_COS] = cos(apart);
    out->number[BALL_APART_SIN] = sin(apart);
    generic_scale(out, to, 1.0);
    for (int a = 0; a < KERNEL_AXES; a++)
        assembly_damper(to, out->port[a], out->port[KERNEL_AXES + a], values[DAMPING].number);
    return whirl_ok();
}

static void doubt(const key_value *values, double speed, const doubt_teller *to) {
    const double ball = values[OUTER].number - values[INNER].number, most = 0.01;
    (void)speed;
    if (values[INNER].given && fabs(values[CLEARANCE].number) > most * ball)
        doubt_value(to, keys[CLEARANCE].name, "is %.3g times a ball's diameter, and bearings have up to %g times",
                    values[CLEARANCE].number / ball, most);
}

const element_type ball_bearing_element = {
    .group = {"ball_bearing",
              "a ball bearing with Hertz contacts, clearance, and a stiffness that varies as balls pass",
              "Sunnersjo 1978; Fukata et al. 1985", keys, KEY_COUNT, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .turning = 1,
    .rounds = passes_of,
    .kinked = true,
    .kernels = kernels,
    .build = build,
    .carries = true,
    .doubt = doubt,
};
#endif
