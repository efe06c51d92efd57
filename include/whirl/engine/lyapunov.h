/// Lyapunov exponents of a recorded motion, and the dimension of its attractor.
#ifndef WHIRL_LYAPUNOV_H
#define WHIRL_LYAPUNOV_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/record.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A mean with its standard error.
typedef struct whirl_estimate {
    double value, error; ///< the mean, and its standard error
} whirl_estimate;

/// Estimates the largest Lyapunov exponent per revolution (natural logarithm): the mean growth of a perturbation over
/// the revolutions in which it was followed, without the first tenth. The error is the standard error of block means.
/// If all perturbations were followed, it includes the distance of the sum of all exponents from the mean divergence.
/// NaN if no perturbation was followed, or if that distance is too large (whirl_lyapunov_spectrum).
whirl_estimate whirl_lyapunov_largest(const whirl_record *record);

/// Estimates all Lyapunov exponents per revolution [dimension], as whirl_lyapunov_largest does. Returns false, with
/// NaN, if not all perturbations were followed, or if the sum of the exponents differs from the mean divergence by more
/// than the standard errors and a thousandth of the exponents' sizes.
bool whirl_lyapunov_spectrum(const whirl_record *record, whirl_estimate *exponents);

/// Returns the Kaplan-Yorke dimension of the attractor in the section from exponents [count], largest first: the number
/// of exponents whose sum is not below zero, plus a fraction of the next. Exponents within 3 errors of zero, and within
/// 0.002, count as zero.
double whirl_kaplan_yorke(const whirl_estimate *exponents, size_t count);

#ifdef __cplusplus
}
#endif
#endif
