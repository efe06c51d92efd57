/// Runs of a fit: orders of the machine over turns while its speed changes, and their derivatives by the unknowns.
#ifndef STUDY_FIT_RUN_H
#define STUDY_FIT_RUN_H

#include "fit_place.h"

/// Runs the machine of a place, the first motion of a run, at the values of the unknowns and at neighbouring ones.
/// Fills in the model and the derivatives [numbers][unknowns] of all motions of the run, and notes them in tried
/// [motions]. WHIRL_BAD_INPUT and WHIRL_NUMERICAL_FAILURE if a run fails or does not reach a row; *lost is then the
/// index of that row's motion. WHIRL_NO_MEMORY, WHIRL_STOPPED.
whirl_status fit_run(const fit_place *p, fit_orbit *tried, double *model, double *slopes, size_t *lost);

/// Makes the machines of all runs of a batch's fit at the first start. WHIRL_BAD_INPUT with a sentence for runs that
/// mean nothing, such as a run without a drive and a rate.
whirl_status fit_runs_check(const whirl_study *study, const whirl_batch *batch);

#endif
