/// Shooting: the segments of an orbit and their ends.
#ifndef ORBIT_SHOOTING_H
#define ORBIT_SHOOTING_H

#include "part.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/orbit.h"

enum {
    MAX_MACHINES = 2, ///< most machines with neighbouring parameters
    MAX_ABREAST = 8   ///< most motions of the present machine side by side
};

/// A machine with the workspace of an orbit's segments. Segment j of `count` leads from node j to node j + 1, the last
/// segment back to the first node.
typedef struct shooting {
    const whirl_system *system;
    const whirl_system *first;         ///< machine for which the shooting was made; must outlive it
    whirl_integrate_options integrate; ///< options of a segment
    size_t dimension;
    size_t kept_count;              ///< coordinates that do not turn: the unknowns of a node
    size_t *kept;                   ///< [kept_count] their indices
    size_t revolutions;             ///< 0: the period is free
    double period;                  ///< total time for which the parts were made
    size_t count;                   ///< number of segments
    size_t part_count;              ///< segments after which their phase in a revolution repeats
    part *parts;                    ///< [part_count]
    whirl_integrator **integrators; ///< [part_count] NULL where lanes carry the segments
    whirl_ensemble *lanes;          ///< segments side by side; NULL: integrators carry one after the other
    whirl_ensemble *motion_lanes;   ///< max(MAX_MACHINES count, MAX_ABREAST) lanes for other motions; NULL: not yet
                                    ///< needed
    whirl_perturbations *columns;   ///< [count] perturbations of the segments in lanes
    double *unit;                   ///< [kept_count][dimension] unit perturbations
    double *vectors;                ///< [count][kept_count][dimension]
    double *ends;                   ///< [count][dimension] ends of the segments
    double *matrices;               ///< [count][kept_count][kept_count] their derivatives
    double volume;                  ///< volume, as in whirl_orbit
} shooting;

/// Makes the workspace of an orbit of `revolutions` revolutions. With 0 revolutions its period is free, and at first
/// `period`. With 0 revolutions and period 0 it is an equilibrium: one node, which stays where it is, and one matrix,
/// its Jacobian. Errors as whirl_orbit_find. Freed by shooting_free.
whirl_status shooting_new(const whirl_system *system, const whirl_orbit_options *options, size_t revolutions,
                          double period, shooting **out);
void shooting_free(shooting *s);

/// Returns true for an equilibrium.
bool shooting_rests(const shooting *s);

/// Carries the segments from nodes [count][dimension]; sets the ends, and with `derivatives` the matrices and the
/// volume, too. `period` is the value of a free period. Returns false if a motion is not bounded.
bool shooting_carry(shooting *s, const double *nodes, double period, bool derivatives);

/// Replaces the present machine. The first machine must exist to the end. Returns false if the lanes cannot carry the
/// new machine, which then needs another shooting.
bool shooting_renew(shooting *s, const whirl_system *system);

/// Carries the segments of `count` other machines from the same nodes: ends [count][segments][dimension]. Returns false
/// if a motion is not bounded, or if lanes cannot carry the machines.
bool shooting_carry_machines(shooting *s, size_t count, const whirl_system *const *systems, const double *nodes,
                             double period, double *ends);

/// Carries up to MAX_ABREAST motions x [count][dimension] over the orbit's whole time. Returns false if one of them is
/// not bounded.
bool shooting_map(shooting *s, size_t count, double *x, double period);

/// Writes the gaps of the segments, end - next node: gap [count][kept_count].
void shooting_gap(const shooting *s, const double *nodes, double *gap);

/// Writes the derivative of the end of segment j by the whole orbit's time: slope [dimension].
void shooting_by_period(const shooting *s, size_t j, double *slope);

/// Carries the segments, and reports the motion at equal steps, whose number per revolution is in the options. Their
/// time is counted from the orbit's beginning. Returns false if a motion is not bounded.
bool shooting_observe(shooting *s, const double *nodes, double period, whirl_observe_fn observe, void *observer);

/// Widens low, high [dimension] to the bounds of all coordinates at these instants, which takes less time. Returns
/// false if a motion is not bounded, or if there are no lanes.
bool shooting_bounds(shooting *s, const double *nodes, double period, double *low, double *high);

/// Writes all nodes after the first by following the motion. Returns false if it is not bounded.
bool shooting_spread(shooting *s, double *nodes, double period);

/// Sets the turning angles of the nodes after the first, which follow from those of the first.
void shooting_turn(const shooting *s, double *nodes);

/// Returns the largest modulus of the coordinates that do not turn.
double shooting_size(const shooting *s, const double *nodes);

#endif
