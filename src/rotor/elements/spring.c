// A spring and damper between two stations, or a station and the ground, with play between them.
#define KERNEL_FILE "elements/spring_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 0
#define KERNEL_NUMBERS SPRING_NUMBERS
#define KERNEL_SWITCHES 4

/// In newtons and length scales.
enum { SPRING_STIFFNESS, SPRING_DAMPING, SPRING_GAP, SPRING_NUMBERS };

#include "generic.h"
#include "registry.h"

const element_kernels ISA(spring_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

enum { BETWEEN, ALONG, STIFFNESS, DAMPING, GAP, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED, "the two stations that it joins; one may be ground"),
    [ALONG] = CHOICE_KEY("along", DEFAULT("xy"), "xy|x|y|tilts",
                         "the axes along which it acts; tilts: between the slopes of the stations"),
    [STIFFNESS] = NUMBER_KEY("stiffness", "k", "N/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                             "stiffness; along tilts in N m per radian"),
    [DAMPING] = NUMBER_KEY("damping", "c", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                           "damping; along tilts in N m s per radian"),
    [GAP] = NUMBER_KEY("gap", "g", "m", OPTIONAL, WHIRL_NOT_NEGATIVE,
                       "play to either side, within which nothing acts; always joined where absent"),
};

enum { ALONG_XY, ALONG_X, ALONG_Y, ALONG_TILTS, ALONGS };

static const axis axes[ALONGS][KERNEL_AXES] = {[ALONG_XY] = {AXIS_X, AXIS_Y},
                                               [ALONG_X] = {AXIS_X, AXES},
                                               [ALONG_Y] = {AXES, AXIS_Y},
                                               [ALONG_TILTS] = {AXIS_TILT_X, AXIS_TILT_Y}};

static whirl_status build(const key_value *values, assembly *to, element *out) {
    const double stiffness = values[STIFFNESS].number, damping = values[DAMPING].number;
    if (values[GAP].given && values[ALONG].choice == ALONG_TILTS)
        return whirl_fail(WHIRL_BAD_INPUT, "has a gap along tilts, expected one along x and y");
    const whirl_status status = element_between(&values[BETWEEN], to, axes[values[ALONG].choice], KERNEL_AXES, out);
    if (status.code != WHIRL_OK) return status;
    out->lumped = !values[GAP].given;
    for (size_t a = 0; out->lumped && a < KERNEL_AXES; a++) {
        assembly_spring(to, out->port[a], out->port[KERNEL_AXES + a], stiffness);
        assembly_damper(to, out->port[a], out->port[KERNEL_AXES + a], damping);
    }
    out->law = values[DAMPING].given;
    out->number[SPRING_STIFFNESS] = stiffness * to->length;
    out->number[SPRING_DAMPING] = damping * to->length * to->clock;
    out->number[SPRING_GAP] = values[GAP].number / to->length;
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

/// Where damping is given the force jumps as the play ends.
static bool jumps(const element *own) {
    return own->law != 0;
}

KERNELS_OF_EVERY_ISA(spring_kernels);

const element_type spring_element = {
    .group = {"spring", "a spring and damper between two stations or a station and the ground, with or without play",
              "", keys, KEY_COUNT, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .kernels = kernels,
    .build = build,
    .jumps = jumps,
    GENERIC_SWITCHES,
};
#endif
