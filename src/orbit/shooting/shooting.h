/// The segments of an orbit and where they lead.
#ifndef ORBIT_SHOOTING_H
#define ORBIT_SHOOTING_H

#include "part.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/orbit.h"

enum {
    MAX_BESIDE = 2, ///< machines beside the present one
    MAX_ABREAST = 8 ///< motions of the present one
};

/// A machine with the workspace of an orbit's segments. Segment j of `count` leads from node j to node j + 1, the last
/// one back to the first.
typedef struct shooting {
    const whirl_system *system;
    const whirl_system *first;         ///< for which it was made; outlives it
    whirl_integrate_options integrate; ///< of a segment
    size_t dimension;
    size_t kept_count;              ///< coordinates that do not turn on and on: the unknowns of a node
    size_t *kept;                   ///< [kept_count] which these are
    size_t revolutions;             ///< 0: the orbit has a time of its own
    double period;                  ///< the time of all of it that the parts were made for
    size_t count;                   ///< segments
    size_t part_count;              ///< after which their parts of a revolution come again
    part *parts;                    ///< [part_count]
    whirl_integrator **integrators; ///< [part_count] NULL where lanes carry the segments
    whirl_ensemble *lanes;          ///< segments side by side; NULL: integrators carry one after the other
    whirl_ensemble *beside;         ///< [MAX_BESIDE count, MAX_ABREAST] for motions beside; NULL: not yet needed
    whirl_perturbations *columns;   ///< [count] of the segments in lanes
    double *unit;                   ///< [kept_count][dimension] unit perturbations
    double *vectors;                ///< [count][kept_count][dimension]
    double *ends;                   ///< [count][dimension] where the segments lead
    double *matrices;               ///< [count][kept_count][kept_count] their derivatives
    double volume;                  ///< as whirl_orbit has it
} shooting;

/// Makes one of that many revolutions, or, of 0, of an orbit that takes `period`, or, of no time at all, of an
/// equilibrium: its one node stays where it is, and the one matrix is its Jacobian. Errors as whirl_orbit_find. Freed
/// by shooting_free.
whirl_status shooting_new(const whirl_system *system, const whirl_orbit_options *options, size_t revolutions,
                          double period, shooting **out);
void shooting_free(shooting *s);

/// Whether it is of an equilibrium.
bool shooting_rests(const shooting *s);

/// Carries the segments from nodes [count][dimension]: ends, and with `derivatives` matrices and volume, too. An orbit
/// with a time of its own takes `period`. False where a motion is not bounded.
bool shooting_carry(shooting *s, const double *nodes, double period, bool derivatives);

/// Puts another machine in the place of the present one; the first one stays to the end. False where lanes do not carry
/// it, and another shooting is to be made.
bool shooting_renew(shooting *s, const whirl_system *system);

/// Carries the segments of `count` other machines from the same nodes: ends [count][segments][dimension]. False where a
/// motion is not bounded, or lanes do not carry them.
bool shooting_carry_beside(shooting *s, size_t count, const whirl_system *const *systems, const double *nodes,
                           double period, double *ends);

/// Carries up to MAX_ABREAST motions x [count][dimension] over the whole of the orbit's time. False where one is not
/// bounded.
bool shooting_map(shooting *s, size_t count, double *x, double period);

/// Writes what the segments miss, end - next node: gap [count][kept_count].
void shooting_gap(const shooting *s, const double *nodes, double *gap);

/// The derivative of the end of segment j by the time of the whole orbit: slope [dimension].
void shooting_by_period(const shooting *s, size_t j, double *slope);

/// Carries the segments and tells of the motion at the end of each of the equal parts that the options say, t from the
/// orbit's beginning. False as above.
bool shooting_observe(shooting *s, const double *nodes, double period, whirl_observe_fn observe, void *observer);

/// The bounds of all coordinates at these instants, in less time: low, high [dimension], which are widened. False where
/// lanes do not carry the segments, too.
bool shooting_bounds(shooting *s, const double *nodes, double period, double *low, double *high);

/// The first node is given: writes the others where the motion leads. False where it is not bounded.
bool shooting_spread(shooting *s, double *nodes, double period);

/// Angles of the nodes after the first follow from it: those that turn are carried along.
void shooting_turn(const shooting *s, double *nodes);

/// The largest modulus of the coordinates that do not turn.
double shooting_size(const shooting *s, const double *nodes);

#endif
