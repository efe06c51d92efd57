/// Derivatives of the numbers of points by parameters, as tables of results have them (whirl_derivatives).
#ifndef REPORT_SENSITIVITY_VIEW_H
#define REPORT_SENSITIVITY_VIEW_H

#include <stddef.h>

#include "whirl/engine/result.h"
#include "whirl/engine/sensitivity.h"
#include "whirl/engine/spread.h"

/// Returns the number of parameters by which a table's numbers are derived; 0 if there are none.
size_t sensitivity_parameters(const whirl_table *table);

/// Returns the name of a parameter, by index from 0; borrowed from the result.
const char *sensitivity_parameter(const whirl_result *result, size_t index);

/// The derivative of a number by a parameter at a point, in SI; NaN where it is missing.
typedef struct sensitivity_at {
    double number, parameter; ///< their values
    double slope, error;      ///< the derivative, and its error
    double change;            ///< % by which the number changes if the parameter grows by 1 %
} sensitivity_at;

/// Reads the derivative of number `number` by parameter `parameter`, both from 0.
sensitivity_at sensitivity_of(const whirl_table *table, size_t point, size_t number, size_t parameter);

/// Returns the point at which the modulus of a number is largest; the number of points if it is known at none.
size_t sensitivity_largest(const whirl_table *table, size_t number);

/// Orders the parameters by the modulus of the change at a point, the largest first, without those whose derivative is
/// missing or below its error; returns how many are left.
size_t sensitivity_order(const whirl_table *table, size_t point, size_t number, size_t order[WHIRL_MAX_SENSITIVITIES]);

#endif
