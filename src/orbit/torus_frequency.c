// The strongest line of a torus' second frequency in a coordinate. With phi = theta + 2 pi rho t/T, T the time of k
// revolutions, the motions that begin at all angles theta are one function of phi and t that repeats after a turn and
// after T: its harmonic exp(i phi) has lines at (rho + i)/T for whole numbers i.
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "turns.h"
#include "whirl/torus.h"

typedef double complex number;

enum { INSTANTS = 64 };

static const double two_pi = 6.283185307179586476925;

typedef struct lines {
    size_t coordinate, count; ///< instants over all revolutions
    number *harmonic;         ///< [count] of exp(i theta), from instant 1 on
    number factor;            ///< exp(-i theta)/nodes of the motion under way
    size_t at;                ///< its next instant
} lines;

static void add_instant(void *context, double t, const double *x) {
    lines *l = context;
    (void)t;
    l->harmonic[l->at++] += l->factor * x[l->coordinate];
}

static bool follow_nodes(lines *l, whirl_integrator *integrator, const whirl_torus *torus, double *x) {
    for (size_t j = 0; j < torus->node_count; j++) {
        memcpy(x, torus->nodes + j * torus->dimension, torus->dimension * sizeof *x);
        l->factor = cexp(-I * two_pi * (double)j / (double)torus->node_count) / (double)torus->node_count;
        l->at = 0;
        for (size_t k = 0; k < torus->revolutions; k++)
            if (whirl_integrator_revolve(integrator, x, add_instant, l) != WHIRL_BOUNDED) return false;
    }
    return true;
}

/// The size of the line at so many turns in all revolutions.
static double size_at(const lines *l, double turns) {
    number line = 0.0;
    for (size_t m = 0; m < l->count; m++)
        line += l->harmonic[m] * cexp(-I * two_pi * fmod(turns * (double)(m + 1) / (double)l->count, 1.0));
    return cabs(line) / (double)l->count;
}

static void find_strongest(const lines *l, const whirl_torus *torus, double *frequency, double *amplitude) {
    double largest = -1.0;
    for (size_t i = 0; i < l->count; i++) {
        const double turns = torus->rotation + (double)i - 0.5 * (double)l->count, size = size_at(l, turns);
        if (size > largest) *frequency = fabs(turns) / (double)torus->revolutions;
        largest = fmax(largest, size);
    }
    *amplitude = 2.0 * largest;
}

static whirl_status check(const whirl_system *system, size_t coordinate) {
    if (coordinate < system->dimension && !turns_on(system->turns, coordinate)) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "a line of coordinate %zu, expected one below %zu that does not turn on and on",
                      coordinate, system->dimension);
}

whirl_status whirl_torus_line(const whirl_system *system, const whirl_torus *torus, const whirl_torus_options *options,
                              size_t coordinate, double *frequency, double *amplitude) {
    whirl_integrate_options own = options->integrate;
    whirl_integrator *integrator = NULL;
    lines l = {.coordinate = coordinate, .count = INSTANTS * torus->revolutions};
    own.steps_per_revolution = INSTANTS;
    *frequency = *amplitude = NAN;
    whirl_status status = check(system, coordinate);
    if (status.code != WHIRL_OK) return status;
    l.harmonic = calloc(l.count + 1, sizeof *l.harmonic);
    double *x = calloc(torus->dimension + 1, sizeof *x);
    status = l.harmonic && x ? whirl_integrator_new(system, &own, &integrator)
                             : whirl_fail(WHIRL_NO_MEMORY, "no memory for the lines of a torus");
    if (status.code == WHIRL_OK && !follow_nodes(&l, integrator, torus, x))
        status = whirl_fail(WHIRL_BAD_INPUT, "the motion along a torus leaves its bounds");
    if (status.code == WHIRL_OK) find_strongest(&l, torus, frequency, amplitude);
    whirl_integrator_free(integrator);
    free(l.harmonic);
    free(x);
    return status;
}
