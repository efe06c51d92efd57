/// The built rotor as its equations of motion see it.
#ifndef ROTOR_MACHINE_H
#define ROTOR_MACHINE_H

#include "element.h"
#include "lanes.h"
#include "whirl/rotor.h"

struct whirl_rotor {
    double speed, length;
    whirl_system system;
    whirl_lanes lanes;
    size_t station_count, element_count, contact_count;
    element *elements; ///< [element_count] those that have a kernel, in the registry's order
    double *numbers;   ///< [station_count][STATION_NUMBERS], then those of the elements, one after the other
    whirl_probe *probes;
    double *mass;
    size_t *contacts; ///< [contact_count] indices of elements
    char (*contact_text)[WHIRL_NAME_SIZE + 16];
    const char **contact_names;
};

/// The accelerations of rotors, one function for every instruction set of vector.h (machine_<isa>.c).
extern lanes_accelerate *const machine_accelerate[];
lanes_accelerate machine_accelerate_scalar, machine_accelerate_128, machine_accelerate_fma, machine_accelerate_avx2,
    machine_accelerate_avx512;

#endif
