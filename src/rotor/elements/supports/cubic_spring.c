// A spring between two stations, or between a station and the ground, whose stiffness changes with the square of the
// displacement.
#define KERNEL_FILE "elements/supports/cubic_spring_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 0
#define KERNEL_NUMBERS CUBIC_NUMBERS
#define KERNEL_SWITCHES 0
#define KERNEL_TILTS

/// Numbers in newtons and length scales; for tilts in N m and the unit of the first tilt.
enum { CUBIC_STIFFNESS, CUBIC_CUBE, CUBIC_DAMPING, CUBIC_NUMBERS };

#include "elements/along.h"
#include "generic.h"
#include "registry.h"

const element_kernels ISA(cubic_spring_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

enum { BETWEEN, ALONG, STIFFNESS, CUBIC, DAMPING, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED, "the two stations that it joins; one may be ground"),
    [ALONG] = ALONG_KEY,
    [STIFFNESS] = NUMBER_KEY("stiffness", "k_1", "N/m", DEFAULT("0"), WHIRL_ANY,
                             "stiffness in the middle; along tilts in N m per radian; below 0: it buckles"),
    [CUBIC] = CITED_NUMBER_KEY("cubic", "k_3", "N/m3", REQUIRED, WHIRL_ANY,
                               "stiffness over the square of the displacement; along tilts in N m per cubic radian; "
                               "below 0: it softens",
                               "Duffing 1918; Ishida, Yamamoto 2012, ch. 6"),
    [DAMPING] = NUMBER_KEY("damping", "c", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                           "damping; along tilts in N m s per radian"),
};

static whirl_status cubic_spring_build(const key_value *values, assembly *to, element *out) {
    const axis *axes = axes_along[values[ALONG].choice];
    const whirl_status status = element_between(&values[BETWEEN], to, axes, KERNEL_AXES, out);
    if (status.code != WHIRL_OK) return status;
    const double unit = generic_tilts(out, to);
    out->number[CUBIC_STIFFNESS] = values[STIFFNESS].number * unit;
    out->number[CUBIC_CUBE] = values[CUBIC].number * unit * unit * unit;
    out->number[CUBIC_DAMPING] = values[DAMPING].number * unit * to->clock;
    return whirl_ok();
}

KERNELS_OF_EVERY_ISA(cubic_spring_kernels);

const element_type cubic_spring_element = {
    .group = {"cubic_spring", "a spring between two places whose stiffness changes with the square of displacement",
              "Duffing 1918", keys, KEY_COUNT, NULL, NULL},
    .number_count = KERNEL_NUMBERS + 2 * KERNEL_PORTS,
    .kernels = kernels,
    .build = cubic_spring_build,
};
#endif
