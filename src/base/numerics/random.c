#include "random.h"
#include "two_pi.h"

#include <math.h>

uint64_t random_next(uint64_t before, uint64_t number) {
    uint64_t z = before + UINT64_C(0x9e3779b97f4a7c15) * (1 + number);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

uint64_t random_bits(uint64_t seed, uint64_t first, uint64_t second) {
    return random_next(random_next(random_next(seed, 0), first), second);
}

double random_share(uint64_t seed, uint64_t first, uint64_t second) {
    return ((double)(random_bits(seed, first, second) >> 11) + 0.5) / 9007199254740992.0;
}

void random_normals(uint64_t seed, uint64_t first, uint64_t index, double out[2]) {
    const double size = sqrt(-2.0 * log(random_share(seed, first, 2 * index)));
    const double angle = two_pi * random_share(seed, first, 2 * index + 1);
    out[0] = size * cos(angle);
    out[1] = size * sin(angle);
}
