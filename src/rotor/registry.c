// The elements that a rotor can be made of, one line each, in the order in which they act.
#include <string.h>

#define VECTOR_ISA 0
#include "element.h"
#include "machine.h"
#include "vector.h"
#include "whirl/rotor.h"

const element_type *const element_types[] = {
    &unbalance_element, &gravity_element, &shaft_element, &film_element, &rub_element, NULL,
};

enum { ELEMENT_TYPES = sizeof element_types / sizeof *element_types };

const whirl_group *whirl_station_keys(void) {
    return &station_group;
}

const whirl_group *const *whirl_element_groups(void) {
    static const whirl_group *const groups[ELEMENT_TYPES] = {
        &unbalance_element.group, &gravity_element.group, &shaft_element.group,
        &film_element.group,      &rub_element.group,     NULL,
    };
    return groups;
}

const whirl_group *whirl_element_group(const char *name) {
    for (const whirl_group *const *group = whirl_element_groups(); *group; group++)
        if (strcmp((*group)->name, name) == 0) return *group;
    return NULL;
}

#if defined(__x86_64__)
#define FOR_EVERY_ISA(name)                                                                                            \
    {                                                                                                                  \
        [VECTOR_SCALAR] = name##_scalar, [VECTOR_128] = name##_128, [VECTOR_FMA] = name##_fma,                         \
        [VECTOR_AVX2] = name##_avx2, [VECTOR_AVX512] = name##_avx512                                                   \
    }
#else
#define FOR_EVERY_ISA(name)                                                                                            \
    { [VECTOR_SCALAR] = name##_scalar, [VECTOR_128] = name##_128 }
#endif

lanes_accelerate *const machine_accelerate[VECTOR_ISAS] = FOR_EVERY_ISA(machine_accelerate);
lanes_flow *const machine_flow[VECTOR_ISAS] = FOR_EVERY_ISA(machine_flow);
lanes_switches *const machine_switches[VECTOR_ISAS] = FOR_EVERY_ISA(machine_switches);
lanes_forcing *const machine_forcing[VECTOR_ISAS] = FOR_EVERY_ISA(machine_forcing);
lanes_contacts *const machine_contacts[VECTOR_ISAS] = FOR_EVERY_ISA(machine_contacts);
