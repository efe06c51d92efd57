/// Random numbers as pure functions of a seed and of indices: there is no state, so that each can be computed alone.
#ifndef BASE_RANDOM_H
#define BASE_RANDOM_H

#include <stddef.h>
#include <stdint.h>

/// Mixes a number into `before`, a seed or an earlier result, and returns 64 random bits (splitmix64: Steele, Lea,
/// Flood 2014).
uint64_t random_next(uint64_t before, uint64_t number);

/// Returns 64 random bits for a seed and two indices.
uint64_t random_bits(uint64_t seed, uint64_t first, uint64_t second);

/// Returns a random number, above 0 and below 1, for a seed and two indices.
double random_share(uint64_t seed, uint64_t first, uint64_t second);

/// Writes numbers `2 index` and `2 index + 1` of the standard normal sequence of `seed` and `first` (Box, Muller 1958).
void random_normals(uint64_t seed, uint64_t first, uint64_t index, double out[2]);

#endif
