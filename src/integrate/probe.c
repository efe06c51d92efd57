// The numbers of a probe as they describe themselves.
#include <math.h>

#include "whirl/system.h"

/// Where a case says a state, its keys are those of the coordinates.
#define COORDINATE(field, symbol, meaning)                                                                             \
    {                                                                                                                  \
#field, .type = WHIRL_MEMBER_INDEX, .offset = offsetof(whirl_probe, field), .part = "initial",                 \
                .key = {                                                                                               \
                    #field, symbol, "1", WHIRL_KEY_NUMBER, false, "0", WHIRL_ANY, NULL, meaning, "" }                  \
    }
#define LENGTH(field, meaning)                                                                                         \
    {                                                                                                                  \
#field, .type = WHIRL_MEMBER_NUMBER, .offset = offsetof(whirl_probe, field), .part = "",                       \
                .key = {                                                                                               \
                    #field, "", "1", WHIRL_KEY_NUMBER, false, "", WHIRL_NOT_NEGATIVE, NULL, meaning, "" }              \
    }
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
