// A harmonic force, moment, torque or axial force from outside, at the speed of the shaft or with its own phase.
#define KERNEL_FILE "elements/loads/harmonic_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 1
#define KERNEL_NUMBERS HARMONIC_OWN
#define KERNEL_SWITCHES 0

#include "harmonic.h"

#include "generic.h"
#include "registry.h"

const element_kernels ISA(force_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum {
    AT,
    AMPLITUDE,
    MOMENT,
    TORQUE,
    AXIAL,
    STEADY_FORCE,
    STEADY_TORQUE,
    STEADY_AXIAL,
    LAW,
    ANGLE,
    PHASE,
    RATIO,
    FREQUENCY,
    KEYPHASOR,
    KEY_COUNT
};

/// Sense of rotation of each law: along an axis, forward, backward.
static const double sides[] = {0.0, 1.0, -1.0};

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station on which the force acts"),
    [AMPLITUDE] =
        NUMBER_KEY("amplitude", "F", "N", OPTIONAL, WHIRL_ANY, "amplitude of a force, zero to peak; this or moment"),
    [MOMENT] = NUMBER_KEY("moment", "M", "N m", OPTIONAL, WHIRL_ANY,
                          "amplitude of a moment that tilts the station, zero to peak, in place of amplitude"),
    [TORQUE] =
        NUMBER_KEY("torque", "T", "N m", OPTIONAL, WHIRL_ANY,
                   "amplitude of a torque that twists the station, zero to peak, in place of amplitude; along the "
                   "rotation"),
    [AXIAL] = NUMBER_KEY("axial", "F_a", "N", OPTIONAL, WHIRL_ANY,
                         "amplitude of a force along the shaft, zero to peak, in place of amplitude; in the direction "
                         "in which positions grow"),
    [STEADY_FORCE] = NUMBER_KEY("steady_force", "F_0", "N", OPTIONAL, WHIRL_ANY,
                                "constant force along the angle, alone or with amplitude"),
    [STEADY_TORQUE] = NUMBER_KEY("steady_torque", "T_0", "N m", OPTIONAL, WHIRL_ANY,
                                 "constant torque along the rotation, alone or with torque"),
    [STEADY_AXIAL] = NUMBER_KEY("steady_axial", "F_a0", "N", OPTIONAL, WHIRL_ANY,
                                "constant force along the shaft, such as a thrust, alone or with axial"),
    [LAW] = CHOICE_KEY("law", DEFAULT("axis"), "axis|forward|backward",
                       "axis: to and fro along one direction; forward: turns as the shaft does; backward: against it"),
    [ANGLE] = ANGLE_KEY("angle", "phi", NULL,
                        "direction of its axis, or of the turning force at phase 0; from the x axis towards y"),
    [PHASE] = ANGLE_KEY("phase", "delta", NULL, "phase at t = 0; at phase 0 the force is largest along its direction"),
    [RATIO] = NUMBER_KEY("ratio", "rho", "1", DEFAULT("1"), WHIRL_ABOVE_TO(0.0, HARMONIC_FASTEST),
                         "frequency over the speed of the shaft"),
    [FREQUENCY] = NUMBER_KEY("frequency", "f", "Hz", OPTIONAL, WHIRL_POSITIVE,
                             "frequency that does not depend on the speed, in place of ratio"),
    [KEYPHASOR] = HARMONIC_KEYPHASOR,
};

FOR_EVERY_ISA(const element_kernels, force_kernels);
const element_kernels *const harmonic_kernels[VECTOR_ISAS] = EVERY_ISA(&, force_kernels);

double harmonic_rounds(const element *own, size_t state) {
    (void)state;
    return own->number[HARMONIC_RATE];
}

void harmonic_force(element *out, const assembly *to, double size, double side, double angle, double phase,
                    double rate) {
    const double direction[2] = {cos(angle), sin(angle)}, across[2] = {-sin(angle), cos(angle)};
    // The sense of the shaft's rotation does not change the force: cos(phase + tau) = cos(-phase - tau).
    phase = copysign(1.0, to->turn) * phase;
    // The force along its direction is cos(theta + phase); across, on the side to which it turns, sin(theta + phase).
    for (size_t a = 0; a < 2; a++) {
        out->number[2 * a] = size * (direction[a] * cos(phase) + side * across[a] * sin(phase));
        out->number[2 * a + 1] = size * (-direction[a] * sin(phase) + side * across[a] * cos(phase));
    }
    out->number[HARMONIC_RATE] = rate;
    generic_scale(out, to, 1.0);
}

whirl_status harmonic_check_rate(const assembly *to, double rate) {
    const double turns = fabs(rate * to->turn);
    if (!to->in_time || assembly_stands(to) || turns <= HARMONIC_FASTEST) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT,
                      "turns %.4g times in a revolution, expected at most %g times in motions: a higher speed, or "
                      "keyphasor: yes, which counts revolutions by its own phase",
                      turns, HARMONIC_FASTEST);
}

bool harmonic_order(const element *own, size_t index, double *order) {
    *order = fabs(own->number[HARMONIC_RATE]);
    return index == 0 && *order > 1.0;
}

static bool force_named_order(const element *own, size_t index, double *order, const char **name) {
    *name = "force";
    return harmonic_order(own, index, order);
}

static bool is_torque(const key_value *values) {
    return values[TORQUE].given || values[STEADY_TORQUE].given;
}

static bool is_axial(const key_value *values) {
    return values[AXIAL].given || values[STEADY_AXIAL].given;
}

static whirl_status find_ports(const key_value *values, const assembly *to, element *out) {
    const bool tilts = values[MOMENT].given;
    if (is_torque(values)) {
        out->station = values[AT].station[0];
        const whirl_status status = assembly_find(to, out->station, AXIS_TWIST, &out->port[0]);
        if (status.code == WHIRL_OK) out->share[0] = assembly_share(to, out->station, AXIS_TWIST);
        return status;
    }
    if (is_axial(values)) {
        out->station = values[AT].station[0];
        return assembly_find(to, out->station, AXIS_AXIAL, &out->port[0]);
    }
    element_on(&values[AT], to, tilts ? AXIS_TILT_X : AXIS_X, out);
    // A station that moves along one axis feels the component along this axis.
    return tilts ? assembly_find(to, out->station, AXIS_TILT_X, &out->port[0]) : whirl_ok();
}

static whirl_status force_check(const key_value *values) {
    const bool force = values[AMPLITUDE].given || values[STEADY_FORCE].given, moment = values[MOMENT].given;
    const bool torque = is_torque(values), axial = is_axial(values);
    if (force + moment + torque + axial != 1)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has %s, expected one: a force (amplitude, steady_force), a moment, a torque (torque, "
                          "steady_torque), or an axial force (axial, steady_axial)",
                          force || moment || torque || axial ? "more than one load" : "no load");
    if ((torque || axial) && (values[LAW].choice != 0 || values[ANGLE].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has %s and %s, which acts %s the shaft's axis, expected none",
                          values[ANGLE].given ? "an angle" : "a law", torque ? "a torque" : "an axial force",
                          torque ? "about" : "along");
    if (values[RATIO].given && values[FREQUENCY].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has both ratio and frequency, expected one of them");
    return whirl_ok();
}

/// Adds the constant force along the angle or along the shaft, or the constant torque about the shaft's axis.
static void add_steady(const key_value *values, assembly *to, const element *out) {
    const double direction[2] = {cos(values[ANGLE].number), sin(values[ANGLE].number)};
    for (size_t a = 0; a < 2; a++) {
        if (out->port[a] == NO_COORDINATE) continue;
        const double load = is_torque(values)  ? copysign(1.0, to->turn) * out->share[a] * values[STEADY_TORQUE].number
                            : is_axial(values) ? values[STEADY_AXIAL].number
                                               : direction[a] * values[STEADY_FORCE].number;
        if (load == 0.0) continue;
        assembly_term(to, (linear_term){out->port[a], SOURCE_ONE, 0, load / assembly_force_scale(to, out->port[a])});
    }
}

/// Registers the torques, to which the twists respond at their own frequency.
static void force_note_torque(const key_value *values, assembly *to) {
    const double sense = copysign(1.0, to->turn);
    harmonic_torque own = {.station = values[AT].station[0], .about_z = true, .count = 1};
    if (values[TORQUE].given) {
        own.of = values[FREQUENCY].given ? HARMONIC_FIXED : HARMONIC_BY_ROTOR;
        own.rate = values[FREQUENCY].given ? 6.283185307179586476925 * values[FREQUENCY].number : values[RATIO].number;
        own.phase = values[PHASE].number;
        own.torques[0] = sense * values[TORQUE].number;
        assembly_harmonic(to, &own);
    }
    if (!values[STEADY_TORQUE].given) return;
    own = (harmonic_torque){.station = own.station, .about_z = true, .felt = true, .count = 1};
    own.torques[0] = sense * values[STEADY_TORQUE].number;
    assembly_harmonic(to, &own);
}

static whirl_status force_build(const key_value *values, assembly *to, element *out) {
    const double per_hertz = 6.283185307179586476925 / to->pace;
    const double rate = values[FREQUENCY].given ? values[FREQUENCY].number * per_hertz : values[RATIO].number;
    whirl_status status = force_check(values);
    if (status.code == WHIRL_OK) status = find_ports(values, to, out);
    if (status.code == WHIRL_OK) status = harmonic_check_rate(to, rate);
    if (status.code != WHIRL_OK) return status;
    const int size = values[MOMENT].given ? MOMENT : is_torque(values) ? TORQUE : is_axial(values) ? AXIAL : AMPLITUDE;
    add_steady(values, to, out);
    if (is_torque(values)) force_note_torque(values, to);
    const double sense = is_torque(values) ? copysign(1.0, to->turn) : 1.0;
    harmonic_force(out, to, values[size].given ? sense * values[size].number : 0.0, sides[values[LAW].choice],
                   values[ANGLE].number, values[PHASE].number, rate * to->turn);
    out->lumped = (!values[RATIO].given && !values[FREQUENCY].given) || !values[size].given;
    for (size_t a = 0; a < 2 && out->lumped; a++) {
        assembly_forcing(to, out->port[a], COS_TAU, out->share[a] * out->number[2 * a]);
        assembly_forcing(to, out->port[a], SIN_TAU, out->share[a] * out->number[2 * a + 1]);
    }
    return whirl_ok();
}

static double force_keyphasor(const key_value *values, double speed) {
    if (!values[KEYPHASOR].choice) return 0.0;
    return values[FREQUENCY].given ? values[FREQUENCY].number * 6.283185307179586476925 : values[RATIO].number * speed;
}

const element_type force_element = {
    .group = {"force",
              "a harmonic force across or along the shaft, moment or torque, at a ratio of the speed or a fixed "
              "frequency, and a constant one",
              "", keys, KEY_COUNT, NULL, NULL},
    .number_count = HARMONIC_NUMBERS,
    .state_count = KERNEL_STATES,
    .turning = 1,
    .rounds = harmonic_rounds,
    .named_order = force_named_order,
    .kernels = harmonic_kernels,
    .build = force_build,
    .keyphasor = force_keyphasor,
};
#endif
