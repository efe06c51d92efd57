/// Means of correlated sequences with honest standard errors.
#ifndef ANALYZE_LYAPUNOV_H
#define ANALYZE_LYAPUNOV_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/analyze.h"

/// The mean of `values` [count] and its standard error: that of the means of 32 and of 16 blocks, the larger one, so
/// that correlation from one value to the next counts as long as it dies out within a block.
/// NaN for no values; the error is NaN for one.
whirl_estimate estimate_mean(const double *values, size_t count);

/// The mean of a sequence that is periodic or quasi-periodic, as the growth about a settled motion is, much sharper
/// than estimate_mean: a mean over whole periods or a smoothly weighted one, whichever agrees better between the two
/// halves of the sequence. The error is that disagreement: no standard error, and worth nothing for a chaotic motion.
whirl_estimate estimate_regular_mean(const double *values, size_t count, size_t period);

/// The growth of all perturbations beside what their sum must be.
typedef struct growth_balance {
    double sum, exact; ///< of all exponents, and by the divergence; NaN where it is not known
    double miss;       ///< their distance, which is an error of the integration: 0 where it is not known
    /// It is more than the standard errors and more than a thousandth of all exponents' sizes: the steps did not carry
    /// the perturbations, and no exponent means anything.
    bool failed;
} growth_balance;

/// Whether a bounded motion took all perturbations along.
bool follows_all(const whirl_record *record);

/// The means and standard errors of all growths of such a motion, exponents [dimension], and their balance; `values`
/// [growth_count] is workspace.
growth_balance gather_exponents(const whirl_record *record, whirl_estimate *exponents, double *values);

/// The sharp mean (estimate_regular_mean) of the growth of the second of all perturbations, after the first tenth of
/// the revolutions. NaN where not all were followed, or there is no memory.
whirl_estimate second_exponent(const whirl_record *record);

/// The balance alone. All zero where not all perturbations were followed, or there is no memory.
growth_balance balance_growth(const whirl_record *record);

#endif
