/// Models: sections of shafts, masses of stations and elements, as reports list and drawings show them.
#ifndef WHIRL_MODEL_H
#define WHIRL_MODEL_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/rotor.h"
#include "whirl/engine/torsion.h"
#include "whirl/internal/bearing.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A stretch of a shaft with constant section, or one tapered finite element. SI.
typedef struct whirl_model_section {
    size_t shaft;              ///< index in the design
    double from, to;           ///< along the shaft, m
    double outer[2], inner[2]; ///< diameters at its ends, m
    double mass;               ///< kg
} whirl_model_section;

/// Masses at a station without those of its part of a shaft, discs included. SI.
typedef struct whirl_model_mass {
    double mass, polar, diametral; ///< kg, kg m2
    size_t shaft;                  ///< index in the design; WHIRL_MODEL_NONE for a station on no shaft
    double position;               ///< along that shaft, m
    bool unbalanced;               ///< true if it has an eccentricity, or an element with an unbalance
    /// Polar inertia that turns with the station, its part of the shaft included, kg m2; NaN if it does not twist.
    double twist;
    double turns; ///< speed of the station over that of the rotor; NaN if it does not twist
} whirl_model_mass;

/// A joint of the twists of two stations: a coupling, a gear, or pieces of a shaft in series. SI.
typedef struct whirl_model_joint {
    whirl_torque_path path;    ///< the path of torque, with the weakest section of its pieces
    double stiffness, damping; ///< N m/rad of the first station, N m s/rad; NaN: a rigid gear, or not known
    double turns;              ///< speed of the first station over that of the rotor
} whirl_model_joint;

/// No station (the ground), or no shaft.
#define WHIRL_MODEL_NONE ((size_t)-1)

/// Roles of elements in a machine.
typedef enum whirl_model_role {
    WHIRL_ROLE_BEARING, ///< it carries the rotor
    WHIRL_ROLE_DRAG,    ///< it is a seal, an impeller or a stage
    WHIRL_ROLE_STATOR,  ///< the rotor may touch it
    WHIRL_ROLE_SUPPORT, ///< it connects a station to the ground, like springs and mounts
    WHIRL_ROLE_LINK,    ///< it connects two stations, like couplings and lumped shafts
    WHIRL_ROLE_OTHER    ///< it is a mass, a load, or the runout of a probe's track
} whirl_model_role;

/// Value of a key of an element, as given or by default.
typedef struct whirl_model_value {
    const whirl_key *key; ///< static, or of the custom type
    bool given;           ///< false: by default, or missing
    double number;        ///< in the unit of the key; the first of a list; NaN if the key has neither value nor default
    double last;          ///< the last of a list; else the number
    size_t count;         ///< length of a list; 0 for a single number
    int choice;           ///< index of the word of a choice
} whirl_model_value;

/// An element with its stations and values.
typedef struct whirl_model_element {
    const char *kind;      ///< "film"; static, or of the custom type
    whirl_model_role role; ///< role in the machine
    size_t station[2];     ///< stations from one end to the other; WHIRL_MODEL_NONE for an end on the ground
    size_t value_count;
    const whirl_model_value *values; ///< [value_count] in the order of its keys
    double viscosity;       ///< viscosity of its oil, Pa s, at the temperature given for the film; NaN without oil
    const whirl_pads *pads; ///< pads of a bearing, pivots at their angles in the machine, from x to y; NULL: none
} whirl_model_element;

/// Mass of a shaft with everything on it.
typedef struct whirl_model_total {
    double mass, centre; ///< kg; centre of mass along the shaft, m
} whirl_model_total;

/// The model of a design.
typedef struct whirl_model {
    size_t section_count, station_count, shaft_count, element_count; ///< lengths of the following arrays
    whirl_model_section *sections; ///< [section_count] shaft by shaft, in order along each
    whirl_model_mass *stations;    ///< [station_count]
    size_t joint_count;
    whirl_model_joint *joints;     ///< [joint_count] joints between stations that twist; NULL: none
    whirl_model_total *shafts;     ///< [shaft_count]
    whirl_model_element *elements; ///< [element_count] without segments, in the order of the design
    whirl_model_value *values;     ///< memory of the values of all elements
    whirl_pads *pads;              ///< memory of the pads of all elements
    bool stands;                   ///< true if weight acts along the shafts
    bool rises;                    ///< true if positions along standing shafts are counted upwards
} whirl_model;

/// Builds the model of a design. Errors as whirl_rotor_new. Freed by whirl_model_free.
whirl_status whirl_design_model(const whirl_design *design, whirl_model *out);

struct whirl_case;

/// Builds the model of a case at its own parameters.
whirl_status whirl_case_model(const struct whirl_case *object, whirl_model *out);

/// Returns the value of a key of an element, or NULL if its kind has no such key.
const whirl_model_value *whirl_model_value_of(const whirl_model_element *of, const char *key);

/// Frees the contents, not the struct; accepts {0}.
void whirl_model_free(whirl_model *model);

#ifdef __cplusplus
}
#endif
#endif
