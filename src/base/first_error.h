/// Keeps the first error of work that continues after it: the message of a whirl_status is overwritten after
/// WHIRL_MESSAGES_KEPT other messages.
#ifndef BASE_FIRST_ERROR_H
#define BASE_FIRST_ERROR_H

#include "whirl/status.h"

/// The first error; all zero if there was none.
typedef struct first_error {
    whirl_code code;
    char message[WHIRL_MESSAGE_SIZE];
} first_error;

/// Notes a status, unless it is success or there was an error before.
void first_error_note(first_error *error, const whirl_status *status);

/// Returns the error as a status; success without one.
whirl_status first_error_status(const first_error *error);

#endif
