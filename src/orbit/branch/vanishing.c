// Test functions of an orbit, which vanish at special points.
#include "vanishing.h"
#include "orbit_describe.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

#include <math.h>

/// A product of complex numbers.
typedef struct product {
    double real, imaginary;
} product;

static void take_into(product *p, double real, double imaginary) {
    const double next = p->real * real - p->imaginary * imaginary;
    p->imaginary = p->real * imaginary + p->imaginary * real;
    p->real = next;
}

/// Multiplies by a factor divided by `size`, an upper bound of its modulus, so that long products do not overflow.
static void take_over(product *p, double real, double imaginary, double size) {
    take_into(p, real / size, imaginary / size);
}

static double vanishing_size_of(const whirl_orbit *orbit, size_t i) {
    return hypot(orbit->multipliers[i].real, orbit->multipliers[i].imaginary);
}

/// Returns the product of (multiplier - at) over all multipliers except the trivial one, each factor divided by
/// |multiplier| + 1. The product is real because complex multipliers come in conjugate pairs.
static double product_about(const whirl_orbit *orbit, double at) {
    const size_t own = orbit_own_multiplier(orbit);
    product all = {1.0, 0.0};
    for (size_t i = 0; i < orbit->multiplier_count; i++)
        if (i != own)
            take_over(&all, orbit->multipliers[i].real - at, orbit->multipliers[i].imaginary,
                      vanishing_size_of(orbit, i) + 1.0);
    return all.real;
}

/// Returns the test function of two multipliers: their product minus 1, which vanishes for a pair on the unit circle
/// and for reciprocal ones. For two eigenvalues of an equilibrium, returns their sum, which vanishes for a pair on the
/// imaginary axis and for opposite ones.
static product of_pair(const whirl_orbit *orbit, size_t i, size_t k) {
    const whirl_multiplier p = orbit->multipliers[i], q = orbit->multipliers[k];
    if (orbit->period == 0.0) return (product){p.real + q.real, p.imaginary + q.imaginary};
    product both = {p.real, p.imaginary};
    take_into(&both, q.real, q.imaginary);
    both.real -= 1.0;
    return both;
}

/// Returns the product of of_pair over all pairs of multipliers without the trivial one, each factor divided by its
/// upper bound.
static double product_of_pairs(const whirl_orbit *orbit) {
    const size_t own = orbit_own_multiplier(orbit);
    product all = {1.0, 0.0};
    for (size_t i = 0; i < orbit->multiplier_count; i++)
        for (size_t k = i + 1; k < orbit->multiplier_count; k++) {
            const product pair = of_pair(orbit, i, k);
            const double a = vanishing_size_of(orbit, i), b = vanishing_size_of(orbit, k),
                         size = orbit->period > 0.0 ? a * b + 1.0 : a + b;
            if (i != own && k != own && size > 0.0) take_over(&all, pair.real, pair.imaginary, size);
        }
    return all.real;
}

bool vanishing_pair(const whirl_orbit *orbit, double *angle) {
    const size_t own = orbit_own_multiplier(orbit);
    double nearest = INFINITY, imaginary = 0.0;
    for (size_t i = 0; i < orbit->multiplier_count; i++)
        for (size_t k = i + 1; k < orbit->multiplier_count; k++) {
            const product pair = of_pair(orbit, i, k);
            const whirl_multiplier p = orbit->multipliers[i];
            if (i == own || k == own || hypot(pair.real, pair.imaginary) >= nearest) continue;
            nearest = hypot(pair.real, pair.imaginary);
            imaginary = fabs(p.imaginary);
            *angle = orbit->period > 0.0 ? atan2(imaginary, p.real) : imaginary;
        }
    return imaginary != 0.0;
}

double vanishing_value(whirl_special kind, size_t touch, const whirl_orbit *orbit) {
    switch (kind) {
    case WHIRL_FOLD:
    case WHIRL_BRANCHING:
        return product_about(orbit, orbit->period > 0.0 ? 1.0 : 0.0);
    case WHIRL_DOUBLING:
        return product_about(orbit, -1.0);
    case WHIRL_NEIMARK_SACKER:
    case WHIRL_HOPF:
        return product_of_pairs(orbit);
    case WHIRL_GRAZE:
        return touch < orbit->touch_count ? orbit->touches[touch].nearest : 1.0;
    case WHIRL_REGULAR:
        break;
    }
    return 1.0;
}
