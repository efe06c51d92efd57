// Periodic orbits by shooting.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "equations.h"
#include "newton.h"
#include "orbit_describe.h"
#include "shooting.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/orbit.h"

whirl_orbit_options whirl_orbit_default(void) {
    whirl_orbit_options options = {
        .integrate = whirl_integrate_default(), .segments = 1, .tolerance = 1e-12, .most_steps = 25};
    strcpy(options.integrate.method, "dop853");
    options.integrate.steps_per_revolution = 512; // instants at which contacts are searched
    options.integrate.rtol = 1e-13;
    options.integrate.atol = 1e-15;
    return options;
}

/// Returns true if Newton's method converged to an equilibrium, which closes after any time.
static bool periodic_orbit_rests(orbit_equations *e) {
    double flow = 0.0, slope = 0.0;
    for (size_t i = 0; i < e->s->dimension; i++) flow = fmax(flow, fabs(e->flow[i]));
    equations_begin_at(e, e->nodes);
    for (size_t i = 0; i < e->s->dimension; i++) slope = fmax(slope, fabs(e->flow[i]));
    return slope <= 1e-8 * flow;
}

static whirl_status periodic_orbit_solve(orbit_equations *e, const double *start, const whirl_orbit_options *options,
                                         double *u, whirl_orbit **out) {
    shooting *s = e->s;
    const newton_problem problem = {.count = equations_count(e),
                                    .context = e,
                                    .evaluate = equations_evaluate,
                                    .size = equations_size,
                                    .tolerance = options->tolerance,
                                    .most_steps = options->most_steps,
                                    .most_halvings = 8};
    // Spread nodes along the motion from the start: they are the first unknowns, together with a free period.
    equations_begin_at(e, start);
    memcpy(e->nodes, start, s->dimension * sizeof *start);
    if (!shooting_spread(s, e->nodes, s->period))
        return whirl_fail(WHIRL_BAD_INPUT, "the motion from which an orbit is searched leaves its bounds");
    equations_take(e, e->nodes, u);
    if (problem.count > s->count * s->kept_count) u[problem.count - 1] = s->period;
    // Solve, and refuse an equilibrium where an orbit is searched.
    const newton_result result = newton_solve(&problem, u);
    if (!result.found)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "no periodic orbit was found: after %d steps of Newton's method it fails to close by %.3g of "
                          "its size, expected %.3g",
                          result.steps, result.size, options->tolerance);
    if (s->revolutions == 0 && !shooting_rests(s) && periodic_orbit_rests(e))
        return whirl_fail(WHIRL_BAD_INPUT, "no periodic orbit was found: Newton's method came to an equilibrium");
    return orbit_describe(s, e->nodes, equations_period(e, u), result.size, out);
}

static whirl_status periodic_orbit_find(const whirl_system *system, const double *start, size_t revolutions,
                                        double period, const whirl_orbit_options *options, whirl_orbit **out) {
    orbit_equations e;
    *out = NULL;
    whirl_status status = equations_make(&e, system, NULL, 0.0, options, revolutions, period);
    double *u = status.code == WHIRL_OK ? calloc(equations_count(&e) + 1, sizeof *u) : NULL;
    if (u)
        status = periodic_orbit_solve(&e, start, options, u, out);
    else if (status.code == WHIRL_OK)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit of %zu revolutions", revolutions);
    free(u);
    equations_free(&e);
    return status;
}

whirl_status whirl_orbit_find(const whirl_system *system, const double *start, size_t revolutions,
                              const whirl_orbit_options *options, whirl_orbit **orbit) {
    *orbit = NULL;
    if (revolutions == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "an orbit of 0 revolutions, expected 1 to %d", WHIRL_MAX_ORBIT);
    return periodic_orbit_find(system, start, revolutions, 0.0, options, orbit);
}

/// Returns true if the right-hand side depends on time. Compares instants without any symmetry between them.
static bool is_driven(const whirl_system *system, const double *x, double *slopes) {
    enum { LOOKS = 5 };
    double forcing[WHIRL_MAX_FORCING], *other = slopes + system->dimension;
    for (int look = 0; look < LOOKS; look++) {
        const double t = system->period * 0.19 * look;
        if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
        system->rhs(system->model, t, forcing, x, look == 0 ? slopes : other);
        for (size_t i = 0; i < system->dimension && look > 0; i++)
            if (fabs(other[i] - slopes[i]) > 1e-12 * fmax(fabs(other[i]), fabs(slopes[i]))) return true;
    }
    return false;
}

whirl_status whirl_orbit_find_free(const whirl_system *system, const double *start, double period,
                                   const whirl_orbit_options *options, whirl_orbit **orbit) {
    *orbit = NULL;
    if (!(period > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "an orbit's period is %g, expected a number above 0", period);
    double *slopes = calloc(2 * system->dimension + 1, sizeof *slopes);
    if (!slopes) return whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit");
    const bool driven = is_driven(system, start, slopes);
    free(slopes);
    if (driven)
        return whirl_fail(WHIRL_BAD_INPUT, "the machine is driven in time (unbalance, forces that turn), expected one "
                                           "without such forces for an orbit with a free period");
    return periodic_orbit_find(system, start, 0, period, options, orbit);
}

whirl_status whirl_orbit_rest(const whirl_system *system, const double *start, const whirl_orbit_options *options,
                              whirl_orbit **orbit) {
    double *x = malloc((system->dimension + 1) * sizeof *x);
    *orbit = NULL;
    if (!x) return whirl_fail(WHIRL_NO_MEMORY, "no memory for an equilibrium");
    memcpy(x, start, system->dimension * sizeof *x);
    whirl_status status = whirl_equilibrium(system, x);
    if (status.code == WHIRL_NUMERICAL_FAILURE) status = whirl_fail(WHIRL_BAD_INPUT, "%s", status.message);
    if (status.code == WHIRL_OK) status = periodic_orbit_find(system, x, 0, 0.0, options, orbit);
    free(x);
    return status;
}

whirl_status whirl_orbit_observe(const whirl_system *system, const whirl_orbit *orbit,
                                 const whirl_orbit_options *options, size_t instants, whirl_observe_fn observe,
                                 void *observer) {
    whirl_orbit_options own = *options;
    shooting *s;
    own.segments = (int)(orbit->segment_count / (orbit->revolutions > 0 ? orbit->revolutions : 1));
    own.integrate.steps_per_revolution = (int)instants * own.segments;
    whirl_status status = shooting_new(system, &own, orbit->revolutions, orbit->period, &s);
    if (status.code != WHIRL_OK) return status;
    if (!shooting_observe(s, orbit->nodes, orbit->period, observe, observer))
        status = whirl_fail(WHIRL_BAD_INPUT, "the motion along an orbit leaves its bounds");
    shooting_free(s);
    return status;
}
