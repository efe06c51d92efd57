// Variant of helical gears at stations that tilt or move along their shafts, which closes the teeth as well.
#define KERNEL_AXES 6 // x, y, twist, tilts along x and y, axial
#define GEAR_IN_SPACE

#include "gear_parts.h"

const element_kernels ISA(gear_helical_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
KERNELS_OF_EVERY_ISA(gear_helical_kernels);

void gear_helical_scale(element *own, const assembly *to) {
    generic_tilts(own, to);
}

#define GEAR_HELICAL                                                                                                   \
    GEAR_TYPE,                                                                                                         \
        .group = {"gear", "helical gears whose tilts and axial displacements close the teeth, too", "", NULL, 0, NULL, \
                  NULL}

const element_type gear_helical = {GEAR_HELICAL};
const element_type gear_helical_turning = {GEAR_HELICAL, GEAR_TURNING};
#endif
