/// Means of correlated sequences, with standard errors that allow for the correlation.
#ifndef ANALYZE_MEAN_GROWTH_H
#define ANALYZE_MEAN_GROWTH_H

#include "whirl/engine/analyze.h"
#include "whirl/engine/record.h"

#include <stdbool.h>
#include <stddef.h>

/// Returns the mean of `values` [count] and its standard error, from the scatter of the means of 16 and of 32 blocks:
/// the larger of the two. It allows for correlation that dies out within a block. NaN for no values; the error is NaN
/// for one.
whirl_estimate estimate_mean(const double *values, size_t count);

/// Returns the mean of a periodic or quasi-periodic sequence, such as the growth about a settled motion. It is a mean
/// over whole periods or a smoothly weighted mean: the one whose values for the two halves of the sequence agree
/// better. It is much more accurate than estimate_mean. The error is the disagreement of the halves, not a standard
/// error; it is meaningless for a chaotic motion.
whirl_estimate estimate_regular_mean(const double *values, size_t count, size_t period);

/// Sum of all exponents, compared with its exact value.
typedef struct growth_balance {
    double sum, exact; ///< sum of all exponents; the same from the divergence, NaN if unknown
    double miss;       ///< distance of `sum` from `exact`, an error of the integration; 0 if unknown
    /// The distance exceeds the standard errors and a thousandth of all exponents' sizes: the steps did not resolve the
    /// perturbations, and no exponent is valid.
    bool failed;
} growth_balance;

/// Returns true for a bounded motion with all perturbations followed.
bool follows_all(const whirl_record *record);

/// Computes the means and standard errors of all growths of a motion for which follows_all is true, exponents
/// [dimension], and their balance; `values` [growth_count] is workspace.
growth_balance gather_exponents(const whirl_record *record, whirl_estimate *exponents, double *values);

/// Returns the sharp mean (estimate_regular_mean) of the second perturbation's growth, after the first tenth of the
/// revolutions. NaN if not all perturbations were followed, or if memory is exhausted.
whirl_estimate second_exponent(const whirl_record *record);

/// Computes the balance alone. All zero if not all perturbations were followed, or if memory is exhausted.
growth_balance balance_growth(const whirl_record *record);

#endif
