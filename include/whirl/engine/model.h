/// What a machine is made of: sections of its shafts, masses of its stations and what acts on these, as reports list
/// and drawings show them.
#ifndef WHIRL_MODEL_H
#define WHIRL_MODEL_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/rotor.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A stretch of a shaft with one section, or one tapered finite element. SI.
typedef struct whirl_model_section {
    size_t shaft;              ///< among the design's
    double from, to;           ///< along the shaft, m
    double outer[2], inner[2]; ///< diameters at its ends, m
    double mass;               ///< kg
} whirl_model_section;

/// What stands at a station besides its part of a shaft, with discs. SI.
typedef struct whirl_model_mass {
    double mass, polar, diametral; ///< kg, kg m2
    size_t shaft;                  ///< among the design's; WHIRL_MODEL_NONE where the station lies on no shaft
    double position;               ///< along that shaft, m
    bool unbalanced;               ///< it has an eccentricity, or an element has an unbalance there
} whirl_model_mass;

/// No station (the ground), or no shaft.
#define WHIRL_MODEL_NONE ((size_t)-1)

/// What an element is to a machine.
typedef enum whirl_model_role {
    WHIRL_ROLE_BEARING, ///< it carries the rotor
    WHIRL_ROLE_DRAG,    ///< a seal, an impeller or a stage
    WHIRL_ROLE_STATOR,  ///< the rotor may touch it
    WHIRL_ROLE_SUPPORT, ///< it holds a station from the ground, as springs and mounts do
    WHIRL_ROLE_LINK,    ///< it joins two stations, as couplings and lumped shafts do
    WHIRL_ROLE_OTHER    ///< a mass, a load, or the runout of a probe's track
} whirl_model_role;

/// An element with its stations.
typedef struct whirl_model_element {
    const char *kind;      ///< "film"; static, or the added type's
    whirl_model_role role; ///< what it is to the machine
    size_t station[2];     ///< the second, or both, WHIRL_MODEL_NONE where that end stands on the ground
} whirl_model_element;

/// A shaft with all that is on it.
typedef struct whirl_model_total {
    double mass, centre; ///< kg; of mass, along the shaft, m
} whirl_model_total;

/// All of a design.
typedef struct whirl_model {
    size_t section_count, station_count, shaft_count, element_count; ///< of the arrays
    whirl_model_section *sections;                                   ///< [section_count] shaft by shaft, along them
    whirl_model_mass *stations;                                      ///< [station_count]
    whirl_model_total *shafts;                                       ///< [shaft_count]
    whirl_model_element *elements; ///< [element_count] but segments, in the order of the design
    bool stands;                   ///< weight acts along the shafts
    bool rises;                    ///< places along shafts that stand are counted upwards
} whirl_model;

/// Finds it. Errors as whirl_rotor_new. Freed by whirl_model_free.
whirl_status whirl_design_model(const whirl_design *design, whirl_model *out);

struct whirl_case;

/// Of a case with its parameters as they are.
whirl_status whirl_case_model(const struct whirl_case *object, whirl_model *out);

/// Frees what it has, not the struct; {0} is none.
void whirl_model_free(whirl_model *model);

#ifdef __cplusplus
}
#endif
#endif
