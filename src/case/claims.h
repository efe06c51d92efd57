/// Claims from memory.
#ifndef CASE_CLAIMS_H
#define CASE_CLAIMS_H

#include "whirl/engine/claims.h"

#include <stddef.h>

/// Reads claims from memory as whirl_claims_load does from a file; `name` is used in messages.
whirl_status claims_parse(const char *text, size_t length, const char *name, whirl_problems *problems,
                          whirl_claims **claims);

#endif
