#include "stiffest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"
#include "matrix_balance.h"
#include "whirl/engine/integrate.h"

/// Largest growth of a perturbation in a step that counts as stable: 1, and a margin for truncation errors of growing
/// modes.
static const double unstable_growth = 1.001;

bool whirl_step_is_unstable(const whirl_step_check *check) {
    return check->growth > unstable_growth;
}

bool phase_search_begin(phase_search *s, const whirl_system *system, double **block) {
    const size_t n = system->dimension;
    *block = malloc((3 * n * n + 4 * n) * sizeof **block);
    if (!*block) return false;
    double *vectors = *block + 3 * n * n;
    *s = (phase_search){.system = system,
                        .stiffest = *block,
                        .jacobian = *block + n * n,
                        .unit = *block + 2 * n * n,
                        .real = vectors,
                        .imaginary = vectors + n,
                        .state = vectors + 2 * n,
                        .x = vectors + 3 * n};
    return true;
}

// ---------------------------------------------------------------- Jacobians

/// Computes column k of the Jacobian into row k of `rows`, by the system's own derivative.
static void exact_columns(const phase_search *s, double t, const double *forcing, const double *x, double *rows) {
    const size_t n = s->system->dimension;
    memset(s->unit, 0, n * n * sizeof *s->unit);
    for (size_t i = 0; i < n; i++) s->unit[i * n + i] = 1.0;
    s->system->tangent(s->system->model, t, forcing, x, NULL, n, s->unit, rows);
}

/// Computes the columns of the Jacobian by differences, for systems without a derivative.
static void difference_columns(const phase_search *s, double t, const double *forcing, const double *x, double *rows) {
    const whirl_system *system = s->system;
    const size_t n = system->dimension;
    double *slope = s->unit;
    system->rhs(system->model, t, forcing, x, slope);
    memcpy(s->state, x, n * sizeof *x);
    for (size_t k = 0; k < n; k++) {
        s->state[k] = x[k] + 1e-7 * fmax(1e-3, fabs(x[k]));
        const double way = s->state[k] - x[k];
        system->rhs(system->model, t, forcing, s->state, rows + k * n);
        for (size_t i = 0; i < n; i++) rows[k * n + i] = (rows[k * n + i] - slope[i]) / way;
        s->state[k] = x[k];
    }
}

void phase_search_note(void *search, double t, const double *x) {
    phase_search *s = search;
    const whirl_system *system = s->system;
    double forcing[WHIRL_MAX_FORCING];
    if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
    if (system->tangent)
        exact_columns(s, t, forcing, x, s->jacobian);
    else
        difference_columns(s, t, forcing, x, s->jacobian);
    // The transpose is as good as the Jacobian: its eigenvalues are the same.
    matrix_balance(system->dimension, s->jacobian, NULL);
    const double norm = matrix_norm(system->dimension, s->jacobian);
    if (!(norm > s->norm) || !isfinite(norm)) return;
    double *spare = s->stiffest;
    s->stiffest = s->jacobian;
    s->jacobian = spare;
    s->norm = norm;
}

// ---------------------------------------------------------------- what a step does there

bool phase_search_solve(phase_search *s) {
    const size_t n = s->system->dimension;
    if (s->solved == s->norm && s->norm > 0.0) return true;
    memcpy(s->jacobian, s->stiffest, n * n * sizeof *s->jacobian);
    if (!matrix_eigen(n, s->jacobian, s->real, s->imaginary, NULL)) return false;
    s->solved = s->norm;
    return true;
}

double phase_search_growth(const phase_search *s, double (*amplification)(double, double), double h) {
    double largest = 1.0;
    for (size_t i = 0; i < s->system->dimension; i++) {
        const double real = h * s->real[i];
        const double growth = amplification(real, h * s->imaginary[i]) / fmax(1.0, exp(real));
        if (growth > largest) largest = growth;
    }
    return largest;
}

double phase_search_steps(const phase_search *s, double (*amplification)(double, double), double steps) {
    const double finer = 1.05, most = 1e9;
    while (steps < most) {
        if (!(phase_search_growth(s, amplification, s->system->period / steps) > unstable_growth)) break;
        steps = ceil(finer * steps);
    }
    return steps;
}
