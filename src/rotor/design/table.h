/// Interpolation of a table of numbers.
#ifndef ROTOR_TABLE_H
#define ROTOR_TABLE_H

#include <stdbool.h>
#include <stddef.h>

/// Returns true if each of the numbers x [count] is greater than the previous one.
bool table_rises(size_t count, const double *x);

/// Returns the value at `at`, between x[0] and x[count - 1], of the piecewise cubic through the points (x, y) [count >=
/// 2] with ascending x. The cubic is smooth, and monotone where the points are (Fritsch, Carlson 1980; slopes after
/// Fritsch, Butland 1984).
double table_value(size_t count, const double *x, const double *y, double at);

/// Returns the derivative of that cubic.
double table_rate(size_t count, const double *x, const double *y, double at);

#endif
