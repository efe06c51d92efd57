// Where the stability of orbits changes along a branch, or a contact.
#include "special.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bracket.h"
#include "describe.h"

/// A function whose sign tells of what.
typedef struct test {
    whirl_special kind;
    size_t touch;     ///< of a graze
    size_t intervals; ///< of it at the first waypoint
} test;

// ---------------------------------------------------------------- functions of the multipliers

/// A product of complex numbers.
typedef struct product {
    double real, imaginary;
} product;

static void take_into(product *p, double real, double imaginary) {
    const double next = p->real * real - p->imaginary * imaginary;
    p->imaginary = p->real * imaginary + p->imaginary * real;
    p->real = next;
}

/// ... over what its size may be, lest many of them leave the range of numbers.
static void take_over(product *p, double real, double imaginary, double size) {
    take_into(p, real / size, imaginary / size);
}

static double size_of(const whirl_orbit *orbit, size_t i) {
    return hypot(orbit->multipliers[i].real, orbit->multipliers[i].imaginary);
}

/// The product of (multiplier - at) over all of them, real because they come in pairs.
static double product_about(const whirl_orbit *orbit, double at) {
    const size_t own = orbit_own_multiplier(orbit);
    product all = {1.0, 0.0};
    for (size_t i = 0; i < orbit->multiplier_count; i++)
        if (i != own)
            take_over(&all, orbit->multipliers[i].real - at, orbit->multipliers[i].imaginary, size_of(orbit, i) + 1.0);
    return all.real;
}

/// What vanishes where two multipliers are a pair on the unit circle, or each other's inverse, and two eigenvalues a
/// pair on the imaginary axis, or each other's negative: their product less 1; their sum.
static product of_pair(const whirl_orbit *orbit, size_t i, size_t k) {
    const whirl_multiplier p = orbit->multipliers[i], q = orbit->multipliers[k];
    if (orbit->period == 0.0) return (product){p.real + q.real, p.imaginary + q.imaginary};
    product both = {p.real, p.imaginary};
    take_into(&both, q.real, q.imaginary);
    both.real -= 1.0;
    return both;
}

/// The product of that over all pairs.
static double product_of_pairs(const whirl_orbit *orbit) {
    const size_t own = orbit_own_multiplier(orbit);
    product all = {1.0, 0.0};
    for (size_t i = 0; i < orbit->multiplier_count; i++)
        for (size_t k = i + 1; k < orbit->multiplier_count; k++) {
            const product pair = of_pair(orbit, i, k);
            const double a = size_of(orbit, i), b = size_of(orbit, k), size = orbit->period > 0.0 ? a * b + 1.0 : a + b;
            if (i != own && k != own && size > 0.0) take_over(&all, pair.real, pair.imaginary, size);
        }
    return all.real;
}

/// The two nearest to that; false where they are real.
static bool find_pair(const whirl_orbit *orbit, double *angle) {
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

// ---------------------------------------------------------------- contacts

/// Times that a switching function becomes positive; 0 where it always is.
static size_t risings(const whirl_touch *touch) {
    return touch->share >= 1.0 ? 0 : touch->intervals;
}

/// The extreme nearest to zero, with the sign that says on which side of the graze the orbit is.
static double graze_value(const test *t, const whirl_orbit *orbit) {
    const whirl_touch *touch = &orbit->touches[t->touch];
    const double size = fmin(fabs(touch->nearest), 1e30);
    return risings(touch) == t->intervals ? size : -size;
}

// ---------------------------------------------------------------- search

static double value_of(const follower *f, const test *t, const waypoint *p) {
    switch (t->kind) {
    case WHIRL_FOLD:
        return p->tangent[f->curve.count];
    case WHIRL_BRANCHING:
        return product_about(p->orbit, p->orbit->period > 0.0 ? 1.0 : 0.0);
    case WHIRL_DOUBLING:
        return product_about(p->orbit, -1.0);
    case WHIRL_NEIMARK_SACKER:
    case WHIRL_HOPF:
        return product_of_pairs(p->orbit);
    case WHIRL_GRAZE:
        return graze_value(t, p->orbit);
    case WHIRL_REGULAR:
        break;
    }
    return 1.0;
}

static bool changes(const follower *f, const test *t, const waypoint *a, const waypoint *b) {
    return (value_of(f, t, a) < 0.0) != (value_of(f, t, b) < 0.0);
}

/// Closes in on the change of sign within `length` of `from`; *at is where along its tangent, p the point there. Not
/// found: p has no orbit.
static whirl_status close_in(follower *f, const test *t, const waypoint *from, const waypoint *to, double length,
                             waypoint *p, double *at) {
    enum { MOST_LOOKS = 80 };
    const size_t all = f->curve.count + 1;
    bracket r = bracket_between(0.0, value_of(f, t, from), length, value_of(f, t, to));
    const double largest = fmax(fabs(r.fa), fabs(r.fb));
    whirl_status status = whirl_ok();
    double *trial = malloc(all * sizeof *trial), last = INFINITY;
    if (!trial) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a point of a branch");
    for (int k = 0; k < MOST_LOOKS; k++) {
        *at = bracket_next(&r);
        for (size_t i = 0; i < all; i++) trial[i] = from->u[i] + *at * from->tangent[i];
        status = follower_find(f, trial, from->tangent, from->tangent, p);
        if (status.code != WHIRL_OK || !p->orbit) break;
        last = value_of(f, t, p);
        bracket_tell(&r, *at, last);
        if (last == 0.0 || fabs(last) <= 1e-13 * largest || bracket_width(&r) <= 1e-12) break;
    }
    free(trial);
    // A change of sign that is no zero: a leap from one extreme to another, or to another orbit.
    if (p->orbit && fabs(last) > 1e-4 * largest) {
        whirl_orbit_free(p->orbit);
        p->orbit = NULL;
    }
    return status;
}

/// A special point that was found, and where.
typedef struct finding {
    whirl_branch_point point;
    double at;
} finding;

enum { MOST_FINDINGS = 16 };

typedef struct findings {
    finding list[MOST_FINDINGS];
    size_t count;
} findings;

static whirl_status find(follower *f, const test *t, const waypoint *from, const waypoint *to, double length,
                         findings *found) {
    finding one = {.point = {.special = t->kind, .touch = t->touch}};
    waypoint p;
    if (found->count == MOST_FINDINGS) return whirl_ok();
    whirl_status status = waypoint_new(f, &p);
    if (status.code == WHIRL_OK) status = close_in(f, t, from, to, length, &p, &one.at);
    const bool paired = t->kind == WHIRL_NEIMARK_SACKER || t->kind == WHIRL_HOPF;
    const bool saddle = p.orbit && paired && !find_pair(p.orbit, &one.point.angle);
    if (status.code == WHIRL_OK && p.orbit && !saddle) {
        one.point.value = follower_value(f, p.u);
        one.point.orbit = p.orbit;
        p.orbit = NULL;
        found->list[found->count++] = one;
    }
    waypoint_free(&p);
    return status;
}

static int by_place(const void *a, const void *b) {
    const finding *p = a, *q = b;
    return p->at < q->at ? -1 : p->at > q->at;
}

static whirl_status find_all(follower *f, const waypoint *from, const waypoint *to, double length, findings *found) {
    static const whirl_special moving[] = {WHIRL_FOLD, WHIRL_BRANCHING, WHIRL_DOUBLING, WHIRL_NEIMARK_SACKER};
    static const whirl_special resting[] = {WHIRL_FOLD, WHIRL_BRANCHING, WHIRL_HOPF};
    const bool moves = from->orbit->period > 0.0;
    const whirl_special *kinds = moves ? moving : resting;
    const size_t count = moves ? sizeof moving / sizeof *moving : sizeof resting / sizeof *resting;
    const test fold = {.kind = WHIRL_FOLD};
    const bool folds = changes(f, &fold, from, to);
    whirl_status status = whirl_ok();
    for (size_t k = 0; k < count && status.code == WHIRL_OK; k++) {
        const test t = {.kind = kinds[k]};
        if (t.kind == WHIRL_BRANCHING && folds) continue;
        if (changes(f, &t, from, to)) status = find(f, &t, from, to, length, found);
    }
    for (size_t k = 0; k < from->orbit->touch_count && status.code == WHIRL_OK; k++) {
        const test t = {.kind = WHIRL_GRAZE, .touch = k, .intervals = risings(&from->orbit->touches[k])};
        if (changes(f, &t, from, to)) status = find(f, &t, from, to, length, found);
    }
    return status;
}

whirl_status special_locate(follower *f, const waypoint *from, const waypoint *to, double length) {
    findings found = {.count = 0};
    whirl_status status = find_all(f, from, to, length, &found);
    qsort(found.list, found.count, sizeof *found.list, by_place);
    for (size_t i = 0; i < found.count; i++) {
        if (status.code == WHIRL_OK) status = follower_add(f, &found.list[i].point);
        if (status.code != WHIRL_OK) whirl_orbit_free(found.list[i].point.orbit);
    }
    return status;
}
