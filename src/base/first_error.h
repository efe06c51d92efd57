/// The first error of work that continues for long after it: the message of a status lasts only for so many others.
#ifndef BASE_FIRST_ERROR_H
#define BASE_FIRST_ERROR_H

#include "whirl/status.h"

/// All zero before an error.
typedef struct first_error {
    whirl_code code;
    char message[WHIRL_MESSAGE_SIZE];
} first_error;

/// Notes a status, unless it is success or there was an error before.
void first_error_note(first_error *error, const whirl_status *status);

/// Returns the error as a status; success without one.
whirl_status first_error_status(const first_error *error);

#endif
