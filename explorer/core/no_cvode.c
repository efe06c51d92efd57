// Declares the methods of SUNDIALS by name, so that cases with them can be read; their start fails.
#include "method.h"

static whirl_status no_cvode_start(whirl_integrator *integrator) {
    return whirl_fail(WHIRL_BAD_INPUT,
                      "method %s needs SUNDIALS, which the explorer does not have; take auto or dop853",
                      integrator->method->about.name);
}

const method cvode_adams_method = {.about = {.name = "cvode-adams", .meaning = "not in the explorer", .adaptive = true},
                                   .start = no_cvode_start};
const method cvode_bdf_method = {.about = {.name = "cvode-bdf", .meaning = "not in the explorer", .adaptive = true},
                                 .start = no_cvode_start};
