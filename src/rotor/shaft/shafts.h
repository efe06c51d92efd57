/// Shafts of finite elements as they are written: materials, shafts, and the segments that these are made of.
#ifndef ROTOR_SHAFTS_H
#define ROTOR_SHAFTS_H

#include "element.h"
#include "timoshenko.h"

/// Keys of `materials`, `shafts` and the element `segment`, in the order of their tables.
enum { MATERIAL_MODULUS, MATERIAL_SHEAR_MODULUS, MATERIAL_POISSON, MATERIAL_DENSITY, MATERIAL_KEYS };
enum {
    SHAFT_MATERIAL,
    SHAFT_MASS,
    SHAFT_SHEAR,
    SHAFT_ROTARY,
    SHAFT_GYROSCOPIC,
    SHAFT_RATIO,
    SHAFT_MASS_DAMPING,
    SHAFT_STIFFNESS_DAMPING,
    SHAFT_VISCOUS,
    SHAFT_HYSTERETIC,
    SHAFT_MESH_TO,
    SHAFT_REDUCE,
    SHAFT_MODES,
    SHAFT_MODES_TO,
    SHAFT_KEYS
};
enum {
    SEGMENT_LENGTH,
    SEGMENT_OUTER,
    SEGMENT_INNER,
    SEGMENT_OUTER_END,
    SEGMENT_INNER_END,
    SEGMENT_FLATS,
    SEGMENT_FLATS_ANGLE,
    SEGMENT_SHAFT,
    SEGMENT_START,
    SEGMENT_FROM,
    SEGMENT_TO,
    SEGMENT_MATERIAL,
    SEGMENT_ELEMENTS,
    SEGMENT_AXIAL_FORCE,
    SEGMENT_SHEAR,
    SEGMENT_ROTARY,
    SEGMENT_GYROSCOPIC,
    SEGMENT_MASS_DAMPING,
    SEGMENT_STIFFNESS_DAMPING,
    SEGMENT_KEYS
};

extern const whirl_group material_group, shaft_group;

/// A shaft's own settings, in SI.
typedef struct shaft_settings {
    bool lumped, rotary, gyroscopic;
    shear_law shear;
    double ratio;               ///< its speed over the rotor's
    double alpha, beta;         ///< proportional damping, 1/s and s
    double viscous, hysteretic; ///< internal damping, s and 1
    double mesh_to;             ///< Hz; 0: not said
    bool reduced;
    size_t modes;    ///< kept in a plane, at most
    double modes_to; ///< Hz, in place of their number; 0: not said
} shaft_settings;

/// WHIRL_BAD_INPUT where keys contradict each other.
whirl_status material_from(const key_value *values, material *out);
whirl_status shaft_settings_from(const key_value *values, shaft_settings *out);

/// Those of a segment: its shaft's, but for what its own keys say.
shaft_settings segment_settings_from(const key_value *values, const shaft_settings *shaft);

/// The steel that shafts are of where nothing else is said.
extern const material shaft_steel;

#endif
