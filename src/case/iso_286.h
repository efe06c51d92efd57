/// Tolerance classes of sizes, "H7" (ISO 286-1:2010).
#ifndef CASE_ISO_286_H
#define CASE_ISO_286_H

#include "quantity.h"

#include <stdbool.h>

/// Finds the limits of a class, from the nominal size, all in m. On failure `why` is the reason.
bool iso_286_limits(const char *name, double size, double *lower, double *upper, char why[WHY_SIZE]);

#endif
