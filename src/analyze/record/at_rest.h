/// Detection of motions at rest at an equilibrium.
#ifndef ANALYZE_AT_REST_H
#define ANALYZE_AT_REST_H

#include "section.h"

/// Searches the equilibrium of a recorded motion that hardly moves (record->rest). Does nothing for others. The only
/// error is WHIRL_NO_MEMORY.
whirl_status at_rest_look(const whirl_system *system, const whirl_integrate_options *integrate, whirl_record *record);

#endif
