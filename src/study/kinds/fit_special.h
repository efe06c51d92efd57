/// Onsets of periodic orbits in a fit: where a branch of forced orbits folds, doubles its period, or begins a torus.
#ifndef STUDY_FIT_SPECIAL_H
#define STUDY_FIT_SPECIAL_H

#include "fit_place.h"

/// Computes the onset: model [1] and its derivatives slopes [unknowns]. At the first evaluation (nothing is `kept`) it
/// is the first fold, doubling or Neimark-Sacker point that the branch meets from motion->from towards larger values;
/// later it is followed from the kept one. WHIRL_BAD_INPUT if there is none; WHIRL_NO_MEMORY.
whirl_status fit_orbit_onset(const fit_place *p, const fit_orbit *kept, fit_orbit *tried, double *model,
                             double *slopes);

#endif
