/// Trial weights that a model proposes.
#ifndef ANALYZE_BALANCE_TRIALS_H
#define ANALYZE_BALANCE_TRIALS_H

#include "whirl/internal/balance.h"

/// Proposes trial weights for all unknowns, by the model.
void balance_propose(const whirl_balance *of, const whirl_balance_model *model, whirl_correction *out);

#endif
