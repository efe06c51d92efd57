/// Journals in films of a machine at rest.
#ifndef ANALYZE_STATICS_H
#define ANALYZE_STATICS_H

#include "whirl/engine/system.h"

#include <stdbool.h>

/// Returns true if any journal lies in a film, with the machine at rest at x.
bool films_any(const whirl_system *system, const double *x);

#endif
