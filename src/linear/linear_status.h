/// Failures of linear analyses for lack of memory.
#ifndef LINEAR_LINEAR_STATUS_H
#define LINEAR_LINEAR_STATUS_H

#include "whirl/engine/system.h"

/// Returns WHIRL_NO_MEMORY if memory ran out since exhausted_watch returned `before`, else `status`. A decomposition
/// that fails for lack of memory would otherwise be reported as a singular matrix.
whirl_status linear_status(int before, whirl_status status, size_t coordinates);

#endif
