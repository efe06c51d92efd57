#include "first_error.h"

#include <stdio.h>

void first_error_note(first_error *error, const whirl_status *status) {
    if (status->code == WHIRL_OK || error->code != WHIRL_OK) return;
    error->code = status->code;
    snprintf(error->message, sizeof error->message, "%s", status->message);
}

whirl_status first_error_status(const first_error *error) {
    return error->code == WHIRL_OK ? whirl_ok() : whirl_fail(error->code, "%s", error->message);
}
