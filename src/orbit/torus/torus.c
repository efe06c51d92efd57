// Tori of one machine.
#include "whirl/engine/torus.h"

#include <math.h>
#include <stdlib.h>

#include "newton.h"
#include "torus_describe.h"
#include "torus_equations.h"
#include "torus_options.h"
#include "torus_start.h"

static whirl_status torus_check(const whirl_system *system, const double *points, size_t count, double rotation,
                                const whirl_torus_options *options) {
    if (count < WHIRL_MIN_TORUS_SECTIONS)
        return whirl_fail(WHIRL_BAD_INPUT, "a torus from %zu sections, expected %d or more", count,
                          WHIRL_MIN_TORUS_SECTIONS);
    if (isfinite(rotation) && !(fabs(rotation) <= 1.0))
        return whirl_fail(WHIRL_BAD_INPUT, "a torus of rotation number %g, expected -1 to 1", rotation);
    for (size_t i = 0; i < count * system->dimension; i++)
        if (!isfinite(points[i]))
            return whirl_fail(WHIRL_BAD_INPUT, "section %zu is not finite", i / system->dimension);
    return torus_check_options(options);
}

/// Moves *u, which grows with the number of nodes, to a torus as accurate as the options require.
static whirl_status torus_solve(torus_equations *e, double **u, whirl_torus **out) {
    const whirl_torus_options *o = e->options;
    const double slight = 1e-8;
    for (;;) {
        // Solve with the present number of nodes.
        torus_equations_refer(e, *u);
        const newton_result result = newton_solve(&(newton_problem){.count = torus_equations_count(e),
                                                                    .context = e,
                                                                    .evaluate = torus_equations_evaluate,
                                                                    .size = torus_equations_size,
                                                                    .tolerance = o->tolerance,
                                                                    .most_steps = o->most_steps,
                                                                    .most_halvings = 6},
                                                  *u);
        // Refuse a failure, and a periodic orbit.
        if (!result.found)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "no torus was found: after %d steps of Newton's method its curve of %zu nodes is carried "
                              "onto itself but for %.3g of its size, expected %.3g",
                              result.steps, e->count, result.size, o->tolerance);
        if (torus_equations_radius(e, *u) <= slight * torus_equations_reach(e, *u))
            return whirl_fail(WHIRL_BAD_INPUT, "no torus was found: Newton's method came to a periodic orbit");
        // Accept the torus if it is accurate between its nodes.
        whirl_status status = torus_describe(e, *u, result.size, out);
        if (status.code != WHIRL_OK || torus_is_accurate(e, *u, *out)) return status;
        // Otherwise repeat with more nodes, up to the most that the options allow.
        const size_t before = e->count, wanted = torus_nodes_wanted(e, *u, (*out)->error);
        if (wanted <= before) {
            char why[WHIRL_MESSAGE_SIZE];
            torus_say_rough(e, *out, why, sizeof why);
            status = whirl_fail(WHIRL_BAD_INPUT, "no torus: %s", why);
        }
        whirl_torus_free(*out);
        *out = NULL;
        if (status.code != WHIRL_OK) return status;
        double *finer = calloc(wanted * e->n + 2, sizeof *finer);
        const bool good = finer && torus_resample(e, before, *u, wanted, finer) && torus_equations_resize(e, wanted);
        free(*u);
        *u = finer;
        if (!good) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a torus of %zu nodes", wanted);
    }
}

whirl_status whirl_torus_find(const whirl_system *system, const double *points, size_t count, size_t revolutions,
                              double rotation, const whirl_torus_options *options, whirl_torus **torus) {
    torus_equations e = {.map = NULL};
    double *u = NULL;
    *torus = NULL;
    whirl_status status = torus_check(system, points, count, rotation, options);
    if (status.code != WHIRL_OK) return status;
    const double *last = points + (count - 1) * system->dimension;
    status = torus_equations_make(&e, system, NULL, 0.0, options, revolutions, system->dimension, last);
    if (status.code == WHIRL_OK && e.n < 2)
        status = whirl_fail(WHIRL_BAD_INPUT, "a machine of %zu coordinates has no tori, expected 2 or more", e.n);
    if (status.code == WHIRL_OK) status = torus_fit(&e, points, count, rotation, &u);
    if (status.code == WHIRL_OK) status = torus_solve(&e, &u, torus);
    free(u);
    torus_equations_free(&e);
    return status;
}

static bool observe_from(whirl_integrator *integrator, const whirl_torus *torus, double theta, double *x,
                         whirl_observe_fn observe, void *observer) {
    bool bounded = true;
    whirl_torus_at(torus, theta, x);
    for (size_t k = 0; k < torus->revolutions && bounded; k++)
        bounded = whirl_integrator_revolve(integrator, x, observe, observer) == WHIRL_BOUNDED;
    return bounded;
}

whirl_status whirl_torus_observe(const whirl_system *system, const whirl_torus *torus,
                                 const whirl_torus_options *options, size_t angles, size_t instants,
                                 whirl_observe_fn observe, void *observer) {
    whirl_integrate_options own = options->integrate;
    whirl_integrator *integrator = NULL;
    double *x = calloc(torus->dimension + 1, sizeof *x);
    bool bounded = true;
    own.steps_per_revolution = (int)instants;
    whirl_status status = x ? whirl_integrator_new(system, &own, &integrator)
                            : whirl_fail(WHIRL_NO_MEMORY, "no memory for a state of a torus");
    for (size_t j = 0; j < angles && bounded && status.code == WHIRL_OK; j++) {
        const double theta = 6.283185307179586476925 * (double)j / (double)angles;
        bounded = observe_from(integrator, torus, theta, x, observe, observer);
    }
    if (!bounded) status = whirl_fail(WHIRL_BAD_INPUT, "the motion along a torus leaves its bounds");
    whirl_integrator_free(integrator);
    free(x);
    return status;
}
