/// Motions whose regime is known, compared with the library's verdicts.
#ifndef SUPPORT_KNOWN_H
#define SUPPORT_KNOWN_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "whirl/engine/analyze.h"
#include "whirl/engine/rotor.h"

enum { KNOWN_DIMENSION = 8, KNOWN_PARAMETERS = 8 };

/// A motion with its regime.
typedef struct known_motion {
    whirl_system system;
    double start[KNOWN_DIMENSION];
    double p[KNOWN_PARAMETERS]; ///< the model of a system that is not a rotor
    whirl_rotor *rotor;         ///< freed when the motion has been judged; NULL for other systems
    char expected[48]; ///< "P-2", "quasi-periodic (1 curve)", "quasi-periodic" for any number of curves, "not P-1"
    bool trap;         ///< too slow or too fine for the record: undetermined is right as well
    int transient;     ///< revolutions, 0: 1100
    char label[128];   ///< names the parameters
} known_motion;

/// Motions of one kind. `make` fills the one of that index, zero before, and returns false past the last.
typedef struct known_family {
    const char *name, *source; ///< where the regime is known from
    int steps;                 ///< of RK4 a revolution; the verdict is confirmed with twice as many; 0: DOP853
    bool (*make)(size_t index, known_motion *motion);
} known_family;

/// The verdict, confirmed with twice the steps: 100 revolutions recorded, 650 watched, by RK4.
whirl_verdict judge_known(const known_motion *motion, int steps);

/// Tests of families, for a main: each is judged as sweeps do it, 100 revolutions recorded, 650 watched; then `more`
/// [more_count] tests, and the total. A family fails when a verdict is wrong with high confidence, or a motion that is
/// no trap stays undetermined or is another by low confidence; the total for more than 0.5 % that are wrong with fair
/// confidence. Without WHIRL_SOAK in the environment every `stride`-th motion only; with it, undetermined motions are
/// judged again as the advice says, which must not lead to a wrong verdict either, and at least `least` of all have to
/// be right.
int run_families(const char *what, const known_family *families, size_t count, size_t stride,
                 const struct CMUnitTest *more, size_t more_count, int least);

#endif
