// Checks that fixed steps are short enough, by the method's stability region and by the equations themselves.
//
// A step h multiplies the mode of eigenvalue lambda by R(h lambda), the machine multiplies it by exp(h lambda). If |R|
// > 1 in a mode that dies out, the computed motion is not a motion of the machine, however smooth it may look (see
// docs/theory.md, "Steps that are too long"). Eigenvalues are computed at the phase where the balanced Jacobian is
// largest, and only if its norm does not already show that all of them lie well within the region.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "method.h"
#include "stiffest.h"
#include "turns.h"

enum { PHASES = 16 };

/// h |lambda| up to which every mode is safe. The region of an explicit method of order 4 contains this half disc, and
/// in a mode that grows R differs from exp by a few percent.
static const double safe_product = 1.0;

// ---------------------------------------------------------------- the region

/// Computes growth and steps of the check at the stiffest phase found.
static void judge_phase(phase_search *s, const method *own, int steps, whirl_step_check *check) {
    const double h = s->system->period / steps;
    check->growth = 1.0;
    check->steps = steps;
    if (h * s->norm <= safe_product || !phase_search_solve(s)) return;
    check->growth = phase_search_growth(s, own->amplification, h);
    check->steps = phase_search_steps(s, own->amplification, steps);
}

// ---------------------------------------------------------------- the revolution

/// Integrates x over one revolution by dop853, which replaces x by its end, and inspects PHASES phases on the way.
/// *motion: how it ended.
static whirl_status step_check_follow(phase_search *s, const whirl_integrate_options *options, double tolerance,
                                      double *x, whirl_motion *motion) {
    whirl_integrate_options exact = *options;
    whirl_integrator *integrator;
    memcpy(exact.method, "dop853", sizeof "dop853");
    exact.steps_per_revolution = PHASES;
    exact.rtol = 1e-13;
    exact.atol = tolerance;
    const whirl_status status = whirl_integrator_new(s->system, &exact, &integrator);
    if (status.code != WHIRL_OK) return status;
    *motion = whirl_integrator_revolve(integrator, x, phase_search_note, s);
    whirl_integrator_free(integrator);
    return status;
}

static void compare_ends(const whirl_system *system, const double *x, const double *end, whirl_motion motion,
                         whirl_step_check *check) {
    double square = 0.0, reach = 0.0;
    if (motion == WHIRL_STUCK) return;
    for (size_t i = 0; i < system->dimension; i++) {
        if (turns_on(system->turns, i)) continue;
        reach = fmax(reach, fabs(x[i]));
        const double away = end ? short_way(system->angles, i, x[i] - end[i]) : 0.0;
        square += away * away;
    }
    check->reach = motion == WHIRL_DIVERGED ? INFINITY : reach;
    if (end) check->error = motion == WHIRL_DIVERGED ? INFINITY : sqrt(square);
}

whirl_status whirl_step_check_revolution(const whirl_system *system, const whirl_integrate_options *options,
                                         const double *start, const double *end, double tolerance,
                                         whirl_step_check *check) {
    const method *own;
    *check = (whirl_step_check){1.0, options->steps_per_revolution, (double)NAN, (double)NAN};
    whirl_status status = method_find(options->method, &own);
    if (status.code != WHIRL_OK || !own->amplification) return status;
    phase_search search;
    double *block;
    if (!phase_search_begin(&search, system, &block)) return whirl_fail(WHIRL_NO_MEMORY, "no memory to look at steps");
    double *x = search.x;
    memcpy(x, start, system->dimension * sizeof *x);
    phase_search_note(&search, 0.0, x);
    judge_phase(&search, own, options->steps_per_revolution, check);
    if (!whirl_step_is_unstable(check)) {
        whirl_motion motion = WHIRL_STUCK;
        status = step_check_follow(&search, options, tolerance, x, &motion);
        judge_phase(&search, own, options->steps_per_revolution, check);
        compare_ends(system, x, end, motion, check);
    }
    free(block);
    return status;
}
