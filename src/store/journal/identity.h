/// Identity of a study as text: case, parameters, points and how they are computed; no results.
#ifndef STORE_IDENTITY_H
#define STORE_IDENTITY_H

#include "whirl/engine/result.h"
#include "whirl/status.h"

#include <stdbool.h>
#include <stddef.h>

/// Writes the identity as lines "LABEL<tab>VALUE" in UTF-8; to be freed. `build` adds what else the bits depend on: the
/// sources and compilation of whirl, kind of arithmetic, mathematical functions of the system. WHIRL_BAD_INPUT for an
/// unknown WHIRL_ISA.
whirl_status identity_text(const whirl_result *outline, bool build, char **text, size_t *size);

/// Writes the first difference in at most `size` bytes: "line 5 of the case was 'a' and is 'b'". False when there is
/// none.
bool identity_difference(const char *earlier, const char *later, char *difference, size_t size);

#endif
