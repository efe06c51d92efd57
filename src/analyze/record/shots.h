/// Newton's method on the map over k revolutions, for several motions side by side: the orbits on which they come to
/// rest, with all their multipliers.
#ifndef ANALYZE_SHOTS_H
#define ANALYZE_SHOTS_H

#include "archive.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/orbit.h"

/// A motion on its way onto an orbit; one block, freed by free.
typedef struct shot {
    const whirl_system *system; ///< borrowed
    size_t dimension, kept;     ///< coordinates, and those that do not turn on and on
    size_t revolutions;         ///< after which the orbit closes
    double *nodes;              ///< [revolutions][dimension] the states at the beginnings of its revolutions
    double *factors;            ///< [revolutions][kept][kept] the derivatives of their ends by these, rows first
    whirl_multiplier *values;   ///< [kept] multipliers by falling modulus
    double residual;            ///< by which it fails to close, over its largest coordinate
    double volume;              ///< sum of ln|multiplier| by the divergence; NaN where the system gives none
    double carried;             ///< revolutions that were computed, with all perturbations
    bool found;
    bool flies, done; ///< it is under way, or has come to its end
} shot;

/// A shot from the state x [dimension], or for one that is read (NULL); NULL without memory.
shot *shot_new(const whirl_system *system, size_t revolutions, const double *x);

/// Goes over what was found; the shot was made for the same system and as many revolutions.
void shot_archive(shot *s, archive *a);

/// The derivative of the map over all revolutions, matrix [kept][kept]; `room` has as many.
void shot_monodromy(const shot *s, double *matrix, double *room);

/// The coordinates of x - node that do not turn: out [kept].
void shot_difference(const shot *s, const double *x, double *out);

/// Their Euclidean length.
double shot_distance(const shot *s, const double *x);

/// Where shots are carried: machines of one structure, by the method that their motions go by, more exactly where that
/// has a tolerance.
typedef struct shooter shooter;

/// WHIRL_BAD_INPUT where the system gives no Jacobian, or the method takes no perturbations along. Freed by
/// shooter_free.
whirl_status shooter_new(const whirl_system *system, const whirl_integrate_options *integrate, shooter **out);
void shooter_free(shooter *s);

/// How many shots go side by side.
size_t shooter_lanes(const shooter *s);

/// Takes shots [count], those that fly among them, towards their orbits from starts that are close, by full steps, few
/// of them, until fewer than `least` >= 1 are left: those that have come to their end are done. Where one closes after
/// fewer revolutions that divide its own, it has these. What flies must not be freed before it is done.
/// WHIRL_NO_MEMORY.
whirl_status shooter_fire(shooter *s, shot *const *shots, size_t count, size_t least);

#endif
