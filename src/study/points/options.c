// Descriptors of the options of a study.
#include <math.h>

#include "member_table.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/study.h"

const whirl_member *whirl_batch_members(void) {
    static const whirl_member members[] = {
        MEMBER(whirl_batch, FLAG, "confirm", confirm, "study", false, "confirm", "", "", WHIRL_KEY_CHOICE, false, "no",
               WHIRL_ANY, "yes|no|true|false",
               "yes: every point is computed again with errors of a step 16 times smaller (rk4: twice the steps); "
               "verdicts that agree may have high confidence",
               ""),
        {.part = NULL},
    };
    return members;
}
