// Variant of a crack on a shaft of another speed than the rotor: the angle of that shaft is a state.
#define KERNEL_FILE "elements/shafts/crack_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 1
#define KERNEL_NUMBERS CRACK_TURNING_NUMBERS
#define KERNEL_SWITCHES 0
#define CRACK_TURNS

#include "crack_parts.h"
#include "generic.h"
#include "registry.h"

const element_kernels ISA(crack_turning_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

/// Describes the range of the law, for a shaft end held by the ground: the weight alone must decide whether the crack
/// is open.
bool crack_range(const element *own, size_t index, const element_seen *seen, element_range *out) {
    double sag[KERNEL_AXES], swing[KERNEL_AXES];
    (void)own;
    for (int a = 0; a < KERNEL_AXES; a++) {
        sag[a] = 0.5 * (seen->low[a] + seen->high[a] + seen->low[KERNEL_AXES + a] + seen->high[KERNEL_AXES + a]);
        swing[a] = 0.5 * (seen->high[a] - seen->low[a] + seen->high[KERNEL_AXES + a] - seen->low[KERNEL_AXES + a]);
    }
    const double reached = hypot(swing[0], swing[1]) / hypot(sag[0], sag[1]);
    *out = (element_range){"vibration over sag", "1", "at which it no longer opens by its weight alone", 1.0, reached};
    if (isnan(seen->radius)) out->reached = NAN;
    return index == 0;
}

void crack_turning_scale(element *own, const assembly *to) {
    generic_scale(own, to, 1.0);
}

static double crack_rounds(const element *own, size_t state) {
    (void)state;
    return own->number[CRACK_RATE];
}

KERNELS_OF_EVERY_ISA(crack_turning_kernels);

const element_type crack_turning = {
    .group = {"crack", "a crack that turns with a shaft of another speed", "", NULL, 0, NULL, NULL},
    .spun = true,
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = 1,
    .turning = 1,
    .rounds = crack_rounds,
    .kernels = kernels,
    .range = crack_range,
};
#endif
