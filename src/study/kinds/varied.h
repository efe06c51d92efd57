/// Machines of a batch at which one parameter of the case has another value, and derivatives of orbits by several
/// parameters.
#ifndef STUDY_VARIED_H
#define STUDY_VARIED_H

#include "whirl/engine/orbit.h"
#include "whirl/engine/sensitivity.h"
#include "whirl/engine/study.h"

/// Room for the parameters that a batch gives, and one more.
typedef whirl_given varied_given[WHIRL_MAX_GIVEN + 1];

/// A parameter by which orbits are differentiated.
typedef struct varied_parameter {
    const char *name;
    double value;
    double reach; ///< as whirl_sensitivity_new takes it; 0 for an eighth of the value
} varied_parameter;

/// Returns a batch whose machines have the parameter `name` at x. `*value`, the value of the batch's own parameter,
/// becomes x if `name` is that parameter. The batch borrows `given` and the name.
whirl_batch varied_batch(const whirl_batch *batch, const char *name, double x, varied_given given, double *value);

/// Derives an orbit of the batch's machine at `value` of its own parameter, by parameters [count]. `lengths`, if not
/// NULL, gets the metres of a unit of displacement and their derivatives [1 + count]. Errors as those of
/// whirl_sensitivity_new and whirl_orbit_sensitivity_new.
whirl_status varied_orbit(const whirl_study *study, const whirl_batch *batch, double value, size_t count,
                          const varied_parameter *parameters, const whirl_orbit *orbit,
                          const whirl_orbit_options *options, size_t instants, double *lengths,
                          whirl_orbit_sensitivity **out);

/// Derives by parameters [count] the extreme of switching function `index` along an orbit, of all extremes the one
/// nearest to 0: slopes [count]. The orbit must stay on one side of 0 there. Errors as those of varied_orbit;
/// WHIRL_NUMERICAL_FAILURE if the function has no extreme.
whirl_status varied_extreme(const whirl_study *study, const whirl_batch *batch, double value, size_t count,
                            const varied_parameter *parameters, const whirl_orbit *orbit,
                            const whirl_orbit_options *options, size_t index, double *slopes);

#endif
