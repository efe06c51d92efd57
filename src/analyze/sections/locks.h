/// Locks of a quasi-periodic motion: the periods that a section excludes.
#ifndef ANALYZE_LOCKS_H
#define ANALYZE_LOCKS_H

#include "curves.h"
#include "section.h"

/// Returns the longest period that must be excluded before a motion on `curves` closed curves (0: unknown) certainly is
/// not locked: a third of the points, of which the last ROTATION_POINTS count, but at least 96.
int longest_lock(const section *all, int curves);

/// Returns the longest period up to which locks are excluded, at most longest_lock. The section lies on `curves`->count
/// >= 1 closed curves, which it visits in turn with the rotation number `rotation` (NaN if unknown).
int locks_excluded(const section *all, const closed_curves *curves, double rotation);

#endif
