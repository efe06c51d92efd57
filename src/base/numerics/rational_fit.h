/// Rational functions that come near samples of a matrix of two rows and columns over frequency, with poles that all
/// entries share, by relaxed vector fitting (Gustavsen, Semlyen 1999; Gustavsen 2006; Deschrijver et al. 2008):
///
///     Z(s) = constant + s slope + sum_j (place_j w_j^2 + rate_j w_j s)/(s^2 + g_j s + w_j^2),  g_j, w_j > 0
///
/// Every pair of poles is so in one form, whether it is complex or of two real ones, and stable; complex ones are no
/// sharper than g_j = half the distance of the samples about them.
#ifndef BASE_RATIONAL_FIT_H
#define BASE_RATIONAL_FIT_H

#include <stdbool.h>
#include <stddef.h>

enum { RATIONAL_MOST_PAIRS = 4, RATIONAL_MOST_SAMPLES = 32, RATIONAL_MOST_SETS = 5, RATIONAL_ENTRIES = 4 };

typedef struct rational_pair {
    double w, g; ///< rad/s
    double place[RATIONAL_ENTRIES], rate[RATIONAL_ENTRIES];
} rational_pair;

typedef struct rational_fit {
    double constant[RATIONAL_ENTRIES], slope[RATIONAL_ENTRIES];
    size_t pair_count;
    rational_pair pairs[RATIONAL_MOST_PAIRS];
} rational_fit;

/// A matrix, row by row, real and imaginary parts.
typedef struct rational_sample {
    double entry[RATIONAL_ENTRIES][2];
} rational_sample;

/// Finds the poles that are best for all of several sets of samples [sets][count] at the same frequencies w [count],
/// rad/s, rising, not below 0, each weighed by its own size: pairs' w and g of out. At negative frequencies functions
/// are conjugate. pair_count: at most (count - 2)/2. False where a number is not finite, or without memory.
bool rational_fit_poles(size_t sets, size_t count, const double *w, const rational_sample *samples, size_t pair_count,
                        rational_fit *out);

/// The function with the poles of io that comes nearest to samples [count]. It is as smooth a function of these as
/// their sizes are. Its slope drives no motion that no sample drives: the symmetric part is kept as large as the least
/// one of the samples' imaginary parts over w, or not below 0.
bool rational_fit_numbers(size_t count, const double *w, const rational_sample *samples, rational_fit *io);

/// The function at i w.
rational_sample rational_fit_value(const rational_fit *of, double w);

/// The root of the sum of squares of all entries.
double rational_size(const rational_sample *of);

#endif
