#include "periodic.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"
#include "mean.h"
#include "whirl/engine/integrate.h"

static whirl_integrate_options tight(void) {
    whirl_integrate_options options = whirl_integrate_default();
    strcpy(options.method, "dop853");
    options.rtol = 1e-13;
    options.atol = 1e-15;
    return options;
}

static whirl_status periodic_start(const mean_system *m, whirl_integrator **integrator) {
    const whirl_integrate_options options = tight();
    whirl_status status = whirl_integrator_new(m->system, &options, integrator);
    if (status.code == WHIRL_OK) status = whirl_integrator_follow(*integrator, m->count);
    return status;
}

/// Integrates x and unit perturbations over the period. The final perturbations are the columns of the monodromy
/// matrix.
static bool carry(const mean_system *m, whirl_integrator *integrator, size_t revolutions, double *x, double *vectors,
                  double *monodromy) {
    const size_t d = m->system->dimension, n = m->count;
    whirl_perturbations all = {.count = n, .vectors = vectors};
    memcpy(vectors, m->unit, n * d * sizeof *vectors);
    for (size_t k = 0; k < revolutions; k++)
        if (whirl_integrator_carry(integrator, x, &all, NULL, NULL) != WHIRL_BOUNDED) return false;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) monodromy[i * n + k] = vectors[k * d + m->kept[i]];
    return true;
}

/// Takes a Newton step for P(x) = x, where the derivative of P is the monodromy matrix. *size becomes the step's size,
/// which is limited to `most`.
static bool step(const mean_system *m, const double *end, const double *monodromy, double most, double *x, double *work,
                 double *size) {
    const size_t n = m->count;
    double *matrix = work, *way = work + n * n;
    *size = 0.0;
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < n; k++) matrix[i * n + k] = (i == k ? 1.0 : 0.0) - monodromy[i * n + k];
        way[i] = end[m->kept[i]] - x[m->kept[i]];
    }
    if (!matrix_solve(n, matrix, 1, way)) return false;
    double longest = 0.0;
    for (size_t i = 0; i < n; i++) longest = fmax(longest, fabs(way[i]));
    for (size_t i = 0; i < n; i++) {
        if (longest > most) way[i] *= most / longest;
        x[m->kept[i]] += way[i];
        *size = fmax(*size, fabs(way[i]) / (1.0 + fabs(x[m->kept[i]])));
    }
    return isfinite(*size);
}

/// Returns the largest change of the matrix since the last call, and stores the matrix for the next call.
static double note_change(const double *matrix, double *noted, size_t count) {
    double change = 0.0, largest = 1.0;
    for (size_t i = 0; i < count; i++) {
        change = fmax(change, fabs(matrix[i] - noted[i]));
        largest = fmax(largest, fabs(matrix[i]));
    }
    memcpy(noted, matrix, count * sizeof *noted);
    return change / largest;
}

/// Runs Newton's method on the Poincare section.
static bool close_orbit(const mean_system *m, whirl_integrator *integrator, size_t revolutions, double *x, bool closed,
                        double *monodromy, double *work) {
    enum { MAX_STEPS = 20 };
    const size_t d = m->system->dimension, n = m->count;
    double *end = work, *vectors = work + d, *rest = work + d + n * d, *noted = rest + n * n + n;
    for (int k = 0; k < MAX_STEPS; k++) {
        double size;
        memcpy(end, x, d * sizeof *end);
        if (!carry(m, integrator, revolutions, end, vectors, monodromy)) return false;
        const double change = note_change(monodromy, noted, n * n);
        if (!closed && k > 0 && change <= 1e-10) return true;
        if (!step(m, end, monodromy, closed ? 1e5 : 1.0, x, rest, &size)) return false;
        if (size <= 1e-9) {
            memcpy(end, x, d * sizeof *end);
            return carry(m, integrator, revolutions, end, vectors, monodromy);
        }
    }
    return false;
}

whirl_status periodic_find(const mean_system *m, double *x, bool closed, double *monodromy, double *period) {
    const whirl_system *system = m->system;
    const size_t d = system->dimension, n = m->count, revolutions = system->turns ? system->repeats : 1;
    whirl_integrator *integrator = NULL;
    if (revolutions == 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "coefficients turn with the shaft, and a phase does not repeat after a number "
                          "of revolutions, expected only one of the two for modes");
    double *work = calloc(d + n * d + 2 * n * n + n + 1, sizeof *work);
    if (!work) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a periodic motion of %zu coordinates", d);
    whirl_status status = periodic_start(m, &integrator);
    *period = system->period * (double)revolutions;
    if (status.code == WHIRL_OK && !close_orbit(m, integrator, revolutions, x, closed, monodromy, work))
        status = whirl_fail(WHIRL_NUMERICAL_FAILURE,
                            "no periodic motion was found, which replaces the equilibrium because coefficients "
                            "turn with the shaft");
    whirl_integrator_free(integrator);
    free(work);
    return status;
}

/// Sums over the instants of the motion.
typedef struct harmonic_sum {
    size_t dimension;
    double share, *mean, *harmonic;
    double rate;
} harmonic_sum;

static void periodic_add(void *observer, double t, const double *x) {
    harmonic_sum *sum = observer;
    const double c = 2.0 * sum->share * cos(sum->rate * t), s = 2.0 * sum->share * sin(sum->rate * t);
    for (size_t i = 0; i < sum->dimension; i++) {
        sum->mean[i] += sum->share * x[i];
        sum->harmonic[2 * i] += c * x[i];
        sum->harmonic[2 * i + 1] -= s * x[i];
    }
}

whirl_status periodic_harmonic(const mean_system *m, const double *x, double *mean, double *harmonic) {
    enum { INSTANTS = 256 };
    const size_t d = m->system->dimension, revolutions = m->system->turns ? m->system->repeats : 1;
    whirl_integrate_options options = tight();
    whirl_integrator *integrator;
    options.steps_per_revolution = INSTANTS;
    harmonic_sum sum = {.dimension = d,
                        .share = 1.0 / (INSTANTS * (double)revolutions),
                        .mean = mean,
                        .harmonic = harmonic,
                        .rate = 6.283185307179586476925 / m->system->period};
    double *at = malloc((d + 1) * sizeof *at);
    // Sum the motion and its harmonic over all revolutions.
    if (!at) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a periodic motion of %zu coordinates", d);
    whirl_status status = whirl_integrator_new(m->system, &options, &integrator);
    memcpy(at, x, d * sizeof *at);
    memset(mean, 0, d * sizeof *mean);
    memset(harmonic, 0, 2 * d * sizeof *harmonic);
    for (size_t k = 0; k < revolutions && status.code == WHIRL_OK; k++)
        if (whirl_integrator_revolve(integrator, at, periodic_add, &sum) != WHIRL_BOUNDED)
            status = whirl_fail(WHIRL_BAD_INPUT, "the periodic motion leaves its bounds");
    whirl_integrator_free(integrator);
    free(at);
    return status;
}
