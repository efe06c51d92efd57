/// Finds a zero of a function that has different signs at two places, by secant steps, with halving if they narrow the
/// bracket too slowly (Dekker 1969; the Illinois method: Dowell, Jarratt 1971).
#ifndef BASE_BRACKET_H
#define BASE_BRACKET_H

#include <math.h>
#include <stdbool.h>

typedef struct bracket {
    double a, fa, b, fb;
    double last; ///< width at the last request
    int side;    ///< end that moved last: -1 for a, 1 for b
    int asked;   ///< requests so far
} bracket;

static inline bracket bracket_between(double a, double fa, double b, double fb) {
    return (bracket){.a = a, .fa = fa, .b = b, .fb = fb, .last = INFINITY};
}

static inline double bracket_width(const bracket *r) {
    return fabs(r->b - r->a);
}

/// Returns the next place to evaluate.
static inline double bracket_next(bracket *r) {
    const double width = bracket_width(r), middle = 0.5 * (r->a + r->b);
    const double secant = r->b - r->fb * (r->b - r->a) / (r->fb - r->fa);
    const bool inside = (secant - r->a) * (secant - r->b) < 0.0;
    const bool narrows = width <= 0.6 * r->last || r->asked % 3 != 2;
    r->last = width;
    r->asked++;
    return inside && narrows ? secant : middle;
}

/// Narrows the bracket by the function's value fc at the place c.
static inline void bracket_update(bracket *r, double c, double fc) {
    const bool like_a = (fc < 0.0) == (r->fa < 0.0);
    if (like_a) {
        r->a = c;
        r->fa = fc;
        if (r->side == -1) r->fb *= 0.5;
    } else {
        r->b = c;
        r->fb = fc;
        if (r->side == 1) r->fa *= 0.5;
    }
    r->side = like_a ? -1 : 1;
}

#endif
