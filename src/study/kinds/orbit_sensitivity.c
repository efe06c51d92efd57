// Derivatives of periodic orbits by parameters: perturbations of the state and of the parameters are carried over every
// revolution, and the ends are joined.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "extended.h"
#include "matrix.h"
#include "turns.h"
#include "whirl/engine/sensitivity.h"

/// Workspace of one orbit.
typedef struct orbit_work {
    whirl_orbit_sensitivity *out;
    whirl_integrator *integrator;
    whirl_perturbations set;
    size_t own, all;   ///< coordinates of the machine, and with the parameters
    double *x;         ///< [all] present state
    double *vectors;   ///< [all][all] present perturbations: those of the state, then those of the parameters
    double *carried;   ///< [revolutions][instants + 1][all][own] perturbations of x at the instants, and at the end
    size_t revolution; ///< present revolution
    size_t instant;    ///< next instant of the present revolution
    size_t steps;      ///< calls of the integrator between two instants
    size_t calls;      ///< calls of the integrator in this revolution
} orbit_work;

/// Returns the perturbations at an instant of a revolution; `instants` is its end.
static double *carried_at(const orbit_work *w, size_t revolution, size_t instant) {
    return w->carried + (revolution * (w->out->instants + 1) + instant) * w->all * w->own;
}

static void orbit_work_note(orbit_work *w, const double *x) {
    double *vectors = carried_at(w, w->revolution, w->instant);
    for (size_t k = 0; k < w->all; k++) memcpy(vectors + k * w->own, w->vectors + k * w->all, w->own * sizeof *x);
    if (w->instant < w->out->instants)
        memcpy(w->out->states + (w->revolution * w->out->instants + w->instant) * w->own, x, w->own * sizeof *x);
    w->instant++;
}

static void orbit_work_observe(void *observer, double t, const double *x) {
    orbit_work *w = observer;
    (void)t;
    if (++w->calls % w->steps == 0) orbit_work_note(w, x);
}

/// Carries one revolution from a node, with all perturbations.
static whirl_status orbit_work_revolve(orbit_work *w, const double *node) {
    memset(w->x, 0, w->all * sizeof *w->x);
    memcpy(w->x, node, w->own * sizeof *w->x);
    memset(w->vectors, 0, w->all * w->all * sizeof *w->vectors);
    for (size_t k = 0; k < w->all; k++) w->vectors[k * w->all + k] = 1.0;
    w->instant = 0;
    w->calls = 0;
    orbit_work_note(w, w->x);
    if (whirl_integrator_carry(w->integrator, w->x, &w->set, orbit_work_observe, w) == WHIRL_BOUNDED) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "the orbit cannot be followed for its derivatives");
}

/// Refuses parameters that change where a turning coordinate is after a revolution.
static whirl_status check_turning(const orbit_work *w, const double *turns) {
    for (size_t j = 0; j < w->out->revolutions && turns; j++)
        for (size_t p = 0; p < w->out->count; p++)
            for (size_t i = 0; i < w->own; i++)
                if (turns[i] > 0.0 &&
                    fabs(carried_at(w, j, w->out->instants)[(w->own + p) * w->own + i]) > 1e-9 * turns[i])
                    return whirl_fail(WHIRL_BAD_INPUT,
                                      "parameter %zu changes the rate at which a part turns, so that no orbit of as "
                                      "many revolutions is near this one",
                                      p + 1);
    return whirl_ok();
}

/// Solves s_{j+1} = M_j s_j + S_j around the orbit for the derivatives at the beginnings of revolutions, of coordinates
/// that do not turn: begins [revolutions][count][own].
static whirl_status orbit_close(const orbit_work *w, const double *turns, double *begins) {
    const size_t m = w->out->revolutions, own = w->own, count = w->out->count, n = m * own;
    double *matrix = calloc(n * n + n * count + 1, sizeof *matrix), *right = matrix ? matrix + n * n : NULL;
    if (!matrix) return whirl_fail(WHIRL_NO_MEMORY, "no memory for derivatives of %zu revolutions", m);
    for (size_t j = 0; j < m; j++) {
        const double *ends = carried_at(w, j, w->out->instants);
        for (size_t i = 0; i < own; i++) {
            const size_t row = ((j + 1) % m) * own + i;
            matrix[row * n + row] += 1.0;
            if (turns_on(turns, i)) continue;
            for (size_t k = 0; k < own; k++)
                if (!turns_on(turns, k)) matrix[row * n + j * own + k] -= ends[k * own + i];
            for (size_t p = 0; p < count; p++) right[p * n + row] = ends[(own + p) * own + i];
        }
    }
    const bool solved = matrix_solve(n, matrix, count, right);
    for (size_t row = 0; row < n && solved; row++)
        for (size_t p = 0; p < count; p++) begins[(row / own * count + p) * own + row % own] = right[p * n + row];
    free(matrix);
    return solved ? whirl_ok()
                  : whirl_fail(WHIRL_BAD_INPUT, "the orbit has a multiplier 1, so that it has no derivatives here");
}

/// Computes the derivatives at every instant from those at the beginnings of revolutions: slopes = M(t) s(0) + s(t).
static void orbit_spread(const orbit_work *w, const double *begins, const double *units) {
    const whirl_orbit_sensitivity *out = w->out;
    for (size_t j = 0; j < out->revolutions; j++)
        for (size_t k = 0; k < out->instants; k++) {
            const double *vectors = carried_at(w, j, k);
            for (size_t p = 0; p < out->count; p++) {
                const double *begin = begins + (j * out->count + p) * w->own;
                double *slope = out->slopes + ((j * out->instants + k) * out->count + p) * w->own;
                for (size_t i = 0; i < w->own; i++) {
                    double sum = vectors[(w->own + p) * w->own + i];
                    for (size_t q = 0; q < w->own; q++) sum += vectors[q * w->own + i] * begin[q];
                    slope[i] = sum / units[p];
                }
            }
        }
}

static whirl_status orbit_derive(orbit_work *w, const whirl_system *system, const whirl_orbit *orbit,
                                 const double *units) {
    const size_t apart = orbit->segment_count / orbit->revolutions;
    double *begins = calloc(w->out->revolutions * w->out->count * w->own + 1, sizeof *begins);
    whirl_status status = begins ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for derivatives of an orbit");
    for (w->revolution = 0; w->revolution < orbit->revolutions && status.code == WHIRL_OK; w->revolution++)
        status = orbit_work_revolve(w, orbit->nodes + w->revolution * apart * w->own);
    if (status.code == WHIRL_OK) status = check_turning(w, system->turns);
    if (status.code == WHIRL_OK) status = orbit_close(w, system->turns, begins);
    if (status.code == WHIRL_OK) orbit_spread(w, begins, units);
    free(begins);
    return status;
}

static whirl_orbit_sensitivity *orbit_sensitivity_make(size_t dimension, size_t count, size_t revolutions,
                                                       size_t instants) {
    const size_t states = revolutions * instants * dimension;
    whirl_orbit_sensitivity *out = calloc(1, sizeof *out + states * (1 + count) * sizeof(double));
    if (!out) return NULL;
    *out = (whirl_orbit_sensitivity){dimension, count, revolutions, instants, (double *)(out + 1), NULL};
    out->slopes = out->states + states;
    return out;
}

whirl_status whirl_orbit_sensitivity_new(const whirl_extended *extended, const whirl_orbit *orbit,
                                         const whirl_orbit_options *options, size_t instants,
                                         whirl_orbit_sensitivity **out) {
    const whirl_system *system = whirl_extended_system(extended);
    const size_t all = system->dimension, own = orbit->dimension, count = all - own;
    *out = NULL;
    if (orbit->revolutions == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "derivatives of an orbit that closes after no whole number of revolutions, "
                                           "expected a forced orbit");
    // Let steps end at the instants.
    whirl_integrate_options integrate = options->integrate;
    const bool fixed = !whirl_method_is_adaptive(integrate.method);
    if (instants < 1 || instants > WHIRL_MAX_STEPS || (fixed && integrate.steps_per_revolution % (int)instants != 0))
        return whirl_fail(WHIRL_BAD_INPUT, "%zu instants of a revolution, expected %s", instants,
                          fixed ? "a divisor of its steps" : "a whole number above 0");
    if (!fixed) integrate.steps_per_revolution = (int)instants;
    // Make the workspace.
    orbit_work w = {.own = own,
                    .all = all,
                    .out = orbit_sensitivity_make(own, count, orbit->revolutions, instants),
                    .steps = (size_t)integrate.steps_per_revolution / instants};
    double units[WHIRL_MAX_SENSITIVITIES];
    for (size_t p = 0; p < count; p++) units[p] = whirl_extended_unit(extended, p);
    w.x = calloc(all + all * all + orbit->revolutions * (instants + 1) * all * own, sizeof *w.x);
    whirl_status status = w.x && w.out ? whirl_integrator_new(system, &integrate, &w.integrator)
                                       : whirl_fail(WHIRL_NO_MEMORY, "no memory for derivatives of an orbit");
    if (status.code == WHIRL_OK) status = whirl_integrator_follow(w.integrator, all);
    // Carry all perturbations around the orbit, and close it.
    if (status.code == WHIRL_OK) {
        w.vectors = w.x + all;
        w.carried = w.vectors + all * all;
        w.set = (whirl_perturbations){.count = all, .vectors = w.vectors, .at_instants = true};
        status = orbit_derive(&w, system, orbit, units);
        if (extended_exhausted(extended)) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for derivatives of an orbit");
    }
    whirl_integrator_free(w.integrator);
    free(w.x);
    if (status.code == WHIRL_OK)
        *out = w.out;
    else
        whirl_orbit_sensitivity_free(w.out);
    return status;
}

void whirl_orbit_sensitivity_free(whirl_orbit_sensitivity *sensitivity) {
    free(sensitivity);
}
