/// All stable orbits of a machine that motions from a box of starts settle on.
#ifndef WHIRL_STABLE_ORBITS_H
#define WHIRL_STABLE_ORBITS_H

#include <stddef.h>

#include "whirl/engine/orbit.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Options of collecting the orbits of a machine.
typedef struct whirl_collect_options {
    whirl_orbit_options orbit; ///< options of finding each
    size_t starts;             ///< number of motions
    const double *low, *high;  ///< [dimension] box that the starts fill evenly; borrowed
    size_t around_count;       ///< number of states that in turn are the origin of the box; 0: the box is not moved
    const double *around;      ///< [around_count][dimension]; borrowed
    size_t settle;             ///< revolutions before the first search for an orbit
    size_t most_revolutions;   ///< revolutions after which a motion is abandoned
    size_t longest;            ///< most revolutions of an orbit, 1 to WHIRL_MAX_ORBIT
} whirl_collect_options;

/// Returns the defaults: 64 starts in the box, 500 revolutions, at most 16000, orbits of up to 32.
whirl_collect_options whirl_collect_default(const double *low, const double *high);

/// Stable orbits on which motions of a machine settle; freed by whirl_collection_free.
typedef struct whirl_collection {
    size_t count;         ///< number of orbits
    whirl_orbit **orbits; ///< [count] all different motions, each with its least number of revolutions
    size_t *reached;      ///< [count] number of motions that reached each
    size_t elsewhere;     ///< motions that reached none: they end on a torus or in chaos, or settle too slowly
    size_t lost;          ///< motions that left the bounds
} whirl_collection;

/// Follows motions in parallel from starts that fill a box, the same ones in every run (an additive recurrence: Roberts
/// 2018), and repeatedly searches for orbits by Newton's method from states that nearly return. Collects the stable
/// orbits, with the motions that settle on each; orbits are compared by all their nodes. Orbits without a start in
/// their basin are not found. WHIRL_BAD_INPUT for invalid options and a system without a Jacobian; WHIRL_NO_MEMORY.
whirl_status whirl_orbit_collect(const whirl_system *system, const whirl_collect_options *options,
                                 whirl_collection **collection);

/// Frees a collection with its orbits; accepts NULL.
void whirl_collection_free(whirl_collection *collection);

#ifdef __cplusplus
}
#endif
#endif
