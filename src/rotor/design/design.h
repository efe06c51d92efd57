/// Internal representation of a design, from which the rotor is built.
#ifndef ROTOR_DESIGN_H
#define ROTOR_DESIGN_H

#include "element.h"
#include "whirl/engine/rotor.h"

/// A station, a shaft or a material.
typedef struct design_part {
    char name[WHIRL_NAME_SIZE];
    key_value *values; ///< values of the keys of station_group, shaft_group or material_group
} design_part;

typedef struct design_element {
    const element_type *type;
    key_value *values; ///< [type->group.key_count]
} design_element;

enum { MAX_TYPES = 64 };

struct whirl_design {
    double speed, length;
    whirl_bearings bearings; ///< replacement of the bearings
    double stiffness;        ///< stiffness of the springs that replace them
    whirl_drag drag;         ///< seals and impellers that are included
    size_t drag_at;          ///< station of the seals and impellers that are included, if not all
    double stages;           ///< factor of stages
    bool in_time;            ///< frequency-dependent coefficients become transfer functions with states
    bool asynchronous;       ///< frequency-dependent coefficients are those at `frequency`
    double frequency;        ///< rad/s, in place of the shaft's speed
    bool spools_vary;        ///< shafts with a speed of their own change it while the machine runs
    size_t spool_count;      ///< 0: shafts with a speed of their own have that of their key
    double
        spool_speeds[WHIRL_MAX_SPOOLS]; ///< [spool_count] rad/s along their rotation, in place of those of their keys
    size_t placed_count;
    const whirl_placed *placed; ///< [placed_count] unbalances that replace those of the design; borrowed
    size_t station_count, element_count, shaft_count, material_count;
    design_part stations[WHIRL_MAX_STATIONS], shafts[WHIRL_MAX_SHAFTS], materials[WHIRL_MAX_MATERIALS];
    design_element elements[WHIRL_MAX_ELEMENTS];
    size_t type_count;
    const element_type *types[MAX_TYPES]; ///< types of the library, then added ones, in the order in which they act
};

#endif
