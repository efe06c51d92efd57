/// What kind of number an expression gives.
#ifndef CASE_DIMENSION_H
#define CASE_DIMENSION_H

#include "parameters.h"

typedef enum value_dimension {
    DIMENSION_PLAIN,   ///< the same in all units; 0, and what has no value, count as such
    DIMENSION_OF_UNIT, ///< as the unit asked about
    DIMENSION_OTHER
} value_dimension;

/// The dimension of an expression over parameters that have been read without a problem, beside that of an SI unit.
value_dimension expression_dimension(const parameter_table *parameters, const char *expression, const char *unit);

#endif
