/// Orbits of settled motions, as a record reports them.
#ifndef ANALYZE_ORBITS_H
#define ANALYZE_ORBITS_H

#include <stdbool.h>
#include <stddef.h>

#include "orbit_search.h"
#include "section.h"

/// Returns true if a search for an orbit of k revolutions costs little compared with the motion itself, given that
/// Newton's method has already taken `spent` revolutions for this motion.
bool orbits_pay(size_t dimension, const whirl_record_options *options, size_t k, double spent);

/// Returns the revolutions after which the motion of a complete record returns; 0 if it does not, or if a search costs
/// too much.
size_t orbits_settled_period(const whirl_record *record, const whirl_record_options *options);

/// Writes to a record with known bounds the orbit that Newton's method found, and the motion's distance from it; or
/// that it found none.
void orbits_record(whirl_record *record, const orbit_search *s, double distance);

#endif
