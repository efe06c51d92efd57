/// Means of correlated sequences with honest standard errors.
#ifndef ANALYZE_LYAPUNOV_H
#define ANALYZE_LYAPUNOV_H

#include <stddef.h>

#include "whirl/analyze.h"

/// The mean of `values` [count] and its standard error: that of the means of 32 and of 16 blocks, the larger one, so
/// that correlation from one value to the next counts as long as it dies out within a block.
/// NaN for no values; the error is NaN for one.
whirl_estimate estimate_mean(const double *values, size_t count);

/// The mean of a sequence that is periodic or quasi-periodic, as the growth about a settled motion is, much sharper
/// than estimate_mean: a mean over whole periods or a smoothly weighted one, whichever agrees better between the two
/// halves of the sequence. The error is that disagreement: no standard error, and worth nothing for a chaotic motion.
whirl_estimate estimate_regular_mean(const double *values, size_t count, size_t period);

#endif
