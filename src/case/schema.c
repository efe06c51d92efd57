// The tables that a case file is checked against, and that `whirl describe` prints.
//
// A key of kind WHIRL_KEY_CHOICE with "" for its choices holds what its meaning says: a text, a name, or a part of the
// file with keys of its own. A number whose unit is "" is in the unit of the swept parameter, or a list.
#include "schema.h"

#include <limits.h>
#include <math.h>

#include "whirl/case.h"
#include "whirl/claims.h"
#include "whirl/study.h"

#define COUNT(keys) (sizeof(keys) / sizeof *(keys))

static const whirl_key case_keys[] = {
    {"whirl", "", "1", WHIRL_KEY_WHOLE, true, "", WHIRL_ANY, NULL, "version of the format, 1", ""},
    {"title", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "", "what the case is about, in one line", ""},
    {"parameters", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "names with values: a number, a number and a unit, or = and an expression over other parameters in SI", ""},
    {"rotor", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "", "the machine: see rotor", ""},
    {"study", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "", "what is computed: see study", ""},
};

// clang-format off
#define ROTOR_KEYS(speeds)                                                                                             \
    {"speed", "omega", "rad/s", WHIRL_KEY_NUMBER, true, "", speeds, NULL,                                              \
     "speed of rotation, above 0; for modes at least 0", ""},                                                          \
    {"length_scale", "", "m", WHIRL_KEY_NUMBER, true, "", WHIRL_POSITIVE, NULL,                                        \
     "length in which displacements are computed and reported, such as the clearance", ""},                            \
    {"materials", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "", "names with the keys of a material of shafts",   \
     ""},                                                                                                              \
    {"shafts", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",                                                     \
     "names with the keys of a shaft of finite elements, which segments make up", ""},                                 \
    {"stations", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "", "names with the keys of a station", ""},           \
    {"elements", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "", "a list of elements, each a kind with its keys",  \
     ""}
// clang-format on

static const whirl_key rotor_keys[] = {ROTOR_KEYS(WHIRL_POSITIVE)};
static const whirl_key still_rotor_keys[] = {ROTOR_KEYS(WHIRL_NOT_NEGATIVE)};

#define OR_NAME(name, ...) ", " #name
#define KEY_AT_REST(name, meaning, ...)                                                                                \
    {#name,                                                                                                            \
     "",                                                                                                               \
     "",                                                                                                               \
     WHIRL_KEY_CHOICE,                                                                                                 \
     false,                                                                                                            \
     "",                                                                                                               \
     WHIRL_ANY,                                                                                                        \
     "",                                                                                                               \
     meaning ", along one parameter or at one point: see " #name,                                                      \
     ""},

static const whirl_key study_keys[] = {
    {"response", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "one point; a study has this or one of sweep, map, basin, branch" WHIRL_STUDIES_AT_REST(OR_NAME), ""},
    {"sweep", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "", "points along one parameter", ""},
    {"map", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "", "points of a plane of two parameters: see map", ""},
    {"basin", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "starts in a plane of two parameters of the initial state, and the motions that they come to rest on: see map",
     ""},
    {"branch", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "orbits along one parameter, stable or not, and where and why they change; alone or beside a sweep: see branch",
     ""},
    {"curves", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "curves over a second parameter, through the special points of the branches: see curves", ""},
    WHIRL_STUDIES_AT_REST(KEY_AT_REST){"initial", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
                                       "names of stations with the state they start from; zero where absent", ""},
    {"starts", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "several starts of every point of a response, sweep or map, to see which motions exist side by side: see starts",
     ""},
    {"integrate", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "", "how and how long: see integrate", ""},
    {"keep", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "", "how much of waveforms and spectra: see keep", ""},
    {"analyze", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "a list of analyses; all but waveform, exponents, evidence and floquet where absent", ""},
    {"detail", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "values of the swept parameter that are computed once more, for longer and with whole waveforms and spectra", ""},
    {"units", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "units of figures and pages, such as um, rpm, Hz, p-p: a length (scale, m, mm, um, in, mil), a speed (rad/s, "
     "rpm), a "
     "frequency (order, Hz, cpm) and a way to count amplitudes (0-p, p-p, rms); absent: as the case writes them",
     ""},
};

// Of points along a parameter.
// clang-format off
#define AXIS_KEYS(needed)                                                                                              \
    {"parameter", "", "", WHIRL_KEY_CHOICE, needed, "", WHIRL_ANY, "", "name of the parameter that varies", ""},       \
    {"from", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL, "its first value", ""},                             \
    {"to", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL, "its last value", ""},                                \
    {"points", "", "1", WHIRL_KEY_WHOLE, false, "", WHIRL_FROM_TO(1, SCHEMA_MAX_POINTS), NULL,                         \
     "number of values, spaced as scale says, both ends included; this or step", ""},                                  \
    {"step", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL,                                                     \
     "distance of the values, from the first up to the last that is not beyond `to`; this or points", ""},             \
    {"scale", "", "", WHIRL_KEY_CHOICE, false, "linear", WHIRL_ANY, "linear|log",                                      \
     "of points: linear: equal differences; log: equal ratios", ""},                                                   \
    {"values", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL,                                                   \
     "a list of the values, rising or falling, in place of from, to, points and step", ""}
// clang-format on

static const whirl_key sweep_keys[] = {
    AXIS_KEYS(true),
    {"start", "", "", WHIRL_KEY_CHOICE, false, "state", WHIRL_ANY, "rest|state|carry",
     "rest: every point from zero; state: from the initial state; carry: from the end of the point before", ""},
    {"direction", "", "", WHIRL_KEY_CHOICE, false, "up", WHIRL_ANY, "up|down|both",
     "with start: carry, along rising or falling values, or both, which shows hysteresis", ""},
};

static const whirl_key axis_keys[] = {AXIS_KEYS(true)};

static const whirl_key map_keys[] = {
    {"x", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "", "the parameter along its rows, and its values", ""},
    {"y", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "", "the parameter from row to row, and its values", ""},
    {"z", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "the parameter from plane to plane, and its values; absent: there is one plane", ""},
    {"start", "", "", WHIRL_KEY_CHOICE, false, "state", WHIRL_ANY, "rest|state",
     "rest: every point from zero; state: from the initial state", ""},
    {"refine", "", "1", WHIRL_KEY_WHOLE, false, "", WHIRL_FROM_TO(2, WHIRL_MAX_SQUARE), NULL,
     "every so many points along both axes are computed first, a power of two, then squares between them are halved "
     "where verdicts differ; absent: all points are computed",
     ""},
};

// Without a parameter there is one point, of the machine as it stands.
static const whirl_key resting_keys[] = {AXIS_KEYS(false)};

static const whirl_key branch_keys[] = {
    {"parameter", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "name of the parameter that varies; that of the sweep where there is one", ""},
    {"from", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL, "its first bound; of the sweep where absent", ""},
    {"to", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL, "its other bound; of the sweep where absent", ""},
    {"at", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL,
     "a list of values at which a motion is let settle and a branch begins; the first bound where absent", ""},
};

static const whirl_key curves_keys[] = {
    {"parameter", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "", "name of the second parameter", ""},
    {"from", "", "", WHIRL_KEY_NUMBER, true, "", WHIRL_ANY, NULL, "its lower bound", ""},
    {"to", "", "", WHIRL_KEY_NUMBER, true, "", WHIRL_ANY, NULL, "its upper bound", ""},
};

static const whirl_key detail_keys[] = {
    {"at", "", "", WHIRL_KEY_NUMBER, true, "", WHIRL_ANY, NULL, "a list of values of the swept parameter", ""},
};

static const whirl_key starts_keys[] = {
    {"count", "", "1", WHIRL_KEY_WHOLE, false, "", WHIRL_FROM_TO(2, WHIRL_MAX_STARTS), NULL,
     "starts of every point; the first is the initial state itself, the others fill the ranges evenly, by the sequence "
     "of "
     "Halton: the same at every point",
     ""},
    {"grid", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "in place of count: numbers of values of the coordinates of within, such as x: 5, from one end of the range to "
     "the other; every point has the initial state itself besides",
     ""},
    {"within", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "",
     "names of stations with ranges of the coordinates of initial, such as x: [-1, 1]; what is not named is as there",
     ""},
    {"neighbours", "", "1", WHIRL_KEY_WHOLE, false, "0", WHIRL_FROM_TO(0, 100000), NULL,
     "rounds, at most, in which points of a sweep or map start from where motions of their neighbours ended, on "
     "attractors that they lack; such starts count in no share",
     ""},
};

// Parts whose keys are members of the structs that they fill.
typedef const whirl_member *(*table)(void);
static const table of_batch[] = {whirl_batch_members, NULL};
static const table of_options[] = {whirl_integrate_members, whirl_record_members, whirl_trace_members, NULL};
static const table of_probe[] = {whirl_probe_members, NULL};

#define GROUP(name, meaning, keys, tables)                                                                             \
    { name, meaning, "", keys, COUNT(keys), NULL, tables }
#define PART(name, meaning, tables)                                                                                    \
    { name, meaning, "", NULL, 0, NULL, tables }

const whirl_group schema_case = GROUP("case", "a case file", case_keys, NULL);
const whirl_group schema_rotor = GROUP("rotor", "the machine", rotor_keys, NULL);
const whirl_group schema_still_rotor = GROUP("rotor", "the machine", still_rotor_keys, NULL);
const whirl_group schema_study = GROUP("study", "what is computed", study_keys, of_batch);
const whirl_group schema_response = PART("response", "one point: no keys", NULL);
const whirl_group schema_sweep = GROUP("sweep", "points along one parameter", sweep_keys, NULL);
const whirl_group schema_map = GROUP("map", "points of a plane of two parameters", map_keys, NULL);
const whirl_group schema_basin =
    GROUP("basin", "starts in a plane, and the motions that they come to rest on", map_keys, NULL);
const whirl_group schema_axis = GROUP("axis", "the values of a parameter, along x or y of a map", axis_keys, NULL);
#define GROUP_AT_REST(name, meaning, ...) GROUP(#name, meaning, resting_keys, of_options),
#define INDEX_AT_REST(name, ...) AT_REST_##name,
#define ADDRESS_AT_REST(name, ...) &schema_at_rest[AT_REST_##name],
const whirl_group schema_at_rest[] = {WHIRL_STUDIES_AT_REST(GROUP_AT_REST){.name = NULL}};
const whirl_group schema_branch =
    GROUP("branch", "branches of periodic orbits and equilibria along one parameter", branch_keys, of_options);
const whirl_group schema_curves = GROUP("curves", "curves of special points over two parameters", curves_keys, NULL);
const whirl_group schema_initial = PART("initial", "the state that a station starts from", of_probe);
const whirl_group schema_starts = GROUP("starts", "several starts of every point", starts_keys, NULL);
const whirl_group schema_integrate = PART("integrate", "how the motion is integrated, and how long", of_options);
const whirl_group schema_keep = PART("keep", "how much of waveforms and spectra is kept", of_options);
const whirl_group schema_detail = GROUP("detail", "values that are computed at length", detail_keys, of_options);

const char *schema_scaled_unit(const whirl_key *key) {
    for (const whirl_member *member = whirl_probe_members(); member->part; member++)
        if (key == &member->key) return key->name[0] == 'v' ? "m/s" : "m";
    return "";
}

enum { WHIRL_STUDIES_AT_REST(INDEX_AT_REST) };

const whirl_group *const *whirl_case_groups(void) {
    static const whirl_group *const groups[] = {
        &schema_case,
        &schema_rotor,
        &schema_study,
        &schema_response,
        &schema_sweep,
        &schema_map,
        &schema_basin,
        &schema_axis,
        WHIRL_STUDIES_AT_REST(ADDRESS_AT_REST) & schema_branch,
        &schema_curves,
        &schema_initial,
        &schema_starts,
        &schema_integrate,
        &schema_keep,
        &schema_detail,
        NULL,
    };
    return groups;
}

// ---------------------------------------------------------------- claims

static const whirl_key claims_keys[] = {
    {"claims", "", "1", WHIRL_KEY_WHOLE, true, "", WHIRL_ANY, NULL, "version of the format, 1", ""},
    {"source", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "", "who says it", ""},
    {"parameter", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "", "name of the parameter that the claims speak of",
     ""},
    {"station", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "", "name of the station whose spectrum is meant", ""},
    {"items", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "", "a list of claims", ""},
};

static const whirl_key claim_keys[] = {
    {"where", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "", "figure or section", ""},
    {"from", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL, "first value of the parameter", ""},
    {"to", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL, "last value of the parameter", ""},
    {"at", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL, "value of the parameter, in place of from and to", ""},
    {"says", "", "", WHIRL_KEY_CHOICE, true, "", WHIRL_ANY, "", "the claim in words", ""},
    {"regime", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
     "P-1 to P-128, periodic, quasi-periodic, chaotic or diverged", ""},
    {"curves", "", "1", WHIRL_KEY_WHOLE, false, "", WHIRL_FROM_TO(1, 64), NULL,
     "closed curves of a quasi-periodic section", ""},
    {"rub", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "true|false|yes|no", "whether there is contact", ""},
    {"lines", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_POSITIVE, NULL, "a list of orders that the spectrum shows",
     ""},
    {"only_lines", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "true|false|yes|no", "and no others", ""},
    {"band", "", "", WHIRL_KEY_NUMBER, false, "", WHIRL_NOT_NEGATIVE, NULL,
     "two orders between which the large lines below the running speed lie", ""},
    {"whirl", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "forward|backward|diverging-backward",
     "direction of the whirl", ""},
};

const whirl_group schema_claims =
    GROUP("claims", "a claims file: what a paper or a measurement says of a rotor", claims_keys, NULL);
const whirl_group schema_claim = GROUP("claim", "one claim of the list `items` of a claims file", claim_keys, NULL);

const whirl_group *const *whirl_claims_groups(void) {
    static const whirl_group *const groups[] = {&schema_claims, &schema_claim, NULL};
    return groups;
}
