/// Profile intervals of a fit: how far an unknown can go, all others being fitted again.
#ifndef STUDY_FIT_PROFILE_H
#define STUDY_FIT_PROFILE_H

#include "fit_motions.h"
#include "least_squares.h"

/// Finds the 95 % profile intervals of all unknowns that are determined, solution->profile: the values at which the
/// least sum of squares over the others is `rise` above that of the solution. NaN for an end that is not within the
/// bounds, or at which a motion is lost. `problem` is that of the fit; the motions are at the solution, and stay there.
/// WHIRL_NO_MEMORY, WHIRL_STOPPED.
whirl_status fit_profile(const fit_motions *motions, const least_squares *problem, double rise,
                         whirl_fit_solution *solution);

#endif
