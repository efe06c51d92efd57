/// The rotation number of a section on closed curves.
#ifndef ANALYZE_ROTATION_H
#define ANALYZE_ROTATION_H

#include "section.h"

/// Points from which rotation numbers and locks are found, the last ones: slow rotations must go round several times.
enum { ROTATION_POINTS = 20000 };

/// Returns the rotation number of a section on `curves` >= 1 closed curves that it visits in turn: turns round a curve
/// from one visit to the next, from 0 to 1/2, without a sense of rotation. NaN if it cannot be determined.
double rotation_number(const section *all, int curves);

#endif
