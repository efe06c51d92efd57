// The registry of analyses: one line each.
#include <string.h>

#include "analysis.h"

// clang-format off
#define ANALYSES(analysis)                                                                                             \
    analysis(poincare, "the state of every station at the end of each recorded revolution", "Poincar\u00e9 1892")           \
    analysis(orbit, "extent of the motion of every station", "")                                                       \
    analysis(rub, "time in contact, number of contacts, largest normal force", "")                                     \
    analysis(waveform, "displacement of every station over time", "")                                                  \
    analysis(spectrum, "amplitudes over orders of the running speed, with the full spectrum of x + iy",                \
             "Harris 1978 (Hann window), Southwick 1993 (full spectrum)")                                              \
    analysis(lyapunov, "largest Lyapunov exponent per revolution with its standard error", "Benettin et al. 1980")     \
    analysis(exponents, "all Lyapunov exponents, the sum that they must have, and the attractor's dimension",          \
             "Benettin et al. 1980; Kaplan, Yorke 1979")                                                               \
    analysis(regime, "P-k, quasi-periodic, chaotic, diverged or undetermined, with the evidence and how far to trust it", \
             "Das, Saiki, Sander, Yorke 2017; Das, Yorke 2018 (weighted Birkhoff averages); Gottwald, Melbourne 2009 "  \
             "(0-1 test); docs/theory.md")                                                                             \
    analysis(winding, "how often and in which sense every station goes round its mean position, and dry whip",         \
             "Black 1968; Jiang, Ulbrich 2005 (dry whip)")                                                             \
    analysis(evidence, "what a verdict can be checked by: 0-1 test, correlation, settling, largest Floquet multiplier", \
             "Gottwald, Melbourne 2009 (0-1 test); docs/theory.md")
// clang-format on

#define ABOUT(name, meaning, source) {#name, meaning, source},
#define PLAN(name, meaning, source) &name##_analysis,

static const whirl_analysis analyses[] = {ANALYSES(ABOUT){NULL, NULL, NULL}};

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
