// The numbers of a probe as they describe themselves.
#include <math.h>

#include "whirl/system.h"

#define MEMBER(TYPE, field, symbol, part, fallback, range, meaning)                                                    \
    {                                                                                                                  \
#field, WHIRL_MEMBER_##TYPE, offsetof(whirl_probe, field), part,                                               \
            {#field, symbol, "1", WHIRL_KEY_NUMBER, false, fallback, range, NULL, meaning, "" }, false                 \
    }
/// Where a case says a state, its keys are those of the coordinates.
#define COORDINATE(field, symbol, meaning) MEMBER(INDEX, field, symbol, "initial", "0", WHIRL_ANY, meaning)
#define LENGTH(field, meaning) MEMBER(NUMBER, field, "", "", "", WHIRL_NOT_NEGATIVE, meaning)
#define PLACE "displacement in length scales, or with a unit of length"
#define RATE "velocity in length scales per radian of rotation, or with a unit of m/s"

const whirl_member *whirl_probe_members(void) {
    static const whirl_member members[] = {
        LENGTH(clearance, "clearance of the journal bearing, 0 where there is none"),
        LENGTH(gap, "radius at which a stator is touched, 0 where there is none"),
        COORDINATE(x, "x", PLACE),
        COORDINATE(y, "y", PLACE),
        COORDINATE(vx, "x'", RATE),
        COORDINATE(vy, "y'", RATE),
        {.part = NULL},
    };
    return members;
}
