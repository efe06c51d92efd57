/// What tests of users' systems share. After cmocka.h.
#ifndef TESTS_USER_NEAR_H
#define TESTS_USER_NEAR_H

#include <string.h>

#include "whirl/status.h"

static inline void good(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

static inline void refused(whirl_status status, const char *words) {
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    if (!strstr(status.message, words)) fail_msg("'%s' does not say '%s'", status.message, words);
}

/// Of the linear oscillators: x'' + 2 zeta x' + x = F cos(omega t).
static const double zeta = 0.04;

/// Their derivative.
static inline int derivative(double t, const double *x, const double *p, const double *dx, double *ddxdt,
                             void *context) {
    (void)t, (void)x, (void)p, (void)context;
    ddxdt[0] = dx[1];
    ddxdt[1] = -2.0 * zeta * dx[1] - dx[0];
    return 0;
}

#endif
