// Reference: periodic orbits of a chain of two masses with a unilateral spring, in extended precision; a program of its
// own, which shares nothing with whirl.
//
// The problem is example 03 of NLvib (M. Krack, J. Gross: Harmonic Balance for Nonlinear Vibration Problems, 2019):
//
//     q'' + D q' + K q + (100 max(q1 - 1, 0), 0) = (0, 0.1 cos W t),   K = [1 -1; -1 2],   D = 0.03 K
//
// The branch of orbits of one period begins at W = 0.8 and is followed by its arc length to W = 0.5. Between contacts
// the motion is linear: it and its derivatives by the start and by W go in Taylor series of high order, whose roots are
// the instants of contact. The force is continuous there, so the derivatives pass without a jump. Orbits are found by
// Newton's method; folds, period doublings, Neimark-Sacker points, neutral saddles, first touches and given values of W
// are zeros of functions along the arc.
//
// All is done twice, with other steps and other orders. The difference between the two is printed; above 1e-15 in
// orbits and 1e-11 in multipliers the program fails.
#include <complex.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { N = 4, MAX_ORDER = 32, MAX_EXTREMA = 64, MAX_POINTS = 64 };

#include "extended.h"

static const real last_W = 0.5L;
static const real values_of_W[] = {0.75L, 0.7L, 0.65L, 0.635L, 0.6L, 0.55L};
enum { VALUES = sizeof values_of_W / sizeof *values_of_W };

/// Steps of a period and order of the series.
typedef struct accuracy {
    int steps, order;
} accuracy;

// ---------------------------------------------------------------- the motion

/// End of a motion over a period, in theta = W t: columns 0 to 3 of `by` are its derivatives by the start, column 4 is
/// that by W. State: q1, q2, dq1/dt, dq2/dt.
typedef struct period {
    real end[N], by[N][N + 1];
    int touches; ///< contacts that begin
    int extrema; ///< of q1 - 1, with its values there
    real extremum[MAX_EXTREMA];
} period;

/// Coefficients of the series of the motion and its five derivatives in powers of theta from an instant on.
typedef struct series {
    int order;
    real x[MAX_ORDER + 1][N], by[MAX_ORDER + 1][N][N + 1];
} series;

/// Computes x' = (A x + b)/W on one side of the contact; b is without the force.
static void slope(bool touching, const real *x, real constant, real *out) {
    const real push = touching ? 100.0L : 0.0L;
    const real elastic[2] = {x[0] - x[1], 2.0L * x[1] - x[0]}, damped[2] = {x[2] - x[3], 2.0L * x[3] - x[2]};
    out[0] = x[2];
    out[1] = x[3];
    out[2] = -elastic[0] - 0.03L * damped[0] - push * (x[0] - constant);
    out[3] = -elastic[1] - 0.03L * damped[1];
}

static void expand(bool touching, real W, real theta, series *s) {
    // The k-th derivative of cos theta is cos(theta + k pi/2); over k! it is the k-th coefficient.
    real factorial = 1.0L;
    const real around[4] = {cosl(theta), -sinl(theta), -cosl(theta), sinl(theta)};
    for (int k = 0; k < s->order; k++) {
        real f[N], column[N], g[N];
        const real over = 1.0L / (W * (k + 1));
        if (k > 0) factorial *= k;
        slope(touching, s->x[k], k == 0 ? 1.0L : 0.0L, f);
        f[3] += 0.1L * around[k % 4] / factorial;
        for (int i = 0; i < N; i++) s->x[k + 1][i] = f[i] * over;
        for (int j = 0; j <= N; j++) {
            for (int i = 0; i < N; i++) column[i] = s->by[k][i][j];
            slope(touching, column, 0.0L, g);
            for (int i = 0; i < N; i++) s->by[k + 1][i][j] = (j == N ? g[i] - f[i] / W : g[i]) * over;
        }
    }
}

/// Returns coordinate i at h after the instant.
static real at(const series *s, int i, real h) {
    real sum = s->x[s->order][i];
    for (int k = s->order - 1; k >= 0; k--) sum = sum * h + s->x[k][i];
    return sum;
}

/// Returns the zero of coordinate i less `level` between a and b, where its signs differ or it is zero in a.
static real root(const series *s, int i, real level, real a, real b) {
    const bool rises = at(s, i, b) > level;
    real h = 0.5L * (a + b);
    for (int n = 0; n < 100; n++) {
        real value = s->x[s->order][i], rate = 0.0L;
        for (int k = s->order - 1; k >= 0; k--) rate = rate * h + value, value = value * h + s->x[k][i];
        *((value > level) == rises ? &b : &a) = h;
        // Newton's step where it stays between, else the middle.
        const real before = h;
        h -= (value - level) / rate;
        if (!(h > a && h < b)) h = fabsl(before - h) < 1e-19L ? before : 0.5L * (a + b);
        if (fabsl(h - before) < 1e-20L) break;
    }
    return h;
}

/// Returns the length of the step, at most h, up to the beginning or end of a contact; records extrema on the
/// way.
static real step_length(const series *s, bool touching, real h, period *p) {
    real from = 0.0L;
    const bool turns = (s->x[0][2] > 0.0L) != (at(s, 2, h) > 0.0L);
    const real ends[2] = {turns ? root(s, 2, 0.0L, 0.0L, h) : h, h};
    for (int n = turns ? 0 : 1; n < 2; n++) {
        const real g = at(s, 0, ends[n]) - 1.0L;
        if (touching ? g < 0.0L : g > 0.0L) return root(s, 0, 1.0L, from, ends[n]);
        if (n == 0 && p->extrema < MAX_EXTREMA) p->extremum[p->extrema++] = g;
        from = ends[n];
    }
    return h;
}

static void carry(const accuracy *a, real W, const real *x, period *p) {
    static series s;
    const real h = 2.0L * pi / a->steps;
    bool touching = x[0] > 1.0L;
    memset(p, 0, sizeof *p);
    memset(&s, 0, sizeof s);
    s.order = a->order;
    for (int i = 0; i < N; i++) s.x[0][i] = x[i], s.by[0][i][i] = 1.0L;
    for (int n = 0; n < a->steps; n++) {
        for (real done = 0.0L; done < h;) {
            expand(touching, W, n * h + done, &s);
            const real length = step_length(&s, touching, h - done, p);
            const bool switches = length < h - done;
            for (int i = 0; i < N; i++) {
                s.x[0][i] = at(&s, i, length);
                for (int j = 0; j <= N; j++) {
                    real sum = s.by[s.order][i][j];
                    for (int k = s.order - 1; k >= 0; k--) sum = sum * length + s.by[k][i][j];
                    s.by[0][i][j] = sum;
                }
            }
            if (!switches) break;
            touching = !touching;
            p->touches += touching;
            done += length;
        }
    }
    memcpy(p->end, s.x[0], sizeof p->end);
    memcpy(p->by, s.by[0], sizeof p->by);
}

// ---------------------------------------------------------------- the branch

/// Computes the multipliers, largest modulus first.
static void multipliers(const period *p, long double complex m[N]) {
    real c[N];
    characteristic(p->by, c);
    find_zeros(c, m);
    for (int i = 0; i < N; i++)
        for (int j = i + 1; j < N; j++) {
            const real larger = cabsl(m[j]) - cabsl(m[i]);
            if (larger > 1e-12L || (larger > -1e-12L && cimagl(m[j]) > cimagl(m[i]))) exchange(&m[i], &m[j]);
        }
}

typedef struct orbit {
    real u[N + 1];       ///< the start, then W
    real tangent[N + 1]; ///< of the branch, of length 1
    period period;
} orbit;

/// Finds the orbit in the plane at `length` along the tangent of `from`; returns false if Newton's method fails.
static bool correct(const accuracy *a, const orbit *from, real length, orbit *o) {
    real before = INFINITY;
    for (int i = 0; i <= N; i++) o->u[i] = from->u[i] + length * from->tangent[i];
    for (int n = 0; n < 30; n++) {
        real matrix[N + 1][N + 1], right[N + 1], size = 0.0L;
        carry(a, o->u[N], o->u, &o->period);
        right[N] = length;
        for (int j = 0; j <= N; j++) right[N] -= from->tangent[j] * (o->u[j] - from->u[j]);
        for (int i = 0; i < N; i++) right[i] = o->u[i] - o->period.end[i];
        for (int i = 0; i <= N; i++)
            for (int j = 0; j <= N; j++)
                matrix[i][j] = i == N ? from->tangent[j] : o->period.by[i][j] - (i == j ? 1.0L : 0.0L);
        solve(matrix, right, N + 1);
        for (int i = 0; i <= N; i++) {
            o->u[i] += right[i];
            size = fmaxl(size, fabsl(right[i]));
        }
        if (!(size < 0.5L)) return false;
        if (size < 1e-17L || (size < 1e-14L && size >= before)) break;
        if (n == 29) return false;
        before = size;
    }
    carry(a, o->u[N], o->u, &o->period);
    return true;
}

/// Computes the tangent of an orbit in the direction of `before` [N + 1].
static void find_tangent(orbit *o, const real *before) {
    real matrix[N + 1][N + 1], t[N + 1] = {0.0L}, size = 0.0L;
    for (int i = 0; i <= N; i++)
        for (int j = 0; j <= N; j++) matrix[i][j] = i == N ? before[j] : o->period.by[i][j] - (i == j ? 1.0L : 0.0L);
    t[N] = 1.0L;
    solve(matrix, t, N + 1);
    for (int i = 0; i <= N; i++) size += t[i] * t[i];
    for (int i = 0; i <= N; i++) o->tangent[i] = t[i] / sqrtl(size);
}

// ---------------------------------------------------------------- special points

enum { FOLD, DOUBLING, PRODUCT_ONE, VALUE, GRAZE = VALUE + VALUES, TESTS = GRAZE + MAX_EXTREMA };

/// Returns the function that is zero at special points of that kind.
static real test_of(const orbit *o, int test) {
    real c[N];
    if (test == FOLD) return o->tangent[N];
    if (test >= GRAZE) return test - GRAZE < o->period.extrema ? o->period.extremum[test - GRAZE] : 1.0L;
    if (test >= VALUE) return o->u[N] - values_of_W[test - VALUE];
    characteristic(o->period.by, c);
    if (test == DOUBLING) return 1.0L - c[3] + c[2] - c[1] + c[0];
    // (m^2 + p m + 1)(m^2 + q m + r): two multipliers of product 1.
    const real p = (c[1] - c[3]) / (c[0] - 1.0L);
    return c[2] - 1.0L - c[0] - p * (c[3] - p);
}

static const char *kind_of(const orbit *o, int test) {
    real c[N];
    if (test == FOLD) return "fold";
    if (test == DOUBLING) return "doubling";
    if (test >= GRAZE) return "touch";
    if (test >= VALUE) return "value";
    characteristic(o->period.by, c);
    return fabsl((c[1] - c[3]) / (c[0] - 1.0L)) < 2.0L ? "Neimark-Sacker" : "neutral saddle";
}

/// A special point and what is printed of it.
typedef struct special {
    const char *kind;
    real length; ///< of the branch up to there
    orbit orbit;
    long double complex multipliers[N];
} special;

/// Finds the zero of a test between `from` and the orbit at `length` (Illinois form of the false position).
static bool locate(const accuracy *a, const orbit *from, real length, int test, orbit *o) {
    real low = 0.0L, high = length, f_low = test_of(from, test), f_high, middle = length;
    if (!correct(a, from, high, o)) return false;
    find_tangent(o, from->tangent);
    f_high = test_of(o, test);
    for (int n = 0; n < 100 && fabsl(high - low) > 1e-17L; n++) {
        middle = (low * f_high - high * f_low) / (f_high - f_low);
        if (!correct(a, from, middle, o)) return false;
        find_tangent(o, from->tangent);
        const real f = test_of(o, test);
        if (f == 0.0L || fabsl(f) < 1e-19L) break;
        if ((f > 0.0L) != (f_high > 0.0L)) {
            low = high, f_low = f_high;
        } else {
            f_low *= 0.5L;
        }
        high = middle, f_high = f;
    }
    return true;
}

static int by_length(const void *one, const void *other) {
    const real a = ((const special *)one)->length, b = ((const special *)other)->length;
    return a < b ? -1 : a > b;
}

static void set_special(special *point, const orbit *o, const char *kind, real length) {
    *point = (special){.kind = kind, .length = length, .orbit = *o};
    multipliers(&o->period, point->multipliers);
}

/// Finds the special points of the branch, in its order; returns their number.
static int follow(const accuracy *a, special *points) {
    orbit here = {.u = {0.0L, 0.0L, 0.0L, 0.0L, 0.8L}, .tangent = {0.0L, 0.0L, 0.0L, 0.0L, 1.0L}}, next;
    real step = 0.002L, length = 0.0L;
    int count = 0;
    if (!correct(a, &here, 0.0L, &next)) return 0;
    here = next;
    find_tangent(&here, (real[]){0.0L, 0.0L, 0.0L, 0.0L, -1.0L});
    set_special(&points[count++], &here, "value", 0.0L);
    while (here.u[N] > last_W && here.u[N] < 1.0L) {
        if (!correct(a, &here, step, &next) || abs(next.period.extrema - here.period.extrema) > 2) {
            step *= 0.5L;
            if (step < 1e-9L) return 0;
            continue;
        }
        find_tangent(&next, here.tangent);
        const int of_step = count;
        for (int test = 0; test < TESTS; test++) {
            if (test >= GRAZE && next.period.extrema != here.period.extrema) continue;
            orbit o;
            if ((test_of(&here, test) > 0.0L) == (test_of(&next, test) > 0.0L)) continue;
            if (!locate(a, &here, step, test, &o) || count == MAX_POINTS) return 0;
            real along = length;
            for (int i = 0; i <= N; i++) along += here.tangent[i] * (o.u[i] - here.u[i]);
            set_special(&points[count++], &o, kind_of(&o, test), along);
        }
        qsort(points + of_step, (size_t)(count - of_step), sizeof *points, by_length);
        length += step;
        here = next;
        step = fminl(1.3L * step, 0.02L);
    }
    return count;
}

// ---------------------------------------------------------------- the table

/// Returns true if the multipliers of a point are printed. At a first touch they are those of the motion without
/// contact, and change from there like a square root, so that no arithmetic gives their digits.
static bool has_multipliers(const special *p) {
    return strcmp(p->kind, "touch") != 0;
}

static void print(const special *p) {
    printf("%s\t%.16Lf", p->kind, p->orbit.u[N]);
    for (int i = 0; i < N; i++) printf("\t%.15Lf", p->orbit.u[i] / (i < 2 ? 1.0L : p->orbit.u[N]));
    if (has_multipliers(p)) {
        printf("\t%d", p->orbit.period.touches);
        for (int i = 0; i < N; i++) printf("\t%.12Lf\t%.12Lf", creall(p->multipliers[i]), cimagl(p->multipliers[i]));
    }
    printf("\n");
}

/// Returns the largest difference of the start and of W.
static real orbits_apart(const special *one, const special *other) {
    real largest = 0.0L;
    for (int i = 0; i <= N; i++) largest = fmaxl(largest, fabsl(one->orbit.u[i] - other->orbit.u[i]));
    return largest;
}

/// Returns the largest difference of multipliers, and of their product from exp(-0.09 2 pi/W), which follows from the
/// damping.
static real multipliers_apart(const special *one, const special *other) {
    long double complex product = 1.0L;
    real largest = 0.0L;
    for (int i = 0; i < N; i++) {
        largest = fmaxl(largest, cabsl(one->multipliers[i] - other->multipliers[i]));
        product *= one->multipliers[i];
    }
    return fmaxl(largest, cabsl(product - expl(-0.18L * pi / one->orbit.u[N])));
}

int main(void) {
    static special coarse[MAX_POINTS], fine[MAX_POINTS];
    const int count = follow(&(accuracy){160, 18}, coarse);
    real orbits = 0.0L, largest = 0.0L;
    if (count == 0 || follow(&(accuracy){240, 24}, fine) != count) {
        fprintf(stderr, "unilateral_chain: the branch was not followed to its end in the same way twice\n");
        return 1;
    }
    printf("# kind, W, q1, q2, dq1/dtau, dq2/dtau at tau = W t = 0, contacts, four multipliers (real, imaginary)\n");
    for (int i = 0; i < count; i++) {
        print(&fine[i]);
        orbits = fmaxl(orbits, orbits_apart(&fine[i], &coarse[i]));
        if (has_multipliers(&fine[i])) largest = fmaxl(largest, multipliers_apart(&fine[i], &coarse[i]));
    }
    printf("# largest difference between two orders and lengths of steps: %.2Lg, of multipliers %.2Lg\n", orbits,
           largest);
    return orbits < 1e-15L && largest < 1e-11L ? 0 : 1;
}
