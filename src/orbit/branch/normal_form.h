/// Criticality: whether the motion that begins at a special point exists where the orbit is unstable, or where the
/// orbit is stable.
#ifndef ORBIT_NORMAL_FORM_H
#define ORBIT_NORMAL_FORM_H

#include "shooting.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

/// Returns the cubic coefficient of the normal form at a doubling, a Neimark-Sacker or a Hopf point (Kuznetsov 2004,
/// 5.4) of an orbit whose segments were carried with derivatives. See whirl_branch_point for its sign and for `angle`.
/// Returns NaN without memory, if a motion near the orbit leaves its bounds, for other points, or if a pair of
/// multipliers is within 1e-3 of a strong resonance (a third or a fourth of a turn).
double normal_form(shooting *s, const whirl_orbit *orbit, whirl_special kind, double angle);

#endif
