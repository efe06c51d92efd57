// Search for zeros on the polynomial of degree 8 through nine Chebyshev points, in Bernstein form (Ainsworth and
// Sanchez 2016). Its least coefficient is a lower bound. Halving by de Casteljau's rule sharpens the bound until a
// piece is clear of zero or is seen to pass it.
#include "crossing.h"

#include <math.h>
#include <string.h>

#include "whirl/engine/system.h"

enum { DEGREE = CROSSING_DEGREE, CHECKS = 2, SAMPLES = DEGREE + 1 + CHECKS, MAX_DEPTH = 14, MAX_REFINEMENTS = 80 };
_Static_assert(SAMPLES + 1 == CROSSING_ROWS, "a row for every sample and one for what is refined");

/// Size below which values are underflow: their relative errors are larger than those of rounding.
static const double MIN_SIZE = 0x1p-900;

/// Values of theta: (1 - cos(j pi/8))/2, then two points between them at which the polynomial is compared with the
/// function.
static const double places[SAMPLES] = {0.0,
                                       0.038060233744356624,
                                       0.14644660940672624,
                                       0.3086582838174551,
                                       0.5,
                                       0.6913417161825449,
                                       0.8535533905932737,
                                       0.9619397662556434,
                                       1.0,
                                       0.4,
                                       0.8};

/// One function in which a zero is searched.
typedef struct suspect {
    const crossing_search *search;
    size_t index, degree;
    double begin;  ///< value of the function at theta = 0
    double margin; ///< largest accepted difference of polynomial and function
} suspect;

/// Computes the Bernstein coefficients of the polynomial through the first DEGREE + 1 values.
static void interpolate(const double *values, double *c) {
    double f[DEGREE + 1], w[DEGREE + 1] = {1.0};
    memcpy(f, values, sizeof f);
    memset(c, 0, (DEGREE + 1) * sizeof *c);
    c[0] = f[0];
    for (int k = 1; k <= DEGREE; k++) {
        for (int j = DEGREE; j >= k; j--) f[j] = (f[j] - f[j - 1]) / (places[j] - places[j - k]);
        for (int j = k; j >= 1; j--) {
            const double share = (double)j / k;
            w[j] = share * w[j - 1] * (1.0 - places[k - 1]) - (1.0 - share) * w[j] * places[k - 1];
            c[j] = share * c[j - 1] + (1.0 - share) * c[j] + f[k] * w[j];
        }
        w[0] *= -places[k - 1];
        c[0] += f[k] * w[0];
    }
}

/// Divides a polynomial at theta = 1/2 into two halves: the left one replaces c, and `right` receives the other.
static void halve(size_t degree, double *c, double *right) {
    for (size_t k = 0; k <= degree; k++) {
        right[degree - k] = c[degree];
        for (size_t j = degree; j > k; j--) c[j] = 0.5 * (c[j] + c[j - 1]);
    }
}

static double value_at(size_t degree, const double *c, double theta) {
    double b[DEGREE + 1];
    memcpy(b, c, (degree + 1) * sizeof *b);
    for (size_t k = degree; k > 0; k--)
        for (size_t j = 0; j < k; j++) b[j] += theta * (b[j + 1] - b[j]);
    return b[0];
}

/// Evaluates the function. If it begins at zero, divides it by theta.
static double evaluate(const suspect *s, double theta) {
    double *values = s->search->work + SAMPLES * s->search->count;
    s->search->values(s->search->context, theta, values);
    double value = values[s->index];
    if (s->search->held[s->index] == 0) return value;
    value -= s->begin;
    for (int i = 0; i < s->search->held[s->index]; i++) value /= theta;
    return value;
}

/// Finds a zero between `low`, where the function is positive, and `high`, where it is not, by regula falsi (Illinois).
static double refine(const suspect *s, double low, double f_low, double high, double f_high) {
    int side = 0;
    for (int i = 0; i < MAX_REFINEMENTS && high - low > 1e-15 && f_high < 0.0; i++) {
        double middle = (low * f_high - high * f_low) / (f_high - f_low);
        if (!(middle > low && middle < high) || i % 8 == 7) middle = 0.5 * (low + high);
        if (!(middle > low && middle < high)) break;
        const double f = evaluate(s, middle);
        if (f > 0.0) {
            low = middle;
            f_low = f;
            if (side == 1) f_high *= 0.5;
            side = 1;
        } else {
            high = middle;
            f_high = f;
            if (side == -1) f_low *= 0.5;
            side = -1;
        }
    }
    return high;
}

/// Tests a piece that is too short to be halved. Returns true if the function itself is below zero at its ends, or
/// where the polynomial is least.
static bool probe(const suspect *s, const double *c, double low, double high, double *theta) {
    const double left = c[0], right = c[s->degree], middle = value_at(s->degree, c, 0.5);
    const double slope = right - left, bend = 2.0 * (left - 2.0 * middle + right);
    double least = bend > 0.0 ? 0.5 - 0.5 * slope / bend : right < left ? 1.0 : 0.0;
    least = least < 0.0 ? 0.0 : least > 1.0 ? 1.0 : least;
    const double at[2] = {low + least * (high - low), high};
    for (int i = 0; i < 2; i++) {
        if (at[i] <= 0.0) continue;
        const double f = evaluate(s, at[i]);
        if (f > 0.0) continue;
        const double f_low = low > 0.0 ? evaluate(s, low) : left;
        *theta = f_low > 0.0 ? refine(s, low, f_low, at[i], f) : low;
        return true;
    }
    return false;
}

/// Searches the piece from low to high, whose coefficients are c, the left half first.
static bool scan(const suspect *s, double *c, double low, double high, int depth, double *theta) {
    double least = c[0];
    bool falling = true;
    for (size_t i = 1; i <= s->degree; i++) {
        least = c[i] < least ? c[i] : least;
        falling = falling && c[i] < c[i - 1];
    }
    if (least > s->margin) return false;
    if (falling && c[0] > s->margin && c[s->degree] < -s->margin) {
        const double f_high = evaluate(s, high), f_low = low > 0.0 ? evaluate(s, low) : c[0];
        if (f_low > 0.0 && f_high <= 0.0) {
            *theta = refine(s, low, f_low, high, f_high);
            return true;
        }
    }
    if (depth == MAX_DEPTH) return probe(s, c, low, high, theta);
    double right[DEGREE + 1];
    const double middle = 0.5 * (low + high);
    halve(s->degree, c, right);
    return scan(s, c, low, middle, depth + 1, theta) || scan(s, right, middle, high, depth + 1, theta);
}

/// Divides a polynomial that is zero at theta = 0 by theta.
static void divide(size_t degree, double *c) {
    for (size_t i = 0; i < degree; i++) c[i] = c[i + 1] * (double)degree / (double)(i + 1);
}

static bool search_one(const crossing_search *search, size_t index, double *theta) {
    const double *samples = search->work + index;
    suspect s = {search, index, DEGREE, samples[0], 0.0};
    double values[SAMPLES], c[DEGREE + 1], size = 0.0;
    if (search->held[index] == CROSSING_ALONG) return false;
    for (int j = 0; j < SAMPLES; j++) {
        values[j] = samples[(size_t)j * search->count] - (search->held[index] > 0 ? s.begin : 0.0);
        size = fabs(values[j]) > size ? fabs(values[j]) : size;
    }
    // A function that is zero all along, or differs from zero by underflow alone, is not crossed: a station that rests
    // in the middle of its stator has no slip there.
    if (size < MIN_SIZE) return false;
    interpolate(values, c);
    for (int j = DEGREE + 1; j < SAMPLES; j++) {
        const double apart = 4.0 * fabs(values[j] - value_at(DEGREE, c, places[j]));
        s.margin = apart > s.margin ? apart : s.margin;
    }
    s.margin += 1e-15 * size;
    for (int i = 0; i < search->held[index]; i++) divide(s.degree--, c);
    if (!(c[0] > 0.0)) { // the function begins in the wrong direction
        *theta = 0.0;
        return true;
    }
    return scan(&s, c, 0.0, 1.0, 0, theta);
}

bool crossing_first(const crossing_search *search, double *theta, size_t *which) {
    bool found = false;
    for (size_t j = 0; j < SAMPLES; j++) search->values(search->context, places[j], search->work + j * search->count);
    for (size_t i = 0; i < search->count; i++) {
        double at;
        if (!search_one(search, i, &at) || (found && at >= *theta)) continue;
        found = true;
        *theta = at;
        *which = i;
    }
    return found;
}
