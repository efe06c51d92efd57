/// Checks of the statuses of the store.
#ifndef UNIT_STORE_EXPECT_H
#define UNIT_STORE_EXPECT_H

#include <string.h>

#include "whirl/status.h"

/// Fails with the message of a status that is not success.
static inline void check(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

/// Fails unless a status has that code and says these words.
static inline void assert_says(whirl_status status, whirl_code code, const char *words) {
    if (status.code != code || !strstr(status.message, words)) fail_msg("%d: '%s'", (int)status.code, status.message);
}

#endif
