/// The parameter of a case that the speed of the shaft is in a fit.
#ifndef CASE_FIT_SPEED_H
#define CASE_FIT_SPEED_H

#include "plan_fit.h"

/// Returns the parameter that rotor.speed is; NULL without one.
const parameter *fit_shaft_parameter(const case_reader *reader, const fit_parts *parts);

/// Returns the same one, unless it is looked for, or given for the set. NULL: the speed is set, and nothing else of the
/// machine follows it.
const parameter *fit_speed_parameter(const case_reader *reader, const fit_parts *parts, const fit_set *set);

#endif
