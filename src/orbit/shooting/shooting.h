/// Shooting: the segments of an orbit and their ends.
#ifndef ORBIT_SHOOTING_H
#define ORBIT_SHOOTING_H

#include "part.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/orbit.h"

enum {
    MAX_BESIDE = 2, ///< neighbouring machines
    MAX_ABREAST = 8 ///< motions of the present machine
};

/// A machine with the workspace of an orbit's segments. Segment j of `count` leads from node j to node j + 1, the last
/// one back to the first.
typedef struct shooting {
    const whirl_system *system;
    const whirl_system *first;         ///< machine for which it was made; outlives it
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
    whirl_ensemble *beside;         ///< [MAX_BESIDE count, MAX_ABREAST] for other motions; NULL: not yet needed
    whirl_perturbations *columns;   ///< [count] perturbations of the segments in lanes
    double *unit;                   ///< [kept_count][dimension] unit perturbations
    double *vectors;                ///< [count][kept_count][dimension]
    double *ends;                   ///< [count][dimension] ends of the segments
    double *matrices;               ///< [count][kept_count][kept_count] their derivatives
    double volume;                  ///< volume, as in whirl_orbit
} shooting;

/// Makes one for an orbit of that many revolutions; for 0 revolutions, one of a free period, now `period`; and for no
/// time at all, an equilibrium: its one node stays where it is, and the one matrix is its Jacobian. Errors as
/// whirl_orbit_find. Freed by shooting_free.
whirl_status shooting_new(const whirl_system *system, const whirl_orbit_options *options, size_t revolutions,
                          double period, shooting **out);
void shooting_free(shooting *s);

/// Returns true for an equilibrium.
bool shooting_rests(const shooting *s);

/// Carries the segments from nodes [count][dimension]: ends, and with `derivatives` matrices and volume, too. A free
/// period is `period`. False if a motion is not bounded.
bool shooting_carry(shooting *s, const double *nodes, double period, bool derivatives);

/// Replaces the present machine; the first one must stay to the end. False if lanes do not carry the new one, which
/// then needs another shooting.
bool shooting_renew(shooting *s, const whirl_system *system);

/// Carries the segments of `count` other machines from the same nodes: ends [count][segments][dimension]. False if a
/// motion is not bounded, or if lanes do not carry them.
bool shooting_carry_beside(shooting *s, size_t count, const whirl_system *const *systems, const double *nodes,
                           double period, double *ends);

/// Carries up to MAX_ABREAST motions x [count][dimension] over the whole of the orbit's time. False if one is not
/// bounded.
bool shooting_map(shooting *s, size_t count, double *x, double period);

/// Writes the gaps of the segments, end - next node: gap [count][kept_count].
void shooting_gap(const shooting *s, const double *nodes, double *gap);

/// Writes the derivative of the end of segment j by the whole orbit's time: slope [dimension].
void shooting_by_period(const shooting *s, size_t j, double *slope);

/// Carries the segments and reports the motion at the end of each of the equal parts in the options, t from the orbit's
/// beginning. False as above.
bool shooting_observe(shooting *s, const double *nodes, double period, whirl_observe_fn observe, void *observer);

/// Computes the bounds of all coordinates at these instants, in less time: widens low, high [dimension]. False also if
/// lanes do not carry the segments.
bool shooting_bounds(shooting *s, const double *nodes, double period, double *low, double *high);

/// Writes all nodes after the first by following the motion. False if it is not bounded.
bool shooting_spread(shooting *s, double *nodes, double period);

/// Sets the turning angles of the nodes after the first, which follow from it.
void shooting_turn(const shooting *s, double *nodes);

/// Returns the largest modulus of the coordinates that do not turn.
double shooting_size(const shooting *s, const double *nodes);

#endif
