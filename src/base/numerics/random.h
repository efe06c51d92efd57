/// Random numbers that are pure functions of what they are for: no state, so that any of them can be made alone.
#ifndef BASE_RANDOM_H
#define BASE_RANDOM_H

#include <stddef.h>
#include <stdint.h>

/// Returns 64 random bits for the bits before and a number (splitmix64: Steele, Lea, Flood 2014). Bits for several
/// numbers are taken one after the other, from a seed.
uint64_t random_next(uint64_t before, uint64_t number);

/// Returns 64 random bits for a seed and two numbers of a purpose.
uint64_t random_bits(uint64_t seed, uint64_t first, uint64_t second);

/// Returns a random number, above 0 and below 1, for the same.
double random_share(uint64_t seed, uint64_t first, uint64_t second);

/// Returns numbers `2 index` and `2 index + 1` of a sequence of the standard normal distribution (Box, Muller 1958).
void random_normals(uint64_t seed, uint64_t first, uint64_t index, double out[2]);

#endif
