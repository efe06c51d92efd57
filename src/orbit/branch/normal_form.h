/// What begins at a special point: whether it is there where the orbit is unstable, or where it is stable.
#ifndef ORBIT_NORMAL_FORM_H
#define ORBIT_NORMAL_FORM_H

#include "shooting.h"

/// The cubic coefficient of the normal form at a doubling, a Neimark-Sacker or a Hopf point (Kuznetsov 2004, 5.4) of an
/// orbit whose segments were carried with derivatives, as whirl_branch_point has it. NaN where memory is lacking, a
/// motion beside it leaves its bounds, the point is of another kind, or a pair of multipliers is within 1e-3 of a
/// strong resonance (a third or a fourth of a turn). angle as whirl_branch_point has it.
double normal_form(shooting *s, const whirl_orbit *orbit, whirl_special kind, double angle);

#endif
