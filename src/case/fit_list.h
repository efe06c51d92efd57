/// The lists of motions and numbers of a fit.
#ifndef CASE_FIT_LIST_H
#define CASE_FIT_LIST_H

#include "fit_table.h"

/// Adds terms [count] to the checksum of the measured numbers, whirl_fit_options.data.
void fit_list_sum(fit_maker *m, size_t count, const double *terms);

/// Adds a motion. WHIRL_BAD_INPUT if there are too many; WHIRL_NO_MEMORY.
whirl_status fit_list_motion(fit_maker *m, const whirl_fit_motion *motion);

/// Adds a number of the last motion. Errors likewise.
whirl_status fit_list_number(fit_maker *m, const whirl_fit_number *number);

#endif
