// Descriptors of the options of a study.
#include <math.h>

#include "whirl/engine/study.h"
#include "words.h"

const whirl_member *whirl_batch_members(void) {
    static const whirl_member members[] = {
        MEMBER(whirl_batch, FLAG, "confirm", confirm, "study", false, "confirm", "", "", WHIRL_KEY_CHOICE, false, "no",
               WHIRL_ANY, "yes|no|true|false",
               "yes: every point is computed once more with errors of a step 16 times smaller (rk4: twice the steps), "
               "and its verdict is trusted where both agree",
               ""),
        {.part = NULL},
    };
    return members;
}
