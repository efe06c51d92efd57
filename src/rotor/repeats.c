#include "machine.h"

#include <math.h>

size_t repeats_of(double ratio) {
    // Ratios of a frequency to a speed have a few roundings.
    const double rounding = 1e-14;
    for (size_t q = 1; q <= WHIRL_MAX_REPEATS; q++) {
        const double turns = (double)q * ratio;
        if (fabs(turns - rint(turns)) <= rounding * fmax(fabs(turns), 1.0)) return q;
    }
    return 0;
}

size_t repeats_of_both(size_t a, size_t b) {
    if (a == 0 || b == 0) return 0;
    size_t common = a;
    while (common % b != 0) common += a;
    return common <= WHIRL_MAX_REPEATS ? common : 0;
}
