/// Builds an assembly from a design: the sum of stations, shafts and elements, before it becomes a rotor.
#ifndef ROTOR_BUILDING_H
#define ROTOR_BUILDING_H

#include "between.h"
#include "design.h"
#include "mesh.h"
#include "reduction.h"

/// Axial support of a vertical shaft.
typedef struct shaft_thrust {
    bool held;         ///< false: the shaft is horizontal and needs no support
    size_t station;    ///< index in the design
    double mass, load; ///< kg and N, of the shaft with everything on it
} shaft_thrust;

/// State of building a rotor from a design.
typedef struct building {
    const whirl_design *design;
    mesh mesh;
    assembly assembly;
    element *elements; ///< [element_count] elements with kernels
    double *numbers;   ///< [number_count] their numbers
    size_t element_count, number_count, state_count;
    whirl_rotor_tell *tell; ///< NULL: the first problem ends the building
    void *context;
    size_t problems;
    shaft_thrust thrust[WHIRL_MAX_SHAFTS];
    reduction reductions[WHIRL_MAX_SHAFTS];
    between_term *between; ///< [between_count]
    size_t between_count;
    body_panels panels;              ///< counts only
    const design_element *keyphasor; ///< element whose phase defines sections; NULL: the shaft's phase defines them
} building;

/// Builds stations, then elements. order [station_count]: order of the stations' coordinates; NULL: as they are listed.
/// Shafts have all coordinates of their meshes. Returns WHIRL_BAD_INPUT, unless problems are reported one by one, and
/// WHIRL_NO_MEMORY. Ended by building_end, also after a failure.
whirl_status building_assemble(building *b, const whirl_design *design, const size_t *order);

/// Reduces the shafts, sorts the assembly, and finds how the coordinates of shafts follow those of their stations.
whirl_status building_finish(building *b);

void building_end(building *b);

/// Adds the weight of vertical shafts to the axial forces of their pieces. To be called while stations have only the
/// masses of stations and discs. WHIRL_BAD_INPUT for a shaft without axial support; *culprit is then the design's
/// element gravity.
whirl_status thrust_build(building *b, size_t *culprit);

/// Returns the value of a key of an element, or NULL if the element has no such key.
const key_value *building_value(const design_element *own, const char *key);

/// Returns true if an element is a bearing, by its kind and its key `role`.
bool building_carries(const design_element *own);

/// Returns true if an element is a seal, an impeller or a stage, by its kind and its key `role`.
bool building_drags(const design_element *own);

#endif
