/// From a design to an assembly: what stations, shafts and elements build together, before it is a rotor.
#ifndef ROTOR_BUILDING_H
#define ROTOR_BUILDING_H

#include "design.h"
#include "mesh.h"

/// What holds a shaft of a machine that stands along its axis.
typedef struct shaft_thrust {
    bool held;         ///< false: nothing, the shaft lies
    size_t station;    ///< of the design
    double mass, load; ///< kg and N, of the shaft and all that is on it
} shaft_thrust;

/// A design on its way to a rotor.
typedef struct building {
    const whirl_design *design;
    mesh mesh;
    assembly assembly;
    element *elements; ///< [element_count] those that have kernels
    double *numbers;   ///< [number_count] theirs
    size_t element_count, number_count, state_count;
    whirl_rotor_tell *tell; ///< NULL: the first problem ends the building
    void *context;
    size_t problems;
    shaft_thrust thrust[WHIRL_MAX_SHAFTS];
    reduction reductions[WHIRL_MAX_SHAFTS];
    between_term *between; ///< [between_count]
    size_t between_count;
    body_panels panels;              ///< how many there are
    const design_element *keyphasor; ///< by which sections are taken; NULL: by the shaft
} building;

/// Stations, then elements; their coordinates in the order [station_count] of all stations, NULL: as listed. Shafts are
/// as their meshes are. WHIRL_BAD_INPUT, where problems are not told one by one; WHIRL_NO_MEMORY. Ended by building_end
/// in any case.
whirl_status building_assemble(building *b, const whirl_design *design, const size_t *order);

/// Reduces the shafts, puts the assembly in order, and finds what lies between stations.
whirl_status building_finish(building *b);

void building_end(building *b);

/// Adds the weight of shafts that stand to the axial forces of their pieces; called when stations have the masses of
/// stations and discs alone. WHIRL_BAD_INPUT with *culprit, the design's element gravity, where nothing holds a shaft.
whirl_status thrust_build(building *b, size_t *culprit);

/// The value of a key of an element; NULL where it has no such key.
const key_value *building_value(const design_element *own, const char *key);

/// Whether an element is a bearing, which carries the rotor, by its kind and its `role`.
bool building_carries(const design_element *own);

/// Whether an element is a seal, an impeller or a stage, likewise.
bool building_drags(const design_element *own);

#endif
