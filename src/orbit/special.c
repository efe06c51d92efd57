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

/// The product of (multiplier - at) over all of them, real because they come in pairs.
static double product_about(const whirl_orbit *orbit, double at) {
    const size_t own = orbit_own_multiplier(orbit);
    double real = 1.0, imaginary = 0.0;
    for (size_t i = 0; i < orbit->multiplier_count; i++) {
        const double a = orbit->multipliers[i].real - at, b = orbit->multipliers[i].imaginary;
        if (i == own) continue;
        const double next = real * a - imaginary * b;
        imaginary = real * b + imaginary * a;
        real = next;
    }
    return real;
}

/// The product of (multiplier i times multiplier k, less 1) over all pairs: 0 where a pair is on the unit circle, and
/// where two real ones are each other's inverse.
static double product_of_pairs(const whirl_orbit *orbit) {
    const size_t own = orbit_own_multiplier(orbit);
    double real = 1.0, imaginary = 0.0;
    for (size_t i = 0; i < orbit->multiplier_count; i++)
        for (size_t k = i + 1; k < orbit->multiplier_count; k++) {
            const whirl_multiplier p = orbit->multipliers[i], q = orbit->multipliers[k];
            if (i == own || k == own) continue;
            const double a = p.real * q.real - p.imaginary * q.imaginary - 1.0;
            const double b = p.real * q.imaginary + p.imaginary * q.real;
            const double next = real * a - imaginary * b;
            imaginary = real * b + imaginary * a;
            real = next;
        }
    return real;
}

/// The pair nearest to product 1; false where it is of two real ones.
static bool pair_on_circle(const whirl_orbit *orbit, double *angle) {
    const size_t own = orbit_own_multiplier(orbit);
    double nearest = INFINITY, imaginary = 0.0;
    for (size_t i = 0; i < orbit->multiplier_count; i++)
        for (size_t k = i + 1; k < orbit->multiplier_count; k++) {
            const whirl_multiplier p = orbit->multipliers[i], q = orbit->multipliers[k];
            if (i == own || k == own) continue;
            const double away =
                hypot(p.real * q.real - p.imaginary * q.imaginary - 1.0, p.real * q.imaginary + p.imaginary * q.real);
            if (away >= nearest) continue;
            nearest = away;
            imaginary = p.imaginary;
            *angle = atan2(fabs(p.imaginary), p.real);
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
        return product_about(p->orbit, 1.0);
    case WHIRL_DOUBLING:
        return product_about(p->orbit, -1.0);
    case WHIRL_NEIMARK_SACKER:
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
    const bool saddle = p.orbit && t->kind == WHIRL_NEIMARK_SACKER && !pair_on_circle(p.orbit, &one.point.angle);
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
    static const whirl_special kinds[] = {WHIRL_FOLD, WHIRL_BRANCHING, WHIRL_DOUBLING, WHIRL_NEIMARK_SACKER};
    const test fold = {.kind = WHIRL_FOLD};
    const bool folds = changes(f, &fold, from, to);
    whirl_status status = whirl_ok();
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds && status.code == WHIRL_OK; k++) {
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
