// Registry of analyses: one line each, with their properties.
#include <string.h>

#include "analysis.h"

/// Cost of finding an orbit or a torus by Newton's method from a neighbouring one.
#define FOUND_COST 10.0

#define MOTION .name = "motion", .method = NULL, .remark = "", .moves = true, .settles = true
static const whirl_kind motion = {MOTION, .asked = "Written in the list `analyze: [...]`."};
static const whirl_kind present = {MOTION, .asked = "Part of every result."};

#define AT_REST .name = "rest", .asked = "A study of its own, in place of sweep or response.", .remark = "", .cost = 1.0
#define ABOUT_REST AT_REST, .method = "linear, about rest", .place = "about where the machine rests"
static const whirl_kind rest = {ABOUT_REST}, still = {ABOUT_REST, .still = true};
static const whirl_kind run = {AT_REST, .method = "in time, turn by turn", .place = "over time"};
static const whirl_kind fitted = {.name = "fit",
                                  .asked = "A study of its own, in place of sweep or response.",
                                  .method = "least squares over periodic orbits",
                                  .remark = "",
                                  .cost = 1.0};

static const whirl_kind branch = {.name = "branch",
                                  .asked = "Of studies with `branch: {...}`.",
                                  .method = NULL,
                                  .remark = ", followed by continuation",
                                  .settles = true,
                                  .found = true,
                                  .cost = FOUND_COST};

static const whirl_kind torus = {.name = "torus",
                                 .asked = "Of studies with `branch: {tori: yes, ...}`.",
                                 .method = NULL,
                                 .begins = "the Neimark-Sacker points of the branches",
                                 .remark = ", followed by continuation",
                                 .settles = true,
                                 .found = true,
                                 .cost = FOUND_COST};

// The last members of whirl_analysis: usual (computed by default), kept (computed whenever waveforms are stored, and
// only then), and the kind of its points.
#define ON_DEMAND false, false, &motion
#define USUAL true, false, &motion
#define KEPT false, true, &motion
#define ALWAYS true, false, &present
#define TURNING false, false, &rest
#define STILL false, false, &still
#define RUNNING false, false, &run
#define FITTED false, false, &fitted
#define TRACED false, false, &branch
#define OF_TORI false, false, &torus

// clang-format off
#define ANALYSES(analysis)                                                                                             \
    analysis(poincare, "the state of every station at the end of each recorded revolution", "Poincar\u00e9 1892",      \
             USUAL)                                                                                                    \
    analysis(orbit, "extent of the motion of every station", "", USUAL)                                                \
    analysis(rub, "time in contact, number of contacts, largest normal force", "", USUAL)                              \
    analysis(waveform, "displacement of every station over time", "", KEPT)                                            \
    analysis(spectrum, "amplitudes over orders of the running speed, with the full spectrum of x + iy",                \
             "Harris 1978 (Hann window), Southwick 1993 (full spectrum)", USUAL)                                       \
    analysis(lyapunov, "largest Lyapunov exponent per revolution with its standard error", "Benettin et al. 1980",     \
             USUAL)                                                                                                    \
    analysis(exponents, "all Lyapunov exponents, their required sum, and the attractor's dimension",                   \
             "Benettin et al. 1980; Kaplan, Yorke 1979", ON_DEMAND)                                                    \
    analysis(regime,                                                                                                   \
             "P-k, quasi-periodic, chaotic, diverged or undetermined, with the evidence and how far to trust it",      \
             "Das, Saiki, Sander, Yorke 2017; Das, Yorke 2018 (weighted Birkhoff averages); Gottwald, Melbourne 2009 " \
             "(0-1 test); docs/theory.md", USUAL)                                                                      \
    analysis(winding, "how often and in which sense every station goes round its mean position, and dry whip",         \
             "Black 1968; Jiang, Ulbrich 2005 (dry whip)", USUAL)                                                      \
    analysis(evidence,                                                                                                 \
             "measures to check a verdict: 0-1 test, correlation, settling, largest Floquet multiplier",               \
             "Gottwald, Melbourne 2009 (0-1 test); docs/theory.md", ON_DEMAND)                                         \
    analysis(floquet,                                                                                                  \
             "the orbit that a motion has settled on, by Newton's method, and all its Floquet multipliers",            \
             "Floquet 1883; docs/theory.md", ON_DEMAND)                                                                \
    analysis(trace, "orbits and equilibria along a branch, stable or not: multipliers, special points, contacts",     \
             "Keller 1977; Kuznetsov 2004; docs/theory.md", TRACED)                                                    \
    analysis(torus, "quasi-periodic motions past Neimark-Sacker points: rotation numbers, bounds, exponents",          \
             "Jorba 2001; Schilder, Osinga, Vogt 2005; docs/theory.md", OF_TORI)                                       \
    WHIRL_STUDIES_AT_REST(analysis)                                                                                    \
    analysis(ranges,                                                                                                   \
             "how far motions and machines at rest reach into the ranges in which laws are valid",                     \
             "docs/theory.md", ALWAYS)
// clang-format on

#define ABOUT(name, meaning, source, ...) {#name, meaning, source, __VA_ARGS__},
#define PLAN(name, ...) &name##_analysis,

static const whirl_analysis analyses[] = {ANALYSES(ABOUT){NULL, NULL, NULL, ON_DEMAND}};

const analysis_plan *const analysis_plans[] = {ANALYSES(PLAN) NULL};

static const char *const roles[WHIRL_ROLES] = {
    [WHIRL_ROLE_POINT] = "point",           [WHIRL_ROLE_SURVEY] = "survey",
    [WHIRL_ROLE_DETAIL] = "detail",         [WHIRL_ROLE_MAP] = "map",
    [WHIRL_ROLE_BASIN] = "basin",           [WHIRL_ROLE_BRANCHES] = "branches",
    [WHIRL_ROLE_CURVES] = "curves",         [WHIRL_ROLE_TORI] = "tori",
    [WHIRL_ROLE_MOTIONS] = "motions",       [WHIRL_ROLE_REST] = "rest",
    [WHIRL_ROLE_TOLERANCES] = "tolerances", [WHIRL_ROLE_RECORDS] = "records"};

const char *whirl_role_name(whirl_role role) {
    return roles[role];
}

whirl_role whirl_role_of(const char *name) {
    int role = 0;
    while (role < WHIRL_ROLES && strcmp(roles[role], name) != 0) role++;
    return (whirl_role)role;
}

const whirl_analysis *whirl_analyses(void) {
    return analyses;
}

bool whirl_analysis_add(whirl_analysis_set *set, const char *name) {
    for (unsigned i = 0; analyses[i].name; i++) {
        if (strcmp(analyses[i].name, name) == 0) {
            *set |= 1u << i;
            return true;
        }
    }
    return false;
}

bool whirl_analysis_has(whirl_analysis_set set, const char *name) {
    whirl_analysis_set one = 0;
    return whirl_analysis_add(&one, name) && (set & one) != 0;
}

whirl_analysis_set whirl_analysis_usual(void) {
    whirl_analysis_set set = 0;
    for (unsigned i = 0; analyses[i].name; i++) set |= analyses[i].usual ? 1u << i : 0;
    return set;
}

const whirl_kind *whirl_analysis_kind(whirl_analysis_set set) {
    for (unsigned i = 0; analyses[i].name; i++)
        if (set >> i & 1u) return analyses[i].kind;
    return &motion;
}

whirl_analysis_set whirl_analysis_fit(whirl_analysis_set set, const whirl_record_options *options) {
    whirl_analysis_set kept = 0;
    for (unsigned i = 0; analyses[i].name; i++) kept |= analyses[i].kept ? 1u << i : 0;
    return options->waveform_revolutions > 0 ? set | kept : set & ~kept;
}
