// Samples of parameters with tolerances: scrambled Sobol sequences through the quantiles of distributions.
#include <limits.h>
#include <math.h>
#include <stdint.h>

#include "member_table.h"
#include "random.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/tolerances.h"

enum { DIGITS = 32, DEGREE = 7, DIMENSIONS = 2 * WHIRL_MAX_TOLERANCES };

/// A primitive polynomial over two elements and the first direction numbers (Joe, Kuo 2008, new-joe-kuo-6.21201).
typedef struct direction {
    unsigned char degree, polynomial; ///< polynomial: its inner coefficients as binary digits
    unsigned char first[DEGREE];      ///< [degree]
} direction;

/// Dimensions from the second on; the first is van der Corput's sequence.
static const direction directions[DIMENSIONS - 1] = {
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
    {7, 7, {1, 1, 3, 13, 7, 35, 63}},
    {7, 8, {1, 3, 5, 9, 1, 25, 53}},
    {7, 14, {1, 3, 1, 13, 9, 35, 107}},
    {7, 19, {1, 3, 1, 5, 27, 61, 31}},
    {7, 21, {1, 1, 5, 11, 19, 41, 61}},
    {7, 28, {1, 3, 5, 3, 3, 13, 69}},
    {7, 31, {1, 1, 7, 13, 1, 19, 1}},
    {7, 32, {1, 3, 7, 5, 13, 19, 59}},
    {7, 37, {1, 1, 3, 9, 25, 29, 41}},
    {7, 41, {1, 3, 5, 13, 23, 1, 55}},
    {7, 42, {1, 3, 7, 3, 13, 59, 17}},
};

const whirl_member *whirl_tolerance_members(void) {
    static const whirl_member members[] = {
        MEMBER(whirl_tolerance_options, WHOLE, "samples", samples, "tolerances", false, "samples", "N", "1",
               WHIRL_KEY_WHOLE, false, "1024", WHIRL_FROM_TO(WHIRL_MIN_SAMPLES, WHIRL_MAX_SAMPLES), NULL,
               "number of samples, a power of two: points of a scrambled Sobol sequence", "Joe, Kuo 2008"),
        MEMBER(whirl_tolerance_options, WHOLE, "seed", seed, "tolerances", false, "seed", "", "1", WHIRL_KEY_WHOLE,
               false, "1", WHIRL_FROM_TO(0, INT_MAX), NULL,
               "seed of the scrambling: another one gives other samples, and the same one always the same", ""),
        MEMBER(whirl_tolerance_options, FLAG, "indices", indices, "tolerances", false, "indices", "", "",
               WHIRL_KEY_CHOICE, false, "no", WHIRL_ANY, "yes|no|true|false",
               "yes: the part of the variance that each parameter causes, alone and with the others; every sample then "
               "takes as many machines as there are parameters, and two more",
               "Saltelli et al. 2010; Jansen 1999"),
        MEMBER(whirl_tolerance_options, WHOLE, "parameters", parameters, "", false, "parameters", "", "1",
               WHIRL_KEY_WHOLE, false, "0", WHIRL_FROM_TO(0, WHIRL_MAX_TOLERANCES), NULL,
               "number of parameters with tolerances", ""),
        {.part = NULL},
    };
    return members;
}

size_t whirl_tolerance_each(const whirl_tolerance_options *options) {
    return options->indices ? (size_t)options->parameters + 2 : 1;
}

size_t whirl_tolerance_machines(const whirl_tolerance_options *options) {
    return options->samples > 0 ? (size_t)options->samples * whirl_tolerance_each(options) : 0;
}

// ---------------------------------------------------------------- the sequence

/// Returns direction number k of a dimension, from 0, as a binary fraction: by the recurrence of its polynomial.
static uint32_t direction_number(const direction *of, unsigned k) {
    uint32_t numbers[DIGITS] = {0};
    const unsigned s = of->degree;
    for (unsigned i = 0; i <= k; i++) {
        if (i < s) {
            numbers[i] = (uint32_t)of->first[i] << (DIGITS - 1 - i);
            continue;
        }
        numbers[i] = numbers[i - s] ^ numbers[i - s] >> s;
        for (unsigned j = 1; j < s; j++)
            if (of->polynomial >> (s - 1 - j) & 1) numbers[i] ^= numbers[i - j];
    }
    return numbers[k];
}

unsigned whirl_sobol(size_t index, size_t dimension) {
    uint32_t x = 0;
    for (unsigned k = 0; k < DIGITS && index >> k > 0; k++)
        if (index >> k & 1)
            x ^= dimension == 0 ? (uint32_t)1 << (DIGITS - 1 - k) : direction_number(&directions[dimension - 1], k);
    return x;
}

// ---------------------------------------------------------------- scrambling

/// Returns 32 random bits, which depend on the arguments alone.
static uint32_t scrambling_bits(int seed, size_t replicate, size_t dimension, unsigned which) {
    const uint64_t of = random_next((uint64_t)(unsigned)seed, 0);
    return (uint32_t)(random_next(random_next(random_next(of, replicate), dimension), which) >> 32);
}

static unsigned parity(uint32_t x) {
    x ^= x >> 16, x ^= x >> 8, x ^= x >> 4, x ^= x >> 2, x ^= x >> 1;
    return x & 1;
}

/// Scrambles the digits of a coordinate by a random lower triangular matrix, and adds random digits (Matousek 1998): a
/// net stays a net, and every point is uniformly distributed.
static uint32_t scramble(uint32_t x, int seed, size_t replicate, size_t dimension) {
    uint32_t y = scrambling_bits(seed, replicate, dimension, DIGITS);
    for (unsigned row = 0; row < DIGITS; row++) {
        const uint32_t own = (uint32_t)1 << (DIGITS - 1 - row), above = ~(own | (own - 1));
        y ^= parity(x & (own | (scrambling_bits(seed, replicate, dimension, row) & above))) ? own : 0;
    }
    return y;
}

// ---------------------------------------------------------------- distributions

/// Returns the distribution function of the standard normal distribution, or of its upper tail.
static double normal_share(double x, bool upper) {
    const double root_half = 0.707106781186547524401;
    return 0.5 * erfc((upper ? x : -x) * root_half);
}

/// Returns the value below which the standard normal distribution has a share up to a half: Newton's method on erfc
/// from an asymptotic estimate.
static double normal_lower(double share) {
    const double root = 2.50662827463100050242; // of 2 pi
    if (!(share > 0.0)) return -INFINITY;
    const double t = sqrt(-2.0 * log(share));
    double x = -(t - (2.515517 + t * (0.802853 + t * 0.010328)) /
                         (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)))); // Hastings 1955, to 4.5e-4
    for (int i = 0; i < 4; i++) {
        const double error = (normal_share(x, false) - share) * root * exp(0.5 * x * x);
        x -= error / (1.0 + 0.5 * x * error); // Halley
    }
    return x;
}

double whirl_tolerance_value(const whirl_tolerance *t, double share) {
    if (t->deviation == 0.0) return t->low + share * (t->high - t->low);
    const double low = (t->low - t->mean) / t->deviation, high = (t->high - t->mean) / t->deviation;
    // Computes in the tail that holds the value, so that no digit is lost.
    const double below = normal_share(low, false), above = normal_share(high, true);
    const double from_low = below + share * (normal_share(high, false) - below);
    const double from_high = above + (1.0 - share) * (normal_share(low, true) - above);
    const double x = from_low <= 0.5 ? normal_lower(from_low) : -normal_lower(from_high);
    return fmin(fmax(t->mean + t->deviation * x, t->low), t->high);
}

// ---------------------------------------------------------------- machines

void whirl_tolerance_values(const whirl_tolerance_options *options, const whirl_tolerance *tolerances, size_t machine,
                            double *values) {
    const size_t count = (size_t)options->parameters, each = whirl_tolerance_each(options);
    const size_t sample = machine / each, which = machine % each;
    const size_t replicate = sample % WHIRL_REPLICATES, index = sample / WHIRL_REPLICATES;
    for (size_t i = 0; i < count; i++) {
        const bool other = which == 1 || which == 2 + i;
        const size_t dimension = i + (other ? count : 0);
        const uint32_t digits = scramble(whirl_sobol(index, dimension), options->seed, replicate, dimension);
        values[i] = whirl_tolerance_value(&tolerances[i], ((double)digits + 0.5) / 4294967296.0);
    }
}
