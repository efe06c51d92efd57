// The registry of analyses: one line each, with what a choice of them can tell of itself.
#include <string.h>

#include "analysis.h"

// Traits.
#define ON_DEMAND false, false, false, false
#define USUAL true, false, false, false
#define KEPT false, true, false, false
#define RESTING false, false, true, false
#define TRACED false, false, false, true

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
    analysis(exponents, "all Lyapunov exponents, the sum that they must have, and the attractor's dimension",          \
             "Benettin et al. 1980; Kaplan, Yorke 1979", ON_DEMAND)                                                    \
    analysis(regime,                                                                                                   \
             "P-k, quasi-periodic, chaotic, diverged or undetermined, with the evidence and how far to trust it",      \
             "Das, Saiki, Sander, Yorke 2017; Das, Yorke 2018 (weighted Birkhoff averages); Gottwald, Melbourne 2009 " \
             "(0-1 test); docs/theory.md", USUAL)                                                                      \
    analysis(winding, "how often and in which sense every station goes round its mean position, and dry whip",         \
             "Black 1968; Jiang, Ulbrich 2005 (dry whip)", USUAL)                                                      \
    analysis(evidence,                                                                                                 \
             "what a verdict can be checked by: 0-1 test, correlation, settling, largest Floquet multiplier",          \
             "Gottwald, Melbourne 2009 (0-1 test); docs/theory.md", ON_DEMAND)                                         \
    analysis(floquet,                                                                                                  \
             "the orbit that a motion has come to rest on, by Newton's method, and all its Floquet multipliers",       \
             "Floquet 1883; docs/theory.md", ON_DEMAND)                                                                \
    analysis(modes, "frequencies, damping, whirl and shapes of small motions about where the machine rests",           \
             "Friswell, Penny, Garvey, Lees 2010; Floquet 1883 where coefficients turn with the shaft", RESTING)       \
    analysis(unbalance, "synchronous response to unbalance about where the machine rests",                             \
             "Friswell, Penny, Garvey, Lees 2010", RESTING)                                                            \
    analysis(trace, "orbits and equilibria along a branch, stable or not: multipliers, special points, contacts",     \
             "Keller 1977; Kuznetsov 2004; docs/theory.md", TRACED)                                                    \
    analysis(torus, "quasi-periodic motions past Neimark-Sacker points: rotation numbers, bounds, exponents",          \
             "Jorba 2001; Schilder, Osinga, Vogt 2005; docs/theory.md", TRACED)
// clang-format on

#define ABOUT(name, meaning, source, ...) {#name, meaning, source, __VA_ARGS__},
#define PLAN(name, ...) &name##_analysis,

static const whirl_analysis analyses[] = {ANALYSES(ABOUT){NULL, NULL, NULL, ON_DEMAND}};

const analysis_plan *const analysis_plans[] = {ANALYSES(PLAN) NULL};

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

bool whirl_analysis_is_resting(whirl_analysis_set set) {
    for (unsigned i = 0; analyses[i].name; i++)
        if ((set >> i & 1u) && analyses[i].resting) return true;
    return false;
}

bool whirl_analysis_is_traced(whirl_analysis_set set) {
    for (unsigned i = 0; analyses[i].name; i++)
        if ((set >> i & 1u) && analyses[i].traced) return true;
    return false;
}

whirl_analysis_set whirl_analysis_fit(whirl_analysis_set set, const whirl_record_options *options) {
    whirl_analysis_set kept = 0;
    for (unsigned i = 0; analyses[i].name; i++) kept |= analyses[i].kept ? 1u << i : 0;
    return options->waveform_revolutions > 0 ? set | kept : set & ~kept;
}
