// A spring and damper with play between two stations, or between a station and the ground.
#define KERNEL_FILE "elements/supports/spring_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 0
#define KERNEL_NUMBERS SPRING_NUMBERS
#define KERNEL_SWITCHES 4
#define KERNEL_TILTS

/// Numbers in newtons and length scales; for tilts in N m and the unit of the first tilt; then this unit, m or rad.
enum { SPRING_STIFFNESS, SPRING_DAMPING, SPRING_GAP, SPRING_UNIT, SPRING_NUMBERS };

#include "elements/along.h"
#include "generic.h"
#include "registry.h"

const element_kernels ISA(spring_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

enum { BETWEEN, ALONG, STIFFNESS, DAMPING, GAP, GAP_ANGLE, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED, "the two stations that it joins; one may be ground"),
    [ALONG] = ALONG_KEY,
    [STIFFNESS] = NUMBER_KEY("stiffness", "k", "N/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                             "stiffness; along tilts and twist in N m per radian"),
    [DAMPING] = NUMBER_KEY("damping", "c", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                           "damping; along tilts and twist in N m s per radian"),
    [GAP] = NUMBER_KEY("gap", "g", "m", OPTIONAL, WHIRL_NOT_NEGATIVE,
                       "play to either side, within which no force acts; absent: no play"),
    [GAP_ANGLE] = NUMBER_KEY("gap_angle", "", "rad", OPTIONAL, WHIRL_NOT_NEGATIVE,
                             "play to either side along tilts or twist, in place of gap; absent: no play"),
};

static whirl_status spring_build(const key_value *values, assembly *to, element *out) {
    const double stiffness = values[STIFFNESS].number, damping = values[DAMPING].number;
    const int along = values[ALONG].choice;
    whirl_status status = check_along(&keys[GAP], &values[GAP], false, along);
    if (status.code == WHIRL_OK) status = check_along(&keys[GAP_ANGLE], &values[GAP_ANGLE], true, along);
    if (status.code == WHIRL_OK) status = element_between(&values[BETWEEN], to, axes_along[along], KERNEL_AXES, out);
    if (status.code != WHIRL_OK) return status;
    const key_value *gap = &values[along_tilts(along) ? GAP_ANGLE : GAP];
    out->lumped = !gap->given;
    for (size_t a = 0; out->lumped && a < KERNEL_AXES; a++) {
        const size_t coordinate[2] = {out->port[a], out->port[KERNEL_AXES + a]};
        const double share[2] = {out->share[a], out->share[KERNEL_AXES + a]};
        assembly_join(to, coordinate, share, &(joining){.stiffness = stiffness, .damping = damping});
    }
    const double unit = generic_tilts(out, to);
    out->law = damping > 0.0;
    out->number[SPRING_STIFFNESS] = stiffness * unit;
    out->number[SPRING_DAMPING] = damping * unit * to->clock;
    out->number[SPRING_GAP] = gap->number / unit;
    out->number[SPRING_UNIT] = unit;
    return whirl_ok();
}

/// Finds the torque of a spring along the twist, as its kernel computes it along its first axis.
static void spring_carry(const element *own, const element_place *at, element_carried *out) {
    const double *n = own->number;
    *out = (element_carried){.unit = n[SPRING_UNIT],
                             .lever = {-1.0, 1.0},
                             .play = n[SPRING_GAP],
                             .stiffness = n[SPRING_STIFFNESS],
                             .damping = n[SPRING_DAMPING]};
    out->closing[0] = unit_of(own, 0);
    out->closing[KERNEL_AXES] = -unit_of(own, KERNEL_AXES);
    const double closing = out->closing[0] * at->q[0] + out->closing[KERNEL_AXES] * at->q[KERNEL_AXES];
    const double rate = out->closing[0] * at->v[0] + out->closing[KERNEL_AXES] * at->v[KERNEL_AXES];
    out->open = fabs(closing) <= n[SPRING_GAP];
    if (!out->open) out->force = out->stiffness * (closing - copysign(n[SPRING_GAP], closing)) + out->damping * rate;
}

/// Returns true if the force jumps as the play ends: there is damping.
static bool spring_jumps(const element *own) {
    return own->law != 0;
}

KERNELS_OF_EVERY_ISA(spring_kernels);

const element_type spring_element = {
    .group = {"spring", "a spring and damper between two stations or a station and the ground, with or without play",
              "", keys, KEY_COUNT, NULL, NULL},
    .number_count = KERNEL_NUMBERS + 2 * KERNEL_PORTS,
    .kernels = kernels,
    .build = spring_build,
    .jumps = spring_jumps,
    .carry = spring_carry,
    .carries_as = WHIRL_TORQUE_WITH_PLAY,
    GENERIC_SWITCHES,
};
#endif
