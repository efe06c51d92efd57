// The options of integration as they describe themselves.
#include <math.h>
#include <stdio.h>

#include "whirl/integrate.h"

#define AT(TYPE, field) .type = WHIRL_MEMBER_##TYPE, .offset = offsetof(whirl_integrate_options, field)

static const whirl_member members[] = {
    {"method", AT(WORD, method), .part = "integrate",
     .key = {"method", "", "", WHIRL_KEY_CHOICE, false, "auto", WHIRL_ANY, "",
             "a method of integration; auto: dop853, or rodas5p where the machine is stiff", ""}},
    {"method_chosen", AT(FLAG, chosen), .part = "",
     .key = {"chosen", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "", "whether auto chose the method", ""}},
    {"located", AT(FLAG, located), .part = "integrate",
     .key = {"contacts", "", "", WHIRL_KEY_CHOICE, false, "unlocated", WHIRL_ANY, "unlocated|located",
             "of method rk4: unlocated: steps go over contacts; located: steps are split where contact begins and "
             "ends; other methods always locate them",
             ""}},
    {"steps_per_revolution", AT(WHOLE, steps_per_revolution), .part = "integrate", .refined = true,
     .key = {"steps_per_revolution",
             "",
             "1",
             WHIRL_KEY_WHOLE,
             false,
             "1024",
             {1, WHIRL_MAX_STEPS, false, false},
             NULL,
             "instants at which the motion is seen; of rk4 also its steps",
             ""}},
    {"rtol", AT(NUMBER, rtol), .part = "integrate", .refined = true,
     .key = {"rtol",
             "",
             "1",
             WHIRL_KEY_NUMBER,
             false,
             "1e-9",
             {0, 1, true, false},
             NULL,
             "relative tolerance of adaptive methods",
             ""}},
    {"atol", AT(NUMBER, atol), .part = "integrate", .refined = true,
     .key = {"atol", "", "1", WHIRL_KEY_NUMBER, false, "1e-12", WHIRL_POSITIVE, NULL,
             "absolute tolerance of adaptive methods, in length scales", ""}},
    {"limit", AT(NUMBER, limit), .part = "integrate",
     .key = {"limit", "", "1", WHIRL_KEY_NUMBER, false, "1e6", WHIRL_POSITIVE, NULL,
             "a motion counts as diverged beyond this displacement or velocity, in length scales", ""}},
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
