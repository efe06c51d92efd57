// Reference: where the motion of the paper's rotor changes, in extended precision; a program of its own, which shares
// nothing with whirl.
//
// The equations are those of docs/theory.md with the numbers of the calibrated reading (cases/paper.yaml): a disc on a
// shaft of unequal stiffness, with the signs that the paper prints, a journal in Capone's film, a disc that rubs. In
// tau = omega t, lengths in clearances. The motion goes in Taylor series of high order, found coefficient by
// coefficient through all intermediate quantities, each with its derivatives by the start and by the stiffness ratio
// r_k; a root of the series is where a contact begins or ends. The force is continuous there, so the derivatives pass
// without a jump. Orbits of several revolutions are found by Newton's method and followed by their arc length from a
// start that is good to some six digits, until the test function of the special point changes its sign.
//
// All is done twice, with other orders and other steps. The difference between the two is printed; above 1e-14 the
// program fails. That takes a minute or more; `confirm` reads the table again and carries each orbit once.
#include <complex.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { N = 8, BY = N + 1, MAX_ORDER = 28, MAX_EXTREMA = 64 };

#include "extended.h"

/// Order of the series, and what of a coordinate their last terms may be over a step.
typedef struct accuracy {
    int order;
    real tolerance;
} accuracy;

// ---------------------------------------------------------------- series

/// A number with its derivatives by the start and by r_k.
typedef struct number {
    real value, by[BY];
} number;

/// Coefficients of powers of the time from an instant on.
typedef struct series {
    number at[MAX_ORDER + 1];
} series;

static void add_number(number *sum, real factor, const number *a) {
    sum->value += factor * a->value;
    for (int i = 0; i < BY; i++) sum->by[i] += factor * a->by[i];
}

static void add_product(number *sum, real factor, const number *a, const number *b) {
    const real p = factor * a->value, q = factor * b->value;
    sum->value += p * b->value;
    for (int i = 0; i < BY; i++) sum->by[i] += p * b->by[i] + q * a->by[i];
}

static void divide(number *a, const number *b) {
    a->value /= b->value;
    for (int i = 0; i < BY; i++) a->by[i] = (a->by[i] - a->value * b->by[i]) / b->value;
}

/// Adds coefficient k of factor a b.
static void add_times(series *sum, real factor, const series *a, const series *b, int k) {
    for (int i = 0; i <= k; i++) add_product(&sum->at[k], factor, &a->at[i], &b->at[k - i]);
}

// Each of the following finds coefficient k of a series from the coefficients up to k of others.

static void sum(series *out, real p, const series *a, real q, const series *b, int k) {
    out->at[k] = (number){.value = 0.0L};
    add_number(&out->at[k], p, &a->at[k]);
    add_number(&out->at[k], q, &b->at[k]);
}

static void times(series *out, const series *a, const series *b, int k) {
    out->at[k] = (number){.value = 0.0L};
    add_times(out, 1.0L, a, b, k);
}

static void ratio(series *out, const series *a, const series *b, int k) {
    out->at[k] = a->at[k];
    for (int i = 1; i <= k; i++) add_product(&out->at[k], -1.0L, &b->at[i], &out->at[k - i]);
    divide(&out->at[k], &b->at[0]);
}

static void root(series *out, const series *a, int k) {
    number rest = a->at[k], twice = {.value = 0.0L};
    if (k == 0) {
        out->at[0].value = sqrtl(rest.value);
        for (int i = 0; i < BY; i++) out->at[0].by[i] = 0.5L * rest.by[i] / out->at[0].value;
        return;
    }
    for (int i = 1; i < k; i++) add_product(&rest, -1.0L, &out->at[i], &out->at[k - i]);
    add_number(&twice, 2.0L, &out->at[0]);
    divide(&rest, &twice);
    out->at[k] = rest;
}

/// With `slope` the series 1/(1 + a^2).
static void arctangent(series *out, const series *a, const series *slope, int k) {
    out->at[k] = (number){.value = k == 0 ? atanl(a->at[0].value) : 0.0L};
    if (k == 0)
        for (int i = 0; i < BY; i++) out->at[0].by[i] = slope->at[0].value * a->at[0].by[i];
    for (int i = 1; i <= k; i++) add_product(&out->at[k], (real)i / k, &a->at[i], &slope->at[k - i]);
}

// ---------------------------------------------------------------- the equations

/// Numbers of the calibrated reading.
static const real w = 0.2L, disc_mass = 420.0L, journal_mass = 50.0L, omega = 650.0L, clearance = 2e-4L, rho = 0.08L,
                  gap = 1.2L, stator = 10.0L, friction = 0.1L, load = 0.0042L, fitted_gravity = 10.584L;

/// A motion from an instant on: x1, y1, x2, y2 and their derivatives, and all that lies between them and their slopes.
typedef struct expansion {
    int order;
    bool touching;
    real tau, r_k;
    series x[N];
    series one, along, across, d[2], spring[2];                           // shaft
    series a, b, square[3], q, root_q, c, p, u, cq, tangent, plus, slope; // film
    series angle, half, g, over_c, pg, v, uc, cc_uu, s, vc, pull[2], film[2];
    series r2, r, over_r, beyond, push; // rub; beyond is r^2 - gap^2
    series force[4];
} expansion;

/// Computes coefficient k of the shaft's forces: along = r_k + 1 + (r_k - 1) cos 2 tau, across = (r_k - 1) sin 2 tau.
static void shaft(expansion *e, int k) {
    const real factorial = tgammal((real)k + 1.0L), size = powl(2.0L, (real)k) / factorial;
    const real angle = 2.0L * e->tau + 0.5L * pi * k, c = size * cosl(angle), s = size * sinl(angle);
    e->along.at[k] = (number){.value = (e->r_k - 1.0L) * c + (k == 0 ? e->r_k + 1.0L : 0.0L)};
    e->across.at[k] = (number){.value = (e->r_k - 1.0L) * s};
    e->along.at[k].by[N] = c + (k == 0);
    e->across.at[k].by[N] = s;
    for (int i = 0; i < 2; i++) sum(&e->d[i], 1.0L, &e->x[i], -1.0L, &e->x[2 + i], k);
    for (int i = 0; i < 2; i++) {
        times(&e->spring[i], &e->along, &e->d[i], k);
        add_times(&e->spring[i], 1.0L, &e->across, &e->d[1 - i], k);
    }
}

/// Computes coefficient k of Capone's force. With P = x B - y A and U = x A + y B the angle's cosine and sine, -A/C and
/// -B/C, do not appear: G = (pi + 2 atan(P/(C sqrt q)))/sqrt q, V = (2 + P G/C)/q, S = -U C/(C^2 - U^2).
static void film(expansion *e, int k) {
    const series *x = &e->x[2], *y = &e->x[3];
    sum(&e->a, 1.0L, x, -2.0L, &e->x[7], k);
    sum(&e->b, 1.0L, y, 2.0L, &e->x[6], k);
    times(&e->square[0], x, x, k);
    add_times(&e->square[0], 1.0L, y, y, k);
    times(&e->square[1], &e->a, &e->a, k);
    add_times(&e->square[1], 1.0L, &e->b, &e->b, k);
    sum(&e->q, 1.0L, &e->one, -1.0L, &e->square[0], k);
    root(&e->root_q, &e->q, k);
    root(&e->c, &e->square[1], k);
    times(&e->p, x, &e->b, k);
    add_times(&e->p, -1.0L, y, &e->a, k);
    times(&e->u, x, &e->a, k);
    add_times(&e->u, 1.0L, y, &e->b, k);
    times(&e->cq, &e->c, &e->root_q, k);
    ratio(&e->tangent, &e->p, &e->cq, k);
    times(&e->square[2], &e->tangent, &e->tangent, k);
    sum(&e->plus, 1.0L, &e->one, 1.0L, &e->square[2], k);
    ratio(&e->slope, &e->one, &e->plus, k);
    arctangent(&e->angle, &e->tangent, &e->slope, k);
    sum(&e->half, pi, &e->one, 2.0L, &e->angle, k);
    ratio(&e->g, &e->half, &e->root_q, k);
    ratio(&e->over_c, &e->p, &e->c, k);
    times(&e->pg, &e->over_c, &e->g, k);
    e->pg.at[k].value += k == 0 ? 2.0L : 0.0L;
    ratio(&e->v, &e->pg, &e->q, k);
    times(&e->uc, &e->u, &e->c, k);
    e->cc_uu.at[k] = e->square[1].at[k];
    add_times(&e->cc_uu, -1.0L, &e->u, &e->u, k);
    ratio(&e->s, &e->uc, &e->cc_uu, k);
    times(&e->vc, &e->v, &e->c, k);
    for (int i = 0; i < 2; i++) {
        times(&e->pull[i], i == 0 ? x : y, &e->vc, k);
        add_number(&e->pull[i].at[k], 2.0L, &e->pull[i].at[k]);
        add_times(&e->pull[i], i == 0 ? 1.0L : -1.0L, &e->g, i == 0 ? &e->b : &e->a, k);
        add_times(&e->pull[i], -2.0L, &e->s, i == 0 ? &e->a : &e->b, k);
        ratio(&e->film[i], &e->pull[i], &e->q, k);
    }
}

/// Computes coefficient k of r^2 - gap^2.
static void reach(expansion *e, int k) {
    times(&e->r2, &e->x[0], &e->x[0], k);
    add_times(&e->r2, 1.0L, &e->x[1], &e->x[1], k);
    sum(&e->beyond, 1.0L, &e->r2, -gap * gap, &e->one, k);
}

/// Adds coefficient k of the stator's push to the disc's slope, where it touches.
static void rub(expansion *e, int k) {
    const real stiffness = stator * journal_mass / (w * w * disc_mass);
    if (!e->touching) return;
    root(&e->r, &e->r2, k);
    ratio(&e->over_r, &e->one, &e->r, k);
    sum(&e->push, stiffness, &e->one, -stiffness * gap, &e->over_r, k);
    for (int i = 0; i < 2; i++) {
        add_times(&e->force[i], -1.0L, &e->push, &e->x[i], k);
        add_times(&e->force[i], i == 0 ? friction : -friction, &e->push, &e->x[1 - i], k);
    }
}

/// Computes coefficient k of the forces over the masses: those on the disc, then those on the journal.
static void forces(expansion *e, int k) {
    const real damping[2] = {4300.0L / (disc_mass * omega), 9300.0L / (2.0L * journal_mass * omega)};
    const real stiffness[2] = {-journal_mass / (2.0L * disc_mass * w * w), 1.0L / (4.0L * w * w)};
    const real gravity = fitted_gravity / (omega * omega * clearance), factorial = tgammal(k + 1.0L);
    for (int i = 0; i < 4; i++) {
        e->force[i].at[k] = (number){.value = k == 0 && i % 2 == 1 ? -gravity : 0.0L};
        add_number(&e->force[i].at[k], -damping[i / 2], &e->x[4 + i].at[k]);
        add_number(&e->force[i].at[k], stiffness[i / 2], &e->spring[i % 2].at[k]);
        if (i < 2)
            e->force[i].at[k].value += rho / factorial * cosl(e->tau + 0.5L * pi * (k - i));
        else
            add_number(&e->force[i].at[k], -load, &e->film[i - 2].at[k]);
    }
    rub(e, k);
}

/// Computes all coefficients from those of power 0.
static void expand(expansion *e) {
    for (int k = 0; k < e->order; k++) {
        e->one.at[k] = (number){.value = k == 0 ? 1.0L : 0.0L};
        shaft(e, k);
        film(e, k);
        reach(e, k);
        forces(e, k);
        for (int i = 0; i < N; i++) {
            e->x[i].at[k + 1] = (number){.value = 0.0L};
            add_number(&e->x[i].at[k + 1], 1.0L / (k + 1), i < 4 ? &e->x[4 + i].at[k] : &e->force[i - 4].at[k]);
        }
    }
    e->one.at[e->order] = (number){.value = 0.0L};
    reach(e, e->order);
}

// ---------------------------------------------------------------- the motion

/// End of a motion over some revolutions: columns 0 to 7 of `by` are its derivatives by the start, column 8 is that by
/// r_k.
typedef struct period {
    real end[N], by[N][BY];
    int contacts; ///< that begin
    int extrema;  ///< of the disc's radius, with what it has beyond the gap there
    real extremum[MAX_EXTREMA];
} period;

/// Returns the value of a series at h, and its rate.
static real value_at(const series *s, int order, real h, real *rate) {
    real sum = s->at[order].value;
    *rate = 0.0L;
    for (int k = order - 1; k >= 0; k--) *rate = *rate * h + sum, sum = sum * h + s->at[k].value;
    return sum;
}

/// Returns the zero of r^2 - gap^2, or of its rate, between a and b, where the signs differ.
static real zero_between(const expansion *e, bool of_rate, real a, real b) {
    real rate, value = value_at(&e->beyond, e->order, b, &rate);
    const bool rises = (of_rate ? rate : value) > 0.0L;
    for (int n = 0; n < 70 && b - a > 0.0L; n++) {
        const real h = 0.5L * (a + b);
        value = value_at(&e->beyond, e->order, h, &rate);
        *(((of_rate ? rate : value) > 0.0L) == rises ? &b : &a) = h;
    }
    return 0.5L * (a + b);
}

/// Returns the length of a step of at most h, which ends where the contact begins or ends: then *switches is true.
/// Notes extrema on the way.
static real step_length(const expansion *e, real h, bool *switches, period *p) {
    real rate, last_rate, from = 0.0L;
    value_at(&e->beyond, e->order, 0.0L, &rate);
    value_at(&e->beyond, e->order, h, &last_rate);
    const bool turns = (rate > 0.0L) != (last_rate > 0.0L);
    const real ends[2] = {turns ? zero_between(e, true, 0.0L, h) : h, h};
    for (int n = turns ? 0 : 1; n < 2; n++) {
        const real beyond = value_at(&e->beyond, e->order, ends[n], &rate);
        *switches = e->touching ? beyond < 0.0L : beyond > 0.0L;
        if (*switches) return zero_between(e, false, from, ends[n]);
        if (n == 0 && p->extrema < MAX_EXTREMA) p->extremum[p->extrema++] = sqrtl(beyond + gap * gap) - gap;
        from = ends[n];
    }
    return h;
}

/// Returns a step over which the last terms of no coordinate exceed the tolerance.
static real safe_step(const expansion *e, real tolerance) {
    real h = 0.125L;
    for (int k = e->order - 1; k <= e->order; k++)
        for (int i = 0; i < N; i++) h = fminl(h, powl(tolerance / fabsl(e->x[i].at[k].value), 1.0L / k));
    return h;
}

/// Makes the motion's state at h the start of the next step.
static void move_on(expansion *e, real h) {
    for (int i = 0; i < N; i++) {
        number sum = e->x[i].at[e->order];
        for (int k = e->order - 1; k >= 0; k--) {
            number next = e->x[i].at[k];
            add_number(&next, h, &sum);
            sum = next;
        }
        e->x[i].at[0] = sum;
    }
    e->tau += h;
}

/// Carries x over revolutions.
static void carry(const accuracy *a, real r_k, int revolutions, const real *x, period *p) {
    static expansion e;
    bool switches;
    memset(p, 0, sizeof *p);
    memset(&e, 0, sizeof e);
    e.order = a->order;
    e.r_k = r_k;
    e.touching = hypotl(x[0], x[1]) > gap;
    for (int i = 0; i < N; i++) {
        e.x[i].at[0].value = x[i];
        e.x[i].at[0].by[i] = 1.0L;
    }
    while (e.tau < 2.0L * pi * revolutions) {
        expand(&e);
        const real left = 2.0L * pi * revolutions - e.tau, whole = fminl(left, safe_step(&e, a->tolerance));
        const real h = step_length(&e, whole, &switches, p);
        move_on(&e, h);
        if (switches) {
            e.touching = !e.touching;
            p->contacts += e.touching;
        } else if (whole == left) {
            break;
        }
    }
    for (int i = 0; i < N; i++) p->end[i] = e.x[i].at[0].value;
    for (int i = 0; i < N; i++) memcpy(p->by[i], e.x[i].at[0].by, sizeof p->by[i]);
}

// ---------------------------------------------------------------- orbits

/// Computes the multipliers, the two of largest modulus first.
static void multipliers(const period *p, long double complex m[N]) {
    real c[N];
    characteristic(p->by, c);
    find_zeros(c, m);
    for (int i = 0; i < 2; i++)
        for (int j = i + 1; j < N; j++)
            if (cabsl(m[j]) > cabsl(m[i])) exchange(&m[i], &m[j]);
}

typedef struct orbit {
    int revolutions;
    real u[BY];       ///< the start, then r_k
    real tangent[BY]; ///< of the branch, of length 1
    period period;
} orbit;

/// Finds the orbit in the plane at `length` along the tangent of `from`, with its own tangent; returns false if
/// Newton's method fails.
static bool correct(const accuracy *a, const orbit *from, real length, orbit *o) {
    real matrix[BY][BY], step[BY], before = INFINITY;
    o->revolutions = from->revolutions;
    for (int i = 0; i < BY; i++) o->u[i] = from->u[i] + length * from->tangent[i];
    for (int n = 0; n < 20; n++) {
        real size = 0.0L, square = 0.0L;
        carry(a, o->u[N], o->revolutions, o->u, &o->period);
        step[N] = length;
        for (int j = 0; j < BY; j++) step[N] -= from->tangent[j] * (o->u[j] - from->u[j]);
        for (int i = 0; i < N; i++) step[i] = o->u[i] - o->period.end[i];
        for (int twice = 0; twice < 2; twice++) {
            for (int i = 0; i < BY; i++)
                for (int j = 0; j < BY; j++)
                    matrix[i][j] = i == N ? from->tangent[j] : o->period.by[i][j] - (i == j ? 1.0L : 0.0L);
            real *right = twice == 0 ? step : o->tangent;
            if (twice == 1) memset(o->tangent, 0, sizeof o->tangent), o->tangent[N] = 1.0L;
            solve(matrix, right, BY);
        }
        for (int i = 0; i < BY; i++) square += o->tangent[i] * o->tangent[i];
        for (int i = 0; i < BY; i++) o->tangent[i] /= sqrtl(square);
        for (int i = 0; i < BY; i++) size = fmaxl(size, fabsl(step[i]));
        if (!(size < 0.5L)) return false;
        if (size < 1e-17L || (size < 1e-14L && size >= before)) return true;
        for (int i = 0; i < BY; i++) o->u[i] += step[i];
        before = size;
    }
    return false;
}

// ---------------------------------------------------------------- special points

/// SINGULAR: test function of a fold if no tangent is known, the determinant of the equations.
typedef enum point_kind { FOLD, DOUBLING, TORUS, TOUCH, SINGULAR } point_kind;

/// Returns the number of the extremum of the radius that is nearest to the gap.
static int nearest_extremum(const period *p) {
    int nearest = 0;
    for (int i = 1; i < p->extrema; i++)
        if (fabsl(p->extremum[i]) < fabsl(p->extremum[nearest])) nearest = i;
    return nearest;
}

/// Returns the function that is zero at special points of that kind.
static real test_of(const orbit *o, point_kind kind) {
    const real one = kind == SINGULAR ? -1.0L : 1.0L;
    real matrix[BY][BY], right[BY] = {0.0L};
    long double complex m[N];
    switch (kind) {
    case FOLD:
        return o->tangent[N];
    case TOUCH:
        return o->period.extremum[nearest_extremum(&o->period)];
    case TORUS:
        multipliers(&o->period, m);
        return cabsl(m[0]) - 1.0L;
    default:
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) matrix[i][j] = o->period.by[i][j] + (i == j ? one : 0.0L);
        return solve(matrix, right, N);
    }
}

/// Finds the zero of a test between `from` and the orbit at `length` (Illinois form of the false position).
static bool locate(const accuracy *a, const orbit *from, real length, point_kind kind, orbit *o) {
    real low = 0.0L, high = length, f_low = test_of(from, kind), f_high = test_of(o, kind);
    for (int n = 0; n < 60 && fabsl(high - low) > 1e-17L; n++) {
        const real middle = (low * f_high - high * f_low) / (f_high - f_low);
        if (!correct(a, from, middle, o)) return false;
        const real f = test_of(o, kind);
        if (fabsl(f) < 1e-18L || middle == high) break;
        if ((f > 0.0L) != (f_high > 0.0L))
            low = high, f_low = f_high;
        else
            f_low *= 0.5L;
        high = middle, f_high = f;
    }
    return true;
}

/// A special point that is looked for: where from, and which way.
typedef struct task {
    const char *name;
    point_kind kind;
    int revolutions;
    real u[BY]; ///< the start, then r_k
    real step;  ///< of r_k
} task;

/// Finds it, by steps along the branch.
static bool find(const accuracy *a, const task *t, orbit *o) {
    orbit here = {.revolutions = t->revolutions, .tangent = {[N] = 1.0L}}, next;
    memcpy(here.u, t->u, sizeof here.u);
    if (!correct(a, &here, 0.0L, &next)) return false;
    const real length = t->step / fabsl(next.tangent[N]);
    for (int n = 0; n < 50; n++) {
        here = next;
        if (!correct(a, &here, length, &next)) return false;
        if ((test_of(&here, t->kind) > 0.0L) != (test_of(&next, t->kind) > 0.0L)) {
            *o = next;
            return locate(a, &here, length, t->kind, o);
        }
    }
    return false;
}

/// Finds it again from a little before to a little after where it was found.
static bool find_again(const accuracy *a, const task *t, const orbit *found, orbit *o) {
    const real around = 1e-6L;
    orbit here;
    return correct(a, found, -around, &here) && correct(a, &here, 2.0L * around, o) &&
           (test_of(&here, t->kind) > 0.0L) != (test_of(o, t->kind) > 0.0L) &&
           locate(a, &here, 2.0L * around, t->kind, o);
}

static const task tasks[] = {
    {"Neimark-Sacker",
     TORUS,
     1,
     {0.159228L, -0.914984L, 0.127558L, -0.850987L, -0.02223L, -0.26966L, 0.149587L, -0.239247L, 0.4985L},
     -0.001L},
    {"fold",
     FOLD,
     5,
     {-0.266858L, -0.614302L, -0.208779L, -0.575309L, -0.122044L, -0.324889L, -0.025048L, -0.213672L, 0.4985L},
     0.0003L},
    {"fold",
     FOLD,
     2,
     {0.099084L, -0.771917L, 0.014045L, -0.687869L, -0.074501L, -0.29178L, 0.231581L, -0.304816L, 0.4231L},
     0.0001L},
    {"doubling",
     DOUBLING,
     2,
     {0.209078L, -1.057985L, 0.148077L, -0.898672L, 0.057623L, -0.210492L, 0.040353L, -0.046347L, 0.3695L},
     -0.0004L},
    {"touch",
     TOUCH,
     4,
     {0.200215L, -1.05401L, 0.137246L, -0.897009L, 0.053938L, -0.220679L, 0.044204L, -0.053519L, 0.3673L},
     -0.0002L},
    {"touch",
     TOUCH,
     8,
     {0.172811L, -1.081996L, 0.070092L, -0.904692L, 0.058742L, -0.208301L, 0.033195L, -0.039975L, 0.3134L},
     -0.0003L},
};
enum { TASKS = sizeof tasks / sizeof *tasks };

// ---------------------------------------------------------------- the table

static void print(const task *t, const orbit *o) {
    long double complex m[N];
    printf("%s\t%.15Lf", t->name, o->u[N]);
    for (int i = 0; i < N; i++) printf("\t%.15Lf", o->u[i]);
    printf("\t%d\t%d", o->revolutions, o->period.contacts);
    multipliers(&o->period, m);
    printf("\t%.10Lf\t%.10Lf\n", creall(m[0]), fabsl(cimagl(m[0])));
    fflush(stdout);
}

static int find_all(void) {
    const accuracy coarse = {20, 1e-18L}, fine = {26, 1e-20L};
    real largest = 0.0L;
    printf("# kind, r_k, the start (x1, y1, x2, y2, derivatives by tau), revolutions, contacts, largest multiplier\n");
    for (size_t i = 0; i < TASKS; i++) {
        orbit first, second;
        if (!find(&coarse, &tasks[i], &first) || !find_again(&fine, &tasks[i], &first, &second)) {
            fprintf(stderr, "paper_rotor: point %zu was not found\n", i + 1);
            return 1;
        }
        print(&tasks[i], &second);
        for (int k = 0; k < BY; k++) largest = fmaxl(largest, fabsl(first.u[k] - second.u[k]));
    }
    printf("# largest difference between two orders and lengths of steps: %.1Lg\n", largest);
    return largest < 1e-14L ? 0 : 1;
}

/// Confirms the points of a table, in the order of the tasks: prints by how much their orbits do not close, and the
/// value of the test function. Does not search. Returns 0 if all tasks have a point.
static int confirm(FILE *table) {
    char line[1024];
    size_t i = 0;
    while (fgets(line, sizeof line, table)) {
        char *rest = line + strcspn(line, "\t");
        if (line[0] == '#') continue;
        if (i == TASKS) return 1;
        orbit o = {.revolutions = tasks[i].revolutions};
        real apart = 0.0L;
        o.u[N] = strtold(rest, &rest);
        for (int k = 0; k < N; k++) o.u[k] = strtold(rest, &rest);
        carry(&(accuracy){22, 1e-18L}, o.u[N], o.revolutions, o.u, &o.period);
        for (int k = 0; k < N; k++) apart = fmaxl(apart, fabsl(o.period.end[k] - o.u[k]));
        const real test = fabsl(test_of(&o, tasks[i].kind == FOLD ? SINGULAR : tasks[i].kind));
        printf("%s\t%.15Lf\t%.1Lg\t%.1Lg\n", tasks[i].name, o.u[N], apart, test);
        i++;
    }
    return i == TASKS ? 0 : 1;
}

/// Prints the table; with the argument "confirm", reads a table and confirms it.
int main(int count, char **arguments) {
    return count > 1 && strcmp(arguments[1], "confirm") == 0 ? confirm(stdin) : find_all();
}
