// The integrators behind one interface.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "method.h"
#include "turns.h"
#include "whirl/engine/descriptor.h"

static const method *const methods[] = {
    &auto_method, &rk4_method, &dop853_method, &rodas5p_method, &cvode_adams_method, &cvode_bdf_method, NULL};
enum { METHOD_COUNT = sizeof methods / sizeof *methods - 1 };

const whirl_method *whirl_method_at(size_t index) {
    return index < METHOD_COUNT ? &methods[index]->about : NULL;
}

whirl_status method_find(const char *name, const method **found) {
    const char *names[METHOD_COUNT];
    for (size_t i = 0; i < METHOD_COUNT; i++) {
        names[i] = methods[i]->about.name;
        if (strcmp(names[i], name) == 0) {
            *found = methods[i];
            return whirl_ok();
        }
    }
    const char *near = whirl_nearest_name(name, names, METHOD_COUNT);
    if (near) return whirl_fail(WHIRL_BAD_INPUT, "no method is called '%.40s', did you mean '%s'?", name, near);
    return whirl_fail(WHIRL_BAD_INPUT, "no method is called '%.40s'", name);
}

whirl_status whirl_method_find(const char *name, const whirl_method **found) {
    const method *own = NULL;
    const whirl_status status = method_find(name, &own);
    *found = own ? &own->about : NULL;
    return status;
}

bool whirl_method_is_adaptive(const char *name) {
    const whirl_method *found;
    return whirl_method_find(name, &found).code == WHIRL_OK && found->adaptive;
}

const struct lanes_method *adaptive_in_lanes(const whirl_integrate_options *options) {
    const method *found;
    return method_find(options->method, &found).code == WHIRL_OK ? found->lanes : NULL;
}

static bool positive(double value) {
    return isfinite(value) && value > 0.0;
}

whirl_status whirl_integrate_check(const whirl_system *system) {
    if (system->frequency_count == 0) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT,
                      "a bearing has coefficients over the frequency of whirl, and a motion in time has no single "
                      "one, expected a machine that was built for motions (whirl_design_in_time)");
}

whirl_status check_options(const whirl_system *system, const whirl_integrate_options *options) {
    const whirl_status moves = whirl_integrate_check(system);
    if (moves.code != WHIRL_OK) return moves;
    if (system->dimension == 0 || !system->rhs)
        return whirl_fail(WHIRL_BAD_INPUT, "the system has no equations, expected a dimension and a right-hand side");
    if (!positive(system->period))
        return whirl_fail(WHIRL_BAD_INPUT, "the system's period is %g, expected a number above 0", system->period);
    const struct {
        const char *what;
        size_t count, most;
    } counts[] = {{"values that depend on time alone", system->forcing_count, WHIRL_MAX_FORCING},
                  {"switching functions", system->switch_count, WHIRL_MAX_SWITCHES},
                  {"contacts", system->contact_count, WHIRL_MAX_CONTACTS},
                  {"probes", system->probe_count, WHIRL_MAX_PROBES}};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        if (counts[i].count > counts[i].most)
            return whirl_fail(WHIRL_BAD_INPUT, "the system has %zu %s, expected at most %zu", counts[i].count,
                              counts[i].what, counts[i].most);
    return whirl_members_check(whirl_integrate_members(), options);
}

/// Allocates workspace for `most` perturbations.
static whirl_status integrator_make_room(whirl_integrator *integrator, size_t most) {
    const size_t rows = integrator->method->rows * (1 + most) + SPARE_ROWS;
    double *slopes = realloc(integrator->slopes, rows * integrator->system->dimension * sizeof *slopes);
    if (!slopes) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu perturbations", most);
    integrator->slopes = slopes;
    integrator->most_perturbations = most;
    return whirl_ok();
}

whirl_status whirl_integrator_new(const whirl_system *system, const whirl_integrate_options *options,
                                  whirl_integrator **out) {
    const method *chosen = NULL;
    *out = NULL;
    whirl_status status = check_options(system, options);
    if (status.code == WHIRL_OK) status = method_find(options->method, &chosen);
    if (status.code != WHIRL_OK) return status;
    whirl_integrator *integrator = calloc(1, sizeof *integrator);
    if (!integrator) return whirl_fail(WHIRL_NO_MEMORY, "no memory for an integrator");
    if (options->located && chosen->located) chosen = chosen->located;
    *integrator = (whirl_integrator){.system = system, .options = *options, .method = chosen};
    status = integrator_make_room(integrator, 0);
    if (status.code == WHIRL_OK) status = chosen->start(integrator);
    if (status.code != WHIRL_OK) {
        free(integrator->slopes);
        free(integrator);
        return status;
    }
    *out = integrator;
    return whirl_ok();
}

/// Brings angles back to their first turn.
static whirl_motion wrap(const whirl_system *system, double *x, whirl_motion motion) {
    for (size_t i = 0; i < system->dimension; i++) x[i] = part_wrapped(system->turns, system->angles, i, x[i]);
    return motion;
}

whirl_motion whirl_integrator_revolve(whirl_integrator *integrator, double *x, whirl_observe_fn observe,
                                      void *observer) {
    return wrap(integrator->system, x, integrator->method->revolve(integrator, x, NULL, observe, observer));
}

whirl_status whirl_integrator_follow(whirl_integrator *integrator, size_t most) {
    const method *own = integrator->method;
    const size_t n = integrator->system->dimension;
    if (!integrator->system->tangent)
        return whirl_fail(WHIRL_BAD_INPUT, "the system gives no Jacobian, expected one to follow perturbations");
    if (!own->about.follows && !(own->about.follows_one && most <= 1))
        return whirl_fail(WHIRL_BAD_INPUT, "method %s takes %s, expected rk4, dop853 or rodas5p", own->about.name,
                          own->about.follows_one ? "no more than one perturbation along" : "no perturbations along");
    if (most > n)
        return whirl_fail(WHIRL_BAD_INPUT, "%zu perturbations are to be followed, expected at most the dimension, %zu",
                          most, n);
    return integrator_make_room(integrator, most);
}

whirl_motion whirl_integrator_carry(whirl_integrator *integrator, double *x, whirl_perturbations *perturbations,
                                    whirl_observe_fn observe, void *observer) {
    if (perturbations->count > integrator->most_perturbations) return WHIRL_STUCK;
    perturbations->volume = 0.0;
    for (size_t i = 0; perturbations->growth && i < perturbations->count; i++) perturbations->growth[i] = 0.0;
    return wrap(integrator->system, x, integrator->method->revolve(integrator, x, perturbations, observe, observer));
}

void whirl_integrator_free(whirl_integrator *integrator) {
    if (!integrator) return;
    integrator->method->end(integrator);
    free(integrator->slopes);
    free(integrator);
}
