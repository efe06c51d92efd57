/// A part of a system's period, as a system of its own.
#ifndef ORBIT_PART_H
#define ORBIT_PART_H

#include "whirl/engine/system.h"

/// The system dx/dt = stretch f(from + stretch t, x), where f is the right-hand side of `whole` and t runs from 0 to
/// own.period. A part must not be moved, since its system points to it.
typedef struct part {
    whirl_system own;
    const whirl_system *whole;
    double from, stretch;
} part;

/// Makes the part of `whole` that begins at `from`, and whose length in its own time is `length`.
void part_of(part *p, const whirl_system *whole, double from, double length, double stretch);

#endif
