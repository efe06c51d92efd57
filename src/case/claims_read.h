/// Claims from memory.
#ifndef CASE_CLAIMS_READ_H
#define CASE_CLAIMS_READ_H

#include <stddef.h>

#include "whirl/engine/claims.h"

/// As whirl_claims_load, from memory; `name` stands for the file in messages.
whirl_status claims_parse(const char *text, size_t length, const char *name, whirl_problems *problems,
                          whirl_claims **claims);

#endif
