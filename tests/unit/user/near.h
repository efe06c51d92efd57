/// Shared by tests of users' systems. Include it after cmocka.h.
#ifndef TESTS_USER_NEAR_H
#define TESTS_USER_NEAR_H

#include <math.h>
#include <string.h>

#include "whirl/engine.h"

static inline void good(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

static inline void refused(whirl_status status, const char *words) {
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    if (!strstr(status.message, words)) fail_msg("'%s' does not say '%s'", status.message, words);
}

static inline void near(double found, double expected, double most) {
    if (!(fabs(found - expected) <= most))
        fail_msg("%.17g, expected %.17g: %.3g off, allowed %.3g", found, expected, found - expected, most);
}

static inline whirl_status attempt(const whirl_user_system *system, int threads, whirl_result **result) {
    whirl_job *job;
    good(whirl_job_of_user_system(system, &job));
    good(whirl_job_threads(job, threads));
    const whirl_status status = whirl_job_run(job, result);
    whirl_job_free(job);
    return status;
}

static inline whirl_result *run(const whirl_user_system *system, int threads) {
    whirl_result *result;
    good(attempt(system, threads, &result));
    return result;
}

/// Of the linear oscillators: x'' + 2 zeta x' + x = F cos(omega t).
static const double zeta = 0.04;

/// Computes the derivative of the equations above.
static inline int derivative(double t, const double *x, const double *p, const double *dx, double *ddxdt,
                             void *context) {
    (void)t, (void)x, (void)p, (void)context;
    ddxdt[0] = dx[1];
    ddxdt[1] = -2.0 * zeta * dx[1] - dx[0];
    return 0;
}

#endif
