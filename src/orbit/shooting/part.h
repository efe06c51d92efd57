/// A part of a system's period, as a system of its own.
#ifndef ORBIT_PART_H
#define ORBIT_PART_H

#include "whirl/engine/system.h"

/// dx/dt = stretch f(from + stretch t, x) of `whole`, t from 0 to own.period. It must not be moved: the system points
/// to it.
typedef struct part {
    whirl_system own;
    const whirl_system *whole;
    double from, stretch;
} part;

/// Makes the part of that length in its own time.
void part_of(part *p, const whirl_system *whole, double from, double length, double stretch);

#endif
