/// Dimension of an expression's value.
#ifndef CASE_DIMENSION_H
#define CASE_DIMENSION_H

#include "parameters.h"

typedef enum value_dimension {
    DIMENSION_PLAIN,   ///< the same in all units; also 0, and expressions without a value
    DIMENSION_OF_UNIT, ///< the dimension of the unit in question
    DIMENSION_OTHER
} value_dimension;

/// Finds the dimension of an expression over parameters that were read without a problem, compared with an SI unit.
value_dimension expression_dimension(const parameter_table *parameters, const char *expression, const char *unit);

#endif
