/// The keys of a case file outside stations and elements, and of a claims file.
#ifndef CASE_SCHEMA_H
#define CASE_SCHEMA_H

#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"

enum { SCHEMA_VERSION = 1, SCHEMA_MAX_POINTS = 10000000, SCHEMA_MAX_DETAIL = 1000 };

/// That of a rotor which may stand still is not listed: it is the other one but for the range of its speed.
extern const whirl_group schema_still_rotor;
extern const whirl_group schema_case, schema_rotor, schema_study, schema_response, schema_sweep, schema_map,
    schema_basin, schema_axis, schema_motions, schema_branch, schema_curves, schema_initial, schema_starts,
    schema_integrate, schema_keep, schema_detail;

#define SCHEMA_INDEX_AT_REST(name, ...) SCHEMA_AT_REST_##name,

/// How many studies of machines at rest there are.
enum { WHIRL_STUDIES_AT_REST(SCHEMA_INDEX_AT_REST) SCHEMA_AT_REST };

/// Of studies of machines at rest (WHIRL_STUDIES_AT_REST), ended by one without a name.
extern const whirl_group schema_at_rest[];

/// The unit that a plain number of the initial state may have instead, "m" or "m/s"; "" for all other keys.
const char *schema_scaled_unit(const whirl_key *key);

extern const whirl_group schema_claims, schema_claim;

#endif
