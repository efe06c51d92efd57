// Ball and roller bearings, whose stiffness varies as their balls or rollers pass: keys, and the numbers of the kernel.
#include "rolling.h"

#define KERNEL_FILE "elements/supports/rolling_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES ROLLING_STATES
#define KERNEL_NUMBERS ROLLING_NUMBERS
#define KERNEL_SWITCHES 0

#include "generic.h"
#include "hertz.h"
#include "registry.h"

const element_kernels ISA(rolling_bearing_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>
#include <stdio.h>

/// Keys; those from CONTACT_ANGLE on are for balls only. The keys of a dent are its depth, width and place; that of a
/// ball has no place.
enum {
    AT,
    FROM,
    COUNT,
    STIFFNESS,
    CLEARANCE,
    INNER,
    OUTER,
    CAGE,
    SLIP,
    ANGLE,
    DAMPING,
    ROWS,
    STAGGERED,
    INNER_DENT,
    INNER_WIDTH,
    INNER_ANGLE,
    OUTER_DENT,
    OUTER_WIDTH,
    OUTER_ANGLE,
    OWN_DENT,
    OWN_WIDTH,
    CONTACT_ANGLE,
    CENTRES,
    AXIAL_LOAD,
    KEY_COUNT
};

#define DENT_KEYS(place, symbol)                                                                                       \
    CITED_NUMBER_KEY(place "_dent", "h_" symbol, "m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,                                \
                     "depth h of a dent, which reduces the approach by h (1 + cos(2 pi phi/w))/2",                     \
                     "Sassi et al. 2007"),                                                                             \
        NUMBER_KEY(place "_dent_width", "w_" symbol, "rad", OPTIONAL, WHIRL_POSITIVE,                                  \
                   "width w of the dent as an angle, at most 120 degrees")

#define RACE_DENT_KEYS(place, symbol)                                                                                  \
    DENT_KEYS(place, symbol), ANGLE_KEY(place "_dent_angle", "", place "_dent",                                        \
                                        "position of its middle at t = 0, from the x axis towards y")

/// Keys of a bearing with rolling elements `one`, plural `many`, whose force is proportional to a power of the
/// approach, as in the unit.
#define ROLLING_KEYS(one, many, unit, cited)                                                                           \
    [AT] = STATION_KEY("at", REQUIRED, "station that it carries"),                                                     \
    [FROM] = STATION_KEY("from", OPTIONAL, "station of the housing; absent: the ground"),                              \
    [COUNT] = WHOLE_KEY(many, "N_b", REQUIRED, WHIRL_FROM_TO(3, 64), "number of " many ", in a row"),                  \
    [STIFFNESS] = CITED_NUMBER_KEY("stiffness", "C_b", "1", REQUIRED, WHIRL_POSITIVE,                                  \
                                   "Hertz stiffness of a " one " between both races in " unit, cited),                 \
    [CLEARANCE] =                                                                                                      \
        NUMBER_KEY("clearance", "g_0", "m", DEFAULT("0"), WHIRL_ANY,                                                   \
                   "radial play of a " one ", half the bearing's internal clearance; below zero for a preload"),       \
    [INNER] = NUMBER_KEY("inner", "r_i", "m", OPTIONAL, WHIRL_POSITIVE, "radius of the inner race"),                   \
    [OUTER] = NUMBER_KEY("outer", "r_o", "m", OPTIONAL, WHIRL_POSITIVE, "radius of the outer race"),                   \
    [CAGE] = CITED_NUMBER_KEY("cage", "", "1", OPTIONAL, WHIRL_ANY,                                                    \
                              "speed of the cage over the rotor's, between those of its races, in place of the radii:" \
                              " r_i/(r_i + r_o) if the outer race does not turn",                                      \
                              "Harris 2001, ch. 8"),                                                                   \
    [SLIP] = CITED_NUMBER_KEY("slip", "s", "1", DEFAULT("0"), WHIRL_FROM_TO(0, 0.5),                                   \
                              "share by which the cage, and every " one " about its own axis, turns more slowly than " \
                              "by rolling: 0.01 to 0.02 is usual",                                                     \
                              "Randall, Antoni 2011"),                                                                 \
    [ANGLE] = ANGLE_KEY("angle", "theta_0", NULL, "position of a " one " at t = 0, from the x axis towards y"),        \
    [DAMPING] =                                                                                                        \
        NUMBER_KEY("damping", "c", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "viscous damping between the races"),    \
    [ROWS] = WHOLE_KEY("rows", "", DEFAULT("1"), WHIRL_FROM_TO(1, 8), "equal rows of " many " in one cage"),           \
    [STAGGERED] = CHOICE_OF_KEY("staggered", DEFAULT("yes"), "yes|no", "rows",                                         \
                                "yes: rows are staggered evenly; no: they are in line"),                               \
    [INNER_DENT] = RACE_DENT_KEYS("inner", "i"), [OUTER_DENT] = RACE_DENT_KEYS("outer", "o"),                          \
    [OWN_DENT] = DENT_KEYS(one, "b")

static const whirl_key ball_keys[KEY_COUNT] = {
    ROLLING_KEYS("ball", "balls", "N/m^1.5: force over approach to the power 3/2", "Harris 2001, ch. 6"),
    [CONTACT_ANGLE] =
        CITED_NUMBER_KEY("contact_angle", "alpha_0", "rad", DEFAULT("0"), WHIRL_FROM_TO(0, 1.0471975511965977),
                         "angle between the contacts and the radius, without load and clearance", "Harris 2001, ch. 7"),
    [CENTRES] = CITED_NUMBER_KEY("centres", "A", "m", OPTIONAL, WHIRL_POSITIVE,
                                 "distance between the centres of curvature of both grooves, (f_i + f_o - 1) times a "
                                 "ball's diameter; required with contact_angle or axial_load",
                                 "Harris 2001, ch. 2"),
    [AXIAL_LOAD] =
        CITED_NUMBER_KEY("axial_load", "F_a", "N", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                         "axial load on every row; the axial displacement that it causes alone stays constant",
                         "Harris 2001, ch. 7; Lim, Singh 1990"),
};

static const whirl_key roller_keys[CONTACT_ANGLE] = {
    ROLLING_KEYS("roller", "rollers", "N/m^(10/9): force over approach to the power 10/9",
                 "Palmgren 1959; Harris 2001, ch. 6"),
};

/// Computes the ratios of both races' speeds to the rotor's. A housing that is no station of a shaft is fixed.
static void find_races(const key_value *values, const assembly *to, double races[2]) {
    races[0] = to->stations[values[AT].station[0]].ratio;
    races[1] = values[FROM].given ? assembly_housing_ratio(to, values[FROM].station[0]) : 0.0;
}

/// Computes the ratio of the cage's speed for balls that roll: the mean of both races' velocities divided by the mean
/// of their radii.
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

/// Sets the rates by tau from that of the cage. A ball rolls on the inner race. The share of the inner race's radius in
/// the sum of both radii is also the share of its speed in the cage's; 0 if unknown. Slip reduces both rates.
static void set_rates(const key_value *values, const double races[2], double cage, double obliquity, double *number) {
    const double radii = values[INNER].number / (values[INNER].number + values[OUTER].number);
    const double share = values[CAGE].given ? (cage - races[1]) / (races[0] - races[1]) : radii;
    const double ball = (1.0 - 2.0 * share) / (2.0 * cos(obliquity)), rolls = 1.0 - values[SLIP].number;
    number[ROLLING_RATES] = rolls * cage;
    number[ROLLING_SPEEDS + DENT_INNER] = races[0];
    number[ROLLING_SPEEDS + DENT_OUTER] = races[1];
    number[ROLLING_SPEEDS + DENT_BALL] = ball > 0.0 ? rolls * (races[0] - cage) * share / ball : 0.0;
}

// ---------------------------------------------------------------- oblique contacts

/// Lengths in metres, with the shaft in the middle of the row.
typedef struct oblique {
    double centres, radial, axial; ///< distance A of both grooves' centres; its parts along the radius and the axis
                                   ///< under load
} oblique;

/// Returns the compression of balls along their contacts.
static double approach(const oblique *o) {
    return hypot(o->radial, o->axial) - o->centres;
}

/// Returns the force along the axis of all balls of a row.
static double thrust(const key_value *values, const oblique *o) {
    const double depth = fmax(approach(o), 0.0);
    return values[COUNT].number * values[STIFFNESS].number * depth * sqrt(depth) * o->axial /
           hypot(o->radial, o->axial);
}

/// Finds the axial displacement at which the row carries the load, by bisection: the thrust grows with it.
static oblique find_oblique(const key_value *values) {
    const double centres = values[CENTRES].number, angle = values[CONTACT_ANGLE].number;
    oblique o = {centres, centres * cos(angle) - values[CLEARANCE].number, centres * sin(angle)};
    if (!(values[AXIAL_LOAD].number > 0.0)) return o;
    double low = o.axial, high = low + centres;
    for (o.axial = high; thrust(values, &o) < values[AXIAL_LOAD].number; o.axial = high) high *= 2.0;
    for (int i = 0; i < 200 && low < high; i++) {
        o.axial = 0.5 * (low + high);
        *(thrust(values, &o) < values[AXIAL_LOAD].number ? &low : &high) = o.axial;
    }
    return o;
}

static whirl_status set_oblique(const key_value *values, double length, element *out, double *angle) {
    *angle = 0.0;
    if (!values[CENTRES].given && !values[CONTACT_ANGLE].given && !values[AXIAL_LOAD].given) return whirl_ok();
    if (!values[CENTRES].given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has %s without centres, expected the distance between the centres of both grooves as well",
                          ball_keys[values[CONTACT_ANGLE].given ? CONTACT_ANGLE : AXIAL_LOAD].name);
    const oblique o = find_oblique(values);
    if (!(o.radial > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has a clearance of %g m, expected less than %g m, the radial part of centres",
                          values[CLEARANCE].number, o.radial + values[CLEARANCE].number);
    const double A = o.centres / length, radial = o.radial / length, axial = o.axial / length;
    *angle = atan2(o.axial, o.radial);
    out->law |= ROLLING_OBLIQUE;
    out->number[ROLLING_CENTRES] = A;
    out->number[ROLLING_RADIAL] = radial;
    out->number[ROLLING_AXIAL_SQUARE] = axial * axial;
    out->number[ROLLING_SPARE] = (hypot(radial, axial) - A) * (hypot(radial, axial) + A);
    return whirl_ok();
}

// ---------------------------------------------------------------- dents

static const int dent_keys[DENTS] = {INNER_DENT, OUTER_DENT, OWN_DENT};

static whirl_status set_dent(const key_value *values, const whirl_key *keys, size_t which, double length,
                             double *number) {
    const key_value *dent = &values[dent_keys[which]], *width = dent + 1;
    const double widest = 2.0943951023931957;
    if (width->given != dent->given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s without %s, expected both",
                          keys[dent_keys[which] + width->given].name, keys[dent_keys[which] + !width->given].name);
    if (width->given && width->number > widest * (1.0 + 1e-12))
        return whirl_fail(WHIRL_BAD_INPUT, "has a dent of %g rad, expected at most %g rad, 120 degrees", width->number,
                          widest);
    number[ROLLING_DEPTH + which] = dent->number / length;
    number[ROLLING_OVER_WIDTH + which] = width->given ? 6.283185307179586476925 / width->number : 1.0;
    number[ROLLING_EDGE + which] = width->given ? cos(0.5 * width->number) : 2.0;
    number[ROLLING_RATES + 1 + which] = width->given ? number[ROLLING_SPEEDS + which] : 0.0;
    if (which != DENT_BALL) number[ROLLING_DENT_START + which] = dent[2].number;
    return whirl_ok();
}

static whirl_status set_dents(const key_value *values, const whirl_key *keys, double length, element *out,
                              bool *dented) {
    whirl_status status = whirl_ok();
    for (size_t which = 0; which < DENTS && status.code == WHIRL_OK; which++) {
        status = set_dent(values, keys, which, length, out->number);
        *dented = *dented || values[dent_keys[which]].given; // also for depth 0: a sweep may begin there
    }
    if (status.code != WHIRL_OK || !*dented) return status;
    if (values[ROWS].number > 1.0)
        return whirl_fail(WHIRL_BAD_INPUT, "has dents and %g rows, expected one row", values[ROWS].number);
    if (!values[OWN_DENT].given) return status;
    out->law |= ROLLING_BALL_DENT;
    if (out->number[ROLLING_SPEEDS + DENT_BALL] == 0.0)
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "has a dent in a rolling element, whose rotation does not follow from cage, expected inner and "
            "outer in place of cage");
    return status;
}

// ---------------------------------------------------------------- the element

/// Returns the number of periods of the forces by a state in a revolution: balls without dents are equal, so that a
/// turn of the cage has as many periods as there are balls.
static double rounds_of(const element *own, size_t state) {
    const bool alike = state == 0 && !(own->law & ROLLING_BALL_DENT);
    return (alike ? own->law & ROLLING_COUNT : 1) * own->number[ROLLING_RATES + state];
}

/// Returns the orders of the cage, of a ball about its own axis, of balls passing a place of each race and, with a
/// fixed outer race, passing a fixed load.
static bool rolling_bearing_named_order(const element *own, size_t index, double *order, const char **name) {
    static const char *const names[] = {"FTF", "BSF", "BPFO", "BPFI", "BPF"};
    const double *speeds = own->number + ROLLING_SPEEDS, cage = own->number[ROLLING_RATES];
    const double balls = own->law & ROLLING_COUNT, outer = speeds[DENT_OUTER], inner = speeds[DENT_INNER];
    const double orders[] = {cage, speeds[DENT_BALL], balls * (cage - outer), balls * (inner - cage),
                             outer == 0.0 ? 0.0 : balls * cage};
    for (size_t i = 0; i < sizeof orders / sizeof *orders; i++) {
        if (orders[i] == 0.0 || index-- > 0) continue;
        *order = fabs(orders[i]);
        *name = names[i];
        return true;
    }
    return false;
}

static void rolling_bearing_note(const element *own, double length, double clock, char *text, size_t size) {
    const char *name;
    double order;
    size_t used = 0;
    (void)length, (void)clock;
    for (size_t i = 0; used < size && rolling_bearing_named_order(own, i, &order, &name); i++)
        used += (size_t)snprintf(text + used, size - used, "%s%s %.4gX", i ? ", " : "", name, order);
}

/// Returns the compression of the rolling element under the load.
static double depth_at(const element *own, double radius) {
    const double *number = own->number;
    const double reach = radius + number[ROLLING_RADIAL];
    return own->law & ROLLING_OBLIQUE ? sqrt(reach * reach + number[ROLLING_AXIAL_SQUARE]) - number[ROLLING_CENTRES]
                                      : radius - number[ROLLING_GAP];
}

/// Describes the range of the Hertz pressure, which is proportional to the load to the power 1/3, for rollers 1/2.
static bool rolling_bearing_range(const element *own, size_t index, const element_seen *seen, element_range *out) {
    const bool line = own->law & ROLLING_LINE;
    const double most = line ? HERTZ_MAX_ROLLER : HERTZ_MAX_BALL, yield = own->number[ROLLING_YIELD];
    const double share = depth_at(own, seen->radius) / yield, power = line ? 5.0 / 9.0 : 0.5;
    *out = (element_range){"Hertz pressure", "Pa", "to which contacts are elastic", most, NAN};
    out->reached = share < 0.0 ? 0.0 : most * pow(share, power);
    return index == 0 && yield > 0.0;
}

KERNELS_OF_EVERY_ISA(rolling_bearing_kernels);

static void doubt_sizes(const key_value *values, const whirl_key *keys, const doubt_teller *to) {
    const double ball = values[OUTER].number - values[INNER].number, most = 0.01;
    if (values[INNER].given && fabs(values[CLEARANCE].number) > most * ball)
        doubt_value(to, keys[CLEARANCE].name, "is %.3g times a ball's diameter, and bearings have up to %g times",
                    values[CLEARANCE].number / ball, most);
    for (size_t which = 0; which < DENTS && values[INNER].given; which++)
        if (values[dent_keys[which]].number > most * ball)
            doubt_value(to, keys[dent_keys[which]].name,
                        "is %.3g times a ball's diameter: beyond %g times the ball falls into it, with an "
                        "inertia that the law leaves out",
                        values[dent_keys[which]].number / ball, most);
}

static void doubt_rollers(const key_value *values, double speed, const doubt_teller *to) {
    (void)speed;
    doubt_sizes(values, roller_keys, to);
}

static void doubt_balls(const key_value *values, double speed, const doubt_teller *to) {
    const double steep = 50.0, degree = 0.017453292519943295;
    (void)speed;
    doubt_sizes(values, ball_keys, to);
    if (!values[CENTRES].given) return;
    const oblique o = find_oblique(values);
    const double angle = atan2(o.axial, o.radial) / degree;
    if (angle > steep)
        doubt_value(to, "axial_load", "is so high that balls touch at %.3g degrees, and shoulders end at about %g",
                    angle, steep);
}

#define ROLLING_TYPE(name, text, source, keys, states, own_kernels, own_build, own_doubt)                              \
    {                                                                                                                  \
        .group = {name, text, source, keys, sizeof keys / sizeof *keys, NULL, NULL},                                   \
        .number_count = KERNEL_NUMBERS + KERNEL_PORTS, .state_count = states, .turning = states, .rounds = rounds_of,  \
        .kinked = true, .kernels = own_kernels, .build = own_build, .carries = true,                                   \
        .named_order = rolling_bearing_named_order, .range = rolling_bearing_range, .note = rolling_bearing_note,      \
        .doubt = own_doubt,                                                                                            \
    }
#define BALL_TYPE(states, own_kernels, own_build)                                                                      \
    ROLLING_TYPE("ball_bearing",                                                                                       \
                 "a ball bearing with Hertz contacts, clearance, and a stiffness that varies as balls pass",           \
                 "Sunnersjo 1978; Fukata et al. 1985", ball_keys, states, own_kernels, own_build, doubt_balls)
#define ROLLER_TYPE(states, own_kernels, own_build)                                                                    \
    ROLLING_TYPE("roller_bearing",                                                                                     \
                 "a bearing of cylindrical rollers, clearance, and a stiffness that varies as rollers pass",           \
                 "Palmgren 1959; Harris 2001", roller_keys, states, own_kernels, own_build, doubt_rollers)

static const element_type dented_balls = BALL_TYPE(DENTED_STATES, dented_kernels, NULL);
static const element_type dented_rollers = ROLLER_TYPE(DENTED_STATES, dented_kernels, NULL);

/// Returns the compression at which a rolling element yields, m. Radii of grooves follow from the distance of their
/// centres.
static double yield_depth(const key_value *values, bool line) {
    const double race = values[INNER].number, diameter = values[OUTER].number - race,
                 stiffness = values[STIFFNESS].number;
    const double groove = !line && values[CENTRES].given ? 0.5 * (values[CENTRES].number / diameter + 1.0) : 0.52;
    if (!values[INNER].given || !(groove > 0.5)) return 0.0;
    return line ? pow(hertz_roller_load(diameter, race, stiffness) / stiffness, 0.9)
                : pow(hertz_ball_load(diameter, race, groove) / stiffness, 2.0 / 3.0);
}

/// Builds a bearing of one kind, by its table of keys and its law.
static whirl_status rolling_bearing_build(const key_value *values, const whirl_key *keys, int law, assembly *to,
                                          element *out) {
    const bool staggered = values[STAGGERED].choice == 0, line = law & ROLLING_LINE;
    const double rows = values[ROWS].number, balls = values[COUNT].number * (staggered ? rows : 1.0);
    const double length = to->length, apart = 6.283185307179586476925 / balls;
    double ratio, races[2], *number = out->number, obliquity = 0.0;
    bool dented = false;
    whirl_status status = element_in_housing(&values[AT], &values[FROM], to, out);
    if (status.code != WHIRL_OK) return status;
    // Compute the rates of cage and rolling elements, and the dents, from the geometry.
    find_races(values, to, races);
    status = cage_ratio(values, races, &ratio);
    out->law = law | (int)balls;
    if (status.code == WHIRL_OK && !line) status = set_oblique(values, length, out, &obliquity);
    if (status.code != WHIRL_OK) return status;
    set_rates(values, races, ratio, obliquity, number);
    status = set_dents(values, keys, length, out, &dented);
    if (dented) out->type = line ? &dented_rollers : &dented_balls;
    for (size_t i = ROLLING_RATES; i < ROLLING_DEPTH; i++) number[i] *= to->turn;
    // Compute the numbers of the contact, in the rotor's units.
    number[ROLLING_STIFFNESS] = values[STIFFNESS].number * (staggered ? 1.0 : rows) *
                                (line ? length * pow(length, 1.0 / 9.0) : length * sqrt(length));
    number[ROLLING_GAP] = values[CLEARANCE].number / length;
    number[ROLLING_START] = values[ANGLE].number;
    number[ROLLING_YIELD] = yield_depth(values, line) / length;
    number[ROLLING_APART_COS] = cos(apart);
    number[ROLLING_APART_SIN] = sin(apart);
    generic_scale(out, to, 1.0);
    // Add the damping to the matrices.
    for (int a = 0; a < KERNEL_AXES; a++)
        assembly_damper(to, out->port[a], out->port[KERNEL_AXES + a], values[DAMPING].number);
    return status;
}

static whirl_status build_balls(const key_value *values, assembly *to, element *out) {
    return rolling_bearing_build(values, ball_keys, 0, to, out);
}

static whirl_status build_rollers(const key_value *values, assembly *to, element *out) {
    return rolling_bearing_build(values, roller_keys, ROLLING_LINE, to, out);
}

const element_type ball_bearing_element = BALL_TYPE(ROLLING_STATES, kernels, build_balls);
const element_type roller_bearing_element = ROLLER_TYPE(ROLLING_STATES, kernels, build_rollers);
#endif
