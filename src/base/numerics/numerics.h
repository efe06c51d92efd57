/// Numerical methods that several layers share.
#ifndef BASE_NUMERICS_H
#define BASE_NUMERICS_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

// ---------------------------------------------------------------- balance
// Balance and norms of matrices.

#ifdef __cplusplus
extern "C" {
#endif

/// Scales rows and columns by powers of two, so that their norms become similar: the eigenvalues stay to the bit, and
/// the norm approaches the largest of them (Osborne 1960; Parlett, Reinsch 1969). `a` is [n][n], row-major. An
/// eigenvector of the original matrix is that of the balanced one, component by component times scale [n] (may be
/// NULL).
void matrix_balance(size_t n, double *a, double *scale);

/// Returns the smaller of the largest row sum and the largest column sum of moduli, a bound of all eigenvalues.
double matrix_norm(size_t n, const double *a);

#ifdef __cplusplus
}
#endif

// ---------------------------------------------------------------- birkhoff
// The weights of Birkhoff averages: a smooth bump over the points, with which means along a quasi-periodic motion
// converge faster than any power of their number (Das, Saiki, Sander, Yorke 2017).

/// Returns the weight of point n of `count`; not normalized.
static inline double birkhoff_weight(size_t n, size_t count) {
    const double t = (double)(n + 1) / (double)(count + 1);
    return exp(-1.0 / (t * (1.0 - t)));
}

// ---------------------------------------------------------------- elimination
// Elimination with row exchanges that skips zeros, for mostly zero matrices (those of an orbit's segments, one after
// the other), and for many right-hand sides one after the other.

/// Decomposes a [n][n], row-major, in place; order [n] are the rows exchanged. False if a number is not finite or a
/// pivot vanishes.
bool elimination_decompose(size_t n, double *a, size_t *order);

/// Solves for b [n], which becomes the solution.
void elimination_solve(size_t n, const double *a, const size_t *order, double *b);

// ---------------------------------------------------------------- mineral_oil
// Kinematic viscosity of mineral oils over temperature: log10 log10(nu + 0.7), nu in mm2/s, falls linearly with log10
// T (Walther 1931; ASTM D341).

/// Temperatures at which viscosities are usually given, K.
#define OIL_40_DEGREES 313.15
#define OIL_100_DEGREES 373.15

/// Returns m2/s at a temperature (K), from the two of `count` >= 2 rows around it, or else the nearest two;
/// temperatures rise, viscosities fall.
double mineral_oil_viscosity(const double *temperatures, const double *viscosities, size_t count, double temperature);

/// Returns m2/s at 100 degC of an oil of viscosity index 100, from that at 40 degC, 6.5 to 1500 mm2/s (ASTM D2270;
/// straight lines between logarithms of some rows of its table).
double mineral_oil_at_100(double at_40);

// ---------------------------------------------------------------- rational_fit
// Rational fits to samples of a 2 x 2 matrix over frequency, with poles that all entries share, by relaxed vector
// fitting (Gustavsen, Semlyen 1999; Gustavsen 2006; Deschrijver et al. 2008):
//
//     Z(s) = constant + s slope + sum_j (place_j w_j^2 + rate_j w_j s)/(s^2 + g_j s + w_j^2),  g_j, w_j > 0
//
// This form covers complex pairs and pairs of real poles, all stable; complex ones are no sharper than g_j = half the
// distance of the samples around them.

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
/// rising, not negative, each weighted by its own size: pairs' w and g of out. At negative frequencies functions are
/// conjugate. pair_count: at most (count - 2)/2. False if a number is not finite, or without memory.
bool rational_fit_poles(size_t sets, size_t count, const double *w, const rational_sample *samples, size_t pair_count,
                        rational_fit *out);

/// Finds the function with the poles of io that is nearest to samples [count]. It depends as smoothly on them as their
/// sizes do. Its slope drives no motion that no sample drives: the symmetric part is at least the least of the samples'
/// imaginary parts over w, or 0.
bool rational_fit_numbers(size_t count, const double *w, const rational_sample *samples, rational_fit *io);

/// Returns the function at i w.
rational_sample rational_fit_value(const rational_fit *of, double w);

/// Returns the root of the sum of squares of all entries.
double rational_size(const rational_sample *of);

// ---------------------------------------------------------------- taylor
// Flow between cylinders of which the inner one turns.

/// Taylor's number, Re (c/R)^(1/2) with Re = rho Omega R c/mu, at which vortices begin (Taylor 1923).
#define FIRST_VORTICES 41.2

// ---------------------------------------------------------------- turns
// Angles in a state: whirl_system.turns and .angles have the length of a turn of each, 0 for other coordinates.

/// Returns true if part i of a state is an angle; `turns` may be NULL.
static inline bool turns_on(const double *turns, size_t i) {
    return turns && turns[i] > 0.0;
}

/// Counts the angles among n parts.
static inline size_t turns_count(const double *turns, size_t n) {
    size_t count = 0;
    for (size_t i = 0; i < n; i++) count += turns_on(turns, i);
    return count;
}

/// Reduces an angle to its first turn.
static inline double in_first_turn(double angle, double turn) {
    return angle - turn * floor(angle / turn);
}

/// Difference of two values of part i: of an angle (whirl_system.angles, may be NULL) the short way round.
static inline double short_way(const double *angles, size_t i, double difference) {
    return turns_on(angles, i) ? remainder(difference, angles[i]) : difference;
}

/// Difference of part i of states a and b; 0 for coordinates that turn.
static inline double part_apart(const double *turns, const double *angles, size_t i, const double *a, const double *b) {
    return turns_on(turns, i) ? 0.0 : short_way(angles, i, a[i] - b[i]);
}

/// Part i after a revolution: coordinates that turn are reduced to their first turn, other angles to half a turn about
/// 0.
static inline double part_wrapped(const double *turns, const double *angles, size_t i, double value) {
    return turns_on(turns, i) ? in_first_turn(value, turns[i]) : short_way(angles, i, value);
}

#endif
