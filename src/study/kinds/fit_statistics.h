/// Statistics of a motion in a fit, for motions that are not periodic: extremes, lines, and the share of contact.
#ifndef STUDY_FIT_STATISTICS_H
#define STUDY_FIT_STATISTICS_H

#include "fit_place.h"

/// Computes the numbers of a place's motion over fit.record revolutions after the transient, from the machine's start:
/// model [numbers], and their derivatives slopes [numbers][unknowns] by finite differences with the relative step
/// fit.difference. These numbers are consecutive in the fit, from `first` on. WHIRL_BAD_INPUT if a motion leaves its
/// bounds; WHIRL_NO_MEMORY.
whirl_status fit_statistics(const fit_place *p, size_t first, fit_orbit *tried, double *model, double *slopes);

#endif
