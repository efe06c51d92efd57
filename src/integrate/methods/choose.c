// Chooses the method for a machine if the method is "auto". dop853 needs the number of steps that its tolerance
// requires or, for a stiff machine, the number that keeps it stable. The latter follows from the eigenvalues of the
// Jacobian and the method's stability function. If that is a great number, the work of both methods over some
// revolutions is counted and compared.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dop853_tableau.h"
#include "method.h"
#include "stepper.h"
#include "stiffest.h"

/// Steps per revolution up to which dop853 is kept: rodas5p takes hundreds of steps at the usual tolerances, each as
/// costly as several of dop853.
static const double crawl = 1000.0;

enum { PROBED = 16, COUNTED = 4, PHASES = 16 };

/// Limits of a trial run of dop853, about a second. most_dop853: steps, twice `crawl` in each of PROBED
/// revolutions; a motion that needs even more does not need them for stability. most_products: multiplications, some
/// n^2 a stage.
static const double most_dop853 = 2.0 * PROBED * 1000.0, most_products = 3e9;

/// Limits of a trial run of rodas5p. most_rodas5p: multiplications, some n^3 a step, about a second. telling_rodas5p:
/// number of steps from which on they can be extrapolated to a revolution. usual_rodas5p: steps that are assumed for a
/// revolution if they cannot.
static const double most_rodas5p = 4e9, telling_rodas5p = 64.0, usual_rodas5p = 500.0;

/// Number of coordinates up to which eigenvalues take about a second. For larger machines the norm bounds them.
enum { MAX_SOLVED = 400 };

static whirl_status choose_start(const whirl_system *system, const whirl_integrate_options *options, const char *name,
                                 double most, whirl_integrator **integrator) {
    whirl_integrate_options own = *options;
    memset(own.method, 0, sizeof own.method);
    memcpy(own.method, name, strlen(name));
    own.steps_per_revolution = PHASES;
    const whirl_status status = whirl_integrator_new(system, &own, integrator);
    if (status.code == WHIRL_OK) (*integrator)->most_steps = (size_t)most;
    return status;
}

/// Returns the share, 0 to 1, of its last revolution that a trial run has completed when its steps ran out; 1 if they
/// did not run out.
static double part_done(const whirl_integrator *integrator) {
    const stepper *c = integrator->workspace;
    return c->tried < integrator->most_steps ? 1.0 : fmin(c->t / integrator->system->period, 1.0);
}

/// Returns the steps per revolution that keep dop853 stable at the stiffest phase seen, or 0 if they are within the
/// limit up to which dop853 is kept.
static double stable_steps(phase_search *search) {
    const double safe = 2.0; // |z| up to which dop853 is stable in the whole left half plane
    if (search->norm * search->system->period <= safe * crawl) return 0.0;
    if (search->system->dimension > MAX_SOLVED) return search->norm * search->system->period / safe;
    if (!phase_search_solve(search)) return 0.0;
    const double steps = phase_search_steps(search, dop853_amplification, crawl);
    return steps > crawl ? steps : 0.0;
}

/// Carries x with a method over some revolutions, and inspects every phase. Stops if dop853 would need too many steps,
/// or if no step is left. Returns the number of revolutions, or -1 if the motion ended.
static double carry(whirl_integrator *integrator, phase_search *search, int revolutions, bool until_stiff,
                    double *steps) {
    for (int i = 0; i < revolutions; i++) {
        if (whirl_integrator_revolve(integrator, search->x, phase_search_note, search) != WHIRL_BOUNDED) return -1.0;
        const double part = part_done(integrator);
        if (part < 1.0) phase_search_note(search, part * search->system->period, search->x);
        *steps = stable_steps(search);
        if (part < 1.0 || (until_stiff && *steps > 0.0)) return i + part;
    }
    return revolutions;
}

/// Counts the work of rodas5p over the last of a few more revolutions. For a machine so large that the trial run ends
/// earlier, counts it over the part that was carried.
static whirl_status count_rodas5p(phase_search *search, const whirl_integrate_options *options, double *steps,
                                  double *count) {
    whirl_integrator *integrator;
    *count = INFINITY;
    const double most = fmax(1.0, most_rodas5p / pow((double)search->system->dimension, 3.0));
    const whirl_status status = choose_start(search->system, options, "rodas5p", fmin(most, 2e4), &integrator);
    if (status.code != WHIRL_OK) return status;
    const double settled = carry(integrator, search, COUNTED, false, steps);
    const double before = integrator->method->work(integrator);
    if (settled >= 0.0 && most < telling_rodas5p) {
        *count = before / (double)((stepper *)integrator->workspace)->tried * usual_rodas5p;
    } else if (settled >= COUNTED) {
        const whirl_motion motion = whirl_integrator_revolve(integrator, search->x, NULL, NULL);
        const double last = integrator->method->work(integrator) - before, part = part_done(integrator);
        if (motion == WHIRL_BOUNDED) *count = part > 0.0 ? last / part : before / settled;
    } else if (settled > 0.0) {
        *count = before / settled;
    }
    whirl_integrator_free(integrator);
    return whirl_ok();
}

whirl_status whirl_method_probe(const whirl_system *system, const whirl_integrate_options *options, const double *from,
                                whirl_method_cost *cost) {
    phase_search search;
    whirl_integrator *integrator;
    double *block, steps = 0.0;
    *cost = (whirl_method_cost){0.0, (double)NAN};
    // Bound the cost by the multiplications of a Jacobian.
    const double products = DOP853_STAGES * (double)system->dimension * (double)system->dimension;
    const double most = fmax(1.0, fmin(most_dop853, most_products / products));
    whirl_status status = choose_start(system, options, "dop853", most, &integrator);
    if (status.code != WHIRL_OK) return status;
    // Count the steps of both methods from the same state.
    if (phase_search_begin(&search, system, &block)) {
        memcpy(search.x, from, system->dimension * sizeof *from);
        phase_search_note(&search, 0.0, search.x);
        steps = stable_steps(&search);
        const bool bounded = steps > 0.0 || carry(integrator, &search, PROBED, true, &steps) >= 0.0;
        if (bounded && steps > 0.0) status = count_rodas5p(&search, options, &steps, &cost->rodas5p);
        cost->dop853 = DOP853_STAGES * steps;
        free(block);
    } else {
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory to choose a method");
    }
    whirl_integrator_free(integrator);
    return status;
}
