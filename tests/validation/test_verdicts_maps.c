// Verdicts on flows whose section follows a map that is known.
//
// Any map G is the section of a smooth flow: x rests while y comes to G(x), then y rests while x comes to y,
//
//     y' = -K a(t) (y - G(x)),  x' = -K b(t) (x - y),  a = max(0, sin t)^2,  b = max(0, -sin t)^2.
//
// After each half the distance from the target is exp(-K pi/2) = 1e-17 of that before, for all steps: the equations are
// linear, and the target does not move. So motions are known that no flow of a textbook has: locks of every period,
// chaos that is proven, and chaos that ends after a known mean lifetime.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_known.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

static const double two_pi = 6.28318530717958647693;

typedef void map(const double *p, const double *x, double *y);

// ---------------------------------------------------------------- maps: parameters p[1], ...; p[0] is the map's number

/// The logistic map; p: r.
static void logistic(const double *p, const double *x, double *y) {
    y[0] = p[1] * x[0] * (1.0 - x[0]);
}

/// A parabola that exceeds the interval 0 .. 1 by p: motions leave it at its middle, after pi/(2 sqrt(p)) revolutions
/// on average (by the density 1/(pi sqrt(x (1 - x)))), and go to -1, where the map is flat.
static void holed(const double *p, const double *x, double *y) {
    const double square = 4.0 * (1.0 + p[1]) * x[0] * (1.0 - x[0]), bend = 20.0;
    y[0] = square < 40.0 ? log1p(exp(bend * (square + 1.0))) / bend - 1.0 : square;
}

/// Henon's map (1976); p: a, b.
static void henon(const double *p, const double *x, double *y) {
    y[0] = 1.0 - p[1] * x[0] * x[0] + x[1];
    y[1] = p[2] * x[0];
}

/// Round a circle that draws in: theta -> theta + p - s/(2 pi q) sin(2 pi q theta), in turns; p: turn, q, s. With
/// turn = m/q it is locked on P-q at theta = 0, 1/q, ... with the multiplier 1 - s of each revolution.
static void circle(const double *p, const double *x, double *y) {
    const double radius = hypot(x[0], x[1]), next = 1.0 + 0.3 * (radius - 1.0), angle = atan2(x[1], x[0]);
    const double turned = angle + two_pi * p[1] - p[3] / p[2] * sin(p[2] * angle);
    y[0] = next * cos(turned);
    y[1] = next * sin(turned);
}

/// Two such rotations without a lock; p: both turns.
static void two_circles(const double *p, const double *x, double *y) {
    for (size_t i = 0; i < 2; i++) circle((double[]){0.0, p[1 + i], 1.0, 0.0}, x + 2 * i, y + 2 * i);
}

/// A spiral about (1, 1); p: modulus and angle, in turns, of the multipliers.
static void spiral(const double *p, const double *x, double *y) {
    const double c = p[1] * cos(two_pi * p[2]), s = p[1] * sin(two_pi * p[2]);
    y[0] = 1.0 + c * (x[0] - 1.0) - s * (x[1] - 1.0);
    y[1] = 1.0 + s * (x[0] - 1.0) + c * (x[1] - 1.0);
}

static const struct {
    map *map;
    size_t size;
} maps[] = {{logistic, 1}, {holed, 1}, {henon, 2}, {circle, 2}, {two_circles, 4}, {spiral, 2}};

enum { LOGISTIC, HOLED, HENON, CIRCLE, TWO_CIRCLES, SPIRAL };

static void rhs(const void *model, double t, const double *forcing, const double *z, double *dzdt) {
    const double *p = model, speed = 25.0, s = sin(t), a = s > 0.0 ? speed * s * s : 0.0,
                 b = s < 0.0 ? speed * s * s : 0.0;
    const size_t n = maps[(int)p[0]].size;
    double target[4];
    (void)forcing;
    maps[(int)p[0]].map(p, z, target);
    for (size_t i = 0; i < n; i++) {
        dzdt[i] = -b * (z[i] - z[n + i]);
        dzdt[n + i] = -a * (z[n + i] - target[i]);
    }
}

static void set(known_motion *m, int number, double a, double b, double c, const char *expected, bool trap) {
    m->p[0] = number;
    m->p[1] = a;
    m->p[2] = b;
    m->p[3] = c;
    m->system = (whirl_system){.dimension = 2 * maps[number].size, .period = two_pi, .rhs = rhs};
    snprintf(m->expected, sizeof m->expected, "%s", expected);
    m->trap = trap;
    snprintf(m->label, sizeof m->label, "%.12g, %.12g, %.12g", a, b, c);
}

static void expect_period(known_motion *m, int period) {
    snprintf(m->expected, sizeof m->expected, "P-%d", period);
}

// ---------------------------------------------------------------- locks

/// Makes a lock on P-2 to P-89, strong to weak: multipliers of a revolution .1, .8, .98, and .996, which may be left
/// open.
static bool make_lock(size_t index, known_motion *m) {
    static const double strengths[] = {0.9, 0.2, 0.02, 0.004};
    const int q = 2 + (int)(index / 4);
    const double s = strengths[index % 4];
    if (q > 89) return false;
    int turns = (int)(0.38196601125 * q + 0.5); // near the golden section, and without a common divisor
    for (int k = 2; k <= turns; k++)
        if (turns % k == 0 && q % k == 0) k = 1, turns--;
    if (turns < 1) turns = 1;
    set(m, CIRCLE, (double)turns / q, q, s, "", s < 0.01);
    expect_period(m, q);
    m->start[0] = cos(0.31 / q);
    m->start[1] = sin(0.31 / q);
    return true;
}

/// Makes a drift just past the tongue of m/q, whose edge delta = s/(2 pi q) is exceeded by a share: the motion slows
/// down at every branch, and takes 1/(q sqrt(delta^2 - edge^2)) revolutions from one to the next.
static bool make_drift(size_t index, known_motion *m) {
    static const double beyond[] = {3.0, 0.3, 0.03, 1e-3, 1e-5};
    static const int fractions[][2] = {{1, 2}, {1, 3}, {2, 5}, {3, 8}, {5, 13}, {8, 21}, {13, 34}, {34, 89}};
    if (index >= COUNT_OF(beyond) * COUNT_OF(fractions)) return false;
    const int *f = fractions[index / COUNT_OF(beyond)];
    const double s = 0.1, edge = s / (two_pi * f[1]), share = beyond[index % COUNT_OF(beyond)];
    set(m, CIRCLE, (double)f[0] / f[1] + edge * (1.0 + share), f[1], s, "quasi-periodic (1 curve)", true);
    m->start[0] = 0.9;
    m->start[1] = 0.1;
    return true;
}

/// Makes a torus of three frequencies: both rotations and their ratio are irrational.
static bool make_two_rotations(size_t index, known_motion *m) {
    static const double turns[] = {0.3819660112501052, 0.4142135623730951, 0.7320508075688772, 0.2360679774997897,
                                   0.6457513110645906, 0.1622776601683795, 0.3166247903553998, 0.6055512754639891};
    const size_t i = index / 4, k = (i + 1 + index % 4) % COUNT_OF(turns);
    if (i >= COUNT_OF(turns)) return false;
    set(m, TWO_CIRCLES, turns[i], turns[k], 0.0, "quasi-periodic", true);
    m->start[0] = m->start[3] = 0.8;
    return true;
}

// ---------------------------------------------------------------- logistic map

static double iterate(double r, double x, int count) {
    while (count-- > 0) x = r * x * (1.0 - x);
    return x;
}

/// Returns a function of r that is 0 if the middle returns after k steps (superstable P-k), or with `meets` if it falls
/// on the unstable fixed point 1 - 1/r after k: chaos with an invariant density (Misiurewicz 1981).
static double condition(double r, int k, bool meets) {
    return iterate(r, 0.5, k) - (meets ? 1.0 - 1.0 / r : 0.5);
}

/// Returns true if this condition holds for a smaller k, too.
static bool is_earlier(double r, int k, bool meets) {
    for (int j = 1; j < k; j++)
        if (fabs(condition(r, j, meets)) < 1e-7) return true;
    return false;
}

/// Returns the root number `index` from r = 3 on, by steps; NaN after the last.
static double find_root(int k, bool meets, size_t index) {
    const double step = 1e-4;
    for (int n = 1; n < 10000; n++) {
        double low = 3.0 + step * (n - 1), high = 3.0 + step * n;
        if (condition(low, k, meets) * condition(high, k, meets) > 0.0) continue;
        for (int i = 0; i < 60; i++) {
            const double middle = 0.5 * (low + high);
            *(condition(low, k, meets) * condition(middle, k, meets) > 0.0 ? &low : &high) = middle;
        }
        if (fabs(condition(low, k, meets)) < 1e-7 && !is_earlier(low, k, meets) && index-- == 0) return low;
    }
    return NAN;
}

/// Returns the last root of P-k before 4, where windows are narrow and chaos lasts long before it ends.
static double find_last(int k) {
    double low = 1e-12, high = low; // below 4
    while (condition(4.0 - high, k, false) < 0.0) low = high, high *= 1.05;
    for (int i = 0; i < 80; i++) {
        const double middle = 0.5 * (low + high);
        *(condition(4.0 - middle, k, false) < 0.0 ? &low : &high) = middle;
    }
    return 4.0 - low;
}

/// Makes a window of P-2 to P-12: five of each from 3 on, and the last up to P-7. In that of P-8 chaos lasts 3e4
/// revolutions on average before it meets a basin that is 6e-5 wide, which no search of whirl's finds.
static bool make_window(size_t index, known_motion *m) {
    const size_t of_each = 6;
    const int k = 2 + (int)(index / of_each);
    if (k > 12) return false;
    double r = index % of_each == of_each - 1 && k < 8 ? find_last(k) : find_root(k, false, index % of_each);
    if (isnan(r)) r = find_root(k, false, 0);
    set(m, LOGISTIC, r, 0.0, 0.0, "", true);
    expect_period(m, k);
    m->start[0] = 0.3 + 0.01 * (double)index;
    return true;
}

/// Makes a system whose chaos is proven, or Henon's.
static bool make_chaos(size_t index, known_motion *m) {
    static const int k_of[] = {3, 4, 4, 5, 5, 5, 5, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 7};
    static const size_t number[] = {0, 0, 1, 0, 1, 2, 3, 0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 5, 6, 7};
    if (index >= COUNT_OF(k_of) + 4) return false;
    if (index < COUNT_OF(k_of)) {
        const double r = find_root(k_of[index], true, number[index]);
        set(m, LOGISTIC, isnan(r) ? 4.0 - 1e-13 : r, 0.0, 0.0, "chaotic", false);
        m->start[0] = 0.3;
    } else {
        set(m, HENON, 1.4, 0.3, 0.0, "chaotic", false);
        m->start[0] = 0.1 * (double)(index - COUNT_OF(k_of));
    }
    return true;
}

/// Makes transient chaos, of 1e3 to 1e6 revolutions on average.
static bool make_transient(size_t index, known_motion *m) {
    static const double lifetimes[] = {1e2, 3e2, 1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6};
    if (index >= 5 * COUNT_OF(lifetimes)) return false;
    const double root = 0.25 * two_pi / lifetimes[index % COUNT_OF(lifetimes)];
    set(m, HOLED, root * root, 0.0, 0.0, "P-1", true);
    m->start[0] = 0.13 + 0.17 * (double)(index / COUNT_OF(lifetimes));
    return true;
}

// ---------------------------------------------------------------- growth

/// Angles of multipliers, in turns.
static const double angles[] = {0.0, 0.5, 0.25, 0.3819660112501052, 0.01};

/// Makes a spiral with multipliers above 1: from 1e-6 on; some leave all bounds within the run, and slow ones do not.
static bool make_growth(size_t index, known_motion *m) {
    static const double moduli[] = {3.0, 1.5, 1.2, 1.1, 1.05, 1.01, 1.003, 1.001};
    if (index >= COUNT_OF(moduli) * COUNT_OF(angles)) return false;
    const double modulus = moduli[index % COUNT_OF(moduli)];
    set(m, SPIRAL, modulus, angles[index / COUNT_OF(moduli)], 0.0, "diverged", modulus < 1.1);
    m->start[0] = 1.0 + 1e-6;
    m->start[1] = 1.0;
    return true;
}

/// Makes a spiral with multipliers below 1 and close to it: it settles slowly.
static bool make_settling(size_t index, known_motion *m) {
    static const double moduli[] = {0.2, 0.9, 0.97, 0.99, 0.997, 0.999};
    if (index >= COUNT_OF(moduli) * COUNT_OF(angles)) return false;
    const double modulus = moduli[index % COUNT_OF(moduli)];
    set(m, SPIRAL, modulus, angles[index / COUNT_OF(moduli)], 0.0, "P-1", modulus > 0.98);
    m->start[0] = 2.0;
    return true;
}

static const known_family families[] = {
    {"locks P-2 to P-89", "construction", 128, make_lock},
    {"slow drifts past a lock", "construction", 128, make_drift},
    {"tori of three frequencies", "construction", 128, make_two_rotations},
    {"windows of the logistic map", "superstable orbits", 128, make_window},
    {"chaotic maps", "Misiurewicz 1981, Henon 1976", 128, make_chaos},
    {"transient chaos", "mean lifetime by construction", 128, make_transient},
    {"growing motions", "multipliers by construction", 128, make_growth},
    {"slow settling", "multipliers by construction", 128, make_settling},
};

int main(void) {
    return run_families("flows of known maps", families, COUNT_OF(families), 24, NULL, 0, 400);
}
