// An elastomer mount between two stations, or between a station and the ground. Its damping fades with the frequency.
#define KERNEL_FILE "elements/supports/mount_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 2
#define KERNEL_NUMBERS MOUNT_NUMBERS
#define KERNEL_SWITCHES 0

/// Numbers: k and k_m in newtons per length scale; k_m/(c omega).
enum { MOUNT_STIFFNESS, MOUNT_BRANCH, MOUNT_RATE, MOUNT_NUMBERS };

#include "generic.h"
#include "registry.h"

const element_kernels ISA(mount_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

enum { BETWEEN, STIFFNESS, BRANCH, DAMPING, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED, "the two stations that it joins; one may be ground"),
    [STIFFNESS] = NUMBER_KEY("stiffness", "k", "N/m", REQUIRED, WHIRL_NOT_NEGATIVE, "stiffness at rest"),
    [BRANCH] = CITED_NUMBER_KEY(
        "branch", "k_m", "N/m", REQUIRED, WHIRL_POSITIVE,
        "stiffness of the spring in series with the damper, which adds to the stiffness at high frequencies",
        "Zener 1948"),
    [DAMPING] = CITED_NUMBER_KEY("damping", "c", "N s/m", REQUIRED, WHIRL_POSITIVE, "damping of the damper in series",
                                 "Zener 1948"),
};

static whirl_status mount_build(const key_value *values, assembly *to, element *out) {
    static const axis axes[KERNEL_AXES] = {AXIS_X, AXIS_Y};
    const whirl_status status = element_between(&values[BETWEEN], to, axes, KERNEL_AXES, out);
    if (status.code != WHIRL_OK) return status;
    out->number[MOUNT_STIFFNESS] = values[STIFFNESS].number * to->length;
    out->number[MOUNT_BRANCH] = values[BRANCH].number * to->length;
    out->number[MOUNT_RATE] = values[BRANCH].number / (values[DAMPING].number * to->clock);
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

KERNELS_OF_EVERY_ISA(mount_kernels);

const element_type mount_element = {
    .group = {"mount", "an elastomer between two stations or a station and the ground, a standard linear solid",
              "Zener 1948; Brinson, Brinson 2008, sec. 5.4", keys, KEY_COUNT, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .kernels = kernels,
    .build = mount_build,
};
#endif
