/// The parameter of a case that sets the speed of the shaft, for fits.
#ifndef CASE_FIT_SPEED_H
#define CASE_FIT_SPEED_H

#include "plan_fit.h"

/// Returns the parameter whose value is rotor.speed; NULL if rotor.speed is a number, an expression, or a parameter
/// that depends on others.
const parameter *fit_shaft_parameter(const case_reader *reader, const fit_parts *parts);

/// Returns fit_shaft_parameter, or NULL if that is an unknown of the fit or has a value for the set. With NULL the
/// speed of each motion is set directly, and nothing else of the machine follows it.
const parameter *fit_speed_parameter(const case_reader *reader, const fit_parts *parts, const fit_set *set);

#endif
