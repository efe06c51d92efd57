/// What a machine is made of: sections of its shafts and masses of its stations, as reports list them.
#ifndef WHIRL_MODEL_H
#define WHIRL_MODEL_H

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
} whirl_model_mass;

/// A shaft with all that is on it.
typedef struct whirl_model_total {
    double mass, centre; ///< kg; of mass, along the shaft, m
} whirl_model_total;

/// All of a design.
typedef struct whirl_model {
    size_t section_count, station_count, shaft_count; ///< of the arrays
    whirl_model_section *sections;                    ///< [section_count] shaft by shaft, along them
    whirl_model_mass *stations;                       ///< [station_count]
    whirl_model_total *shafts;                        ///< [shaft_count]
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
