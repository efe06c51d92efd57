/// Whether a motion has come to rest at an equilibrium.
#ifndef ANALYZE_AT_REST_H
#define ANALYZE_AT_REST_H

#include "whirl/engine/analyze.h"

/// Looks for the equilibrium of a recorded motion that hardly moves (record->rest). Does nothing for others.
/// WHIRL_NO_MEMORY alone is an error.
whirl_status at_rest_look(const whirl_system *system, const whirl_integrate_options *integrate, whirl_record *record);

#endif
