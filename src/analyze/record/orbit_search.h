/// Shooting: Newton's method on the map over k revolutions, for several motions side by side. Finds the orbits on which
/// they settle, with all their multipliers.
#ifndef ANALYZE_ORBIT_SEARCH_H
#define ANALYZE_ORBIT_SEARCH_H

#include <stdbool.h>
#include <stddef.h>

#include "archive.h"
#include "section.h"

/// A search for a motion's orbit; one block, freed by free.
typedef struct orbit_search {
    const whirl_system *system; ///< borrowed
    size_t dimension, kept;     ///< coordinates, and those that do not turn
    size_t revolutions;         ///< period of the orbit
    double *nodes;              ///< [revolutions][dimension] the states at the beginnings of its revolutions
    double *factors; ///< [revolutions][kept][kept] derivative of a revolution's end by its beginning, row by row
    whirl_multiplier *values; ///< [kept] multipliers by falling modulus
    double residual;          ///< distance by which the orbit fails to close, over its largest coordinate
    double volume;            ///< sum of ln|multiplier| from the divergence; NaN if the system gives none
    double carried;           ///< revolutions that were computed, with all perturbations
    bool found;
    bool in_lane, done; ///< true if the search is in a lane; true if it has ended
} orbit_search;

/// Makes a search from the state x [dimension], or, if x is NULL, one that an archive restores. Returns NULL without
/// memory.
orbit_search *orbit_search_new(const whirl_system *system, size_t revolutions, const double *x);

/// Archives (saves or restores) the result; the search must be for the same system and period.
void orbit_search_archive(orbit_search *s, archive *a);

/// Computes the derivative of the map over all revolutions, matrix [kept][kept]; `work` [kept][kept] is workspace.
void orbit_search_monodromy(const orbit_search *s, double *matrix, double *work);

/// Computes the coordinates of x - node that do not turn: out [kept].
void orbit_search_difference(const orbit_search *s, const double *x, double *out);

/// Returns the Euclidean length of that difference.
double orbit_search_distance(const orbit_search *s, const double *x);

/// The ensemble that carries searches: machines of one structure, by the method of their motions, with a tighter
/// tolerance if the method is adaptive.
typedef struct orbit_searches orbit_searches;

/// Makes the lanes of searches. Returns WHIRL_BAD_INPUT if the system has no Jacobian, or if the method does not carry
/// perturbations. Freed by orbit_searches_free.
whirl_status orbit_searches_new(const whirl_system *system, const whirl_integrate_options *integrate,
                                orbit_searches **out);
void orbit_searches_free(orbit_searches *s);

/// Returns the number of searches that run side by side.
size_t orbit_searches_lanes(const orbit_searches *s);

/// Runs the searches [count], including those in lanes, until fewer than `least` >= 1 of them are unfinished. A search
/// takes a few full Newton steps, since its start is close to an orbit. If an orbit closes after fewer revolutions (a
/// divisor of its period), these become its period. Searches in lanes must not be freed before they are done.
/// WHIRL_NO_MEMORY.
whirl_status orbit_searches_run(orbit_searches *s, orbit_search *const *searches, size_t count, size_t least);

#endif
