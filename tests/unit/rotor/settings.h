// Shared by tests of designs: settings, checks of statuses, random numbers.
#ifndef UNIT_ROTOR_SETTINGS_H
#define UNIT_ROTOR_SETTINGS_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "whirl/engine/rotor.h"

static inline whirl_setting value(const char *key, double number) {
    return (whirl_setting){key, number, NULL};
}

static inline whirl_setting word(const char *key, const char *text) {
    return (whirl_setting){key, 0.0, text};
}

static inline void check(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

/// Returns numbers between `low` and `high` that follow from *seed.
static inline double uniform(uint64_t *seed, double low, double high) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

#endif
