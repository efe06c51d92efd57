// Calls a user's functions once before a run, to check that they have the signatures with which whirl calls them. From
// Python they come as addresses, whose signatures nothing else checks. A function with another signature writes its
// slopes into the parameters, or leaves slopes unwritten.
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "user.h"

/// A NaN that no arithmetic produces, to mark numbers that a function has not written.
static const uint64_t unwritten = 0x7ff8dead0badbeefu;

/// Arguments of a call, with copies of those that a function must not change.
typedef struct form_arguments {
    size_t capacity; ///< size of each array below: all have the largest size, so that a wrong function that confuses
                     ///< them stays within
    double *state, *parameters, *perturbation, *slopes, *kept;
} form_arguments;

static bool form_changed(const form_arguments *a, const double *argument, size_t which) {
    return memcmp(argument, a->kept + which * a->capacity, a->capacity * sizeof *argument) != 0;
}

/// Fails if a function has changed an input or left slopes unwritten. name, form: of the function, for the message.
static whirl_status form_judge(const whirl_user_system *system, const form_arguments *a, const char *name,
                               const char *form) {
    const double *const arguments[] = {a->state, a->parameters, a->perturbation};
    static const char *const names[] = {"state", "parameters", "perturbation"};
    for (size_t i = 0; i < 3; i++)
        if (form_changed(a, arguments[i], i))
            return whirl_fail(WHIRL_BAD_INPUT, "the %s change the %s that they are given, expected %s", name, names[i],
                              form);
    // Slopes of displacements are not used: they are the velocities. The marks of unwritten numbers are NaN, so that
    // bits are compared.
    for (size_t k = system->displacements; k < system->dimension; k++)
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison,cert-exp42-c,cert-flp37-c)
        if (memcmp(&a->slopes[k], &unwritten, sizeof unwritten) == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "the %s leave number %zu of %zu unwritten, expected %s", name, k,
                              system->dimension, form);
    return whirl_ok();
}

static void form_fill(const whirl_user_system *system, form_arguments *a) {
    for (size_t i = 0; i < 4 * a->capacity; i++) a->state[i] = 0.0;
    for (size_t k = 0; k < system->dimension; k++) {
        a->state[k] = a->perturbation[k] = system->start[k];
        memcpy(&a->slopes[k], &unwritten, sizeof unwritten);
    }
    for (size_t k = 0; k < system->parameter_count; k++) a->parameters[k] = system->parameters[k].value;
    memcpy(a->kept, a->state, 3 * a->capacity * sizeof *a->kept);
}

whirl_status user_check_form(const whirl_user_system *system) {
    const size_t most = system->dimension > system->parameter_count ? system->dimension : system->parameter_count;
    form_arguments a = {.capacity = most + 1};
    a.state = calloc(7 * a.capacity, sizeof *a.state);
    if (!a.state) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the arguments of a system");
    a.parameters = a.state + a.capacity;
    a.perturbation = a.parameters + a.capacity;
    a.slopes = a.perturbation + a.capacity;
    a.kept = a.slopes + a.capacity;
    // Call the slopes. A failure at the start says nothing about the signature: the run will report it.
    const double t = 0.0;
    whirl_status status = whirl_ok();
    form_fill(system, &a);
    if (system->lanes ? system->lanes(1, 1, &t, a.state, a.parameters, a.slopes, system->context) == 0
                      : system->rates(t, a.state, a.parameters, a.slopes, system->context) == 0)
        status = form_judge(system, &a, "slopes",
                            system->lanes ? "the arguments count, row, t, x, p, dxdt, context, and a number for every "
                                            "slope"
                                          : "the arguments t, x, p, dxdt, context, and a number for every slope");
    // Call the tangent.
    if (status.code == WHIRL_OK && system->tangent) {
        form_fill(system, &a);
        if (system->tangent(t, a.state, a.parameters, a.perturbation, a.slopes, system->tangent_context) == 0)
            status = form_judge(system, &a, "numbers of the tangent",
                                "the arguments t, x, p, dx, ddxdt, context, and a number for every slope");
    }
    free(a.state);
    return status;
}
