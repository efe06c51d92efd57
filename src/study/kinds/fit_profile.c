#include "fit_profile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// A fit with one unknown held.
typedef struct profile {
    fit_motions motions; ///< own motions, so that those of the fit stay at the solution
    least_squares problem;
    size_t unknowns, held;                ///< number of unknowns; index of the one that is held
    double values[WHIRL_MAX_UNKNOWNS];    ///< values of all unknowns
    double *residuals, *derivatives;      ///< [numbers], [numbers][unknowns]
    double *others;                       ///< [numbers][unknowns - 1]
    double bounds[3][WHIRL_MAX_UNKNOWNS]; ///< low, high and scale of the others
} profile;

/// Writes the values or numbers of all unknowns but the held one to out.
static void profile_drop(const profile *p, const double *all, double *out) {
    for (size_t u = 0; u < p->unknowns; u++)
        if (u != p->held) *out++ = all[u];
}

static bool profile_evaluate(void *context, const double *others, double *residuals, double *derivatives) {
    profile *p = context;
    for (size_t u = 0; u < p->unknowns; u++)
        if (u != p->held) p->values[u] = *others++;
    if (!fit_motions_evaluate(&p->motions, p->values, residuals, p->derivatives)) return false;
    for (size_t i = 0; i < p->problem.count; i++)
        profile_drop(p, p->derivatives + i * p->unknowns, derivatives + i * (p->unknowns - 1));
    return true;
}

static void profile_accept(void *context) {
    profile *p = context;
    fit_motions_keep(&p->motions);
}

/// Computes the least sum of squares with the held unknown at x; NaN if a motion is lost.
static double profile_sum(profile *p, double x) {
    double others[WHIRL_MAX_UNKNOWNS];
    p->values[p->held] = x;
    profile_drop(p, p->values, others);
    if (p->problem.unknowns > 0) {
        const least_squares_result found = least_squares_solve(&p->problem, others, p->residuals, p->others);
        size_t k = 0;
        for (size_t u = 0; u < p->unknowns; u++)
            if (u != p->held) p->values[u] = others[k++];
        return found.end == LEAST_SQUARES_FOUND || found.end == LEAST_SQUARES_STUCK ? found.sum : (double)NAN;
    }
    if (!fit_motions_evaluate(&p->motions, p->values, p->residuals, p->derivatives)) return NAN;
    fit_motions_keep(&p->motions);
    double sum = 0.0;
    for (size_t i = 0; i < p->problem.count; i++) sum += p->residuals[i] * p->residuals[i];
    return sum;
}

/// Finds one end of an interval, on the side of the first distance `step`. The square root of the sum's rise is nearly
/// linear in the held unknown.
static double profile_end(profile *p, const whirl_fit_solution *s, double step, double low, double high, double rise) {
    enum { TRIES = 12 };
    const double from = s->value[p->held];
    double inside = from, inside_root = 0.0, outside = NAN, outside_root = NAN, x = from + step;
    for (int i = 0; i < TRIES; i++) {
        x = fmin(fmax(x, low), high);
        const double root = sqrt(fmax(profile_sum(p, x) - s->sum, 0.0) / rise);
        if (p->motions.status.code == WHIRL_STOPPED || p->motions.status.code == WHIRL_NO_MEMORY) return NAN;
        if (fabs(root - 1.0) < 1e-4) return x;
        if (root < 1.0 && (x == low || x == high)) return NAN;
        if (root < 1.0) {
            inside = x;
            inside_root = root;
        } else {
            outside = x;
            outside_root = root; // NaN where a motion is lost
        }
        // Next, try where the chord reaches the rise; half way to a lost motion; without any end, at most three times
        // as far.
        if (isfinite(outside_root))
            x = inside + (outside - inside) * (1.0 - inside_root) / (outside_root - inside_root);
        else if (isfinite(outside))
            x = 0.5 * (inside + outside);
        else
            x = from + (x - from) * fmin(1.0 / root, 3.0);
    }
    return NAN;
}

/// Fills in the problem of the unknowns that are not held, and the motions at the solution.
static whirl_status profile_begin(profile *p, const fit_motions *motions, const least_squares *problem,
                                  const whirl_fit_solution *s, size_t held) {
    p->held = held;
    memcpy(p->values, s->value, p->unknowns * sizeof *p->values);
    profile_drop(p, problem->low, p->bounds[0]);
    profile_drop(p, problem->high, p->bounds[1]);
    profile_drop(p, problem->scale, p->bounds[2]);
    fit_motions_free(&p->motions);
    return fit_motions_copy(motions, &p->motions);
}

whirl_status fit_profile(const fit_motions *motions, const least_squares *problem, double rise, whirl_fit_solution *s) {
    // Make the problem with one unknown less.
    const size_t unknowns = problem->unknowns, numbers = problem->count;
    profile p = {.unknowns = unknowns, .problem = *problem, .motions = {.fit = motions->fit}};
    p.residuals = calloc(numbers * 2 * unknowns + 1, sizeof *p.residuals);
    if (!p.residuals) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the profiles of a fit");
    p.derivatives = p.residuals + numbers;
    p.others = p.derivatives + numbers * unknowns;
    p.problem.unknowns = unknowns - 1;
    p.problem.context = &p;
    p.problem.evaluate = profile_evaluate;
    p.problem.accept = profile_accept;
    p.problem.low = p.bounds[0];
    p.problem.high = p.bounds[1];
    p.problem.scale = p.bounds[2];
    whirl_status status = whirl_ok();
    for (size_t u = 0; u < unknowns && status.code == WHIRL_OK; u++) {
        if (s->known[u] == WHIRL_FIT_UNKNOWN || s->known[u] == WHIRL_FIT_AT_BOUND) continue;
        for (size_t side = 0; side < 2 && status.code == WHIRL_OK; side++) {
            status = profile_begin(&p, motions, problem, s, u);
            if (status.code != WHIRL_OK) break;
            s->profile[u][side] =
                profile_end(&p, s, side ? s->half[u] : 0.0 - s->half[u], problem->low[u], problem->high[u], rise);
            if (p.motions.status.code == WHIRL_STOPPED || p.motions.status.code == WHIRL_NO_MEMORY)
                status = p.motions.status;
        }
    }
    fit_motions_free(&p.motions);
    free(p.residuals);
    return status;
}
