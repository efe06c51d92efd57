/// Reads derivatives of the numbers of points with respect to parameters from tables of results (whirl_derivatives).
#ifndef REPORT_SENSITIVITY_VIEW_H
#define REPORT_SENSITIVITY_VIEW_H

#include <stddef.h>

#include "whirl/engine/result.h"
#include "whirl/engine/sensitivity.h"
#include "whirl/engine/spread.h"

/// Returns the number of parameters of a table's derivatives; 0 if it has no derivatives.
size_t sensitivity_parameters(const whirl_table *table);

/// Returns the name of parameter `index`, from 0; borrowed from the result.
const char *sensitivity_parameter(const whirl_result *result, size_t index);

/// The derivative of a number with respect to a parameter at a point, in SI; NaN if it is missing.
typedef struct sensitivity_at {
    double number, parameter; ///< values of the number and of the parameter
    double slope, error;      ///< the derivative, and its error
    double change;            ///< % by which the number changes if the parameter grows by 1 %
} sensitivity_at;

/// Returns the derivative of number `number` with respect to parameter `parameter`, both from 0.
sensitivity_at sensitivity_of(const whirl_table *table, size_t point, size_t number, size_t parameter);

/// Returns the point at which the absolute value of a number is largest, or the number of points if no point has it.
size_t sensitivity_largest(const whirl_table *table, size_t number);

/// Orders the parameters by the absolute value of the change at a point, the largest first, and leaves out parameters
/// whose derivative is missing or below its error. Returns the number of parameters in `order`.
size_t sensitivity_order(const whirl_table *table, size_t point, size_t number, size_t order[WHIRL_MAX_SENSITIVITIES]);

#endif
