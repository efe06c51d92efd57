// A universal joint between two shafts at a fixed angle, and the moments that it causes twice a turn.
#define KERNEL_FILE "elements/shafts/joint_kernel.h"
#define KERNEL_AXES 4
#define KERNEL_STATES 0
#define KERNEL_NUMBERS JOINT_NUMBERS
#define KERNEL_SWITCHES 0
#define KERNEL_PHASED 1

/// Numbers: moments on the tilts of the driving shaft, then of the driven shaft, N m: each constant, by cos 2 tau, by
/// sin 2 tau; then the bend and the torque.
enum { JOINT_MOMENTS, JOINT_BEND = 3 * KERNEL_AXES, JOINT_TORQUE, JOINT_NUMBERS };

#include "generic.h"
#include "registry.h"

const element_kernels ISA(joint_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>
#include <stdio.h>

enum { BETWEEN, BEND, DIRECTION, YOKE, TORQUE, KEY_COUNT };

static const double right_angle = 1.57079632679489661923;

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED, "the ends of the driving and of the driven shaft; they tilt"),
    [BEND] = CITED_NUMBER_KEY("bend", "b", "rad", REQUIRED, WHIRL_NOT_NEGATIVE,
                              "constant angle between both shafts, below a right angle", "Hooke 1676"),
    [DIRECTION] =
        ANGLE_KEY("direction", "delta", NULL, "direction in which the driven shaft leans, from the x axis towards y"),
    [YOKE] = ANGLE_KEY("yoke", "phi", NULL,
                       "direction of the pin in the driving shaft's yoke at t = 0, from the x axis towards y"),
    [TORQUE] =
        CITED_NUMBER_KEY("torque", "T", "N m", REQUIRED, WHIRL_ANY,
                         "torque that the driving shaft transmits, along the rotation", "Seherr-Thoss et al. 2006"),
};

/// Adds a moment to the numbers of two tilts. Its components are along and across the direction in which the driven
/// shaft leans. Each component has a constant part and parts by cos 2p and by sin 2p, 2p = 2 tau + twice.
static void add_moment(double *number, double direction, double twice, const double along[3], const double across[3]) {
    const double c = cos(direction), s = sin(direction);
    for (int a = 0; a < 2; a++, number += 3) {
        double part[3];
        for (int i = 0; i < 3; i++) part[i] = a == 0 ? c * along[i] - s * across[i] : s * along[i] + c * across[i];
        number[0] = part[0];
        number[1] = part[1] * cos(twice) + part[2] * sin(twice);
        number[2] = part[2] * cos(twice) - part[1] * sin(twice);
    }
}

/// Builds the element. The cross passes on a moment along its normal a1 x (z2 x a1), where a1 = (cos p, sin p, 0) and
/// z2 = (sin b, 0, cos b); the moment's component along the driving shaft is T. The components across the shafts bend
/// them: T tan b sin p (-sin p, cos p) the driving shaft, and T (-sin b cos^2 p, -tan b sin p cos p) the driven shaft,
/// as moments about x and y. Moments (M_y, -M_x) turn tilts (dx/dz, dy/dz).
static whirl_status joint_build(const key_value *values, assembly *to, element *out) {
    static const axis axes[] = {AXIS_TILT_X, AXIS_TILT_Y};
    const double b = values[BEND].number, direction = values[DIRECTION].number;
    const double torque = values[TORQUE].number * copysign(1.0, to->turn);
    const double t = 0.5 * torque * tan(b), s = 0.5 * torque * sin(b), twice = 2.0 * (values[YOKE].number - direction);
    if (!(b < right_angle))
        return whirl_fail(WHIRL_BAD_INPUT, "has a bend of %g rad, expected less than a right angle", b);
    if (values[BETWEEN].station[0] == GROUND || values[BETWEEN].station[1] == GROUND)
        return whirl_fail(WHIRL_BAD_INPUT, "joins the ground, expected two stations");
    const whirl_status status = element_between(&values[BETWEEN], to, axes, 2, out);
    if (status.code != WHIRL_OK) return status;
    add_moment(out->number, direction, twice, (const double[3]){0.0, 0.0, t}, (const double[3]){t, -t, 0.0});
    add_moment(out->number + 6, direction, twice, (const double[3]){0.0, 0.0, -t}, (const double[3]){s, s, 0.0});
    out->number[JOINT_BEND] = b;
    out->number[JOINT_TORQUE] = values[TORQUE].number;
    generic_scale(out, to, 1.0);
    return status;
}

/// Describes how far the driven shaft runs ahead: p2 - p1 = t sin 2 p1 + t^2/2 sin 4 p1 + ..., t = tan^2(b/2).
static void joint_note(const element *own, double length, double clock, char *text, size_t size) {
    const double b = own->number[JOINT_BEND], half = tan(0.5 * b), t = half * half, torque = own->number[JOINT_TORQUE];
    (void)length, (void)clock;
    snprintf(text, size,
             "the driven shaft runs ahead by %.12g rad twice and %.12g rad four times a turn, at %.12g to %.12g of the "
             "driving one's speed; moments up to %.6g N m bend the driving shaft, %.6g N m the driven one",
             t, 0.5 * t * t, cos(b), 1.0 / cos(b), fabs(torque) * tan(b), fabs(torque) * sin(b));
}

static void joint_doubt(const key_value *values, double speed, const doubt_teller *to) {
    const double most = 0.7853981633974483;
    (void)speed;
    if (values[BEND].number > most)
        doubt_value(to, keys[BEND].name, "is %.3g degrees, and single joints go up to 45",
                    values[BEND].number * 90.0 / right_angle);
}

KERNELS_OF_EVERY_ISA(joint_kernels);

const element_type joint_element = {
    .group = {"joint", "a universal joint between two shafts at an angle that does not turn: moments twice a turn",
              "Seherr-Thoss, Schmelz, Aucktor 2006", keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .kernels = kernels,
    .build = joint_build,
    .note = joint_note,
    .doubt = joint_doubt,
};
#endif
