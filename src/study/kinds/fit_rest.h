/// Numbers of a fit about the equilibrium: onsets, critical speeds, frequencies and damping ratios of modes.
#ifndef STUDY_FIT_REST_H
#define STUDY_FIT_REST_H

#include "fit_place.h"

/// Computes the number: model [1] and its derivatives slopes [unknowns]. Once the number is known (`kept`), it is
/// followed from its last value. WHIRL_BAD_INPUT if there is none; WHIRL_NO_MEMORY.
whirl_status fit_at_rest(const fit_place *p, const whirl_fit_number *number, const fit_orbit *kept, fit_orbit *tried,
                         double *model, double *slopes);

#endif
