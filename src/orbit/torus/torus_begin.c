// The first torus of a branch, near a Neimark-Sacker point. There, up to second order, the map turns the ellipse Re(q
// exp(i theta)), where q is an eigenvector of its derivative, by the angle of the multiplier of q.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"
#include "section_map.h"
#include "torus_equations.h"
#include "torus_follower.h"
#include "two_pi.h"

/// Computes the eigenvector of a [n][n] with the eigenvalue nearest to exp(i angle): vector [n][2]. Returns false
/// without memory.
static bool torus_begin_eigenvector(size_t n, double *a, double angle, double *vector) {
    double *real = calloc(2 * n + 2 * n * n, sizeof *real), *imaginary = real ? real + n : NULL;
    double *vectors = real ? imaginary + n : NULL;
    size_t nearest = 0;
    const bool good = real && matrix_eigen(n, a, real, imaginary, vectors);
    for (size_t i = 1; good && i < n; i++)
        if (hypot(real[i] - cos(angle), imaginary[i] - sin(angle)) <
            hypot(real[nearest] - cos(angle), imaginary[nearest] - sin(angle)))
            nearest = i;
    if (good) memcpy(vector, vectors + 2 * nearest * n, 2 * n * sizeof *vector);
    free(real);
    return good;
}

/// Sets the trial to the orbit with the ellipse around it, and both direction and reference to the ellipse.
static bool place_ellipse(torus_follower *f, const whirl_branch_point *point, const double *vector, double step) {
    enum { FIRST_NODES = 11 };
    torus_equations *e = &f->equations;
    const size_t n = e->n, most = e->options->most_nodes, count = FIRST_NODES < most ? FIRST_NODES : most;
    double *centre = f->forward;
    section_map_take(e->map, point->orbit->nodes, centre);
    for (size_t j = 0; j < count; j++) {
        const double theta = two_pi * (double)j / (double)count;
        for (size_t i = 0; i < n; i++) {
            f->direction[j * n + i] = vector[2 * i] * cos(theta) - vector[2 * i + 1] * sin(theta);
            f->trial[j * n + i] = centre[i];
        }
    }
    f->direction[count * n] = f->direction[count * n + 1] = 0.0;
    if (!torus_follower_resize(f, count, f->trial) || !curve_make_unit(&f->curve, f->direction)) return false;
    torus_equations_refer(e, f->direction);
    for (size_t i = 0; i < count * n; i++) f->trial[i] += step * f->direction[i];
    f->trial[count * n] = point->angle;
    f->trial[count * n + 1] = point->value;
    memcpy(f->forward, f->direction, (count * n + 2) * sizeof *f->forward);
    return true;
}

static whirl_status find_first(torus_follower *f, const whirl_branch_point *point, double step, torus_waypoint *at) {
    torus_equations *e = &f->equations;
    const size_t n = e->n;
    double *work = calloc(n * n + 4 * n, sizeof *work), *vector = work ? work + n * n : NULL, volume;
    if (!work) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a torus");
    double *centre = vector + 2 * n, *image = centre + n;
    section_map_take(e->map, point->orbit->nodes, centre);
    const bool good = section_map_carry(e->map, 1, centre, image, work, &volume) &&
                      torus_begin_eigenvector(n, work, point->angle, vector) && place_ellipse(f, point, vector, step);
    free(work);
    whirl_status status =
        good ? torus_follower_find(f, at)
             : whirl_fail(WHIRL_BAD_INPUT, "the motion around a Neimark-Sacker point could not be followed");
    if (status.code == WHIRL_OK && (!at->torus || at->rough))
        status = whirl_fail(WHIRL_BAD_INPUT,
                            "no torus was found %g from the Neimark-Sacker point at %.10g (its rotation number is "
                            "%.6g): a smaller step may find it",
                            step, point->value, point->angle / two_pi);
    return status;
}

static whirl_status torus_begin_check(const whirl_branch_point *point, double step) {
    const double slight = 1e-3;
    if (point->special != WHIRL_NEIMARK_SACKER || point->orbit->revolutions == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "no torus begins at this point, expected a Neimark-Sacker point of an orbit "
                                           "of whole revolutions");
    if (!(step > 0.0 && isfinite(step)))
        return whirl_fail(WHIRL_BAD_INPUT, "a torus %g from its orbit, expected a number above 0", step);
    for (int q = 1; q <= 4; q++)
        if (fabs(remainder(point->angle * q, two_pi)) < q * slight)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "the multipliers at %.10g are %d-th roots of 1 within %g (a strong resonance): what "
                              "begins there need not be a torus",
                              point->value, q, slight);
    return whirl_ok();
}

whirl_status whirl_torus_begin(const whirl_family *family, const whirl_branch_point *point, double step,
                               const whirl_torus_branch_options *options, whirl_torus **torus, double *value) {
    torus_follower f = {.trial = NULL};
    torus_waypoint at = {.u = NULL};
    *torus = NULL;
    whirl_status status = torus_begin_check(point, step);
    if (status.code != WHIRL_OK) return status;
    const whirl_orbit *orbit = point->orbit;
    status =
        torus_follower_begin(&f, family, orbit->revolutions, orbit->dimension, orbit->nodes, point->value, options);
    if (status.code == WHIRL_OK) status = torus_waypoint_new(&f, &at);
    if (status.code == WHIRL_OK) status = find_first(&f, point, step, &at);
    if (status.code == WHIRL_OK) {
        *value = at.u[f.curve.count];
        *torus = at.torus;
        at.torus = NULL;
    }
    torus_waypoint_free(&at);
    torus_follower_end(&f);
    return status;
}
