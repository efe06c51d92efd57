/// The points of a branch so far, and its end.
#ifndef ORBIT_BRANCH_POINTS_H
#define ORBIT_BRANCH_POINTS_H

#include "whirl/engine/branch.h"

/// Adds a point to a branch, which then owns the orbit. If a stop was requested, sets the end WHIRL_END_STOPPED
/// instead.
whirl_status branch_add(whirl_branch *branch, const whirl_branch_options *options, const whirl_branch_point *point);

/// Returns the final status of a continuation. A stop is the branch's end: later errors except WHIRL_NO_MEMORY are
/// ignored.
whirl_status branch_finish(whirl_branch *branch, const whirl_branch_options *options, whirl_status status);

#endif
