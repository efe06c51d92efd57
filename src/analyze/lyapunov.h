/// Means of correlated sequences with honest standard errors.
#ifndef ANALYZE_LYAPUNOV_H
#define ANALYZE_LYAPUNOV_H

#include <stddef.h>

#include "whirl/analyze.h"

/// The mean of `values` [count] and its standard error. The error is that of the means of blocks; the length of the
/// blocks is doubled from one value on for as long as at least 16 remain, and the largest error counts, so that
/// correlation from one value to the next, however it decays, does not make the error too small.
/// NaN for no values; the error is NaN for one.
whirl_estimate estimate_mean(const double *values, size_t count);

#endif
