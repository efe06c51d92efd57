/// Sets of weights that excite one mode alone.
#ifndef ANALYZE_BALANCE_SETS_H
#define ANALYZE_BALANCE_SETS_H

#include "whirl/internal/balance.h"

/// Finds the weight sets of the modes: whirl_correction.sets.
whirl_status balance_find_sets(const whirl_balance *of, const whirl_balance_model *model, whirl_correction *out);

#endif
