/// Runs of a machine at changing speeds in which numbers of a fit were measured.
#ifndef CASE_FIT_RUN_H
#define CASE_FIT_RUN_H

#include "fit_table.h"

/// Reads the keys of the run of a set of measured numbers, if it has one.
void fit_run_read(case_reader *reader, const machine_parts *machine, fit_set *out);

/// Evaluates the expressions of the run of a set, and reports wrong ones. Returns false if there are any.
bool fit_run_check(case_reader *reader, valuation *v, const fit_set *set);

/// Makes the run of a set at the parameters of the case, with no motions yet. WHIRL_NO_MEMORY.
whirl_status fit_run_make(fit_maker *m, const fit_set *set, whirl_fit_run **out);

/// Returns false for a speed, rad/s, that the run does not reach: its speed goes from one value to another at a given
/// rate. Writes these values to ends, rad/s.
bool fit_run_reaches(const whirl_fit_run *run, double speed, double ends[2]);

#endif
