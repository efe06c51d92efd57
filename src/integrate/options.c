// Descriptors of the options of integration.
#include <math.h>
#include <stdio.h>

#include "member_table.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/integrate.h"

#define WORD(TYPE, name, field, part, key, fallback, choices, meaning)                                                 \
    MEMBER(whirl_integrate_options, TYPE, name, field, part, false, key, "", "", WHIRL_KEY_CHOICE, false, fallback,    \
           WHIRL_ANY, choices, meaning, "")
#define NUMBER(field, fallback, range, refined, meaning)                                                               \
    MEMBER(whirl_integrate_options, NUMBER, #field, field, "integrate", refined, #field, "", "1", WHIRL_KEY_NUMBER,    \
           false, fallback, range, NULL, meaning, "")

static const whirl_member members[] = {
    WORD(WORD, "method", method, "integrate", "method", "auto", "",
         "a method of integration; auto: dop853, or rodas5p for a stiff machine"),
    WORD(FLAG, "method_chosen", chosen, "", "chosen", "", "", "whether auto chose the method"),
    WORD(FLAG, "located", located, "integrate", "contacts", "unlocated", "unlocated|located",
         "with method rk4: unlocated: steps cross contacts; located: steps are split where contact begins and ends; "
         "other methods always locate contacts"),
    MEMBER(whirl_integrate_options, WHOLE, "steps_per_revolution", steps_per_revolution, "integrate", true,
           "steps_per_revolution", "", "1", WHIRL_KEY_WHOLE, false, "1024", WHIRL_FROM_TO(1, WHIRL_MAX_STEPS), NULL,
           "number of instants at which a revolution is observed; for rk4 also its steps", ""),
    NUMBER(rtol, "1e-9", WHIRL_ABOVE_TO(0, 1), true, "relative tolerance of adaptive methods"),
    NUMBER(atol, "1e-12", WHIRL_POSITIVE, true,
           "absolute tolerance of adaptive methods, in length scales; absent: 1e-12, and at most 1e-9 of the machine's "
           "smallest clearance or gap"),
    NUMBER(limit, "1e6", WHIRL_POSITIVE, false,
           "a motion counts as diverged beyond this displacement or velocity, in length scales"),
    {.part = NULL},
};

const whirl_member *whirl_integrate_members(void) {
    return members;
}

whirl_integrate_options whirl_integrate_default(void) {
    whirl_integrate_options options = {.chosen = false};
    whirl_members_default(members, &options);
    snprintf(options.method, sizeof options.method, "rk4");
    return options;
}
