#include "support_lanes.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "whirl/engine/ensemble.h"

static void carry_alone(const whirl_system *system, const whirl_integrate_options *options, int revolutions,
                        double *x) {
    whirl_integrator *integrator;
    require_ok(whirl_integrator_new(system, options, &integrator));
    revolve(integrator, x, revolutions);
    whirl_integrator_free(integrator);
}

/// Carries the rotors from rest in lanes and writes their states [count][dimension]. Returns false if the processor
/// lacks the instruction set.
static bool carry_in_lanes(const char *set, const whirl_integrate_options *options, whirl_rotor *const *rotors,
                           size_t count, int revolutions, double *states) {
    const size_t n = whirl_rotor_system(rotors[0])->dimension;
    whirl_ensemble *ensemble;
    setenv("WHIRL_ISA", set, 1);
    const whirl_status status = whirl_ensemble_new(whirl_rotor_system(rotors[0]), options, count, &ensemble);
    unsetenv("WHIRL_ISA");
    if (status.code != WHIRL_OK) return false;
    memset(states, 0, count * n * sizeof *states);
    for (size_t l = 0; l < count; l++)
        require_ok(whirl_ensemble_load(ensemble, l, whirl_rotor_system(rotors[l]), states + l * n));
    for (int i = 0; i < revolutions; i++) whirl_ensemble_revolve(ensemble, count, NULL);
    for (size_t l = 0; l < count; l++) whirl_ensemble_state(ensemble, l, states + l * n);
    whirl_ensemble_free(ensemble);
    return true;
}

void carry_both(const char *method, int steps, whirl_rotor *const *rotors, size_t count, const double *start,
                int revolutions, double *in_lanes, double *alone) {
    const size_t n = whirl_rotor_system(rotors[0])->dimension;
    whirl_integrate_options options = whirl_integrate_default();
    whirl_ensemble *lanes;
    snprintf(options.method, sizeof options.method, "%s", method);
    options.steps_per_revolution = steps;
    options.rtol = 1e-15; // those of make_integrator
    options.atol = 1e-16;
    require_ok(whirl_ensemble_new(whirl_rotor_system(rotors[0]), &options, count, &lanes));
    for (size_t l = 0; l < count; l++) require_ok(whirl_ensemble_load(lanes, l, whirl_rotor_system(rotors[l]), start));
    for (int i = 0; i < revolutions; i++) whirl_ensemble_revolve(lanes, count, NULL);
    for (size_t l = 0; l < count; l++) {
        whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotors[l]), method, steps);
        memcpy(alone + l * n, start, n * sizeof *alone);
        revolve(integrator, alone + l * n, revolutions);
        whirl_ensemble_state(lanes, l, in_lanes + l * n);
        whirl_integrator_free(integrator);
    }
    whirl_ensemble_free(lanes);
}

double compare_lanes_with_alone(const char *method, const char *const *sets, whirl_rotor *const *rotors, size_t count,
                                int revolutions) {
    const size_t n = whirl_rotor_system(rotors[0])->dimension, size = count * n;
    whirl_integrate_options options = whirl_integrate_default();
    double *alone = calloc(3 * size, sizeof *alone), worst = 0.0;
    bool found = false;
    assert_non_null(alone);
    double *first = alone + size, *lanes = first + size;
    snprintf(options.method, sizeof options.method, "%s", method);
    for (size_t l = 0; l < count; l++) carry_alone(whirl_rotor_system(rotors[l]), &options, revolutions, alone + l * n);
    for (; *sets; sets++) {
        if (!carry_in_lanes(*sets, &options, rotors, count, revolutions, lanes)) continue;
        if (!found) memcpy(first, lanes, size * sizeof *lanes);
        assert_memory_equal(lanes, first, size * sizeof *lanes);
        for (size_t i = 0; i < size; i++) worst = fmax(worst, fabs(lanes[i] - alone[i]));
        found = true;
    }
    free(alone);
    return worst;
}
