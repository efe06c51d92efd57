/// Measured numbers of a fit that stand in the case: onsets, critical speeds, frequencies and damping ratios of modes.
#ifndef CASE_FIT_VALUE_H
#define CASE_FIT_VALUE_H

#include "fit_table.h"

/// Reads the keys of a set that is a single measured number; returns false if the set is a table.
bool fit_value_read(case_reader *reader, fit_set *out);

/// Returns true for an onset or a critical speed, which is measured along a parameter or the speed.
bool fit_value_varies(const fit_set *set);

/// Reports keys of a set, a table or a single number, that do not fit its other keys.
void fit_value_check_keys(case_reader *reader, const fit_set *set);

/// Adds the single number of a set, and the motion that is computed for it. m->at and m->noise are those of the set.
/// Returns false after a problem.
bool fit_value_make(fit_maker *m, const fit_set *set);

#endif
