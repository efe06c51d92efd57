/// Measured numbers of a fit that stand in the case: onsets, critical speeds, frequencies and damping ratios of modes.
#ifndef CASE_FIT_VALUE_H
#define CASE_FIT_VALUE_H

#include "fit_table.h"

/// Reads the keys of such a number; returns false for a table.
bool fit_value_read(case_reader *reader, fit_set *out);

/// Returns true for an onset or a critical speed, which is measured along a parameter or the speed.
bool fit_value_varies(const fit_set *set);

/// Checks the keys of a table, or of such a number, that do not fit the others.
void fit_value_check_keys(case_reader *reader, const fit_set *set);

/// Adds the number, and what is computed for it. m->at and m->noise are those of the set. Returns false after a
/// problem.
bool fit_value_make(fit_maker *m, const fit_set *set);

#endif
