/// A motion on its way to a periodic orbit: when Newton's method is worth a try, and whether the motion itself reaches
/// the orbit that was found. See docs/theory.md, "Orbits of settled motions".
#ifndef ANALYZE_APPROACH_H
#define ANALYZE_APPROACH_H

#include "settling.h"
#include "shots.h"

typedef struct approach approach;

/// For motions of the system that go by these options; NULL without memory. Freed by approach_free.
approach *approach_new(const whirl_system *system, const whirl_integrate_options *integrate,
                       const whirl_record_options *options);
void approach_free(approach *a);

/// Goes over its state.
void approach_archive(approach *a, archive *to);

/// After `revolution` revolutions, the last states of which `states` has: of how many revolutions an orbit may be
/// near, 0 where Newton's method is not worth a try.
size_t approach_tries(approach *a, const settling *states, int revolution);

/// Takes what Newton's method made of that state: *s belongs to the approach from then on. Errors: WHIRL_NO_MEMORY.
whirl_status approach_take(approach *a, shot *s, const settling *states, int revolution);

/// Before the next revolution's end is looked at: what that was, where an orbit is known.
void approach_goes_on(approach *a, const settling *states);

/// Whether the motion, at the beginning of the orbit's first revolution now, has come so near to a stable orbit, by a
/// way that its multipliers foretell, that it cannot but come to rest on it.
bool approach_arrives(const approach *a, const settling *states);

/// The orbit that was found last, NULL where there is none; it belongs to the approach.
shot *approach_orbit(const approach *a);

/// Revolutions that Newton's method has taken.
double approach_spent(const approach *a);

#endif
