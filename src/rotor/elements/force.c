// A harmonic force or moment from outside, at the speed of the shaft or with a phase of its own.
#define KERNEL_FILE "elements/harmonic_kernel.h"
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

enum { AT, AMPLITUDE, MOMENT, LAW, ANGLE, PHASE, RATIO, FREQUENCY, KEY_COUNT };
enum { LAW_AXIS, LAW_FORWARD, LAW_BACKWARD };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = {"at", "", "", WHIRL_KEY_STATION, true, "", WHIRL_ANY, NULL, "station that it acts on", ""},
    [AMPLITUDE] = {"amplitude", "F", "N", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL,
                   "of a force, zero to peak; or moment", ""},
    [MOMENT] = {"moment", "M", "N m", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL,
                "of a moment that tilts the station, zero to peak, in place of amplitude", ""},
    [LAW] = {"law", "", "", WHIRL_KEY_CHOICE, false, "axis", WHIRL_ANY, "axis|forward|backward",
             "axis: to and fro along one direction; forward: turns as the shaft does; backward: against it", ""},
    [ANGLE] = {"angle", "phi", "rad", WHIRL_KEY_NUMBER, false, "0", WHIRL_ANY, NULL,
               "direction of its axis, or where it points at phase 0; from the x axis towards y", ""},
    [PHASE] = {"phase", "delta", "rad", WHIRL_KEY_NUMBER, false, "0", WHIRL_ANY, NULL,
               "phase at t = 0; at phase 0 it is largest along its direction", ""},
    [RATIO] = {"ratio",
               "rho",
               "1",
               WHIRL_KEY_NUMBER,
               false,
               "1",
               {0.0, HARMONIC_FASTEST, true, false},
               NULL,
               "its frequency over the speed of the shaft",
               ""},
    [FREQUENCY] = {"frequency", "f", "Hz", WHIRL_KEY_NUMBER, false, "", WHIRL_POSITIVE, NULL,
                   "frequency that does not depend on the speed, in place of ratio", ""},
};

FOR_EVERY_ISA(const element_kernels, force_kernels);
const element_kernels *const harmonic_kernels[VECTOR_ISAS] = EVERY_ISA(&, force_kernels);

double harmonic_rounds(const element *own) {
    return own->number[HARMONIC_RATE];
}

/// Scales the force of `own` and sets its rate.
static void set_rate(element *own, const assembly *to, double rate) {
    own->number[HARMONIC_RATE] = rate;
    generic_scale(own, to, 1.0);
}

void harmonic_turning(element *out, const assembly *to, double size, double angle, double rate) {
    out->number[HARMONIC_XC] = out->number[HARMONIC_YS] = size * cos(angle);
    out->number[HARMONIC_YC] = size * sin(angle);
    out->number[HARMONIC_XS] = -size * sin(angle);
    set_rate(out, to, rate);
}

/// The parts of the force at phase theta: those of cos theta and sin theta along x, then along y.
static void set_parts(const key_value *values, double size, double parts[4]) {
    const double angle = values[ANGLE].number, phase = values[PHASE].number;
    const double direction[2] = {cos(angle), sin(angle)}, across[2] = {-sin(angle), cos(angle)};
    // Along its direction cos(theta + phase); across, on the side to which it turns, sin(theta + phase).
    const double side = values[LAW].choice == LAW_AXIS ? 0.0 : values[LAW].choice == LAW_FORWARD ? 1.0 : -1.0;
    for (size_t a = 0; a < 2; a++) {
        parts[2 * a] = size * (direction[a] * cos(phase) + side * across[a] * sin(phase));
        parts[2 * a + 1] = size * (-direction[a] * sin(phase) + side * across[a] * cos(phase));
    }
}

static whirl_status find_ports(const key_value *values, const assembly *to, element *out) {
    const size_t station = values[AT].station[0], *at = to->stations[station].coordinate;
    const axis first = values[MOMENT].given ? AXIS_TILT_X : AXIS_X;
    out->station = station;
    out->port[0] = at[first];
    out->port[1] = at[first + 1];
    // A station that moves along one axis feels the part along it.
    return values[MOMENT].given ? assembly_find(to, station, AXIS_TILT_X, &out->port[0]) : whirl_ok();
}

static whirl_status check(const key_value *values) {
    if (values[AMPLITUDE].given == values[MOMENT].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s, expected one of them",
                          values[MOMENT].given ? "both amplitude and moment" : "neither amplitude nor moment");
    if (values[RATIO].given && values[FREQUENCY].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has both ratio and frequency, expected one of them");
    return whirl_ok();
}

static whirl_status build(const key_value *values, assembly *to, element *out) {
    const double per_hertz = 6.283185307179586476925 / to->speed;
    const double rate = values[FREQUENCY].given ? values[FREQUENCY].number * per_hertz : values[RATIO].number;
    whirl_status status = check(values);
    if (status.code == WHIRL_OK) status = find_ports(values, to, out);
    if (status.code != WHIRL_OK) return status;
    if (rate > HARMONIC_FASTEST)
        return whirl_fail(WHIRL_BAD_INPUT, "is %g times as fast as the shaft, expected at most %g times", rate,
                          HARMONIC_FASTEST);
    set_parts(values, values[MOMENT].given ? values[MOMENT].number : values[AMPLITUDE].number, out->number);
    out->lumped = !values[RATIO].given && !values[FREQUENCY].given;
    for (size_t a = 0; a < 2 && out->lumped; a++) {
        assembly_forcing(to, out->port[a], COS_TAU, out->number[2 * a]);
        assembly_forcing(to, out->port[a], SIN_TAU, out->number[2 * a + 1]);
    }
    set_rate(out, to, rate);
    return whirl_ok();
}

const element_type force_element = {
    .group = {"force", "a harmonic force or moment, at a ratio of the speed or a fixed frequency", "", keys, KEY_COUNT,
              NULL, NULL},
    .number_count = HARMONIC_NUMBERS,
    .state_count = KERNEL_STATES,
    .turning = 1,
    .rounds = harmonic_rounds,
    .kernels = harmonic_kernels,
    .build = build,
};
#endif
