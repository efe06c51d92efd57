/// Rational fits to samples of a 2 x 2 matrix over frequency, with poles that all entries share, by relaxed vector
/// fitting (Gustavsen, Semlyen 1999; Gustavsen 2006; Deschrijver et al. 2008):
///
///     Z(s) = constant + s slope + sum_j (place_j w_j^2 + rate_j w_j s)/(s^2 + g_j s + w_j^2),  g_j, w_j > 0
///
/// This form covers complex pairs and pairs of real poles, all stable; complex ones are no sharper than g_j = half the
/// distance of the samples around them.
#ifndef BASE_RATIONAL_FIT_H
#define BASE_RATIONAL_FIT_H

#include <stdbool.h>
#include <stddef.h>

enum { RATIONAL_MAX_PAIRS = 4, RATIONAL_MAX_SAMPLES = 32, RATIONAL_MAX_SETS = 5, RATIONAL_ENTRIES = 4 };

typedef struct rational_pair {
    double w, g; ///< rad/s
    double place[RATIONAL_ENTRIES], rate[RATIONAL_ENTRIES];
} rational_pair;

typedef struct rational_fit {
    double constant[RATIONAL_ENTRIES], slope[RATIONAL_ENTRIES];
    size_t pair_count;
    rational_pair pairs[RATIONAL_MAX_PAIRS];
} rational_fit;

/// A matrix, row by row, real and imaginary parts.
typedef struct rational_sample {
    double entry[RATIONAL_ENTRIES][2];
} rational_sample;

/// Finds the best common poles for several sets of samples [sets][count] at the same frequencies w [count], rad/s,
/// rising, not negative, and writes them as w and g of the pairs of out. Each sample is weighted by its own size. At
/// negative frequencies functions are conjugate. pair_count: at most (count - 2)/2. False if a number is not finite, or
/// without memory.
bool rational_fit_poles(size_t sets, size_t count, const double *w, const rational_sample *samples, size_t pair_count,
                        rational_fit *out);

/// Finds the function with the poles of io that is nearest to samples [count]. It depends as smoothly on the samples as
/// their sizes do. Its slope makes no motion unstable unless a sample does: no eigenvalue of the slope's symmetric part
/// is below the least damping of the samples (imaginary part over w), or below 0 if no sample has a negative one.
bool rational_fit_numbers(size_t count, const double *w, const rational_sample *samples, rational_fit *io);

/// Returns the function at s = i w.
rational_sample rational_fit_value(const rational_fit *of, double w);

/// Returns the size of a sample: the root of the sum of squares of all entries.
double rational_size(const rational_sample *of);

#endif
