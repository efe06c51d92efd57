/// The orbits of settled motions: what a record says of them.
#ifndef ANALYZE_ORBITS_H
#define ANALYZE_ORBITS_H

#include "shots.h"

/// Whether a search for an orbit of k revolutions costs little beside the motion itself, where Newton's method has
/// taken `spent` revolutions of it before.
bool orbits_pay(size_t dimension, const whirl_record_options *options, size_t k, double spent);

/// After how many revolutions the motion of a complete record returns; 0 where it does not, or a search does not pay.
size_t orbits_settled_period(const whirl_record *record, const whirl_record_options *options);

/// Tells a record whose bounds are known of the orbit that Newton's method found, or did not, at this distance from the
/// motion.
void orbits_tell(whirl_record *record, const shot *s, double distance);

#endif
