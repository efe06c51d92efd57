// Pitchforks that are reached on their side branch. Beyond the pitchfork the side branch is its own mirror image if the
// machine is symmetric.
//
// Near a pitchfork the parameter is even along the side branch, and the product of all (multiplier - 1) vanishes like
// the square of the distance (Golubitsky, Schaeffer 1985, chapter VI). The tangent turns back as at a fold, but the
// product keeps its sign. The point is located on the symmetric branch, where the product passes zero and Newton's
// method is regular.
#include "mirrored.h"
#include "curve.h"
#include "follower.h"
#include "special_points.h"
#include "vanishing.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// The neighbourhood of a possible pitchfork.
typedef struct pitchfork {
    const waypoint *side;  ///< point of the side branch farther from the vertex
    double *vertex;        ///< [unknowns] vertex of the side branch, by the cubic through both points
    double length;         ///< length of the step
    waypoint beyond;       ///< on the symmetric branch, on the side of the vertex without a side branch
    waypoint within;       ///< on the symmetric branch, on the other side
    waypoint sides[2];     ///< on both sides of `within`, at its parameter
    double *trial, *along; ///< [unknowns] workspace
} pitchfork;

/// Returns true for two points between which the branch turns back while no multiplier passes 1.
static bool mirrored_turns(const follower *f, const waypoint *a, const waypoint *b) {
    const size_t n = f->curve.count;
    const whirl_special kind = WHIRL_BRANCHING;
    const bool turns = (a->tangent[n] < 0.0) != (b->tangent[n] < 0.0);
    return turns && (vanishing_value(kind, 0, a->orbit) < 0.0) == (vanishing_value(kind, 0, b->orbit) < 0.0);
}

/// Writes the vertex: the point where the tangent, taken as linear between both points, has no part along the
/// parameter.
static void mirrored_vertex(const follower *f, const waypoint *a, const waypoint *b, pitchfork *p) {
    const size_t n = f->curve.count;
    const double x = a->tangent[n] / (a->tangent[n] - b->tangent[n]), y = 1.0 - x;
    const double share = x * x * (3.0 - 2.0 * x);
    for (size_t i = 0; i <= n; i++) p->trial[i] = b->u[i] - a->u[i];
    p->length = sqrt(curve_dot(&f->curve, p->trial, p->trial));
    for (size_t i = 0; i <= n; i++)
        p->vertex[i] = a->u[i] + share * p->trial[i] + p->length * x * y * (y * a->tangent[i] - x * b->tangent[i]);
    p->side = fabs(a->u[n] - p->vertex[n]) > fabs(b->u[n] - p->vertex[n]) ? a : b;
}

/// Returns the distance of two points in units of the curve's scale.
static double mirrored_distance(const follower *f, pitchfork *p, const double *a, const double *b) {
    for (size_t i = 0; i <= f->curve.count; i++) p->along[i] = a[i] - b[i];
    return sqrt(curve_dot(&f->curve, p->along, p->along));
}

/// Searches an orbit from p->trial at its value of the parameter. The derivative of the previous point is discarded,
/// since it has another sign on the other branch.
static whirl_status mirrored_look(follower *f, pitchfork *p, waypoint *out) {
    f->curve.known = false;
    curve_parameter_direction(&f->curve, p->along);
    return follower_find(f, p->trial, p->along, p->along, out);
}

/// Searches the symmetric branch on both sides of the vertex, far enough away that the product exceeds its errors.
/// *there becomes false if the branch is not found.
static whirl_status mirrored_centre(follower *f, pitchfork *p, bool *there) {
    const size_t n = f->curve.count;
    const double height = p->side->u[n] - p->vertex[n], least = 1e-4 * fabs(f->options->to - f->options->from);
    const double reach = copysign(fmax(fabs(height), least), height);
    *there = false;
    memcpy(p->trial, p->vertex, (n + 1) * sizeof *p->trial);
    p->trial[n] = p->vertex[n] - reach;
    whirl_status status = mirrored_look(f, p, &p->beyond);
    if (status.code != WHIRL_OK || !p->beyond.orbit) return status;
    if (mirrored_distance(f, p, p->beyond.u, p->vertex) > p->length) return status;
    for (size_t i = 0; i <= n; i++)
        p->trial[i] = p->beyond.u[i] + 2.0 * reach * p->beyond.tangent[i] / p->beyond.tangent[n];
    status = mirrored_look(f, p, &p->within);
    *there = status.code == WHIRL_OK && p->within.orbit;
    return status;
}

/// Searches the side branch on both sides of the symmetric branch. Mirror images have the same stability, to a
/// thousandth: this is the accuracy of a product of small numbers.
static whirl_status mirrored_image(follower *f, pitchfork *p, bool *there) {
    const size_t n = f->curve.count;
    const double height = p->side->u[n] - p->vertex[n], reach = p->within.u[n] - p->vertex[n];
    double product[2];
    for (int k = 0; k < 2; k++) {
        const double factor = (k == 0 ? 1.0 : -1.0) * sqrt(reach / height);
        waypoint *own = &p->sides[k];
        for (size_t i = 0; i < n; i++) p->trial[i] = p->within.u[i] + factor * (p->side->u[i] - p->vertex[i]);
        p->trial[n] = p->within.u[n];
        const whirl_status status = mirrored_look(f, p, own);
        if (status.code != WHIRL_OK || !own->orbit) return status;
        product[k] = vanishing_value(WHIRL_BRANCHING, 0, own->orbit);
    }
    const double apart = mirrored_distance(f, p, p->sides[0].u, p->sides[1].u);
    *there = apart > mirrored_distance(f, p, p->sides[0].u, p->within.u) &&
             fabs(product[0] - product[1]) <= 1e-3 * fabs(product[0]);
    return whirl_ok();
}

static whirl_status mirrored_search(follower *f, const waypoint *from, const waypoint *to, pitchfork *p,
                                    whirl_branch_point *out, bool *image) {
    bool there;
    mirrored_vertex(f, from, to, p);
    whirl_status status = mirrored_centre(f, p, &there);
    if (status.code == WHIRL_OK && there) status = special_crossing(f, &p->beyond, &p->within, out);
    if (status.code == WHIRL_OK && there && out->orbit) status = mirrored_image(f, p, image);
    return status;
}

whirl_status mirrored_locate(follower *f, const waypoint *from, const waypoint *to, whirl_branch_point *out,
                             bool *image) {
    const size_t all = f->curve.count + 1;
    out->orbit = NULL;
    *image = false;
    if (!mirrored_turns(f, from, to)) return whirl_ok();
    double *work = calloc(3 * all, sizeof *work);
    if (!work) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a point of a branch");
    pitchfork p = {.vertex = work, .trial = work + all, .along = work + 2 * all};
    whirl_status status = waypoint_new(f, &p.beyond);
    if (status.code == WHIRL_OK) status = waypoint_new(f, &p.within);
    for (int k = 0; k < 2 && status.code == WHIRL_OK; k++) status = waypoint_new(f, &p.sides[k]);
    if (status.code == WHIRL_OK) status = mirrored_search(f, from, to, &p, out, image);
    if (status.code != WHIRL_OK) {
        whirl_orbit_free(out->orbit);
        out->orbit = NULL;
    }
    waypoint_free(&p.beyond);
    waypoint_free(&p.within);
    for (int k = 0; k < 2; k++) waypoint_free(&p.sides[k]);
    free(work);
    return status;
}
