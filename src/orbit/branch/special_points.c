// Locates changes of stability, or of contact, along a branch.
#include "special_points.h"
#include "branch_points.h"
#include "curve.h"
#include "follower.h"
#include "normal_form.h"
#include "vanishing.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bracket.h"

/// A test function, whose sign change marks a special point.
typedef struct test {
    whirl_special kind;
    size_t touch;     ///< index in the orbit's touches, for a graze
    size_t intervals; ///< number of intervals of contact at the first waypoint, for a graze
} test;

// ---------------------------------------------------------------- contacts

/// Returns the extreme of the switching function nearest to zero, with a sign for the side of the graze on which the
/// orbit is.
static double graze_value(const test *t, const whirl_orbit *orbit) {
    const whirl_touch *touch = &orbit->touches[t->touch];
    const double size = fmin(fabs(touch->nearest), 1e30);
    return whirl_touch_closings(touch) == t->intervals ? size : -size;
}

// ---------------------------------------------------------------- search

/// Returns the value of the test function. A fold uses the tangent's parameter: the product of multipliers also
/// vanishes there, but has no sign change along the branch.
static double special_value_of(const follower *f, const test *t, const waypoint *p) {
    if (t->kind == WHIRL_FOLD) return p->tangent[f->curve.count];
    return t->kind == WHIRL_GRAZE ? graze_value(t, p->orbit) : vanishing_value(t->kind, 0, p->orbit);
}

static bool special_changes(const follower *f, const test *t, const waypoint *a, const waypoint *b) {
    return (special_value_of(f, t, a) < 0.0) != (special_value_of(f, t, b) < 0.0);
}

/// Finds the point at a place along the tangent.
static whirl_status special_look(follower *f, const waypoint *from, const waypoint *to, double at, double *trial,
                                 waypoint *p) {
    follower_predict(f, from, to, from, at, trial);
    const double *across = follower_across(f, from, to, from, trial + f->curve.count + 1);
    return follower_find(f, trial, across, from->tangent, p);
}

/// Returns a place in the bracket a little off `at`. Exactly where branches cross, the direction is undefined.
static double special_aside(const bracket *r, double at) {
    const double farther = fabs(r->b - at) > fabs(r->a - at) ? r->b : r->a;
    return at + 1e-3 * (farther - at);
}

/// Closes in on the sign change. *at is its place along the tangent, and p the point there, which has no orbit if the
/// search failed.
static whirl_status special_close_in(follower *f, const test *t, const waypoint *from, const waypoint *to, waypoint *p,
                                     double *at) {
    enum { MAX_LOOKS = 80 };
    const size_t all = f->curve.count + 1;
    whirl_status status = whirl_ok();
    double *trial = malloc(2 * all * sizeof *trial), last = INFINITY;
    if (!trial) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a point of a branch");
    bracket r = bracket_between(0.0, special_value_of(f, t, from), follower_length(f, from, to, trial),
                                special_value_of(f, t, to));
    // The test function is only as exact as the tolerance of orbits.
    const double largest = fmax(fabs(r.fa), fabs(r.fb)), nothing = fmax(1e-13, 0.1 * f->options->orbit.tolerance);
    for (int k = 0; k < MAX_LOOKS; k++) {
        *at = bracket_next(&r);
        status = special_look(f, from, to, *at, trial, p);
        if (status.code == WHIRL_OK && !p->orbit && t->kind == WHIRL_BRANCHING) {
            *at = special_aside(&r, *at);
            status = special_look(f, from, to, *at, trial, p);
        }
        if (status.code != WHIRL_OK || !p->orbit) break;
        last = special_value_of(f, t, p);
        bracket_update(&r, *at, last);
        if (fabs(last) <= nothing * largest || bracket_width(&r) <= 1e-12) break;
    }
    free(trial);
    // Discard a sign change without a zero: a jump from one extreme to another, or to another orbit.
    if (p->orbit && fabs(last) > 1e-4 * largest) {
        whirl_orbit_free(p->orbit);
        p->orbit = NULL;
    }
    return status;
}

/// A located special point and its place.
typedef struct finding {
    whirl_branch_point point;
    double at;
} finding;

enum { MAX_FINDINGS = 16 };

typedef struct findings {
    finding list[MAX_FINDINGS];
    size_t count;
} findings;

static whirl_status special_find(follower *f, const test *t, const waypoint *from, const waypoint *to,
                                 findings *found) {
    finding one = {.point = {.second = NAN, .criticality = NAN, .special = t->kind, .touch = t->touch}};
    waypoint p;
    if (found->count == MAX_FINDINGS) return whirl_ok();
    whirl_status status = waypoint_new(f, &p);
    if (status.code == WHIRL_OK) status = special_close_in(f, t, from, to, &p, &one.at);
    const bool paired = t->kind == WHIRL_NEIMARK_SACKER || t->kind == WHIRL_HOPF;
    const bool saddle = p.orbit && paired && !vanishing_pair(p.orbit, &one.point.angle);
    if (status.code == WHIRL_OK && p.orbit && !saddle) {
        one.point.value = follower_value(f, p.u);
        one.point.criticality = normal_form(f->equations.s, p.orbit, t->kind, one.point.angle);
        one.point.orbit = p.orbit;
        p.orbit = NULL;
        found->list[found->count++] = one;
    }
    waypoint_free(&p);
    return status;
}

static int special_by_place(const void *a, const void *b) {
    const finding *p = a, *q = b;
    return p->at < q->at ? -1 : p->at > q->at;
}

static whirl_status find_all(follower *f, const waypoint *from, const waypoint *to, bool pitchfork, findings *found) {
    static const whirl_special moving[] = {WHIRL_FOLD, WHIRL_BRANCHING, WHIRL_DOUBLING, WHIRL_NEIMARK_SACKER};
    static const whirl_special resting[] = {WHIRL_FOLD, WHIRL_BRANCHING, WHIRL_HOPF};
    const bool moves = from->orbit->period > 0.0;
    const whirl_special *kinds = moves ? moving : resting;
    const size_t count = moves ? sizeof moving / sizeof *moving : sizeof resting / sizeof *resting;
    const test fold = {.kind = WHIRL_FOLD};
    const bool folds = special_changes(f, &fold, from, to);
    whirl_status status = whirl_ok();
    for (size_t k = 0; k < count && status.code == WHIRL_OK; k++) {
        const test t = {.kind = kinds[k]};
        if ((t.kind == WHIRL_BRANCHING && folds) || (t.kind == WHIRL_FOLD && pitchfork)) continue;
        if (special_changes(f, &t, from, to)) status = special_find(f, &t, from, to, found);
    }
    for (size_t k = 0; k < from->orbit->touch_count && status.code == WHIRL_OK; k++) {
        const test t = {.kind = WHIRL_GRAZE, .touch = k, .intervals = whirl_touch_closings(&from->orbit->touches[k])};
        if (special_changes(f, &t, from, to)) status = special_find(f, &t, from, to, found);
    }
    return status;
}

whirl_status special_crossing(follower *f, const waypoint *from, const waypoint *to, whirl_branch_point *out) {
    const test t = {.kind = WHIRL_BRANCHING};
    findings found = {.count = 0};
    out->orbit = NULL;
    if (!special_changes(f, &t, from, to)) return whirl_ok();
    const whirl_status status = special_find(f, &t, from, to, &found);
    if (found.count > 0) *out = found.list[0].point;
    return status;
}

whirl_status special_locate(follower *f, const waypoint *from, const waypoint *to, bool pitchfork) {
    findings found = {.count = 0};
    whirl_status status = find_all(f, from, to, pitchfork, &found);
    qsort(found.list, found.count, sizeof *found.list, special_by_place);
    for (size_t i = 0; i < found.count; i++) {
        if (status.code == WHIRL_OK) status = branch_add(f->branch, f->options, &found.list[i].point);
        if (status.code != WHIRL_OK) whirl_orbit_free(found.list[i].point.orbit);
    }
    return status;
}
