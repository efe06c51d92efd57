/// The map over k revolutions, from section to section, with its derivative.
#ifndef ORBIT_SECTION_MAP_H
#define ORBIT_SECTION_MAP_H

#include "whirl/engine/ensemble.h"
#include "whirl/engine/integrate.h"
#include "whirl/status.h"

#include <stddef.h>

typedef struct section_map {
    size_t revolutions;
    size_t dimension;
    size_t count;                 ///< coordinates of a section's point: those that do not turn
    size_t *kept;                 ///< [count] their indices
    whirl_ensemble *lanes;        ///< points side by side; NULL: the integrator carries one after the other
    whirl_integrator *integrator; ///< NULL with lanes
    size_t side_by_side;          ///< points that run at once
    double *rest;                 ///< [dimension] turning coordinates, the same at every section
    double *states;               ///< [side_by_side][dimension] workspace
    double *vectors;              ///< [side_by_side][count][dimension] workspace
    whirl_perturbations *columns; ///< [side_by_side] perturbations of these
} section_map;

/// Makes the map of a system, which must outlive it, over `revolutions` revolutions. WHIRL_BAD_INPUT if the system's
/// angles do not return after them, if it has no Jacobian, and as whirl_integrator_new; WHIRL_NO_MEMORY. Freed by
/// section_map_free, which accepts NULL.
whirl_status section_map_new(const whirl_system *system, const whirl_integrate_options *options, size_t revolutions,
                             section_map **out);
void section_map_free(section_map *map);

/// Convert a state to its point, and a point to its state.
void section_map_take(const section_map *map, const double *state, double *point);
void section_map_put(const section_map *map, const double *point, double *state);

/// Maps points [many][count]: images [many][count] and, unless NULL, their derivatives [many][count][count] and the
/// mean of the integrals of the divergence (whirl_perturbations). Returns false if a motion is not bounded.
bool section_map_carry(section_map *map, size_t many, const double *points, double *images, double *derivatives,
                       double *volume);

#endif
