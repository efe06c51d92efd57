// Variant of helical gears at stations that tilt, whose tilts close the teeth as well.
#define KERNEL_AXES 5 // x, y, twist, tilts along x and y
#define GEAR_TILTS

#include "gear_parts.h"

const element_kernels ISA(gear_tilting_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
KERNELS_OF_EVERY_ISA(gear_tilting_kernels);

void gear_tilting_scale(element *own, const assembly *to) {
    generic_tilts(own, to);
}

#define GEAR_TILTING                                                                                                   \
    GEAR_TYPE, .group = {"gear", "helical gears whose tilts close the teeth, too", "", NULL, 0, NULL, NULL}

const element_type gear_tilting = {GEAR_TILTING};
const element_type gear_tilting_turning = {GEAR_TILTING, GEAR_TURNING};
#endif
