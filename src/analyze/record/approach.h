/// A motion's approach to a periodic orbit: when Newton's method is worth a try, and whether the motion itself reaches
/// the orbit that was found. See docs/theory.md, "Orbits of settled motions".
#ifndef ANALYZE_APPROACH_H
#define ANALYZE_APPROACH_H

#include <stdbool.h>
#include <stddef.h>

#include "archive.h"
#include "orbit_search.h"
#include "section.h"
#include "settling.h"

typedef struct approach approach;

/// Makes the test of approach for motions of the system with these options. Returns NULL without memory. Freed by
/// approach_free.
approach *approach_new(const whirl_system *system, const whirl_integrate_options *integrate,
                       const whirl_record_options *options);
void approach_free(approach *a);

/// Writes the state of `a` to, or reads it from, an archive.
void approach_archive(approach *a, archive *to);

/// Returns the period of an orbit that may be near after `revolution` revolutions, given the last states; 0 if Newton's
/// method is not worth a try.
size_t approach_tries(approach *a, const settling *states, int revolution);

/// Takes the result of Newton's method that started at the last state: the approach then owns *s. WHIRL_NO_MEMORY.
whirl_status approach_take(approach *a, orbit_search *s, const settling *states, int revolution);

/// Compares the last return with its prediction, if an orbit is known. Called before approach_arrives.
void approach_goes_on(approach *a, const settling *states);

/// Returns true if the motion, at the start of the orbit's first revolution, must settle on a stable orbit: it is near
/// enough, and approaches the orbit as the orbit's multipliers predict.
bool approach_arrives(const approach *a, const settling *states);

/// Returns the orbit that was found last, NULL without one; owned by the approach.
orbit_search *approach_orbit(const approach *a);

/// Returns the revolutions that Newton's method has taken.
double approach_spent(const approach *a);

#endif
